// SPDX-License-Identifier: MIT
// A mind in the steady state allocates nothing: it is asked ten times a second in each of fourteen robots.
#include <gtest/gtest.h>

#include <cmath>
#include <regista/testkit/count_allocations.hpp>

#include "team.hpp"

namespace regista::mind {
namespace {

TEST(Allocation, NothingIsAllocatedAfterAHundredDecisions) {
  const auto plan = plan_of(team());
  std::vector<Mind> minds;
  for (int number = 1; number <= 7; ++number) minds.emplace_back(*plan, number, 1);
  std::vector<Outcome> outcomes(7);
  std::vector<std::vector<std::uint8_t>> air(7);
  for (auto& bytes : air) bytes.reserve(128);
  std::vector<HeardPacket> heard;
  heard.reserve(7);
  Percepts given;
  given.balls.reserve(4);
  given.robots.reserve(16);

  for (int k = 0; k < 400; ++k) {
    const double time = 0.1 * k;
    if (k == 100) testkit::allocations = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      given.time = time;
      given.game.phase = Phase::playing;
      given.odometry = {0.02, 0.0, 0.05};
      given.placed.reset();
      if (k == 0) given.placed = placed(-3.0 + 0.9 * static_cast<double>(i), 0.5);
      given.balls.clear();
      given.robots.clear();
      if (k % 7 != 0) given.balls.push_back({{1.0 + 0.3 * std::sin(0.1 * k), 0.2}, 0.05, 0.05});
      for (int r = 0; r < 7; ++r) given.robots.push_back({{0.8 + 0.5 * r, 0.3 * r - 1.0}, 0.1, 0.1, r == 3});
      heard.clear();
      for (std::size_t j = 0; j < 7; ++j) {
        if (j != i && !air[j].empty()) heard.push_back({time, air[j]});
      }
      testkit::counting = true;
      minds[i].think(given, heard, outcomes[i]);
      testkit::counting = false;
    }
    for (std::size_t i = 0; i < 7; ++i) air[i].assign(outcomes[i].packet.begin(), outcomes[i].packet.end());
    ASSERT_TRUE(k < 100 || testkit::allocations == 0) << testkit::allocations << " by decision " << k;
  }
  EXPECT_EQ(minds[0].world().common().active.size(), 7u) << "they did hear each other";
}

// The counter counts: otherwise the test above could not fail.
TEST(Allocation, IsCounted) {
  std::vector<int>* volatile some = nullptr;
  EXPECT_EQ(testkit::allocations_during([&some] { some = new std::vector<int>(100); }), 2u);
  delete some;
}

}  // namespace
}  // namespace regista::mind
