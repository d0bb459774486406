// SPDX-License-Identifier: MIT
#include "report/tuning_page.hpp"

#include <gmock/gmock.h>

#include "report/tuning_figures.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const TunedCourse& course, const std::string& why_not = "gnuplot is not installed") {
  std::vector<PageFigure> figures;
  for (Figure& each : tuning_figures(course.view())) figures.push_back({std::move(each), "", why_not});
  return tuning_page({course.view(), std::move(figures), "1.2.3", "9f2c", "regista tune x"});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

std::vector<std::string> ids(const std::string& page) {
  std::vector<std::string> out;
  constexpr std::string_view before = "<section id=\"";
  for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at + 1)) {
    const std::size_t begin = at + before.size();
    out.push_back(page.substr(begin, page.find('"', begin) - begin));
  }
  return out;
}

void expect_sound(const std::string& page) {
  EXPECT_TRUE(is_our_page(page.substr(0, page_beginning)));
  EXPECT_THAT(page, testing::EndsWith("</html>\n"));
  for (const char* each : {"section", "details", "table", "figure", "ul", "li", "header", "p", "pre", "tr"}) {
    EXPECT_EQ(count(page, std::string("<") + each + ">") + count(page, std::string("<") + each + " "),
              count(page, std::string("</") + each + ">"))
        << each;
  }
  for (const char* each : {"<script", "<link", "<img", "<iframe", "@import", "url(", "src=", "http:", "https:"}) {
    EXPECT_THAT(page, Not(HasSubstr(each)));
  }
}

study::TuningPlan comparison() {
  study::TuningPlan plan = tuning_plan();
  plan.compared = {study::Algorithm::random_search, study::Algorithm::spsa};
  plan.search_pairs = 24;
  plan.pairs = 2;
  plan.repeats = 3;
  plan.verification_pairs = 20;
  return plan;
}

// A tuned team that forfeits a match of the search.
campaign::Decided with_a_forfeit(const study::TuningPlan& plan, const campaign::Job& job, const std::string& what) {
  return override_of(job, plan.parameters[0].path) > 5.5 ? campaign::forfeit({0, what, what, 3, 417, what}, 1.0)
                                                         : decided_by(plan, job, peak);
}

TEST(TuningPage, HasItsPartsInTheirOrder) {
  const study::TuningPlan plan = tuning_plan();
  const TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, "out of memory"); });
  const std::string page = page_of(course);
  EXPECT_THAT(ids(page), ElementsAre("findings", "setup", "convergence", "values", "slices", "finalists", "trace",
                                     "failures", "reproduction"));
  expect_sound(page);
  EXPECT_THAT(page, AllOf(HasSubstr("<h1 id=\"verdict\">The tuned team is better than the base team"),
                          HasSubstr("download=\"trace.csv\""), HasSubstr("out of memory"), HasSubstr("Regista 1.2.3"),
                          HasSubstr("9f2c"), HasSubstr("regista tune x"), HasSubstr("document of spqr"),
                          HasSubstr("the team that is tuned"), HasSubstr("how much the distance counts")));
  EXPECT_EQ(count(page, "Here a figure is missing: gnuplot is not installed"), 4u);
  EXPECT_EQ(page, page_of(course));
}

TEST(TuningPage, OfAComparison) {
  const std::string page = page_of(TunedCourse(comparison()));
  EXPECT_THAT(ids(page), ElementsAre("findings", "algorithms", "setup", "reproduction"));
  expect_sound(page);
  EXPECT_THAT(page, AllOf(HasSubstr("<code>random_search</code>"), HasSubstr("download=\"runs.csv\"")));
}

TEST(TuningPage, StoppedAnywhere) {
  for (const study::TuningPlan& plan : {tuning_plan(), comparison()}) {
    const std::uint64_t all = TunedCourse(plan).played;
    for (std::uint64_t most = 0; most < all; most += 61) {
      const TunedCourse course(plan, peak, most);
      const std::string page = page_of(course);
      expect_sound(page);
      EXPECT_THAT(page, HasSubstr("Not at its end: "));
    }
  }
}

TEST(TuningPage, NoNameGetsOutOfItsPlace) {
  const std::string hostile =
      "</title></style></pre><script>alert(1)</script>\"'><img src=x onerror=alert(1)>\n\u202e&#60;";
  const study::TuningPlan plan = tuning_plan();
  TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, hostile); });
  study::TuningPlan& shown = course.plan;
  shown.name = shown.question = shown.team = shown.document = shown.folder = shown.file = course.file = hostile;
  shown.settings = {hostile};
  for (study::Parameter& each : shown.parameters) each.path = each.unit = each.doc = hostile;
  for (study::TuningOpponent& each : shown.opponents) {
    each.label = each.file = hostile;
    for (campaign::Job& job : each.jobs) job.home_inputs = job.away_inputs = job.common_inputs = {{hostile, hostile}};
  }
  shown.objective.terms[0].measure = hostile;
  const std::string page = page_of(course, hostile);
  for (const char* each : {"<script", "<img", "\u202e"}) EXPECT_EQ(count(page, each), 0u);
  EXPECT_EQ(count(page, "</title>"), 1u);
  EXPECT_EQ(count(page, "</style>"), 1u);
  EXPECT_EQ(count(page, "<section"), count(page, "</section>"));
  EXPECT_EQ(count(page, "<td"), count(page, "</td>"));
  // Nor do commands get into the scripts of figures.
  for (const Figure& each : tuning_figures(course.view())) {
    EXPECT_THAT(each.commands, Not(HasSubstr("'>")));
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
  EXPECT_THAT(names, ElementsAre("convergence", "importance", "slice_1", "slice_2"));
  for (const char* each : {"roles", "slice_", "slice_x", "slice_1234", "convergence2", ""}) {
    EXPECT_FALSE(is_tuning_figure(each));
  }
  EXPECT_EQ(count(figures[0].csv, "\n"), course.record.trace.size() + 1);
  EXPECT_THAT(figures[0].commands, AllOf(HasSubstr("'tuned, verified'"), HasSubstr("'base team, verified'")));
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_EQ(count(figures[i].csv, ",1\n"), 1u);  // the tuned point
    const bool bearing = figures[i].title == "weights.bearing";
    EXPECT_EQ(count(figures[i].commands, "set logscale x"), bearing ? 1u : 0u);
    EXPECT_THAT(figures[i].commands, HasSubstr(bearing ? "from first 1," : "from first 5,"));  // the base team's
  }
  const std::vector<Figure> compared = tuning_figures(TunedCourse(comparison()).view());
  ASSERT_EQ(compared.size(), 1u);
  EXPECT_EQ(compared[0].name, "algorithms");
  EXPECT_EQ(count(compared[0].csv, "\n"), 7u);
  EXPECT_TRUE(tuning_figures(TunedCourse(tuning_plan(), peak, 0).view()).empty());
}

TEST(TuningFigures, LongSearchesAreThinned) {
  study::TuningPlan plan = tuning_plan();
  plan.search_pairs = 5000;
  plan.slice_points = 0;
  const TunedCourse course(plan);
  ASSERT_GT(course.record.trace.size(), 4000u);
  const Figure figure = tuning_figures(course.view()).front();
  EXPECT_LE(count(figure.csv, "\n"), 1003u);
  EXPECT_THAT(figure.csv, HasSubstr(fmt::format("\n{},{},", course.record.trace.back().matches,
                                                course.record.trace.back().evaluation)));
}

TEST(TuningFigures, ForfeitsStandAtTheBottom) {
  const study::TuningPlan plan = tuning_plan();
  const TunedCourse course(plan, [&](const campaign::Job& job) { return with_a_forfeit(plan, job, "x"); });
  ASSERT_TRUE(std::ranges::any_of(course.record.trace, [](const auto& each) { return each.played.failed; }));
  const Figure figure = tuning_figures(course.view()).front();
  EXPECT_THAT(figure.commands, HasSubstr("'forfeited'"));
  EXPECT_THAT(figure.csv, Not(HasSubstr(",-10,")));
}

TEST(TuningArguments, TheWordsThatPlayItAgain) {
  study::TuningPlan plan = tuning_plan();
  plan.overrides = {"search.matches=100", "seed=4"};
  plan.limits.processor_seconds = 20;
  EXPECT_THAT(tuning_arguments(plan), ElementsAre("tune", "configs/studies/weights.yaml", "--set", "search.matches=100",
                                                  "--set", "seed=4", "--processor-seconds", "20", "--memory", "2048"));
  plan.overrides.clear();
  plan.compared = {study::Algorithm::spsa, study::Algorithm::sbplx};
  plan.repeats = 7;
  for (campaign::Job& job : plan.base.jobs) job.plugins = {"my plugins"};
  EXPECT_THAT(tuning_arguments(plan),
              ElementsAre("tune", "configs/studies/weights.yaml", "--compare", "spsa,sbplx", "--repeats", "7",
                          "--plugins", "my plugins", "--processor-seconds", "20", "--memory", "2048"));
}

}  // namespace
}  // namespace regista::report
