// SPDX-License-Identifier: MIT
// Within what was reserved, neither a vote nor what follows from it allocates.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <numeric>
#include <random>
#include <vector>

#include "../negotiation/follow_map.hpp"
#include "vote.hpp"

namespace {

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(ScramVote, NothingIsAllocatedWithinWhatWasReserved) {
  constexpr std::size_t robots = 22, roles = 64;
  const scram::MapCode code(robots, roles);
  scram::BallotBox ballots;
  ballots.reserve(code);
  scram::Follower follower;
  follower.reserve(roles);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(code.bytes());
  std::vector<std::int32_t> map(robots), out(robots), numbers(robots), ids(roles);
  std::vector<std::uint32_t> order(roles);
  std::iota(numbers.begin(), numbers.end(), 1);
  std::iota(ids.begin(), ids.end(), 0);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(6);
  const auto count = regista::testkit::allocations_during([&] {
    for (int round = 0; round < 1000; ++round) {
      for (std::size_t robot = 0; robot < robots; ++robot)
        map[robot] = static_cast<std::int32_t>((robot + random() % 3) % roles);
      negotiation::BitWriter writer(bytes);
      code.write(map, writer);
      ballots.put(1 + static_cast<int>(random() % robots), bytes, round);
      ballots.elect(3, map, round - 10.0, [](int, std::span<const std::int32_t>) { return true; });
      follower.follow(
          map, {numbers, ids, order}, [](std::size_t, std::size_t) { return true; }, out);
    }
  });
  EXPECT_EQ(count, 0u);
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
