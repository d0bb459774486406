// SPDX-License-Identifier: MIT
// The engine with results that are all there already: what it hands on, and that it plays none of them again; and with
// the workers of main.cpp, which play nothing. Real ones are tested with the program itself, in tests/end_to_end.
#include "campaign/engine.hpp"
#include "campaign/match_encoding.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

namespace regista::campaign {
namespace {

class EngineTest : public testing::Test {
 protected:
  EngineTest() { std::filesystem::remove(file); }
  ~EngineTest() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + end);
  }

  // Seeds 0 to count - 1 of one fixture at their places, the last of them first; the home team scores the seed.
  void fill(Store& store, std::uint64_t count) {
    fixture = store.add(std::vector<Store::Fixture>{{"key", {}}}).front();
    for (std::uint64_t seed = count; seed-- > 0;) {
      const MatchResult decided{
          {static_cast<int>(seed), 0}, "full_time", "h", metrics_from_json(R"({"packets":[1,2]})"), std::nullopt, 1.0};
      store.insert(static_cast<std::int64_t>(seed) + 1, {fixture, seed}, decided, 1);
    }
  }

  // Fails when a match is to be played, and writes down what is handed on.
  Schedule schedule_of(std::uint64_t matches) {
    Schedule schedule;
    schedule.matches = matches;
    schedule.at = [this](std::uint64_t index) { return std::optional(MatchKey{fixture, index}); };
    schedule.job = [](std::uint64_t index) {
      ADD_FAILURE() << "match " << index << " would be played again";
      return Job{};
    };
    schedule.take = [this](std::uint64_t index, const MatchResult* decided, bool fresh) {
      EXPECT_FALSE(fresh);
      order.push_back(index);
      if (decided != nullptr) {
        EXPECT_EQ(decided->score[0], static_cast<int>(index));
        metrics.insert(decided->metrics.of_side(match::Side::home, "packets"));
      } else {
        missing.insert(index);
      }
      return true;
    };
    return schedule;
  }

  std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("engine-" + std::to_string(getpid()) + ".db");
  std::int64_t fixture = 0;
  std::vector<std::uint64_t> order;
  std::set<std::uint64_t> missing;
  std::set<std::optional<double>> metrics;
};

TEST_F(EngineTest, HandsOnInTheOrderOfTheScheduleUntilItIsEnough) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 500);
  Schedule schedule = schedule_of(500);
  const auto take = schedule.take;
  schedule.take = [&](std::uint64_t index, const MatchResult* decided, bool fresh) {
    return take(index, decided, fresh) && index + 1 != 400;
  };
  EXPECT_EQ(run(schedule, store, 3, {}), Finish::enough);
  ASSERT_EQ(order.size(), 400u);
  for (std::uint64_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  EXPECT_TRUE(missing.empty());
  EXPECT_EQ(store.rows(), 500);
}

// Several schedules of one study, each with its own part of the rows: what is played now, and what was before.
TEST_F(EngineTest, RowsOfAScheduleBeginAfterItsFirst) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 4);  // rows 1 to 4
  Schedule schedule;
  schedule.matches = 6;
  schedule.first_row = 20;
  schedule.at = [this](std::uint64_t index) { return std::optional(MatchKey{fixture, 50 + index}); };
  schedule.job = [](std::uint64_t index) {
    Job job;
    job.seed = 50 + index;
    return job;
  };
  int fresh_ones = 0;
  schedule.take = [&](std::uint64_t index, const MatchResult* decided, bool fresh) {
    EXPECT_EQ(decided->score[0], static_cast<int>(50 + index));
    fresh_ones += fresh ? 1 : 0;
    return true;
  };
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::complete);
  EXPECT_EQ(fresh_ones, 6);
  EXPECT_EQ(store.rows(), 10);
  EXPECT_FALSE(store.row(5));
  for (std::int64_t row = 21; row <= 26; ++row) {
    ASSERT_TRUE(store.row(row)) << row;
    EXPECT_EQ(store.row(row)->decided.score[0], row - 21 + 50);
  }
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::complete);
  EXPECT_EQ(fresh_ones, 6);  // none is played again
}

// Time is over when the third match is to be begun: two are played to their ends, and what is stored is taken until the
// next one that is not.
TEST_F(EngineTest, BeginsNoMatchOnceTimeIsOver) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 4);
  Schedule schedule;
  schedule.matches = 50;
  schedule.at = [this](std::uint64_t index) { return std::optional(MatchKey{fixture, index}); };
  int begun = 0;
  schedule.job = [&begun](std::uint64_t index) {
    ++begun;
    Job job;
    job.seed = index;
    return job;
  };
  schedule.take = [this](std::uint64_t index, const MatchResult* decided, bool /*fresh*/) {
    EXPECT_NE(decided, nullptr);
    order.push_back(index);
    return true;
  };
  schedule.out_of_time = [&begun] { return begun == 2; };
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::out_of_time);
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(order, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(store.rows(), 6);
  // From the beginning: nothing is played, and what there is counts all the same.
  order.clear();
  schedule.out_of_time = [] { return true; };
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::out_of_time);
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(order.size(), 6u);
}

// Sixteen matches a worker: more would cost memory, fewer would let workers wait for the slowest match.
TEST_F(EngineTest, WorkersRunAheadOfThePlaceThatIsDue) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 300);
  for (const int workers : {1, 2, 5}) {
    order.clear();
    Schedule schedule = schedule_of(300);
    std::uint64_t most = 0;
    schedule.at = [&](std::uint64_t index) {
      most = std::max<std::uint64_t>(most, index + 1 - order.size());
      return std::optional(MatchKey{fixture, index});
    };
    EXPECT_EQ(run(schedule, store, workers, {}), Finish::complete);
    EXPECT_EQ(most, 16u * static_cast<unsigned>(workers)) << workers;
  }
}

TEST_F(EngineTest, HandsOnAllOfThem) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 100);
  EXPECT_EQ(run(schedule_of(100), store, 2, {}), Finish::complete);
  EXPECT_EQ(order.size(), 100u);
}

TEST_F(EngineTest, WhatIsNotWantedIsHandedOnWithoutAResultAndKeepsItsPlace) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 60);
  Schedule schedule = schedule_of(60);
  schedule.at = [this](std::uint64_t index) {
    return index % 7 == 3 ? std::nullopt : std::optional(MatchKey{fixture, index});
  };
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::complete);
  ASSERT_EQ(order.size(), 60u);
  for (std::uint64_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(order[i], i);
    EXPECT_EQ(missing.contains(i), i % 7 == 3) << i;
  }
}

TEST_F(EngineTest, MetricsAreReadWhenTheyAreWanted) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 3);
  Schedule schedule = schedule_of(3);
  run(schedule, store, 1, {});
  EXPECT_EQ(metrics, std::set<std::optional<double>>{std::nullopt});
  metrics.clear();
  schedule.metrics = Metrics::wanted;
  run(schedule, store, 1, {});
  EXPECT_EQ(metrics, std::set<std::optional<double>>{1.0});
}

// Two places of the schedule mean the same match where equal teams play each other: it is stored at the first.
TEST_F(EngineTest, AMatchThatStandsTwiceInTheScheduleIsReadTwice) {
  Store store(file, Store::Mode::create, "1.0");
  const auto number = store.add(std::vector<Store::Fixture>{{"key", {}}}).front();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const MatchResult decided{{static_cast<int>(seed), 0}, "full_time",  "h",
                              metrics_from_json("{}"),     std::nullopt, 1.0};
    store.insert(static_cast<std::int64_t>(2 * seed) + 1, {number, seed}, decided, 1);
  }
  std::vector<int> scores;
  Schedule schedule = schedule_of(40);
  schedule.at = [&](std::uint64_t index) { return std::optional(MatchKey{number, index / 2}); };
  schedule.take = [&](std::uint64_t, const MatchResult* decided, bool) {
    scores.push_back(decided == nullptr ? -1 : decided->score[0]);
    return true;
  };
  EXPECT_EQ(run(schedule, store, 2, {}), Finish::complete);
  ASSERT_EQ(scores.size(), 40u);
  for (std::size_t i = 0; i < scores.size(); ++i) EXPECT_EQ(scores[i], static_cast<int>(i / 2));
}

TEST_F(EngineTest, StopsWhenItIsAsked) {
  Store store(file, Store::Mode::create, "1.0");
  fill(store, 10);
  Schedule schedule = schedule_of(10);
  schedule.asked_to_stop = [] { return true; };
  EXPECT_EQ(run(schedule, store, 1, {}), Finish::interrupted);
  EXPECT_TRUE(order.empty());
}

TEST_F(EngineTest, AnEmptyScheduleIsComplete) {
  Store store(file, Store::Mode::create, "1.0");
  EXPECT_EQ(run({}, store, 1, {}), Finish::complete);
}

}  // namespace
}  // namespace regista::campaign
