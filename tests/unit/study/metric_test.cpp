// SPDX-License-Identifier: MIT
#include "study/measure.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "match/side.hpp"

namespace regista::study {
namespace {

using match::Side;
using testing::ElementsAre;

const match::MetricNumbers metrics = campaign::metrics_from_json(R"({
  "roles": [{"goalkeeper": {"overlap_seconds": 0.5, "switches": 2, "robot_seconds": [1, 2]},
             "playing.striker": {"overlap_seconds": 1.25, "switches": 3},
             "striker": {"overlap_seconds": 4}},
            {"goalkeeper": {"overlap_seconds": 7}}],
  "packets": [12, 34],
  "packets_by_reason": [{"period": 10, "offer": 2}, {"period": 30}],
  "agreement": [0.75, null],
  "switches": [99, 98],
  "duration": 600.0,
  "budget_curve": [[1, 2, 3], []]
})");

TEST(Metric, NamesOfASide) {
  const auto names = [](Side side) {
    std::vector<std::string> out;
    for (const std::size_t place : metrics.names().of(side)) out.push_back(metrics.names().path(place));
    return out;
  };
  EXPECT_THAT(names(Side::home),
              ElementsAre("goalkeeper.overlap_seconds", "goalkeeper.switches", "playing.striker.overlap_seconds",
                          "playing.striker.switches", "striker.overlap_seconds", "packets", "packets_by_reason.period",
                          "packets_by_reason.offer", "agreement", "switches"));
  EXPECT_THAT(names(Side::away),
              ElementsAre("goalkeeper.overlap_seconds", "packets", "packets_by_reason.period", "agreement", "switches"))
      << "agreement has no number this time";
}

TEST(Metric, Values) {
  EXPECT_EQ(metrics.of_side(Side::home, "packets"), 12.0);
  EXPECT_EQ(metrics.of_side(Side::away, "packets"), 34.0);
  EXPECT_EQ(metrics.of_side(Side::home, "packets_by_reason.period"), 10.0);
  EXPECT_EQ(metrics.of_side(Side::home, "goalkeeper.overlap_seconds"), 0.5);
  EXPECT_EQ(metrics.of_side(Side::away, "goalkeeper.overlap_seconds"), 7.0);
  EXPECT_EQ(metrics.of_match("duration"), 600.0);
}

TEST(Metric, RolesMayBeNamedInFull) {
  EXPECT_EQ(metrics.of_side(Side::home, "roles.goalkeeper.overlap_seconds"), 0.5);
  EXPECT_EQ(metrics.of_side(Side::home, "roles.playing.striker.overlap_seconds"), 1.25);
  EXPECT_EQ(metrics.of_side(Side::home, "playing.striker.overlap_seconds"), 1.25);
  EXPECT_EQ(metrics.of_side(Side::home, "roles.overlap_seconds"), 5.75);
}

TEST(Metric, SumsOverAllRoles) {
  EXPECT_EQ(metrics.of_side(Side::home, "overlap_seconds"), 0.5 + 1.25 + 4.0);
  EXPECT_EQ(metrics.of_side(Side::away, "overlap_seconds"), 7.0);
  // A number of the team comes before a sum of the same name.
  EXPECT_EQ(metrics.of_side(Side::home, "switches"), 99.0);
}

TEST(Metric, WhatASideHasNot) {
  for (const char* path :
       {"", "roles", "goalkeeper", "packets_by_reason", "packets_by_reason.offers", "duration", "budget_curve",
        "budget_curve.1", "striker.switches", "robot_seconds", "goalkeeper.robot_seconds.1", "roles."}) {
    EXPECT_EQ(metrics.of_side(Side::home, path), std::nullopt) << path;
  }
  EXPECT_EQ(metrics.of_side(Side::away, "agreement"), std::nullopt);
  EXPECT_EQ(metrics.of_side(Side::away, "striker.overlap_seconds"), std::nullopt);
  EXPECT_EQ(metrics.of_match("packets"), std::nullopt);
  EXPECT_EQ(match::MetricNumbers().of_side(Side::home, "packets"), std::nullopt);
  EXPECT_EQ(campaign::metrics_from_json("{}").of_side(Side::home, "packets"), std::nullopt);
}

TEST(Metric, NamedValuesAreThoseOfTheirPaths) {
  const auto values = metric_values(metrics, 0);
  ASSERT_EQ(values.size(), 10u);
  for (const NamedValue& each : values) {
    EXPECT_EQ(metrics.of_side(Side::home, each.path), each.value) << each.path;
    EXPECT_NE(each.path, "overlap_seconds");
  }
  const auto all = all_metric_values(metrics, 0);
  ASSERT_EQ(all.size(), 11u);
  EXPECT_EQ(all.back().path, "overlap_seconds");
  EXPECT_EQ(all.back().value, 5.75);
}

}  // namespace
}  // namespace regista::study
