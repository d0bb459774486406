// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "page_soundness.hpp"
#include "report/tuning_report.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const TunedCourse& course) {
  Outline outline = tuning_outline(course.view());
  outline.fingerprint = "9f2c";
  return outline_page(outline, "weights.db", tuning_figures(course.view()));
}

std::vector<std::string> names_in_key(const Figure& figure) {
  std::vector<std::string> out;
  for (const Series& each : figure.chart.panels.at(0).series) {
    if (!each.name.empty()) out.push_back(each.name);
  }
  return out;
}

Figure figure_of(const TunedCourse& course, const std::string& name) {
  const std::vector<Figure> all = tuning_figures(course.view());
  const auto found = std::ranges::find(all, name, &Figure::name);
  return found == all.end() ? Figure{} : *found;
}

// A tuned team that forfeits a match of the search.
campaign::MatchResult with_a_forfeit(const study::TuningPlan& plan, const campaign::Job& job, const std::string& what) {
  return override_of(job, plan.parameters[0].path) > 5.5 ? campaign::forfeit({0, what, what, 3, 417, what}, 1.0)
                                                         : decided_by(plan, job, peak);
}

TEST(TuningPage, HasItsPartsInTheirOrder) {
  study::TuningPlan plan = tuning_plan();
  plan.program = "1.2.3";
  plan.asked.search.minutes = 5.0;
  const TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, "out of memory"); });
  const std::string page = page_of(course);
  EXPECT_THAT(ids(page), ElementsAre("played", "findings", "setup", "convergence", "values", "slices", "finalists",
                                     "trace", "failures", "base", "reproduction"));
  expect_sound(page);
  EXPECT_THAT(page, AllOf(HasSubstr("<h1 id=\"verdict\">The tuned team is better than the base team"),
                          HasSubstr("download=\"trace.csv\""), HasSubstr("out of memory"), HasSubstr("Regista 1.2.3"),
                          HasSubstr("9f2c"), HasSubstr("regista report weights.db --study again"),
                          HasSubstr("The search had a limit of wall time."), HasSubstr("document of spqr"),
                          HasSubstr("the team that is tuned"), HasSubstr("how much the distance counts")));
  EXPECT_EQ(count(page, "<svg "), 7u);
  EXPECT_EQ(page, page_of(course));
}

TEST(TuningPage, StoppedAnywhere) {
  const std::uint64_t all = TunedCourse(tuning_plan()).played;
  for (std::uint64_t most = 0; most < all; most += 61) {
    const std::string page = page_of(TunedCourse(tuning_plan(), peak, most));
    expect_sound(page);
    EXPECT_THAT(page, HasSubstr("Not at its end: "));
  }
}

TEST(TuningPage, NoNameGetsOutOfItsPlace) {
  const std::string hostile =
      "</title></style></pre><script>alert(1)</script>\"'><img src=x onerror=alert(1)>\n\u202e&#60;";
  const study::TuningPlan plan = tuning_plan();
  TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, hostile); });
  study::TuningPlan& shown = course.plan;
  shown.asked.name = shown.asked.question = shown.asked.team = shown.document = shown.folder = course.file = hostile;
  shown.settings = {hostile};
  for (study::Parameter& each : shown.parameters) each.path = each.unit = each.doc = hostile;
  for (study::TuningOpponent& each : shown.opponents) {
    each.label = each.file = hostile;
    for (campaign::Job& job : each.jobs) job.home_inputs = job.away_inputs = job.common_inputs = {{hostile, hostile}};
  }
  shown.objective.terms[0].measure = hostile;
  const std::string page = page_of(course);
  EXPECT_EQ(count(page, "<script"), 1u);  // ours
  for (const char* each : {"<img", "\u202e"}) EXPECT_EQ(count(page, each), 0u);
  EXPECT_EQ(count(page, "</title>"), 1u);
  EXPECT_EQ(count(page, "</style>"), 1u);
  EXPECT_EQ(count(page, "<section"), count(page, "</section>"));
  EXPECT_EQ(count(page, "<td"), count(page, "</td>"));
  for (const Figure& each : tuning_figures(course.view())) {
    EXPECT_THAT(each.title, Not(HasSubstr("\n")));
    EXPECT_THAT(each.csv, Not(HasSubstr("\"\"")));
  }
}

TEST(TuningFigures, TheirNamesAndTables) {
  const TunedCourse course(tuning_plan());
  const std::vector<Figure> figures = tuning_figures(course.view());
  std::vector<std::string> names;
  for (const Figure& each : figures) {
    names.push_back(each.name);
    EXPECT_TRUE(is_tuning_figure(each.name));
  }
  EXPECT_THAT(names,
              ElementsAre("verification", "convergence", "history_1", "history_2", "importance", "slice_1", "slice_2"));
  for (const char* each : {"roles", "slice_", "slice_x", "slice_1234", "convergence2", ""}) {
    EXPECT_FALSE(is_tuning_figure(each));
  }
  EXPECT_EQ(count(figures[1].csv, "\n"), course.record.trace.size() + 1);
  EXPECT_THAT(names_in_key(figures[1]),
              ElementsAre("an evaluation", "best so far", "tuned, verified", "base team, verified"));
  for (const std::size_t i : {5u, 6u}) {
    EXPECT_EQ(count(figures[i].csv, ",1\n"), 1u);  // the tuned point
    const bool bearing = figures[i].title == "weights.bearing";
    const Panel& panel = figures[i].chart.panels.at(0);
    EXPECT_EQ(panel.x.logarithmic, bearing);
    const auto base = std::ranges::find(panel.series, Join::dashes, &Series::join);
    ASSERT_NE(base, panel.series.end());
    for (const Point& each : base->points) EXPECT_EQ(each.x, bearing ? 1.0 : 5.0);  // the base team's
  }
  EXPECT_TRUE(tuning_figures(TunedCourse(tuning_plan(), peak, 0).view()).empty());
}

TEST(TuningFigures, AParameterIsDrawnOverItsEvaluations) {
  const TunedCourse course(tuning_plan());
  const std::vector<study::SearchStep>& trace = course.record.trace;
  const Figure figure = figure_of(course, "history_1");
  EXPECT_EQ(figure.title, course.plan.parameters[0].path);
  EXPECT_EQ(count(figure.csv, "\n"), trace.size() + 1);
  const std::vector<Series>& series = figure.chart.panels.at(0).series;
  const auto tried = std::ranges::find(series, "tried", &Series::name),
             best = std::ranges::find(series, "best so far", &Series::name);
  ASSERT_EQ(tried->points.size(), trace.size());
  for (std::size_t i = 0; i < trace.size(); ++i) EXPECT_EQ(tried->points[i].y, trace[i].values[0]);
  // The line ends at the value of the evaluation that the report names as the best.
  const auto leader = std::ranges::max_element(trace, {}, [](const auto& each) { return each.played.counted; });
  EXPECT_EQ(best->points.back().y, leader->values[0]);
  EXPECT_EQ(best->points.back().x, static_cast<double>(trace.size()));
}

TEST(TuningFigures, TheVerificationIsDrawnWithItsIntervals) {
  const TunedCourse course(tuning_plan());
  const Figure figure = figure_of(course, "verification");
  const std::vector<CandidateVerdict> verdicts = candidate_verdicts(course.view());
  ASSERT_FALSE(verdicts.empty());
  EXPECT_EQ(figure.chart.rows.size(), verdicts.size());
  EXPECT_THAT(figure.csv, HasSubstr(fmt::format("\n{},{},", verdicts[0].finalist + 1, verdicts[0].difference.value)));
  EXPECT_EQ(figure_of(course, "convergence").title, "The search and its verification");
  const TunedCourse searching(tuning_plan(), peak, 61);
  EXPECT_EQ(figure_of(searching, "verification").name, "");
  EXPECT_EQ(figure_of(searching, "convergence").title, "The search");
}

TEST(TuningFigures, LongSearchesAreThinned) {
  study::TuningPlan plan = tuning_plan();
  plan.search_pairs = 5000;
  plan.asked.slices.points = 0;
  const TunedCourse course(plan);
  ASSERT_GT(course.record.trace.size(), 4000u);
  const Figure figure = figure_of(course, "convergence");
  EXPECT_LE(count(figure.csv, "\n"), 1003u);
  EXPECT_THAT(figure.csv, HasSubstr(fmt::format("\n{},{},", course.record.trace.back().matches,
                                                course.record.trace.back().evaluation)));
}

TEST(TuningFigures, ForfeitsStandAtTheBottom) {
  const study::TuningPlan plan = tuning_plan();
  const TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, "x"); });
  ASSERT_TRUE(std::ranges::any_of(course.record.trace, [](const auto& each) { return each.played.failed; }));
  const Figure figure = figure_of(course, "convergence");
  EXPECT_THAT(names_in_key(figure), Contains("forfeited"));
  const Chart& chart = figure.chart;
  for (const Series& each : chart.panels.at(0).series) {
    if (each.name != "forfeited") continue;
    EXPECT_EQ(each.shape, Shape::cross);
    for (const Point& point : each.points) EXPECT_EQ(point.y, chart.y.range.value().low);
  }
  EXPECT_THAT(figure.csv, Not(HasSubstr(",-10,")));
}

}  // namespace
}  // namespace regista::report
