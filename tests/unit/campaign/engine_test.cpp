// SPDX-License-Identifier: MIT
// The engine with results that are all there already: what it hands on, and that it plays none of them again. Workers
// are tested with the program itself, in tests/end_to_end.
#include "campaign/engine.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

namespace regista::campaign {
namespace {

class EngineTest : public testing::Test {
 protected:
  EngineTest() { std::filesystem::remove(file); }
  ~EngineTest() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + end);
  }
  std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("engine-" + std::to_string(getpid()) + ".db");
};

TEST_F(EngineTest, HandsOnInTheOrderOfTheSchedule) {
  Store store(file, Store::Mode::create, "1.0");
  const auto fixture = store.fixture("key", "");
  constexpr std::uint64_t count = 500;
  for (std::uint64_t seed = count; seed-- > 0;) {
    store.insert(fixture, seed, {{static_cast<int>(seed), 0}, "full_time", "h", "{}", std::nullopt, 1.0}, 1);
  }
  std::vector<std::uint64_t> order;
  Schedule schedule;
  schedule.matches = count;
  schedule.at = [&](std::uint64_t index) {
    Scheduled out;
    out.job.seed = index;
    out.fixture = fixture;
    return out;
  };
  schedule.take = [&](std::uint64_t index, const Decided& decided, bool fresh) {
    EXPECT_FALSE(fresh);
    EXPECT_EQ(decided.score[0], static_cast<int>(index));
    order.push_back(index);
    return index + 1 != 400;
  };
  EXPECT_EQ(run(schedule, store, 3, {}), Finish::enough);
  ASSERT_EQ(order.size(), 400u);
  for (std::uint64_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  EXPECT_EQ(store.rows(), static_cast<std::int64_t>(count));
}

TEST_F(EngineTest, StopsWhenItIsAsked) {
  Store store(file, Store::Mode::create, "1.0");
  Schedule schedule;
  schedule.matches = 10;
  schedule.asked_to_stop = [] { return true; };
  EXPECT_EQ(run(schedule, store, 1, {}), Finish::interrupted);
  EXPECT_EQ(store.rows(), 0);
}

TEST_F(EngineTest, AnEmptyScheduleIsComplete) {
  Store store(file, Store::Mode::create, "1.0");
  EXPECT_EQ(run({}, store, 1, {}), Finish::complete);
}

}  // namespace
}  // namespace regista::campaign
