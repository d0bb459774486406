// SPDX-License-Identifier: MIT
// Every measure that an experiment names is seen in a figure as wide as the page.
#include "report/experiment_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/metric_reference.hpp"
#include "unit/study/experiment_fixture.hpp"

namespace regista::report {
namespace {

using study::ExperimentPlan;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<Figure> figures(const ExperimentPlan& plan) {
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial each = trial(plan, index);
    const int more = static_cast<int>(each.condition + each.pair % 2);
    course.take(study::played(each.side, 10.0 * more, 100 + more, more, 0));
  }
  return experiment_figures({plan, course, [](std::uint64_t) { return std::string(); }});
}

std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> out;
  for (const Figure& each : figures) out.push_back(each.name);
  return out;
}

ExperimentPlan measuring(std::size_t arms, std::size_t values, std::vector<std::string> measures) {
  ExperimentPlan plan = study::experiment_of(arms, values, 4);
  plan.measures = std::move(measures);
  plan.asked.primary->measure = "packets";
  return plan;
}

TEST(ExperimentFigures, OneForEachMeasureThePrimaryOneFirst) {
  EXPECT_THAT(names(figures(measuring(3, 1, {"goals", "packets", "points"}))), ElementsAre("measure_2", "measures_1"));
  EXPECT_THAT(names(figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))),
              ElementsAre("measure_2", "roles"));
  EXPECT_THAT(names(figures(measuring(2, 3, {"striker.overlap_seconds", "packets"}))),
              ElementsAre("sweep_2", "sweep_1"));
  for (const Figure& each : figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))) {
    EXPECT_EQ(each.chart.width, page_width) << each.name;
    EXPECT_TRUE(is_experiment_figure(each.name));
  }
  // A page asks for them by these names.
  for (const ExperimentPlan& plan : {measuring(3, 1, {"packets", "goals", "points"}),
                                     measuring(2, 3, {"packets", "goals", "striker.overlap_seconds"})}) {
    EXPECT_THAT(names_of_experiment_figures(plan), testing::IsSupersetOf(names(figures(plan))));
  }
  for (const char* other : {"measure_", "measure_x", "measure_1234", "measure", "convergence"}) {
    EXPECT_FALSE(is_experiment_figure(other)) << other;
  }
}

TEST(ExperimentFigures, ArmsHaveTheirMeansAndIntervals) {
  const std::vector<Figure> drawn = figures(measuring(2, 1, {"packets", "agreement"}));
  ASSERT_THAT(names(drawn), ElementsAre("measure_1"));  // nobody has a value of the other one
  // Pairs have 100, 101, 100, 101 and one more: Student's t of three degrees of freedom is 3.1824.
  EXPECT_THAT(drawn[0].csv, AllOf(StartsWith("arm,mean,low,high\narm 0,100.5,99.58"), HasSubstr(",101.41"),
                                  HasSubstr("\narm 1,101.5,100.58")));
  EXPECT_THAT(drawn[0].description, HasSubstr("95 %"));
  EXPECT_EQ(drawn[0].chart.panels.at(0).x.title, "packets, per match");
  EXPECT_THAT(drawn[0].chart.rows, ElementsAre("arm 0", "arm 1"));
}

// Three strips beside each other at most, as many in each figure as in the others.
TEST(ExperimentFigures, OtherMeasuresStandBesideEachOther) {
  const std::vector<Figure> drawn = figures(
      measuring(2, 1, {"goals", "packets", "points", "goal_difference", "striker.unplayed_seconds", "agreement"}));
  ASSERT_THAT(names(drawn), ElementsAre("measure_2", "measures_1"));
  const Figure& others = drawn[1];
  ASSERT_EQ(others.chart.panels.size(), 3u);
  EXPECT_EQ(others.chart.panels[0].x.title, "goals, per match");
  EXPECT_THAT(others.csv, StartsWith("arm,goals mean,goals low,goals high,points mean,"));
  EXPECT_EQ(others.title, "Goals; points; goal difference");
}

TEST(ExperimentFigures, WhatIsZeroOrMissingIsNotDrawn) {
  // Nobody scores against the arms, and no match has the last one.
  const ExperimentPlan plan = measuring(2, 1, {"packets", "goals_against", "agreement"});
  EXPECT_THAT(names(figures(plan)), ElementsAre("measure_1"));
  EXPECT_THAT(names(figures(measuring(2, 2, {"packets", "goals_against"}))), ElementsAre("sweep_1"));
}

TEST(ExperimentFigures, AxesHaveTheWordsOfPeople) {
  EXPECT_EQ(measure_axis("striker.overlap_seconds"), "striker held twice, minutes of 60");
  EXPECT_EQ(measure_axis("playing.wing_left.uncovered_seconds"), "wing left held by nobody, minutes of 60");
  EXPECT_EQ(measure_axis("overlap_seconds"), "roles held twice, minutes of 60");
  EXPECT_EQ(measure_axis("switches_after_silence"), "changes of role after the silence, per match");
  EXPECT_EQ(measure_axis("goal_difference"), "goal difference, per match");
  EXPECT_EQ(measure_axis("agreement"), "agreement of all robots on the assignment, share of time");
  EXPECT_EQ(measure_axis("packets"), "packets, per match");
  EXPECT_EQ(measure_axis("plugin_totals.x.crossings"), "plugin totals.x.crossings, per match");
}

TEST(ExperimentFigures, PanelsOfRolesAreThoseThatMeasuresName) {
  const Figure figure = figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))[1];
  EXPECT_EQ(figure.title, "Roles: held twice");
  EXPECT_THAT(figure.csv, AllOf(StartsWith("role,arm 0 overlap_seconds,"), Not(HasSubstr("switches"))));
}

config::Node text(const char* value) { return config::Node::scalar(value, false, {}); }

TEST(ExperimentFigures, ValuesThatAreNoNumbersHaveRows) {
  ExperimentPlan plan = measuring(2, 2, {"packets"});
  EXPECT_EQ(figures(plan)[0].chart.panels.at(0).series.at(0).interval, Interval::band);
  plan.asked.sweep->values = {text("a long name of a value that would not fit beside others"), text("b")};
  const Figure figure = figures(plan)[0];
  EXPECT_THAT(figure.chart.rows, ElementsAre("\"a long name of a value that would not fit beside others\"", "b"));
  EXPECT_EQ(figure.chart.panels.at(0).series.at(0).interval, Interval::whiskers);
  EXPECT_THAT(figure.csv, HasSubstr("\n1,b,"));
}

TEST(ExperimentFigures, TheirPicturesNameEveryArm) {
  ExperimentPlan rows = measuring(3, 2, {"packets"});
  rows.asked.sweep->values = {text("a"), text("b")};
  for (const ExperimentPlan& plan :
       {measuring(3, 1, {"packets", "goals", "striker.switches", "striker.overlap_seconds"}),
        measuring(9, 3, {"packets"}), rows}) {
    for (const Figure& each : figures(plan)) {
      for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
        EXPECT_THAT(svg(each, Medium::page).str(), HasSubstr(fmt::format(">arm {}</text>", arm))) << each.name;
      }
    }
  }
}

// What the table says is what is drawn: the first arm's mean and its interval.
TEST(ExperimentFigures, TheChartHasTheNumbersOfItsTable) {
  for (const ExperimentPlan& plan : {measuring(2, 1, {"packets"}), measuring(2, 3, {"packets"})}) {
    const Figure figure = figures(plan)[0];
    const Point point = figure.chart.panels.at(0).series.at(0).points.at(0);
    const double mean = figure.chart.rows.empty() ? point.y : point.x;
    EXPECT_THAT(figure.csv, HasSubstr(fmt::format(",{},{},{}", mean, point.low, point.high)));
    EXPECT_LT(point.low, mean);
    EXPECT_LT(mean, point.high);
  }
}

}  // namespace
}  // namespace regista::report
