// SPDX-License-Identifier: MIT
// What programs read of a tuning: JSON and CSV.
#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "report/tuning_report.hpp"
#include "texts/json.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::json;
using study::TuningStage;

Json read(const TunedCourse& course) {
  const std::string text = outline_json(tuning_outline(course.view()));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
  return Json::parse(text);
}

// Goal differences of a stage, added up as the matches were played: by values and seed, weighted, mean of both matches.
struct Ledger {
  using Team = std::pair<double, double>;
  std::map<Team, std::map<std::uint64_t, double>> sums;

  void take(const study::TuningPlan& plan, const campaign::Job& job, const campaign::MatchResult& decided) {
    const std::size_t side = job.overrides.front().starts_with("home.") ? 0 : 1;
    const auto& opponent = side == 0 ? job.away_inputs : job.home_inputs;
    const double weight = opponent.front().hash == "document of fixed_rate" ? 0.75 : 0.25;
    sums[{override_of(job, plan.parameters[0].path), override_of(job, plan.parameters[1].path)}][job.seed] +=
        0.5 * weight * (decided.score[side] - decided.score[1 - side]);
  }
  double mean(const Team& team) const {
    double sum = 0.0;
    for (const auto& [seed, value] : sums.at(team)) sum += value;
    return sum / static_cast<double>(sums.at(team).size());
  }
};

TEST(TuningJson, NumbersAreThoseOfTheMatches) {
  const study::TuningPlan plan = tuning_plan();
  std::map<TuningStage, Ledger> ledgers;
  const TunedCourse course(plan, [&](const campaign::Job& job) {
    campaign::MatchResult decided = decided_by(plan, job, peak);
    ledgers[static_cast<TuningStage>(job.seed >> 50)].take(plan, job, decided);
    return decided;
  });
  const Json json = read(course);
  EXPECT_EQ(json["tuning"], "weights");
  EXPECT_EQ(json["complete"], true);
  EXPECT_TRUE(json["stage"].is_null());
  EXPECT_EQ(json["verified"], true);
  EXPECT_EQ(json["objective"]["terms"][0]["measure"], "goal_difference");
  EXPECT_EQ(json["opponents"][1]["weight"], 0.25);
  EXPECT_EQ(json["parameters"][1]["log_scale"], true);

  const Json& finalist = json["finalists"][0];
  const Ledger::Team tuned{finalist["values"][0], finalist["values"][1]}, base{5.0, 1.0};
  EXPECT_NEAR(finalist["selection"]["mean"].get<double>(), ledgers[TuningStage::selection].mean(tuned), 1e-12);
  const Ledger& verified = ledgers[TuningStage::verification];
  const Json& candidate = json["verification"]["candidates"][0];
  EXPECT_EQ(candidate["finding"], "better");
  EXPECT_EQ(candidate["pairs"], verified.sums.at(tuned).size());
  EXPECT_NEAR(candidate["value"]["mean"].get<double>(), verified.mean(tuned), 1e-12);
  EXPECT_NEAR(candidate["base"]["mean"].get<double>(), verified.mean(base), 1e-12);
  EXPECT_NEAR(candidate["difference"].get<double>(), verified.mean(tuned) - verified.mean(base), 1e-12);
  const study::ScoreDifference& scores = course.record.verification.of().front();
  EXPECT_EQ(candidate["p"], scores.p());
  EXPECT_EQ(candidate["p_holm"], scores.p());
  EXPECT_EQ(candidate["interval"][0], scores.estimate().interval.low);
  EXPECT_EQ(candidate["interval"][1], scores.estimate().interval.high);

  ASSERT_EQ(json["tuned"]["values"].size(), 2u);
  EXPECT_EQ(json["tuned"]["finalist"], 1);
  EXPECT_EQ(json["tuned"]["values"][0]["tuned"], finalist["values"][0]);
  EXPECT_EQ(json["tuned"]["values"][0]["base"], 5.0);
  ASSERT_EQ(json["slices"].size(), 2u);
  for (const Json& slice : json["slices"]) {
    const bool distance = slice["path"] == "weights.distance";
    ASSERT_EQ(slice["points"].size(), 6u);  // five, and the tuned one
    for (const Json& point : slice["points"]) {
      Ledger::Team at = tuned;
      (distance ? at.first : at.second) = point["value"];
      EXPECT_NEAR(point["objective"]["mean"].get<double>(), ledgers[TuningStage::slices].mean(at), 1e-12);
    }
  }
  const Json& matches = json["matches"];
  EXPECT_EQ(matches["search"].get<std::uint64_t>() + matches["selection"].get<std::uint64_t>() +
                matches["verification"].get<std::uint64_t>() + matches["slices"].get<std::uint64_t>(),
            course.played);
}

TEST(TuningJson, ForfeitsAreListed) {
  const study::TuningPlan plan = tuning_plan();
  const TunedCourse course(plan, [&](const campaign::Job& job) {
    return override_of(job, plan.parameters[0].path) > 5.5
               ? campaign::forfeit({0, "greedy", "assign", 3, 417, "no answer"}, 1.0)
               : decided_by(plan, job, peak);
  });
  const study::Forfeits& first = course.record.tally.forfeits.listed().at(0);
  const Json forfeits = read(course)["forfeits"];
  EXPECT_EQ(forfeits["unlisted"], 0);
  ASSERT_EQ(forfeits["listed"].size(), course.record.tally.forfeits.listed().size());
  EXPECT_EQ(forfeits["listed"][0], (Json{{"by", "the team that is tuned"},
                                         {"plugin", "greedy"},
                                         {"call", "assign"},
                                         {"what", "no answer"},
                                         {"matches", first.count},
                                         {"first_match", first.first_match + 1}}));
}

TEST(TuningJson, OfAMinimisedObjectiveInTheUsersTerms) {
  study::TuningPlan plan = tuning_plan();
  plan.objective = {{{"striker.overlap_seconds", 1.0}}, true};
  plan.asked.search.algorithm = "sbplx";
  const TunedCourse course(plan);
  const Json json = read(course);
  const Json& candidate = json["verification"]["candidates"][0];
  EXPECT_GT(candidate["value"]["mean"].get<double>(), 0.0);
  EXPECT_LT(candidate["difference"].get<double>(), 0.0);
  EXPECT_NEAR(candidate["search_less_verified"].get<double>(),
              candidate["search"]["mean"].get<double>() - candidate["value"]["mean"].get<double>(), 1e-9);
  for (const Json& slice : json["slices"]) {
    EXPECT_GE(slice["importance"].get<double>(), 0.0);
    for (const Json& point : slice["points"]) {
      const Json& interval = point["objective"]["interval"];
      EXPECT_LE(interval[0].get<double>(), point["objective"]["mean"].get<double>());
      EXPECT_GE(interval[1].get<double>(), point["objective"]["mean"].get<double>());
    }
  }
}

TEST(TuningJson, WhateverTheBytesItIsJson) {
  TunedCourse course(tuning_plan());
  course.plan.asked.name = course.plan.asked.question = course.plan.opponents[0].label = course.file =
      "\xff\"\\\n\u202e";
  EXPECT_EQ(read(course)["tuning"], "\xef\xbf\xbd\"\\\n\u202e");
}

std::vector<std::vector<std::string>> rows(const std::string& csv) {
  std::vector<std::vector<std::string>> out;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    out.emplace_back();
    std::istringstream fields(line + ',');
    for (std::string field; std::getline(fields, field, ',');) out.back().push_back(field);
  }
  return out;
}

TEST(TuningCsv, ALineForAnEvaluationThatReadsBackExactly) {
  for (const bool minimise : {false, true}) {
    study::TuningPlan plan = tuning_plan();
    plan.objective.minimise = minimise;
    plan.asked.search.algorithm = "sbplx";
    plan.pairs = 3;
    const TunedCourse course(plan);
    const auto table = rows(tuning_csv(course.view()));
    ASSERT_EQ(table.size(), course.record.trace.size() + 1);
    EXPECT_EQ(table[0],
              (std::vector<std::string>{"evaluation", "pairs_from", "repeated", "failed", "weights.distance",
                                        "weights.bearing", "value", "standard_error", "pairs", "best", "matches"}));
    for (std::size_t i = 1; i < table.size(); ++i) {
      const study::SearchStep& step = course.record.trace[i - 1];
      const auto number = [&](std::size_t column) { return std::strtod(table[i][column].c_str(), nullptr); };
      ASSERT_EQ(table[i].size(), 11u);
      EXPECT_EQ(number(0), static_cast<double>(i));
      EXPECT_EQ(table[i][2], step.repeated ? "1" : "0");
      EXPECT_EQ(number(4), step.values[0]);
      EXPECT_EQ(number(5), step.values[1]);
      EXPECT_EQ(number(6), minimise ? -step.played.score.mean : step.played.score.mean);
      EXPECT_EQ(number(7), step.played.score.standard_deviation / std::sqrt(3.0));
      EXPECT_EQ(number(9), minimise ? -step.best : step.best);
      EXPECT_EQ(number(10), static_cast<double>(step.matches));
      EXPECT_NE(table[i][6], "-0");
    }
  }
}

TEST(TuningCsv, HostilePathsStayInTheirField) {
  TunedCourse course(tuning_plan());
  course.plan.parameters[0].path = "=cmd(\"x\"),\n";
  EXPECT_THAT(
      tuning_csv(course.view()),
      testing::StartsWith("evaluation,pairs_from,repeated,failed,\"'=cmd(\"\"x\"\"),\n\",weights.bearing,value"));
}

}  // namespace
}  // namespace regista::report
