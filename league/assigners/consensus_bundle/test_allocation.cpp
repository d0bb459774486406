// SPDX-License-Identifier: MIT
// A robot that bids, writes, reads and hears allocates nothing once it is set up.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <vector>

#include "path.hpp"
#include "segment.hpp"
#include "standing_bid.hpp"
#include "test_problems.hpp"

namespace {

using namespace consensus_bundle;
using namespace consensus_bundle::test;

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(ConsensusBundle, NothingIsAllocatedAfterSetup) {
  constexpr std::size_t robots = 22, tasks = 64;
  Random random(51);
  std::vector<Consensus> team(robots);
  Segment segment;
  segment.setup(robots, tasks);
  for (std::size_t k = 0; k < robots; ++k) team[k].setup(static_cast<int>(k) + 1, robots, tasks);
  StandingBid standing;
  standing.setup(tasks);
  Told told;
  told.claims.reserve(tasks);
  told.stamps.reserve(robots);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(segment.bytes(tasks));
  std::vector<Chance> chances(tasks);
  const Worth worth;
  for (std::int64_t tick = 0; tick < 1000; ++tick) {
    for (Chance& each : chances) each = {below(random, 5) != 0, share(random), {share(random), share(random)}};
    const std::size_t k = below(random, robots), other = below(random, robots);
    const std::size_t limit = 1 + below(random, 4);
    const auto count = regista::testkit::allocations_during([&] {
      standing.look(chances, {0.0, 0.0}, 0.02);
      team[k].rebuild(limit, [&](auto path, std::uint32_t task) {
        return gain_of(worth, standing.start(), standing.tasks(), path, task);
      });
      segment.write(0, static_cast<int>(k) + 1, tick, team[k].claims(), team[k].stamps(), bytes);
      std::uint8_t epoch = 0;
      segment.read(bytes, static_cast<int>(k) + 1, tick, epoch, told);
      if (k != other) team[other].hear(told);
    });
    ASSERT_EQ(count, 0u) << tick;
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
