// SPDX-License-Identifier: MIT
// A search allocates nothing after reserve().
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <random>
#include <vector>

#include "field.hpp"

namespace {

using namespace preferred_poses;

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(PreferredPoses, NothingIsAllocatedWithinWhatWasReserved) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  Search search;
  search.reserve(22);
  for (int round = 0; round < 1000; ++round) {
    std::vector<Point> mates(random() % 23), opponents(random() % 23);
    for (auto* robots : {&mates, &opponents}) {
      for (Point& each : *robots) each = {anywhere(random), anywhere(random)};
    }
    const auto count = regista::testkit::allocations_during([&] {
      search.best({mates, opponents, {0.1, 0.2}, std::nullopt}, {4.5, 3.0}, {});
    });
    ASSERT_EQ(count, 0u);
  }
  EXPECT_GT(regista::testkit::allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
