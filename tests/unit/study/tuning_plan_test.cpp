// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "config/json.hpp"
#include "config/sanitized.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TuningPlan every_value() {
  TuningPlan plan = tuning_of(3, 2, Algorithm::spsa);
  plan.question = "Is it \"better\"?\n";
  plan.settings = {"tasks.keep=all"};
  plan.parameters[1].integer = true;
  plan.parameters[1].most = 9.0;
  plan.parameters[2].log_scale = true;
  plan.parameters[2].least = 1.0 / 3.0;
  plan.objective = {{{"points", 10.0}, {"striker.overlap_seconds", -0.1}}, true};
  plan.openings = {{"scene.yaml", {"scene", "hash"}}, {"other.yaml", {"other", "hash 2"}}};
  plan.most_goals = 9;
  plan.seed = 12345;
  plan.search_pairs = 77;
  plan.pairs = 3;
  plan.pairs_for_all = true;
  plan.minutes = 2.5;
  plan.population = 11;
  plan.finalists = 6;
  plan.selection_pairs = 8;
  plan.candidates = 2;
  plan.head_to_head = true;
  plan.verification_pairs = 99;
  plan.confidence = 0.99;
  plan.slice_points = 5;
  plan.slice_pairs = 4;
  plan.limits.processor_seconds = 3;
  plan.limits.memory = std::uint64_t{1} << 30;
  plan.folder = "/tmp";
  plan.file = "t.yaml";
  plan.overrides = {"search.matches=10"};
  plan.opponents[0].jobs[0].overrides = {"home.tasks.keep=all"};
  return plan;
}

TEST(TuningPlan, IsReadAsItWasWritten) {
  for (const TuningPlan& plan : {every_value(), tuning_of(1, 1), tuning_of(5, 4, Algorithm::bobyqa)}) {
    const TuningPlan read = tuning_plan_from_json(to_json(plan));
    EXPECT_EQ(to_json(read), to_json(plan));
    EXPECT_THAT(differences(plan, read), IsEmpty());
    EXPECT_EQ(read.parameters, plan.parameters);
    EXPECT_EQ(read.document, plan.document);
    EXPECT_EQ(read.minutes, plan.minutes);
    EXPECT_EQ(read.objective, plan.objective);
    for (std::size_t i = 0; i < plan.opponents.size(); ++i) {
      EXPECT_EQ(read.opponents[i].jobs, plan.opponents[i].jobs);
      EXPECT_EQ(read.opponents[i].weight, plan.opponents[i].weight);
    }
    EXPECT_EQ(read.base.jobs, plan.base.jobs);
  }
}

TEST(TuningPlan, NamesThatAreNoTextAreWrittenAllTheSame) {
  TuningPlan plan = tuning_of(1, 1);
  plan.folder = "/tmp/\xff\xfe";
  EXPECT_NO_THROW(tuning_plan_from_json(to_json(plan)));
}

TEST(TuningPlan, EveryTruncationIsRefused) {
  const std::string whole = to_json(every_value());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(tuning_plan_from_json(whole.substr(0, length)), std::invalid_argument) << length;
  }
}

// Read or refused with a reason; what is read can be used.
void try_plan(const std::string& text) {
  try {
    const TuningPlan plan = tuning_plan_from_json(text);
    to_json(plan);
    most_matches(plan);
    differences(plan, plan);
    EXPECT_GE(plan.free_parameters(), 1u);
    EXPECT_GE(plan.finalists, 1u);
    EXPECT_GE(plan.candidates, 1u);
    EXPECT_GT(plan.evaluations(plan.algorithm),
              least_evaluations(plan.algorithm, plan.free_parameters(),
                                has_population(plan.algorithm) ? plan.population : 0));
    values_of(plan, point_of(plan, start_values(plan)));
    TunedDocument(plan).with(start_values(plan));
  } catch (const std::invalid_argument&) {
  }
}

TEST(TuningPlan, AnyByteMayBeDamaged) {
  const std::string whole = to_json(every_value());
  std::mt19937 random(1);
  for (int round = 0; round < (sanitized ? 2000 : 20000); ++round) {
    std::string text = whole;
    for (int i = std::uniform_int_distribution(1, 3)(random); i > 0; --i) {
      const std::size_t at = std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random);
      static constexpr std::string_view bytes = "0123456789-+eE.\"{}[],:tfn \x00\xff";
      text[at] = bytes[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)];
    }
    ASSERT_NO_THROW(try_plan(text)) << text;
  }
}

// Every value in turn replaced by every kind of nonsense, at every depth.
TEST(TuningPlan, AnyValueMayBeAnother) {
  using Json = nlohmann::ordered_json;
  const Json whole = Json::parse(to_json(every_value()));
  const std::vector<Json> instead{nullptr,
                                  true,
                                  0,
                                  -1,
                                  1,
                                  2,
                                  0.5,
                                  1e300,
                                  -1e300,
                                  18446744073709551615ull,
                                  4294967296ull,
                                  "",
                                  "text",
                                  "\n",
                                  Json::array(),
                                  Json::object(),
                                  Json::array({1}),
                                  Json{{"a", 1}}};
  const std::vector<std::string> places = [&] {
    std::vector<std::string> out;
    const Json flat = whole.flatten();
    for (const auto& [path, value] : flat.items()) {
      for (std::string each = path; !each.empty(); each.resize(each.rfind('/'))) {
        if (std::ranges::find(out, each) == out.end()) out.push_back(each);
      }
    }
    return out;
  }();
  EXPECT_GT(places.size(), 60u);
  for (std::size_t i = 0; i < places.size(); i += sanitized ? 3 : 1) {  // sanitizers are slow
    const std::string& place = places[i];
    for (const Json& each : instead) {
      Json damaged = whole;
      damaged[Json::json_pointer(place)] = each;
      ASSERT_NO_THROW(try_plan(damaged.dump())) << place << ' ' << each;
    }
    Json damaged = whole;
    Json& parent = damaged[Json::json_pointer(place).parent_pointer()];
    // A job may leave out some of its own.
    const bool of_job = place.find("/home/") != std::string::npos || place.find("/away/") != std::string::npos;
    // Results of before know none.
    const bool new_one = place.ends_with("/match_wall_seconds");
    if (!parent.is_object() || of_job || new_one) continue;
    parent.erase(Json::json_pointer(place).back());
    EXPECT_THROW(tuning_plan_from_json(damaged.dump()), std::invalid_argument) << "without " << place;
  }
}

TEST(TuningPlan, NumbersThatNoTuningHasAreRefused) {
  const auto refused = [](const char* what, const std::function<void(TuningPlan&)>& change) {
    TuningPlan plan = every_value();
    change(plan);
    EXPECT_THROW(tuning_plan_from_json(to_json(plan)), std::invalid_argument) << what;
  };
  refused("no parameter", [](TuningPlan& p) { p.parameters.clear(); });
  refused("all fixed", [](TuningPlan& p) {
    for (Parameter& each : p.parameters) each.least = each.most = each.start;
  });
  refused("empty range", [](TuningPlan& p) { p.parameters[0].least = 2.0; });
  refused("start outside", [](TuningPlan& p) { p.parameters[0].start = 2.0; });
  refused("logarithm of nothing", [](TuningPlan& p) { p.parameters[2].least = 0.0; });
  refused("no opponent", [](TuningPlan& p) { p.opponents.clear(); });
  refused("opponents without weight", [](TuningPlan& p) { p.opponents[0].weight = 0.0; });
  refused("opponents of any weight", [](TuningPlan& p) { p.opponents[0].weight = 5.0; });
  refused("no objective", [](TuningPlan& p) { p.objective.terms.clear(); });
  refused("no goals", [](TuningPlan& p) { p.most_goals = 0; });
  refused("no pairs", [](TuningPlan& p) { p.pairs = 0; });
  refused("no finalists", [](TuningPlan& p) { p.finalists = p.candidates = 0; });
  refused("no candidates", [](TuningPlan& p) { p.candidates = 0; });
  refused("more candidates", [](TuningPlan& p) { p.candidates = p.finalists + 1; });
  refused("many finalists", [](TuningPlan& p) { p.finalists = std::uint64_t{1} << 40; });
  refused("many slices", [](TuningPlan& p) { p.slice_points = std::uint64_t{1} << 40; });
  refused("large population", [](TuningPlan& p) { p.population = std::uint64_t{1} << 40; });
  refused("search too short", [](TuningPlan& p) { p.search_pairs = p.pairs; });
  refused("search too long", [](TuningPlan& p) { p.search_pairs = std::uint64_t{1} << 40; });
  refused("confidence", [](TuningPlan& p) { p.confidence = 1.0; });
  refused("seed", [](TuningPlan& p) { p.seed = std::uint64_t{1} << 32; });
}

TEST(TuningPlan, WhatHasChangedIsNamed) {
  const TuningPlan before = every_value();
  const auto changed = [&](const char* named, const std::function<void(TuningPlan&)>& change) {
    TuningPlan now = every_value();
    change(now);
    EXPECT_THAT(differences(before, now), Contains(HasSubstr(named)));
    EXPECT_EQ(differences(now, now).size(), 0u);
  };
  changed("the tuning: was trial, now other", [](TuningPlan& p) { p.name = "other"; });
  changed("the parameters", [](TuningPlan& p) { p.parameters.pop_back(); });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].most = 0.99; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].start = 0.51; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].log_scale = true; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[1].integer = false; });
  changed("the opponents", [](TuningPlan& p) { p.opponents.pop_back(); });
  changed("the opponents", [](TuningPlan& p) { p.opponents[0].weight = 0.5001; });
  changed("the objective: was minimise 10 points - 0.1 striker.overlap_seconds, now maximise",
          [](TuningPlan& p) { p.objective.minimise = false; });
  changed("the objective", [](TuningPlan& p) { p.objective.terms[0].weight = 10.000001; });
  changed("the algorithm: was spsa, now bobyqa", [](TuningPlan& p) { p.algorithm = Algorithm::bobyqa; });
  changed("the seed: was 12345, now 1", [](TuningPlan& p) { p.seed = 1; });
  changed("pairs of the search", [](TuningPlan& p) { p.search_pairs = 76; });
  changed("pairs for each evaluation", [](TuningPlan& p) { p.pairs = 4; });
  changed("pairs for each evaluation", [](TuningPlan& p) { p.pairs_for_all = false; });
  changed("the minutes", [](TuningPlan& p) { p.minutes.reset(); });
  changed("the population", [](TuningPlan& p) { p.population = 12; });
  changed("the finalists", [](TuningPlan& p) { p.finalists = 5; });
  changed("pairs of the selection", [](TuningPlan& p) { p.selection_pairs = 9; });
  changed("the candidates", [](TuningPlan& p) { p.candidates = 1; });
  changed("verification.against: was base, now opponents", [](TuningPlan& p) { p.head_to_head = false; });
  changed("pairs of the verification", [](TuningPlan& p) { p.verification_pairs = 98; });
  changed("the confidence: was 0.99, now 0.95", [](TuningPlan& p) { p.confidence = 0.95; });
  changed("points of the slices", [](TuningPlan& p) { p.slice_points = 6; });
  changed("pairs of the slices", [](TuningPlan& p) { p.slice_pairs = 5; });
  changed("--processor-seconds: was 3, now 4", [](TuningPlan& p) { p.limits.processor_seconds = 4; });
  changed("--memory", [](TuningPlan& p) { p.limits.memory = std::uint64_t{2} << 30; });
  changed("the team: team base has changed",
          [](TuningPlan& p) { p.opponents[1].jobs[0].home_inputs[0].hash = "other"; });
  changed("opponent 1: team opponent 1 has changed",
          [](TuningPlan& p) { p.opponents[1].jobs[0].away_inputs[0].hash = "other"; });
  changed("rules has changed", [](TuningPlan& p) { p.opponents[0].jobs[0].common_inputs[0].hash = "other"; });
  changed("rules has changed", [](TuningPlan& p) { p.opponents[0].jobs[1].common_inputs[0].hash = "other"; });
  changed("rules has changed", [](TuningPlan& p) {
    for (campaign::Job& each : p.base.jobs) each.common_inputs[0].hash = "other";
  });
  changed("scene has changed", [](TuningPlan& p) { p.openings[0].input.hash = "other"; });
  changed("another order", [](TuningPlan& p) { std::swap(p.openings[0], p.openings[1]); });
}

TEST(TuningPlan, PointsAndValues) {
  TuningPlan plan = tuning_of(4, 1);
  plan.parameters[1].least = plan.parameters[1].most = 0.5;  // fixed
  plan.parameters[2] = {"p2", 0.123456789, 0.0, 1.0, false, false, "", ""};
  EXPECT_EQ(plan.free_parameters(), 3u);
  // The start is itself, however many digits it has.
  EXPECT_EQ(values_of(plan, point_of(plan, start_values(plan))), start_values(plan));
  Eigen::VectorXd point(3);
  point << 0.0, 0.25, 1.0;
  EXPECT_EQ(values_of(plan, point), (ParameterValues{0.0, 0.5, 0.25, 1.0}));
  EXPECT_EQ(point_of(plan, {0.0, 0.5, 0.25, 1.0}), point);
}

TEST(TuningPlan, Budget) {
  TuningPlan plan = tuning_of(3, 2, Algorithm::sbplx);
  plan.search_pairs = 41;
  plan.pairs = 4;
  EXPECT_EQ(plan.evaluations(Algorithm::sbplx), 10u);
  EXPECT_EQ(plan.evaluations(Algorithm::spsa), 41u);
  EXPECT_EQ(most_matches(plan, TuningStage::search), 160u);
  EXPECT_EQ(most_matches(plan, TuningStage::selection), 3u * 4 * 4);
  EXPECT_EQ(most_matches(plan, TuningStage::verification), 30u * 2 * 4);
  EXPECT_EQ(most_matches(plan, TuningStage::slices), 0u);
  plan.slice_points = 5;
  plan.slice_pairs = 2;
  EXPECT_EQ(most_matches(plan, TuningStage::slices), 16u * 2 * 4);
  plan.head_to_head = true;
  plan.candidates = 2;
  EXPECT_EQ(most_matches(plan, TuningStage::verification), 30u * 2 * 2);
  plan.pairs_for_all = true;
  EXPECT_EQ(plan.evaluations(Algorithm::spsa), 10u);
}

TEST(TuningPlan, BoundsOfScores) {
  TuningPlan plan = tuning_of(1, 1);
  EXPECT_EQ(score_bounds(plan)->low, -10.0);
  EXPECT_EQ(score_bounds(plan)->high, 10.0);
  plan.objective = {{{"points", 3.0}, {"goal_difference", -0.5}}, false};
  EXPECT_EQ(score_bounds(plan)->low, -5.0);
  EXPECT_EQ(score_bounds(plan)->high, 8.0);
  plan.objective.minimise = true;
  EXPECT_EQ(score_bounds(plan)->low, -8.0);
  EXPECT_EQ(score_bounds(plan)->high, 5.0);
  plan.objective.terms.push_back({"packets", 1.0});
  EXPECT_FALSE(score_bounds(plan));
}

TEST(TuningPlan, InWords) {
  EXPECT_EQ(in_words({{{"points", 1.0}}, false}), "points");
  EXPECT_EQ(in_words({{{"points", 10.0}, {"overlap_seconds", -0.5}}, false}), "10 points - 0.5 overlap_seconds");
  EXPECT_EQ(in_words({{{"packets", -1.0}, {"points", 2.0}}, true}), "-1 packets + 2 points");
}

TEST(TuningPlan, AsksForTheMetricsThatItLooksAt) {
  TuningPlan plan = tuning_of(2, 1);
  const std::vector<Opening> scenes{{"scene.yaml", {"scene", "hash"}}};
  for (const bool short_games : {false, true}) {
    plan.openings = short_games ? scenes : std::vector<Opening>();
    ASSERT_EQ(plan.short_games(), short_games);
    plan.objective = {{{"points", 1.0}, {"goal_difference", 2.0}}, true};
    EXPECT_EQ(wanted_metrics(plan), short_games ? campaign::Metrics::packets : campaign::Metrics::left_out);
    plan.objective.terms.push_back({"touches", 1.0});
    EXPECT_EQ(wanted_metrics(plan), campaign::Metrics::wanted);
  }
}

}  // namespace
}  // namespace regista::study
