// SPDX-License-Identifier: MIT
// Tenures whose lengths are written down, and their quantiles beside those of the house's statistics.
#include "match/metrics_coordination.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "statistics/moments.hpp"

namespace regista::match {
namespace {

struct Tenure : testing::Test {
  TenureMeasures measures{3, 600.0};
  double now = 0.0;

  // Robot 1 takes a role every so many seconds, from role 0.
  void hold(const std::vector<double>& seconds) {
    int role = 0;
    measures.decided(1, role, now, true);
    for (const double each : seconds) measures.decided(1, ++role, now += each, true);
  }
};

TEST_F(Tenure, WhatIsNotFinishedDoesNotCount) {
  EXPECT_EQ(measures.result().median_seconds, std::nullopt);
  measures.decided(1, 0, 0.0, true);
  measures.decided(1, 0, 100.0, true);
  EXPECT_EQ(measures.result().median_seconds, std::nullopt) << "it still holds it at the end";
  measures.decided(1, 1, 100.1, true);
  EXPECT_DOUBLE_EQ(*measures.result().median_seconds, 100.1);
  EXPECT_DOUBLE_EQ(*measures.result().tenth_seconds, 100.1);
}

TEST_F(Tenure, QuantilesLieBetweenTheOrderedLengths) {
  hold({0.9, 0.1, 0.5, 0.3});
  EXPECT_NEAR(*measures.result().median_seconds, 0.4, 1e-12);
  EXPECT_NEAR(*measures.result().tenth_seconds, 0.1 + 0.3 * 0.2, 1e-12);
}

TEST_F(Tenure, RobotsDecideEachForThemselves) {
  measures.decided(1, 0, 0.0, true);
  measures.decided(2, 1, 0.02, true);
  measures.decided(2, 0, 0.12, true);
  measures.decided(1, 1, 0.5, true);
  EXPECT_NEAR(*measures.result().median_seconds, 0.3, 1e-12) << "0.1 s and 0.5 s";
}

TEST_F(Tenure, ToHoldNothingIsAnEndButNoTenure) {
  measures.decided(1, 0, 0.0, true);
  measures.decided(1, -1, 2.0, true);
  measures.decided(1, 0, 50.0, true);
  measures.decided(1, 1, 52.0, true);
  EXPECT_DOUBLE_EQ(*measures.result().median_seconds, 2.0);
  EXPECT_DOUBLE_EQ(*measures.result().tenth_seconds, 2.0) << "not the 48 s without a role";
}

TEST_F(Tenure, WhatIsInterruptedDoesNotCountAndBeginsAnew) {
  measures.decided(1, 0, 0.0, true);
  measures.decided(1, 0, 10.0, false);
  measures.decided(1, 1, 11.0, false);
  EXPECT_EQ(measures.result().median_seconds, std::nullopt) << "no role is taken out of play";
  measures.decided(1, 1, 40.0, true);
  measures.crashed(1);
  measures.decided(1, 2, 60.0, true);
  EXPECT_EQ(measures.result().median_seconds, std::nullopt);
  measures.decided(1, 0, 63.0, true);
  EXPECT_DOUBLE_EQ(*measures.result().median_seconds, 3.0);
}

TEST_F(Tenure, QuantilesAreThoseOfTheHouse) {
  std::mt19937 random(5);
  for (const std::size_t count : {1u, 2u, 3u, 10u, 11u, 1000u}) {
    TenureMeasures some(1, 60.0);
    std::vector<double> lengths;
    int role = 0;
    double time = 0.0;
    some.decided(1, role, time, true);
    for (std::size_t i = 0; i < count; ++i) {
      lengths.push_back(0.02 * static_cast<double>(1 + random() % 4000));  // up to 80 s: longer than there is room for
      some.decided(1, ++role, time += lengths.back(), true);
    }
    EXPECT_NEAR(*some.result().median_seconds, statistics::quantile(lengths, 0.5), 1e-9) << count;
    EXPECT_NEAR(*some.result().tenth_seconds, statistics::quantile(lengths, 0.1), 1e-9) << count;
  }
}

}  // namespace
}  // namespace regista::match
