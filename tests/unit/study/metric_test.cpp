// SPDX-License-Identifier: MIT
#include "study/metric.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace regista::study {
namespace {

using testing::ElementsAre;

constexpr auto metrics = R"({
  "roles": [{"goalkeeper": {"overlap_seconds": 0.5, "switches": 2},
             "playing.striker": {"overlap_seconds": 1.25, "switches": 3, "note": "text"},
             "striker": {"overlap_seconds": 4}},
            {"goalkeeper": {"overlap_seconds": 7}}],
  "packets": [12, 34],
  "packets_by_reason": [{"period": 10, "offer": 2}, {"period": 30}],
  "agreement": [0.75, null],
  "switches": [99, 98],
  "duration": 600.0,
  "three": [1, 2, 3],
  "names": ["a", "b"]
})";

TEST(Metric, PathsOfASide) {
  EXPECT_THAT(metric_paths(metrics, 0),
              ElementsAre("goalkeeper.overlap_seconds", "goalkeeper.switches", "playing.striker.overlap_seconds",
                          "playing.striker.switches", "striker.overlap_seconds", "packets", "packets_by_reason.period",
                          "packets_by_reason.offer", "agreement", "switches", "overlap_seconds"));
  EXPECT_THAT(metric_paths(metrics, 1), ElementsAre("goalkeeper.overlap_seconds", "packets", "packets_by_reason.period",
                                                    "agreement", "switches", "overlap_seconds"))
      << "agreement has no number this time";
  EXPECT_THAT(metric_names(metrics, 1), ElementsAre("goalkeeper.overlap_seconds", "packets", "packets_by_reason.period",
                                                    "agreement", "switches"));
}

TEST(Metric, Values) {
  EXPECT_EQ(metric(metrics, 0, "packets"), 12.0);
  EXPECT_EQ(metric(metrics, 1, "packets"), 34.0);
  EXPECT_EQ(metric(metrics, 0, "packets_by_reason.period"), 10.0);
  EXPECT_EQ(metric(metrics, 0, "goalkeeper.overlap_seconds"), 0.5);
  EXPECT_EQ(metric(metrics, 1, "goalkeeper.overlap_seconds"), 7.0);
}

TEST(Metric, RolesMayBeNamedInFull) {
  EXPECT_EQ(metric(metrics, 0, "roles.goalkeeper.overlap_seconds"), 0.5);
  EXPECT_EQ(metric(metrics, 0, "roles.playing.striker.overlap_seconds"), 1.25);
  EXPECT_EQ(metric(metrics, 0, "playing.striker.overlap_seconds"), 1.25);
  EXPECT_EQ(metric(metrics, 0, "roles.overlap_seconds"), 5.75);
}

TEST(Metric, SumsOverAllRoles) {
  EXPECT_EQ(metric(metrics, 0, "overlap_seconds"), 0.5 + 1.25 + 4.0);
  EXPECT_EQ(metric(metrics, 1, "overlap_seconds"), 7.0);
  EXPECT_EQ(metric(metrics, 0, "note"), std::nullopt);
  // A number of the match comes before a sum of the same name.
  EXPECT_EQ(metric(metrics, 0, "switches"), 99.0);
}

TEST(Metric, WhatASideHasNot) {
  for (const char* path : {"", "roles", "goalkeeper", "packets_by_reason", "packets_by_reason.offers", "duration",
                           "three", "names", "striker.switches", "roles."}) {
    EXPECT_EQ(metric(metrics, 0, path), std::nullopt) << path;
  }
  EXPECT_EQ(metric(metrics, 1, "agreement"), std::nullopt);
  EXPECT_EQ(metric(metrics, 1, "striker.overlap_seconds"), std::nullopt);
  EXPECT_EQ(metric("{}", 0, "packets"), std::nullopt);
  EXPECT_EQ(metric("[]", 0, "packets"), std::nullopt);
}

TEST(Metric, NamedValuesAreThoseOfTheirPathsWithoutSums) {
  const auto values = metric_values(metrics, 0);
  ASSERT_EQ(values.size(), 10u);
  for (const NamedValue& each : values) {
    EXPECT_EQ(metric(metrics, 0, each.path), each.value) << each.path;
    EXPECT_NE(each.path, "overlap_seconds");
  }
}

TEST(Metric, RefusesWhatIsNoJson) {
  for (const char* text : {"", "{", "nonsense"}) {
    EXPECT_THROW(metric(text, 0, "packets"), std::invalid_argument) << text;
    EXPECT_THROW(metric_values(text, 0), std::invalid_argument) << text;
    EXPECT_THROW(metric_paths(text, 0), std::invalid_argument) << text;
    EXPECT_THROW(metric_names(text, 0), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace regista::study
