// SPDX-License-Identifier: MIT
// A participant allocates nothing after setup(), whatever it hears and decides.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <random>
#include <vector>

#include "test_auctions.hpp"

namespace {

using namespace auction;
using auction_test::below;

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(DistributedAuction, NothingIsAllocatedAfterSetup) {
  constexpr std::size_t tasks = 27, robots = 22;
  std::mt19937 random(2);
  Participant<OneTask> part;
  part.setup(3, robots, tasks);
  std::vector<char> is_active(robots + 1, 1), is_listed(tasks, 1);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::uint32_t> known;
    std::vector<std::int32_t> values;
    for (std::uint32_t task = 0; task < tasks; ++task) {
      if (below(random, 4) == 0) continue;
      known.push_back(task);
      values.push_back(below(random, 5) == 0 ? may_not : static_cast<std::int32_t>(below(random, 50)));
    }
    const std::vector<std::int32_t> groups(known.size(), 0);
    const std::vector<Told> told{
        {below(random, tasks), {1 + below(random, 60), static_cast<int>(below(random, 23))}, false}};
    is_active[1 + below(random, robots)] = below(random, 2) == 0 ? 0 : 1;
    Situation situation;
    situation.now = 0.5 * round;
    situation.plays = below(random, 10) != 0;
    situation.is_active = is_active;
    situation.robots = robots;
    situation.tasks = known;
    situation.values = values;
    situation.groups = groups;
    situation.is_listed = is_listed;
    const auto count = regista::testkit::allocations_during([&] {
      part.hear(1 + static_cast<int>(below(random, robots)), static_cast<std::uint8_t>(round / 100), told,
                situation.now);
      part.decide(situation, {3, 5.0}, OneTask{2});
      if (round % 3 == 0) part.sent();
    });
    ASSERT_EQ(count, 0u);
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
