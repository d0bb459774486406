// SPDX-License-Identifier: MIT
// Numbers of plugins: how reports of several robots become one number of a match, and under which names it is found.
#include "match/metrics.hpp"

#include <gmock/gmock.h>

#include <regista/extensions/metric.h>

#include <optional>
#include <string>
#include <vector>

#include "match/metric_table.hpp"

namespace regista::match {
namespace {

using testing::Contains;
using testing::ElementsAre;

mind::MetricReport once(int metric, double value, int place = 0) {
  return {metric, place, 1, value, value, value, value};
}

const std::vector<mind::TeamMetric> all{{"a.sum", REGISTA_METRIC_SUM},
                                        {"a.mean", REGISTA_METRIC_MEAN},
                                        {"b.least", REGISTA_METRIC_LEAST},
                                        {"b.greatest", REGISTA_METRIC_GREATEST},
                                        {"b.over_time", REGISTA_METRIC_OVER_TIME}};

TEST(PluginMeasures, CombineWhatRobotsReport) {
  PluginMeasures measures(all, 3);
  const std::vector<mind::MetricReport> first{once(0, 2.0), once(1, 2.0), once(2, 2.0), once(3, 2.0)};
  const std::vector<mind::MetricReport> second{{0, 0, 3, 6.0, -1.0, 4.0, 3.0},
                                               {1, 0, 3, 6.0, -1.0, 4.0, 3.0},
                                               {2, 0, 3, 6.0, -1.0, 4.0, 3.0},
                                               {3, 0, 3, 6.0, -1.0, 4.0, 3.0}};
  measures.decided(1, first);
  measures.decided(3, second);
  const PluginMetrics out = measures.result();
  EXPECT_THAT(out.total_names, ElementsAre("a.sum"));
  EXPECT_THAT(out.totals, ElementsAre(8.0));
  EXPECT_THAT(out.value_names, ElementsAre("a.mean", "b.least", "b.greatest", "b.over_time"));
  EXPECT_THAT(out.values, ElementsAre(2.0, -1.0, 4.0, std::nullopt));
}

TEST(PluginMeasures, AStateHoldsUntilTheRobotReportsAgain) {
  PluginMeasures measures(all, 2);
  measures.sample();  // nobody has said anything
  measures.decided(1, std::vector{once(4, 1.0)});
  measures.sample();  // 1
  measures.decided(2, std::vector{once(4, 5.0)});
  measures.sample();  // 1 and 5
  measures.decided(1, {});
  measures.decided(1, std::vector{mind::MetricReport{4, 0, 2, 12.0, 3.0, 9.0, 3.0}});
  measures.sample();  // 3, the last that was said, and 5
  measures.crashed(2);
  measures.sample();  // 3
  EXPECT_EQ(measures.result().values[3], (1.0 + 1.0 + 5.0 + 3.0 + 5.0 + 3.0) / 6.0);
}

TEST(PluginMeasures, InstancesOfARobotHaveStatesOfTheirOwn) {
  PluginMeasures measures(all, 2);
  measures.decided(1, std::vector{once(4, 1.0, 0), once(4, 3.0, 7)});
  measures.sample();  // 1 and 3
  measures.decided(1, std::vector{once(4, 5.0, 7)});
  measures.sample();  // 1 and 5
  EXPECT_EQ(measures.result().values[3], (1.0 + 3.0 + 1.0 + 5.0) / 4.0);
}

TEST(PluginMeasures, WithoutAReportASumIsZeroAndTheRestIsMissing) {
  const PluginMetrics out = PluginMeasures(all, 2).result();
  EXPECT_THAT(out.totals, ElementsAre(0.0));
  EXPECT_THAT(out.values, testing::Each(std::nullopt));
}

TEST(PluginMeasures, StandInTheTableOfMetrics) {
  Result played;
  played.metrics.teams[0].plugins = {{"a.sum"}, {"a.mean", "a.switches"}, {8.0}, {2.5e-9, std::nullopt}};
  const MetricNumbers numbers = metric_numbers(metric_table(), {played}, {});
  EXPECT_EQ(numbers.of_side(Side::home, "plugin_totals.a.sum"), 8.0);
  EXPECT_EQ(numbers.of_side(Side::home, "plugin_values.a.mean"), 2.5e-9) << "not rounded";
  EXPECT_EQ(numbers.of_side(Side::home, "plugin_values.a.switches"), std::nullopt);
  EXPECT_EQ(numbers.of_side(Side::away, "plugin_totals.a.sum"), std::nullopt);
  MemberNames team;
  team.plugin_totals = {"a.sum"};
  team.plugin_values = {"a.mean", "a.switches"};
  const std::vector<std::string> paths = metric_paths(metric_table(), team);
  for (const char* const each : {"plugin_totals.a.sum", "plugin_values.a.mean"}) EXPECT_THAT(paths, Contains(each));
  EXPECT_EQ(find_metric(metric_table(), "plugin_totals.a.sum")->total, MetricRow::Total::sum);
  EXPECT_EQ(find_metric(metric_table(), "plugin_values.a.switches")->name, "plugin_values")
      << "though a number of roles is called so";
}

}  // namespace
}  // namespace regista::match
