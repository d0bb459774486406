// SPDX-License-Identifier: MIT
// Every measure that an experiment names is seen in a figure as wide as the page.
#include "report/experiment_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/gnuplot.hpp"
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
  EXPECT_THAT(names(figures(measuring(3, 1, {"goals", "packets", "points"}))),
              ElementsAre("measure_2", "measure_1", "measure_3"));
  EXPECT_THAT(names(figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))),
              ElementsAre("measure_2", "roles"));
  EXPECT_THAT(names(figures(measuring(2, 3, {"striker.overlap_seconds", "packets"}))),
              ElementsAre("sweep_2", "sweep_1"));
  for (const Figure& each : figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))) {
    EXPECT_GT(each.width, 1100) << each.name;
    EXPECT_TRUE(is_experiment_figure(each.name));
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
  EXPECT_THAT(drawn[0].commands, HasSubstr("'packets'.', per match'"));
}

TEST(ExperimentFigures, PanelsOfRolesAreThoseThatMeasuresName) {
  const Figure figure = figures(measuring(2, 1, {"striker.overlap_seconds", "packets"}))[1];
  EXPECT_EQ(figure.title, "Overlap by role");
  EXPECT_THAT(figure.csv, AllOf(StartsWith("role,arm 0 overlap_seconds,"), Not(HasSubstr("switches"))));
}

config::Node text(const char* value) { return config::Node::scalar(value, false, {}); }

TEST(ExperimentFigures, ValuesThatAreNoNumbersHaveRows) {
  ExperimentPlan plan = measuring(2, 2, {"packets"});
  EXPECT_THAT(figures(plan)[0].commands, HasSubstr("filledcurves"));
  plan.asked.sweep->values = {text("a long name of a value that would not fit beside others"), text("b")};
  const Figure figure = figures(plan)[0];
  EXPECT_THAT(figure.commands, AllOf(HasSubstr("set ytics scale 0 ('\"a long"), Not(HasSubstr("filledcurves"))));
  EXPECT_THAT(figure.csv, HasSubstr("\n1,b,"));
}

TEST(ExperimentFigures, GnuplotDrawsThem) {
  ExperimentPlan rows = measuring(3, 2, {"packets"});
  rows.asked.sweep->values = {text("a"), text("b")};
  for (const ExperimentPlan& plan :
       {measuring(3, 1, {"packets", "goals", "striker.switches", "striker.overlap_seconds"}),
        measuring(9, 3, {"packets"}), rows}) {
    for (const Figure& each : figures(plan)) {
      const Drawing drawing = draw(each, Png::left_out);
      if (drawing.no_gnuplot) GTEST_SKIP() << "gnuplot is not installed";
      EXPECT_EQ(drawing.why_not, "") << each.name;
      EXPECT_THAT(drawing.svg, HasSubstr("arm 0")) << each.name;
    }
  }
}

}  // namespace
}  // namespace regista::report
