// SPDX-License-Identifier: MIT
#include "match/metric_table.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace regista::match {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

const std::vector<std::string> roles{"goalkeeper", "playing.striker"};

Result result() {
  Result out;
  out.score = {3, 1};
  out.packets = {40, 50};
  for (TeamMetrics& team : out.metrics.teams) team.coordination.roles.resize(roles.size());
  out.metrics.teams[0].coordination.roles[1].all.overlap_seconds = 0.1 * 3;
  out.metrics.teams[0].coordination.roles[0].robot_seconds = {1.0, 2.0};
  out.metrics.teams[1].packets_by_reason[0] = 7;
  out.metrics.playing_seconds = 600.0;
  return out;
}

TEST(MetricTable, EveryRowSaysWhatItIs) {
  std::set<std::string> patterns;
  for (const MetricRow& row : metric_table()) {
    EXPECT_TRUE(patterns.insert(row.pattern()).second) << row.pattern();
    EXPECT_THAT(metric_parts, Contains(row.part)) << row.pattern();
    EXPECT_NE(row.meaning, "") << row.pattern();
    EXPECT_EQ(row.name.ends_with("_seconds"), row.unit == "s") << row.pattern() << ": " << row.unit;
    EXPECT_EQ(row.name.ends_with("_metres"), row.unit == "m") << row.pattern() << ": " << row.unit;
    EXPECT_LE(row.name.ends_with("_share"), row.unit == "share" || row.unit == "packets") << row.pattern();
  }
}

TEST(MetricTable, EveryPathIsThatOfItsRow) {
  const std::vector<std::string> paths = metric_paths(metric_table(), {roles});
  EXPECT_EQ(std::set<std::string>(paths.begin(), paths.end()).size(), paths.size());
  for (const std::string& path : paths) EXPECT_NE(find_metric(metric_table(), path), nullptr) << path;
  EXPECT_THAT(paths, Contains("playing.striker.overlap_seconds"));
  EXPECT_THAT(paths, Contains("overlap_seconds"));
  EXPECT_THAT(paths, Contains("packets_by_reason.whistle"));
  EXPECT_THAT(paths, Not(Contains("budget_curve")));
  EXPECT_THAT(paths, Not(Contains("playing_seconds")));
  EXPECT_EQ(find_metric(metric_table(), "roles.goalkeeper.switches")->name, "switches");
  EXPECT_EQ(find_metric(metric_table(), "rates.switches_per_minute")->name, "rates.switches_per_minute");
  EXPECT_EQ(find_metric(metric_table(), "goals"), nullptr);
  EXPECT_EQ(find_metric(metric_table(), "goalkeeperswitches"), nullptr);
}

TEST(MetricTable, PathsAreThoseThatMatchesHave) {
  const Result played = result();
  const MetricNumbers numbers = metric_numbers(metric_table(), {played}, {roles, roles});
  std::vector<std::string> of_match;
  for (const std::size_t place : numbers.names().of(Side::away)) of_match.push_back(numbers.names().path(place));
  for (const MetricNames::Sum& sum : numbers.names().sums(Side::away)) of_match.push_back(sum.name);
  std::vector<std::string> told = metric_paths(metric_table(), {roles});
  std::ranges::sort(of_match);
  std::ranges::sort(told);
  EXPECT_EQ(of_match, told);
}

TEST(MetricTable, NumbersOfAMatch) {
  const Result played = result();
  const MetricNumbers numbers = metric_numbers(metric_table(), {played, 30.25}, {roles, roles});
  EXPECT_EQ(numbers.of_side(Side::home, "score"), 3.0);
  EXPECT_EQ(numbers.of_side(Side::away, "packets"), 50.0);
  EXPECT_EQ(numbers.of_side(Side::home, "packets_share"), 30.25);
  EXPECT_EQ(numbers.of_side(Side::home, "packets_over_share"), 9.75);
  EXPECT_EQ(numbers.of_side(Side::home, "playing.striker.overlap_seconds"), 0.3) << "to the sixth decimal";
  EXPECT_EQ(numbers.of_side(Side::home, "overlap_seconds"), 0.3);
  EXPECT_EQ(numbers.of_side(Side::home, "rates.overlap_seconds_per_minute"), 0.03);
  EXPECT_EQ(numbers.of_side(Side::home, "agreement"), std::nullopt);
  EXPECT_EQ(numbers.of_match("playing_seconds"), 600.0);
  const MetricNumbers of_whole = metric_numbers(metric_table(), {played}, {roles, roles});
  EXPECT_EQ(of_whole.of_side(Side::home, "packets_share"), std::nullopt);
  EXPECT_EQ(of_whole.names(), numbers.names());
  EXPECT_FALSE(of_whole == numbers);
  EXPECT_TRUE(of_whole == metric_numbers(metric_table(), {played}, {roles, roles}));
}

TEST(MetricTable, NamesMayNotStandThereTwice) {
  EXPECT_THROW(MetricNames({{.side = Side::home, .name = "a"}, {.side = Side::home, .name = "a"}}),
               std::invalid_argument);
  EXPECT_EQ(MetricNames({{.side = Side::home, .name = "a"}, {.side = Side::away, .name = "a"}}).size(), 2u);
}

}  // namespace
}  // namespace regista::match
