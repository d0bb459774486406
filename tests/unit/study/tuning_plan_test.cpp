// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "process/sanitized.hpp"
#include "texts/json.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TuningPlan every_value() {
  TuningPlan plan = tuning_of(3, 2, Algorithm::spsa);
  config::Tuning& asked = plan.asked;
  asked.question = "Is it \"better\"?";
  asked.settings.set = config::Node::map({{"tasks.keep", {}, config::Node::scalar("all", false, {})}}, {});
  asked.objective.minimise = {{"points", 10.0, {}}, {"striker.overlap_seconds", -0.1, {}}};
  asked.seed = 12345;
  asked.search.pairs = 3;
  asked.search.minutes = 2.5;
  asked.search.population = 11;
  asked.selection.finalists = 6;
  asked.verification.candidates = 2;
  asked.verification.against = config::Tuning::Against::base;
  asked.verification.confidence = 0.99;
  asked.slices = {5, 4};
  asked.settings.limits.processor_seconds = 3;
  asked.settings.limits.memory = 1024;
  asked.settings.rules = "rules.yaml";
  asked.settings.limit = 12.5;
  asked.opponent_disturbance = "noise.yaml";
  plan.parameters[1].integer = true;
  plan.parameters[1].most = 9.0;
  plan.parameters[2].log_scale = true;
  plan.parameters[2].least = 1.0 / 3.0;
  plan.openings = {{"scene.yaml", {"scene", "hash"}}, {"other.yaml", {"other", "hash 2"}}};
  plan.starts = {{0.1, 2.0, 0.5}, {0.2, 3.0, 0.75}};
  plan.most_goals = 9;
  plan.search_pairs = 77;
  plan.pairs = 3;
  plan.selection_pairs = 8;
  plan.verification_pairs = 99;
  plan.folder = "/tmp";
  plan.plugins = {"plugins"};
  plan.program = "1.2";
  complete(plan);
  return plan;
}

TEST(TuningPlan, IsReadAsItWasWritten) {
  for (TuningPlan plan : {every_value(), tuning_of(1, 1), tuning_of(5, 4, Algorithm::bobyqa)}) {
    complete(plan);
    const TuningPlan read = tuning_plan_from_json(to_json(plan));
    EXPECT_EQ(to_json(read), to_json(plan));
    EXPECT_THAT(differences(plan, read), IsEmpty());
    EXPECT_EQ(read.parameters, plan.parameters);
    EXPECT_EQ(read.starts, plan.starts);
    EXPECT_EQ(read.document, plan.document);
    EXPECT_EQ(read.asked.search.minutes, plan.asked.search.minutes);
    EXPECT_EQ(read.objective, plan.objective);
    EXPECT_EQ(read.settings, plan.settings);
    EXPECT_EQ(read.program, plan.program);
    for (std::size_t i = 0; i < plan.opponents.size(); ++i) {
      EXPECT_EQ(read.opponents[i].jobs, plan.opponents[i].jobs);
      EXPECT_EQ(read.opponents[i].weight, plan.opponents[i].weight);
    }
    EXPECT_EQ(read.base.jobs, plan.base.jobs);
  }
}

// What is set for the tuned team is set for the base team as well where that is its opponent.
TEST(TuningPlan, JobsAreAsTheyAreAskedFor) {
  const TuningPlan plan = every_value();
  const campaign::Job& away = plan.opponents[1].jobs[1];
  EXPECT_EQ(away.teams, (std::array<std::string, 2>{"opponent 1.yaml", "base.yaml"}));
  EXPECT_EQ(away.overrides, std::vector<std::string>{"away.tasks.keep=all"});
  EXPECT_EQ(away.home_disturbance + away.away_disturbance + away.rules + away.limit, "noise.yamlrules.yaml12.5");
  EXPECT_EQ(plan.base.jobs[0].overrides, (std::vector<std::string>{"home.tasks.keep=all", "away.tasks.keep=all"}));
  EXPECT_EQ(plan.base.jobs[0].away_disturbance, "");
  EXPECT_EQ(plan.settings, std::vector<std::string>{"tasks.keep=all"});
  EXPECT_EQ(plan.opponents[0].weight, 0.5);
  EXPECT_TRUE(plan.objective.minimise);
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
    EXPECT_GE(plan.finalists(), 1u);
    EXPECT_GE(plan.candidates(), 1u);
    EXPECT_GT(plan.evaluations(), least_evaluations(plan.algorithm(), plan.free_parameters(),
                                                    has_population(plan.algorithm()) ? plan.population() : 0));
    values_of(plan, point_of(plan, start_values(plan)));
    TunedDocument(plan).with(start_values(plan));
  } catch (const std::invalid_argument&) {
  }
}

TEST(TuningPlan, AnyByteMayBeDamaged) {
  const std::string whole = to_json(every_value());
  std::mt19937 random(1);
  for (int round = 0; round < (sanitized ? 500 : 5000); ++round) {
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
  for (std::size_t i = 0; i < places.size(); i += sanitized ? 9 : 1) {  // sanitizers are slow
    const std::string& place = places[i];
    for (const Json& each : instead) {
      Json damaged = whole;
      damaged[Json::json_pointer(place)] = each;
      ASSERT_NO_THROW(try_plan(damaged.dump())) << place << ' ' << each;
    }
    Json damaged = whole;
    Json& parent = damaged[Json::json_pointer(place).parent_pointer()];
    if (!parent.is_object() || place == "/program" || place == "/starts") continue;
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
  refused("an opponent that nobody asked for", [](TuningPlan& p) { p.asked.opponents.pop_back(); });
  refused("opponents without weight", [](TuningPlan& p) { p.asked.opponents[0].weight = 0.0; });
  refused("no algorithm", [](TuningPlan& p) { p.asked.search.algorithm = "dreams"; });
  refused("no goals", [](TuningPlan& p) { p.most_goals = 0; });
  refused("no pairs", [](TuningPlan& p) { p.pairs = 0; });
  refused("no finalists", [](TuningPlan& p) { p.asked.selection.finalists = p.asked.verification.candidates = 0; });
  refused("no candidates", [](TuningPlan& p) { p.asked.verification.candidates = 0; });
  refused("more candidates", [](TuningPlan& p) { p.asked.verification.candidates = 7; });
  refused("many finalists", [](TuningPlan& p) { p.asked.selection.finalists = 1 << 30; });
  refused("many slices", [](TuningPlan& p) { p.asked.slices.points = 1 << 30; });
  refused("large population", [](TuningPlan& p) { p.asked.search.population = 1 << 30; });
  refused("search too short", [](TuningPlan& p) { p.search_pairs = p.pairs; });
  refused("search too long", [](TuningPlan& p) { p.search_pairs = std::uint64_t{1} << 40; });
  refused("confidence", [](TuningPlan& p) { p.asked.verification.confidence = 1.0; });
  refused("seed", [](TuningPlan& p) { p.asked.seed = -1; });
}

TEST(TuningPlan, WhatHasChangedIsNamed) {
  const TuningPlan before = every_value();
  const auto changed = [&](const char* named, const std::function<void(TuningPlan&)>& change) {
    TuningPlan now = every_value();
    change(now);
    EXPECT_THAT(differences(before, now), Contains(HasSubstr(named)));
    EXPECT_EQ(differences(now, now).size(), 0u);
  };
  changed("tuning: was trial, now other", [](TuningPlan& p) { p.asked.name = "other"; });
  changed("the parameters", [](TuningPlan& p) { p.parameters.pop_back(); });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].most = 0.99; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].start = 0.51; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[0].log_scale = true; });
  changed("the parameters", [](TuningPlan& p) { p.parameters[1].integer = false; });
  changed("the number of opponents: was 2, now 1", [](TuningPlan& p) { p.asked.opponents.pop_back(); });
  changed("opponents.0.weight: was 1, now 0.5", [](TuningPlan& p) { p.asked.opponents[0].weight = 0.5; });
  changed("objective.minimise", [](TuningPlan& p) { p.asked.objective.minimise[0].weight = 10.000001; });
  changed("objective.maximise.points: was none, now 10",
          [](TuningPlan& p) { std::swap(p.asked.objective.maximise, p.asked.objective.minimise); });
  changed("search.algorithm: was spsa, now bobyqa", [](TuningPlan& p) { p.asked.search.algorithm = "bobyqa"; });
  changed("seed: was 12345, now 1", [](TuningPlan& p) { p.asked.seed = 1; });
  changed("pairs of the search", [](TuningPlan& p) { p.search_pairs = 76; });
  changed("pairs for each evaluation", [](TuningPlan& p) { p.pairs = 4; });
  changed("search.pairs: was 3, now none", [](TuningPlan& p) { p.asked.search.pairs.reset(); });
  changed("search.minutes: was 2.5, now none", [](TuningPlan& p) { p.asked.search.minutes.reset(); });
  changed("search.population: was 11, now 12", [](TuningPlan& p) { p.asked.search.population = 12; });
  changed("selection.finalists: was 6, now 5", [](TuningPlan& p) { p.asked.selection.finalists = 5; });
  changed("pairs of the selection", [](TuningPlan& p) { p.selection_pairs = 9; });
  changed("verification.candidates: was 2, now 1", [](TuningPlan& p) { p.asked.verification.candidates = 1; });
  changed("verification.against: was base, now opponents",
          [](TuningPlan& p) { p.asked.verification.against = config::Tuning::Against::opponents; });
  changed("pairs of the verification", [](TuningPlan& p) { p.verification_pairs = 98; });
  changed("verification.confidence: was 0.99, now 0.95", [](TuningPlan& p) { p.asked.verification.confidence = 0.95; });
  changed("slices.points: was 5, now 6", [](TuningPlan& p) { p.asked.slices.points = 6; });
  changed("limits.processor_seconds: was 3, now 4",
          [](TuningPlan& p) { p.asked.settings.limits.processor_seconds = 4; });
  changed("limits.memory: was 1024, now 2048", [](TuningPlan& p) { p.asked.settings.limits.memory = 2048; });
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

// How matches are played, and what people call files, changes nothing that is found.
TEST(TuningPlan, WhatDecidesNothingIsNoChange) {
  TuningPlan now = every_value();
  now.asked.question = "Another?";
  now.asked.settings.isolation = config::Isolation::always;
  now.asked.settings.play_twice = false;
  now.asked.settings.limits.match_seconds = 5;
  now.asked.settings.rules = "elsewhere.yaml";
  now.folder = "/elsewhere";
  EXPECT_THAT(differences(every_value(), now), IsEmpty());
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
  EXPECT_EQ(plan.evaluations(), 10u);
  EXPECT_EQ(tuning_of(3, 2, Algorithm::spsa).evaluations(), 40u);
  EXPECT_EQ(most_matches(plan, TuningStage::search), 160u);
  EXPECT_EQ(most_matches(plan, TuningStage::selection), 3u * 4 * 4);
  EXPECT_EQ(most_matches(plan, TuningStage::verification), 30u * 2 * 4);
  EXPECT_EQ(most_matches(plan, TuningStage::slices), 0u);
  plan.asked.slices.points = 5;
  plan.asked.slices.pairs = 2;
  EXPECT_EQ(most_matches(plan, TuningStage::slices), 16u * 2 * 4);
  plan.asked.verification.against = config::Tuning::Against::base;
  plan.asked.verification.candidates = 2;
  EXPECT_EQ(most_matches(plan, TuningStage::verification), 30u * 2 * 2);
  plan.asked.search.algorithm = "spsa";
  EXPECT_EQ(plan.evaluations(), 41u);
  plan.asked.search.pairs = 4;
  EXPECT_EQ(plan.evaluations(), 10u);
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
