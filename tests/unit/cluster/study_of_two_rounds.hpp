// SPDX-License-Identifier: MIT
// A study made by hand: a round of six matches, and, when those are known, one of four.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "campaign/store.hpp"
#include "study/study.hpp"

namespace regista::cluster {

class TwoRounds : public study::Study {
 public:
  // enough: of matches, after which nothing more is needed. equal: the last match of the first round is its first
  // again.
  explicit TwoRounds(std::uint64_t enough = 10, bool equal = false) : enough_(enough), equal_(equal) {}

  const char* what() const override { return "trial"; }
  std::uint64_t most_matches() const override { return 10; }
  std::uint64_t counted() const override { return taken_; }
  campaign::Metrics metrics() const override { return campaign::Metrics::left_out; }
  campaign::Limits limits() const override { return limits_; }
  const std::string& folder() const override { return folder_; }
  std::string plan() const override { return "{}"; }
  std::vector<std::string> differences(const std::string&) const override { return {}; }
  void run(const study::PlayRound& play) override {
    bool more = true;
    std::uint64_t first = 0;
    for (const std::uint64_t matches : {6u, 4u}) {
      study::Round round;
      round.matches = matches;
      round.first_row = first;
      round.fixtures = {{first == 0 ? "one" : "two", {}}};
      round.at = [this, first](std::uint64_t index) {
        const std::uint64_t seed = equal_ && first == 0 && index == 5 ? 0 : index;
        return std::optional(study::Round::Place{0, 100 * first + seed});
      };
      round.first_of_pairing = [first](std::uint64_t index) { return first == 0 && index == 0; };
      round.job = [](std::uint64_t) { return campaign::Job(); };
      round.take = [this, &more](std::uint64_t, const campaign::MatchResult*) { return more = ++taken_ < enough_; };
      play(round);
      if (!more) return;
      first += matches;
    }
  }

 private:
  std::uint64_t enough_, taken_ = 0;
  bool equal_;
  campaign::Limits limits_;
  std::string folder_ = "/";
};

inline campaign::MatchResult match() {
  return {{1, 0}, "full_time", "h", campaign::metrics_from_json("{}"), std::nullopt, 1.0};
}

// A folder that is there as long as a test.
class FolderTest : public testing::Test {
 protected:
  FolderTest() { std::filesystem::create_directory(folder); }
  ~FolderTest() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("cluster-" + std::to_string(getpid()));
};

}  // namespace regista::cluster
