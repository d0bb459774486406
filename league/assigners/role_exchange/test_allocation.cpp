// SPDX-License-Identifier: MIT
// Nothing is allocated after reserve(), neither by the permutation nor by a robot that negotiates.
#include <plugins/assigners/test_allocation.hpp>

#include "best_permutation.hpp"
#include "negotiator.hpp"

TEST(RoleExchange, ThePermutationAllocatesNothing) {
  assignment::expect_nothing_allocated<role_exchange::BestPermutation>(
      role_exchange::forbidden, [](role_exchange::BestPermutation& solver, const assignment::Matrix& utilities,
                                   auto order, auto out) { solver.find(utilities, order, order, out); });
}

TEST(RoleExchange, ANegotiatorAllocatesNothing) {
  constexpr std::size_t robots = 22, roles = 64;
  std::mt19937 random(4);
  role_exchange::Negotiator one, other;
  one.reserve({}, 3, robots, roles);
  other.reserve({}, 4, robots, roles);
  const std::vector<std::int32_t> claims(robots, role_exchange::no_role);
  const std::vector<double> claimed(robots, -100.0);
  for (int round = 0; round < 500; ++round) {
    std::vector<std::int32_t> members, tasks;
    for (std::int32_t number = 1; number <= static_cast<std::int32_t>(robots); ++number) {
      if (number == 3 || number == 4 || random() % 2 == 0) members.push_back(number);
    }
    for (std::int32_t id = 0; id < static_cast<std::int32_t>(roles); ++id) {
      if (random() % 2 == 0) tasks.push_back(id);
    }
    std::vector<std::uint32_t> order(tasks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> values(members.size() * tasks.size());
    for (double& value : values) value = static_cast<double>(random() % 100) / 100.0;
    const role_exchange::Situation now{.time = 1.0 + round,
                                       .members = members,
                                       .tasks = tasks,
                                       .choice = order,
                                       .order = order,
                                       .utilities = {values.data(), members.size(), tasks.size(), tasks.size()},
                                       .claims = claims,
                                       .claimed = claimed,
                                       .begins = false,
                                       .own_role = role_exchange::no_role};
    const auto count = regista::testkit::allocations_during([&] {
      one.decide(now);
      other.decide(now);
      one.sent(one.message());
      other.hear(3, one.message(), now.time);
      one.hear(4, other.message(), now.time);
    });
    ASSERT_EQ(count, 0u) << round;
  }
}
