// SPDX-License-Identifier: MIT
// Recordings of any content: shown, or refused in one line.
#include "recording/recorded_match.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <random>
#include <string>
#include <vector>

#include "fuzz/recorded_match/recorded.hpp"

namespace regista::recording {
namespace {

using testing::HasSubstr;

class RecordedMatchTest : public testing::Test {
 protected:
  RecordedMatchTest()
      : file_((access("/dev/shm", W_OK) == 0 ? "/dev/shm/recorded_" : testing::TempDir() + "recorded_") +
              std::to_string(getpid()) + ".mcap") {}
  ~RecordedMatchTest() override { std::filesystem::remove(file_); }
  Shown shown(const RecordedTexts& texts) const {
    write_recording(file_, texts);
    return show(file_);
  }
  std::filesystem::path file_;
};

TEST_F(RecordedMatchTest, ShowsASoundRecording) {
  const Shown sound = shown({});
  EXPECT_EQ(sound.refusal, "");
  EXPECT_THAT(sound.picture, HasSubstr("a 1: goalkeeper"));
  EXPECT_THAT(sound.picture, HasSubstr("a 1 : 0 a"));
}

TEST_F(RecordedMatchTest, MessagesThatContradictThemselvesAreRefused) {
  RecordedTexts texts;
  texts.game.replace(texts.game.find("[[0,1],[0,-1]]"), 14, "[[0],[0,-1]]");
  EXPECT_EQ(shown(texts).refusal, file_.string() + ": is damaged: the last state of the game cannot be read");
  texts = {};
  texts.decision.replace(texts.decision.find("\"rows\":[1,2]"), 12, "\"rows\":[1]");
  EXPECT_EQ(shown(texts).refusal, file_.string() + ": is damaged: a message of /decision/home/1 cannot be read");
  texts = {};
  texts.belief = "{\"time\":1";
  EXPECT_EQ(shown(texts).refusal, file_.string() + ": is damaged: a message of /belief/home/1 cannot be read");
}

TEST_F(RecordedMatchTest, RowsThatNoTableHoldsAreShownAsNumbers) {
  RecordedTexts texts;
  for (const char* old : {"\"columns\":[0,1]", "\"role\":0,\"before\""}) {
    const std::size_t at = texts.decision.find(old);
    ASSERT_NE(at, std::string::npos);
    texts.decision.replace(texts.decision.find('0', at), 1, "-77");
  }
  EXPECT_THAT(shown(texts).picture, HasSubstr("role -77"));
}

// Pieces of the messages are taken out, doubled, or replaced by what JSON knows else.
TEST_F(RecordedMatchTest, WhateverStandsInAMessageItIsShownOrRefused) {
  const std::vector<std::string> others{"null", "-1",   "1e300", "1e999", "\"x\"", "[]",
                                        "{}",   "true", "0",     "7",     "[[]]",  "99999999999999999999",
                                        "-3.5", ""};
  std::mt19937 random(11);
  const auto below = [&](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
  };
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    RecordedTexts texts;
    const std::array<std::string*, 5> all{&texts.field, &texts.team, &texts.game, &texts.decision, &texts.belief};
    std::string& text = *all[below(all.size())];
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      // From one comma or bracket to the next stands a value, or a key with its value.
      const std::size_t begin = text.find_first_of(",:[{", below(text.size()));
      if (begin == std::string::npos) continue;
      const std::size_t end = std::min(text.find_first_of(",]}", begin + 1), text.size());
      text.replace(begin + 1, end - begin - 1, others[below(others.size())]);
    }
    const Shown outcome = shown(texts);
    refused += outcome.picture.empty() ? 1 : 0;
    ASSERT_NE(outcome.picture.empty(), outcome.refusal.empty()) << text;
    ASSERT_EQ(outcome.refusal.find('\n'), std::string::npos) << outcome.refusal;
    ASSERT_EQ(outcome.picture.find("nan"), std::string::npos) << text;
  }
  EXPECT_GT(refused, 300);
  EXPECT_LT(refused, 1900);
}

}  // namespace
}  // namespace regista::recording
