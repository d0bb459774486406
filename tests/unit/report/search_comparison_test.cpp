// SPDX-License-Identifier: MIT
// What is said of a comparison of search algorithms: text, JSON, table, figure and page.
#include "report/search_comparison.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "config/json.hpp"
#include "page_soundness.hpp"
#include "report/search_comparison_figures.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/search_comparison_page.hpp"
#include "report/search_comparison_report.hpp"
#include "report/search_comparison_sentences.hpp"
#include "report/tuning_figures.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

study::SearchComparisonPlan comparison() {
  study::SearchComparisonPlan plan{tuning_plan(), {study::Algorithm::random_search, study::Algorithm::spsa}, 5};
  plan.tuning.search_pairs = 24;
  plan.tuning.pairs = 2;
  plan.tuning.verification_pairs = 20;
  plan.tuning.slice_points = 0;
  return plan;
}

struct ComparedCourse {
  explicit ComparedCourse(study::SearchComparisonPlan asked = comparison(), const Quality& quality = peak,
                          std::uint64_t most = ~std::uint64_t{0})
      : plan(std::move(asked)), record(plan) {
    run([&](const campaign::Job& job) { return decided_by(plan.tuning, job, quality); }, most);
  }
  ComparedCourse(study::SearchComparisonPlan asked, const Decide& decide) : plan(std::move(asked)), record(plan) {
    run(decide, ~std::uint64_t{0});
  }
  ComparedCourse(const ComparedCourse&) = delete;
  ComparedCourse& operator=(const ComparedCourse&) = delete;

  SearchComparisonView view() const { return {plan, record}; }

  study::SearchComparisonPlan plan;
  study::SearchComparisonRecord record;
  std::uint64_t played = 0;
  std::string standings;  // before each match

 private:
  void run(const Decide& decide, std::uint64_t most) {
    const Decide noted = [&](const campaign::Job& job) {
      standings += search_comparison_standing(view());
      return decide(job);
    };
    try {
      compare_searches(plan, played_by(noted, played, most), record);
    } catch (const Stopped&) {
    }
  }
};

std::string page_of(const ComparedCourse& course, const std::string& why_not = "gnuplot is not installed") {
  std::vector<PageFigure> figures;
  for (Figure& each : search_comparison_figures(course.view())) figures.push_back({std::move(each), "", why_not});
  return search_comparison_page({course.view(), std::move(figures), {"1.2.3", "9f2c", "regista tune x"}});
}

TEST(SearchComparisonText, IsOrderedByMediansAndSaysThatItIsNoTest) {
  const ComparedCourse course;
  const std::vector<AlgorithmSummary> of = algorithm_summaries(course.view());
  ASSERT_EQ(of.size(), 2u);
  const bool first = of[0].difference->median >= of[1].difference->median;
  EXPECT_THAT(
      search_comparison_text(course.view()),
      AllOf(HasSubstr("weights: 2 parameters of base.yaml, goal_difference as large as possible, by 2 algorithms\n"),
            HasSubstr(first ? "from the base team: random_search +" : "from the base team: spsa +"),
            HasSubstr("Nothing was tested.\n"), HasSubstr("All had the same budget, 96 matches"),
            HasSubstr(fmt::format("{} of 5", of[0].better)), HasSubstr("same 20 pairs"),
            HasSubstr("Compared: random_search (2 pairs for each evaluation), spsa (1 pair for each evaluation); "
                      "5 runs of each, seeds from 3."),
            HasSubstr("weights.distance      5  0 to 10 m  linear"), Not(HasSubstr("Not at its end")),
            Not(HasSubstr("selection")), Not(HasSubstr("Forfeits"))));
}

TEST(SearchComparisonText, AlgorithmsThatCameToTheSameAreEqual) {
  const ComparedCourse course(comparison(), [](double, double) { return 0.3; });
  EXPECT_THAT(search_comparison_text(course.view()), HasSubstr("from the base team: random_search +0.00, spsa +0.00."));
}

// Of a minimised objective the least median is the first, and is told with the user's sign.
TEST(SearchComparisonText, AMinimisedObjectiveHasTheUsersSign) {
  study::SearchComparisonPlan plan = comparison();
  plan.tuning.objective = {{{"striker.overlap_seconds", 1.0}}, true};
  const ComparedCourse course(plan);
  const std::vector<AlgorithmSummary> of = algorithm_summaries(course.view());
  const bool first = of[0].difference->median <= of[1].difference->median;
  EXPECT_THAT(search_comparison_text(course.view()),
              AllOf(HasSubstr(first ? "from the base team: random_search" : "from the base team: spsa"),
                    HasSubstr("the smaller the better")));
  for (const AlgorithmSummary& each : of) {
    std::size_t better = 0;
    for (const study::ComparedRun* const run : each.runs) better += run->judged.mean > 0.0 ? 1 : 0;
    EXPECT_EQ(each.better, better);
  }
}

TEST(SearchComparisonText, ForfeitsAreTold) {
  const study::SearchComparisonPlan plan = comparison();
  const ComparedCourse course(plan, [&](const campaign::Job& job) {
    return override_of(job, "weights.distance") > 8.0
               ? campaign::forfeit(
                     {job.overrides.front().starts_with("home.") ? 0 : 1, "greedy", "assign", 3, 417, "out of memory"},
                     1.0)
               : decided_by(plan.tuning, job, peak);
  });
  EXPECT_THAT(search_comparison_text(course.view()),
              HasSubstr("forfeited by the team that is tuned: plugin greedy, assign: out of memory"));
  EXPECT_THAT(ids(page_of(course)), ElementsAre("findings", "algorithms", "setup", "failures", "reproduction"));
}

// Stopped by Ctrl-C at any place: everything can be told, is told the same way twice, and says that it is not its end.
TEST(SearchComparisonText, StoppedAnywhere) {
  const std::uint64_t all = ComparedCourse().played;
  std::set<study::TuningStage> seen;
  for (std::uint64_t most = 0; most < all; most += most < 8 ? 1 : 61) {
    const ComparedCourse course(comparison(), peak, most);
    ASSERT_TRUE(course.record.stage.has_value());
    seen.insert(*course.record.stage);
    const std::string text = search_comparison_text(course.view());
    EXPECT_THAT(text, HasSubstr("Not at its end: "));
    EXPECT_EQ(text, search_comparison_text(course.view()));
    EXPECT_EQ(Json::parse(search_comparison_json(course.view()))["complete"], false);
    const std::string page = page_of(course);
    expect_sound(page);
    EXPECT_THAT(page, HasSubstr("Not at its end: "));
    EXPECT_TRUE(search_comparison_figures(course.view()).empty());
  }
  EXPECT_EQ(seen.size(), 2u);
}

TEST(SearchComparisonStanding, ShowsWhereItIs) {
  const ComparedCourse course;
  EXPECT_THAT(course.standings, AllOf(HasSubstr("by 2 algorithms\nrun 1 of 10; matches asked for: 8 of at most 1840\n"),
                                      HasSubstr("run 2 of 10"), HasSubstr("last: random_search, run 1: "),
                                      HasSubstr("in its search (optimistic)"), HasSubstr("last: spsa, run 5: "),
                                      HasSubstr("judging the runs; matches asked for: ")));
  EXPECT_THAT(search_comparison_standing(course.view()), HasSubstr("all is done"));
}

// Of five runs the quartiles are the second, third and fourth in order.
TEST(SearchComparisonJson, Quartiles) {
  const ComparedCourse course;
  const std::string text = search_comparison_json(course.view());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  const Json json = Json::parse(text);
  EXPECT_EQ(json["tuning"], "weights");
  EXPECT_EQ(json["complete"], true);
  EXPECT_TRUE(json["stage"].is_null());
  EXPECT_TRUE(json["algorithm"].is_null());
  EXPECT_TRUE(json["tuned_file"].is_null());
  EXPECT_FALSE(json.contains("tuned"));
  ASSERT_EQ(json["compared"].size(), 2u);
  for (const Json& each : json["compared"]) {
    std::vector<double> judged;
    std::size_t better = 0;
    for (const Json& run : each["runs"]) {
      judged.push_back(run["judged"]["mean"]);
      if (judged.back() > 0.0) ++better;
      EXPECT_LE(run["matches"].get<std::uint64_t>(), 96u);
    }
    ASSERT_EQ(judged.size(), 5u);
    std::ranges::sort(judged);
    EXPECT_EQ(each["difference_quartiles"], (Json{judged[1], judged[2], judged[3]}));
    EXPECT_EQ(each["better"], better);
  }
  EXPECT_EQ(json["matches"]["search"].get<std::uint64_t>() + json["matches"]["verification"].get<std::uint64_t>(),
            course.played);
}

TEST(SearchComparisonCsv, ALineForARun) {
  const ComparedCourse course;
  std::istringstream lines(search_comparison_csv(course.view()));
  std::vector<std::vector<std::string>> table;
  for (std::string line; std::getline(lines, line);) {
    table.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) table.back().push_back(field);
  }
  ASSERT_EQ(table.size(), 11u);
  EXPECT_THAT(table[0], ElementsAre("algorithm", "repeat", "evaluations", "matches", "weights.distance",
                                    "weights.bearing", "seen", "judged", "standard_error", "pairs", "ended"));
  EXPECT_EQ(table[1][0], "random_search");
  EXPECT_EQ(table[1][1], "1");
  EXPECT_EQ(table[10][0], "spsa");
  EXPECT_EQ(table[10][1], "5");
  EXPECT_EQ(std::strtod(table[1][7].c_str(), nullptr), course.record.runs[0].judged.mean);
}

TEST(SearchComparisonPage, HasItsPartsInTheirOrder) {
  const std::string page = page_of(ComparedCourse());
  EXPECT_THAT(ids(page), ElementsAre("findings", "algorithms", "setup", "reproduction"));
  expect_sound(page);
  EXPECT_THAT(page, AllOf(HasSubstr("<code>random_search</code>"), HasSubstr("download=\"runs.csv\""),
                          HasSubstr("Regista 1.2.3"), HasSubstr("9f2c"), HasSubstr("regista tune x"),
                          HasSubstr("how much the distance counts")));
}

TEST(SearchComparisonPage, NoNameGetsOutOfItsPlace) {
  const std::string hostile = "</title></style><script>alert(1)</script>\"'><img src=x>\n\u202e&#60;";
  ComparedCourse course;
  study::TuningPlan& shown = course.plan.tuning;
  shown.name = shown.question = shown.team = shown.document = shown.folder = hostile;
  for (study::Parameter& each : shown.parameters) each.path = each.unit = each.doc = hostile;
  for (study::TuningOpponent& each : shown.opponents) each.label = each.file = hostile;
  for (study::ComparedRun& each : course.record.runs) each.ended = hostile;
  const std::string page = page_of(course, hostile);
  for (const char* each : {"<script", "<img", "\u202e"}) EXPECT_EQ(count(page, each), 0u);
  EXPECT_EQ(count(page, "<td"), count(page, "</td>"));
}

TEST(SearchComparisonFigures, ARowForARun) {
  const ComparedCourse course;
  const std::vector<Figure> figures = search_comparison_figures(course.view());
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_TRUE(is_search_comparison_figure(figures[0].name));
  EXPECT_FALSE(is_tuning_figure(figures[0].name));
  EXPECT_EQ(count(figures[0].csv, "\n"), 11u);
  for (const char* each : {"", "algorithm", "convergence"}) EXPECT_FALSE(is_search_comparison_figure(each));
}

TEST(SearchComparisonReport, SaysTheSameAsItsParts) {
  const ComparedCourse course;
  const auto report = search_comparison_report(comparison());
  EXPECT_THAT(report->incomplete(), HasSubstr("0 matches: the comparison is not at its end"));
  std::string first;
  report->study().run([&](const study::Round& round) {
    for (std::uint64_t i = 0; i < round.matches; ++i) {
      const campaign::Decided decided = decided_by(course.plan.tuning, round.job(i), peak);
      if (first.empty()) first = report->match(round, i, decided);
      const bool more = round.take(i, &decided);
      report->take(round, i, &decided);
      if (!more) return;
    }
  });
  EXPECT_THAT(first, testing::StartsWith("search, seed 3: "));
  EXPECT_EQ(report->text(), search_comparison_text(course.view()));
  EXPECT_EQ(report->json(), search_comparison_json(course.view()));
  EXPECT_EQ(report->begin_table({}) + report->end_table(), search_comparison_csv(course.view()));
  EXPECT_TRUE(report->incomplete().empty());
  EXPECT_FALSE(report->is_table_of_matches());
}

TEST(SearchComparisonArguments, TheWordsThatPlayItAgain) {
  study::SearchComparisonPlan plan = comparison();
  plan.algorithms = {study::Algorithm::spsa, study::Algorithm::sbplx};
  plan.repeats = 7;
  plan.tuning.limits.processor_seconds = 20;
  for (campaign::Job& job : plan.tuning.base.jobs) job.plugins = {"my plugins"};
  EXPECT_THAT(search_comparison_arguments(plan),
              ElementsAre("tune", "configs/studies/weights.yaml", "--compare", "spsa,sbplx", "--repeats", "7",
                          "--plugins", "my plugins", "--processor-seconds", "20", "--memory", "2048"));
}

}  // namespace
}  // namespace regista::report
