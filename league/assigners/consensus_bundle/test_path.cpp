// SPDX-License-Identifier: MIT
// What tasks are worth in a path: worked by hand, and against every place tried one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "path.hpp"
#include "test_problems.hpp"

namespace {

using namespace consensus_bundle;
using namespace consensus_bundle::test;

TEST(Path, TheFirstTaskIsWorthItsUtility) {
  const Worth worth{.kept_per_second = 0.5, .speed = 0.25, .step = 0.001, .most = 4095};
  const std::vector<Chance> tasks{{true, 0.5, {3, 4}}, {false, 0.9, {0, 0}}, {true, 0.0, {1, 1}}, {true, 9.0, {0, 0}}};
  EXPECT_EQ(gain_of(worth, {0, 0}, tasks, {}, 0).value, 501u);
  EXPECT_EQ(gain_of(worth, {0, 0}, tasks, {}, 1).value, 0u);
  EXPECT_EQ(gain_of(worth, {0, 0}, tasks, {}, 2).value, 1u);
  EXPECT_EQ(gain_of(worth, {0, 0}, tasks, {}, 3).value, 4095u);
}

TEST(Path, ATaskOnTheWayComesFirstAndLosesNothing) {
  const Worth worth{.kept_per_second = 0.5, .speed = 1.0, .step = 0.001, .most = 4095};
  // At 0 the robot; tasks at 2, 1 and -1 on a line. What lies behind costs a detour of 2 s to there and back.
  const std::vector<Chance> tasks{{true, 0.8, {2, 0}}, {true, 0.6, {1, 0}}, {true, 0.4, {-1, 0}}};
  const std::vector<std::uint32_t> path{0};
  const Gain on_the_way = gain_of(worth, {0, 0}, tasks, path, 1);
  EXPECT_EQ(on_the_way.place, 0u);
  EXPECT_EQ(on_the_way.value, 601u);
  // Last: 5 m instead of 1 m keep 1/16 of 0.4. First: 4 m instead of 2 m leave 0.2 of 0.8, and 0.4 come.
  const Gain behind = gain_of(worth, {0, 0}, tasks, path, 2);
  EXPECT_EQ(behind.place, 1u);
  EXPECT_EQ(behind.value, 26u);
}

TEST(Path, WhatCostsMoreThanItBringsIsLeft) {
  const Worth worth{.kept_per_second = 0.01, .speed = 0.1, .step = 0.001, .most = 4095};
  const std::vector<Chance> tasks{{true, 0.8, {4, 0}}, {true, 0.0, {-4, 0}}};
  EXPECT_EQ(gain_of(worth, {0, 0}, tasks, std::vector<std::uint32_t>{0}, 1).value, 0u);
}

TEST(Path, SharesAreThoseOfThePowerAtWholeSecondsAndFallBetween) {
  for (const double kept : {0.01, 0.5, 0.95, 1.0}) {
    for (int seconds = 0; seconds < 60; ++seconds) {
      EXPECT_NEAR(share_kept(kept, seconds), std::pow(kept, seconds), 1e-12);
      EXPECT_LE(share_kept(kept, seconds + 0.5), share_kept(kept, seconds));
      EXPECT_GE(share_kept(kept, seconds + 0.5), share_kept(kept, seconds + 1));
    }
  }
}

// The worth of a path, from its definition.
double plainly(const Worth& worth, const Place& start, const std::vector<Chance>& tasks,
               const std::vector<std::uint32_t>& path) {
  double sum = 0.0, walked = 0.0;
  Place at = start;
  for (const std::uint32_t each : path) {
    walked += std::hypot(tasks[each].place.x - at.x, tasks[each].place.y - at.y);
    at = tasks[each].place;
    const double straight = std::hypot(at.x - start.x, at.y - start.y);
    sum += tasks[each].utility * share_kept(worth.kept_per_second, (walked - straight) / worth.speed);
  }
  return sum;
}

TEST(Path, ThePlaceIsTheBest) {
  Random random(41);
  for (int round = 0; round < 3000; ++round) {
    const Worth worth{.kept_per_second = 0.5 + 0.5 * share(random), .speed = 0.25, .step = 1e-3, .most = 4095};
    std::vector<Chance> tasks(6);
    for (Chance& each : tasks) each = {true, share(random), {9.0 * share(random) - 4.5, 6.0 * share(random) - 3.0}};
    const Place start{share(random), share(random)};
    std::vector<std::uint32_t> path{0, 1, 2, 3, 4};
    std::shuffle(path.begin(), path.end(), random);
    path.resize(1 + below(random, 5));
    double best = 0.0;
    for (std::size_t at = 0; at <= path.size(); ++at) {
      std::vector<std::uint32_t> with = path;
      with.insert(with.begin() + static_cast<std::ptrdiff_t>(at), 5);
      best = std::max(best, plainly(worth, start, tasks, with) - plainly(worth, start, tasks, path));
    }
    const Gain gain = gain_of(worth, start, tasks, path, 5);
    if (best < 1e-9) {
      EXPECT_LE(gain.value, 1u);
      continue;
    }
    EXPECT_NEAR(gain.value, 1.0 + best / worth.step, 0.6);
    std::vector<std::uint32_t> with = path;
    with.insert(with.begin() + static_cast<std::ptrdiff_t>(gain.place), 5);
    EXPECT_NEAR(plainly(worth, start, tasks, with) - plainly(worth, start, tasks, path), best, 1e-9);
  }
}

}  // namespace
