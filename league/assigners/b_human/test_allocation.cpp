// SPDX-License-Identifier: MIT
// Positions, lists of tasks and the active player allocate nothing within what was reserved.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <numeric>
#include <random>
#include <vector>

#include "active_player.hpp"
#include "positions.hpp"
#include "statement.hpp"

namespace {

using namespace b_human;
using regista::testkit::allocations_during;

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(BHuman, NothingIsAllocatedWithinWhatWasReserved) {
  constexpr std::size_t robots = 22, roles = 27;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  Positions positions;
  positions.reserve(robots, roles);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(statement_bytes(roles));
  for (int round = 0; round < 500; ++round) {
    std::vector<TaskList> lists(random() % (robots + 1));
    std::vector<Position> tasks(random() % (roles + 1));
    std::vector<Member> members;
    std::vector<Candidate> candidates(lists.size());
    for (std::size_t j = 0; j < tasks.size(); ++j) tasks[j] = {static_cast<int>(j), {place(random), place(random)}};
    for (TaskList& each : lists) {
      for (const Position& task : tasks) {
        if (random() % 4 != 0) each.add(task.id);
      }
      members.push_back({millimetres(place(random)), 0, static_cast<int>(random() % roles), &each});
    }
    for (Candidate& each : candidates) {
      each.knows_ball = true;
      each.pose.x = place(random);
    }
    std::vector<std::uint32_t> order(tasks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::int32_t> out(members.size());
    const auto count = allocations_during([&] {
      positions.assign(
          members, tasks, [](auto i, auto j) { return (i + j) % 5 != 0; }, 1000, order, order, out);
      active_player(candidates, {0, 0}, ActiveRule{});
      if (lists.empty()) return;
      write(lists.front(), roles, bytes);
      read(bytes, roles);
    });
    ASSERT_EQ(count, 0u);
  }
  EXPECT_GT(allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
