// SPDX-License-Identifier: MIT
// Files of recordings of all kinds, and whether they are taken for a match.
#include "report/tournament_history.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "course.hpp"
#include "mcap/writer.hpp"
#include "recording/recording_metadata.hpp"
#include "study/study.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

struct Written {
  std::string seed = "7", home = R"({"team":"a"})", away = R"({"team":"b"})", opening = "left";
  std::string game = R"({"time":100,"score":[2,1]})", goal = "";  // at the very end, of an event
  bool whole = true, backwards = false;  // backwards: what comes later stands first in the file
  int packets = 0;
};

class PageRecordingsTest : public testing::Test {
 protected:
  PageRecordingsTest() : results_(fs::path(testing::TempDir()) / ("results_" + std::to_string(getpid()) + ".db")) {
    fs::create_directory(study::recording_folder(results_));
  }
  ~PageRecordingsTest() override { fs::remove_all(study::recording_folder(results_)); }

  fs::path write(const Written& content, std::int64_t row = 1) const {
    const fs::path file = study::recording_file(results_, row);
    {
      mcap::Writer writer(file, {.replace = true});
      writer.write(mcap::Metadata{
          "match",
          {{"seed", content.seed}, {"home", content.home}, {"away", content.away}, {"opening", content.opening}}});
      const mcap::ChannelId game = writer.add_channel("/game", "json"), events = writer.add_channel("/event", "json");
      const mcap::ChannelId others = writer.add_channel("/belief/home/1", "json");
      std::vector<mcap::Message> messages{
          {game, 0, 1'000'000'000, 1'000'000'000, R"({"time":1,"score":[0,0]})"},
          {events, 0, 99'990'000'000, 99'990'000'000, R"({"event":"goal","time":99.99,"score":[1,1]})"}};
      if (!content.game.empty()) messages.push_back({game, 1, 100'000'000'000, 100'000'000'000, content.game});
      if (!content.goal.empty()) messages.push_back({events, 1, 100'050'000'000, 100'050'000'000, content.goal});
      if (content.backwards) std::ranges::reverse(messages);
      for (const mcap::Message& each : messages) writer.write(each);
      const mcap::ChannelId sent = writer.add_channel("/packet", "json");
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(content.packets); ++i) {
        writer.write({sent, i, 100'055'000'000, 100'055'000'000, "{}"});
      }
      writer.write({others, 0, 100'060'000'000, 100'060'000'000, "{}"});
      writer.close();
    }
    if (!content.whole) fs::resize_file(file, fs::file_size(file) - 40);
    return file;
  }

  fs::path results_;
  recording::RecordingIdentity match_{7, {"a", "b"}, "left", std::array<int, 2>{2, 1}, {}};
};

TEST_F(PageRecordingsTest, OfTheSameMatch) {
  EXPECT_TRUE(recording::is_recording_of(write({}), match_));
  EXPECT_TRUE(recording::is_recording_of(write({.game = R"({"score":[1,1]})", .goal = R"({"score":[2,1]})"}), match_));
  match_.packets = 2.0;
  EXPECT_TRUE(recording::is_recording_of(write({.packets = 2}), match_));
  EXPECT_FALSE(recording::is_recording_of(write({.packets = 3}), match_));
  match_.packets.reset();
  match_.labels = {"a (one/a.yaml)", "b (c)"};
  EXPECT_TRUE(recording::is_recording_of(write({}), match_));
}

// MCAP lets messages stand in any order; their times say what came last.
TEST_F(PageRecordingsTest, TheOrderInTheFileDoesNotMatter) {
  for (const bool backwards : {false, true}) {
    const fs::path file = write({.game = R"({"score":[1,1]})",
                                 .goal = R"({"event":"goal","time":100.05,"score":[2,1]})",
                                 .backwards = backwards});
    EXPECT_TRUE(recording::is_recording_of(file, match_)) << backwards;
    EXPECT_EQ(recording::first_goal(file), 99.99) << backwards;
  }
}

TEST_F(PageRecordingsTest, OfAnother) {
  for (const Written& each :
       {Written{.seed = "8"}, Written{.home = R"({"team":"b"})"}, Written{.away = R"({"team":"a"})"},
        Written{.away = R"({"team":"b ("})"}, Written{.opening = "right"}, Written{.opening = ""},
        Written{.game = R"({"score":[1,2]})"}, Written{.goal = R"({"score":[3,1]})"}, Written{.whole = false},
        // And such as nobody here writes.
        Written{.seed = ""}, Written{.home = "{"}, Written{.home = "[]"}, Written{.away = R"({"team":3})"},
        Written{.game = ""}, Written{.game = "[["}, Written{.game = R"({"score":"2:1"})"},
        Written{.game = R"({"score":[2]})"}, Written{.game = R"({"score":null})"}}) {
    EXPECT_FALSE(recording::is_recording_of(write(each), match_))
        << each.seed << each.home << each.away << each.opening << each.game;
  }
}

TEST_F(PageRecordingsTest, OfAMatchThatFailed) {
  match_.score.reset();
  EXPECT_TRUE(recording::is_recording_of(write({}), match_));
  EXPECT_TRUE(recording::is_recording_of(write({.whole = false}), match_));
  EXPECT_FALSE(recording::is_recording_of(write({.seed = "8", .whole = false}), match_));
}

TEST_F(PageRecordingsTest, NoneAtAll) {
  const fs::path file = study::recording_file(results_, 1);
  EXPECT_FALSE(recording::is_recording_of(file, match_));
  std::ofstream(file) << "";
  EXPECT_FALSE(recording::is_recording_of(file, match_));
  std::ofstream(file) << "\x89MCAP0\r\n and no more";
  EXPECT_FALSE(recording::is_recording_of(file, match_));
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(recording::is_recording_of(file, match_));
}

TEST_F(PageRecordingsTest, EachFileIsFittingOrAnother) {
  Course course({"a", "b"}, 3);
  course.plan.asked.seed = 7;
  course.plan.openings = {{"scenes/l.yaml", {"opening left", "hash"}}};
  course.tournament.emplace(course.plan);
  TournamentHistory record(course.plan, *course.tournament, {0, 1, 2, 3, 900});
  for (const campaign::MatchResult& each : {match(2, 1), match(0, 0), failed(0), match(0, 0), match(2, 1)}) {
    course.take(each);
    record.take(&each);
  }
  write({}, 1);                                                                      // row 1, as it was
  write({.home = R"({"team":"b"})", .away = R"({"team":"a"})", .whole = false}, 2);  // cut off
  write({.seed = "8", .whole = false}, 3);                                           // of the failure
  write({.seed = "8", .game = R"({"score":[0,0]})"}, 4);                             // the sides are wrong
  write({}, 901);                                                                    // beyond the schedule
  const PageRecordings found = page_recordings(course.view(), record, results_);
  ASSERT_EQ(found.fitting.size(), 2u);
  EXPECT_EQ(found.fitting[0].index, 0u);
  EXPECT_EQ(found.fitting[1].index, 2u);
  EXPECT_EQ(found.not_read, 0u);
}

TEST(RecordingPlace, NoTwoResultsShareOne) {
  EXPECT_EQ(study::recording_file("x/b.db", 12), "x/b.recordings/12.mcap");
  EXPECT_EQ(study::page_file("x/b.db"), "x/b.html");
  EXPECT_EQ(study::recording_folder("b.sqlite"), "b.sqlite.recordings");
  EXPECT_EQ(study::page_file("b.html"), "b.html.html");
  EXPECT_EQ(study::page_file("x.y/b"), "x.y/b.html");
  EXPECT_EQ(study::page_file("b.1.db"), "b.1.html");
}

}  // namespace
}  // namespace regista::report
