// SPDX-License-Identifier: MIT
// Plans that Regista 0.2.0 wrote of small studies (tests/fixtures/plans_of_version_1; lists of hashes were cut), read
// as today's: they ask for the same matches.
#include "study/plan_fields.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "campaign/job.hpp"
#include "study/experiment_plan.hpp"
#include "study/tournament_calendar.hpp"
#include "study/tournament_plan.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "texts/json.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;

std::string plan_of_before(const std::string& study) {
  std::ifstream in(REGISTA_FIXTURES "/plans_of_version_1/" + study + ".json");
  return {std::istreambuf_iterator<char>(in), {}};
}

// But for the order in which values are laid over documents, which have nothing to do with each other here.
void expect_same_match(const campaign::Job& now, const Json& before) {
  campaign::Job then = campaign::job_from_json(before.dump()), today = now;
  std::ranges::sort(then.overrides);
  std::ranges::sort(today.overrides);
  EXPECT_EQ(today, then) << campaign::to_json(today) << "\n" << campaign::to_json(then);
}

TEST(OlderPlans, OfATournament) {
  const std::string text = plan_of_before("tournament");
  const Json before = Json::parse(text);
  const TournamentPlan plan = tournament_plan_from_json(text);
  EXPECT_EQ(plan.asked.name, "dist");
  EXPECT_EQ(plan.pairs(), 1u);
  EXPECT_EQ(plan.first_seed(), 1u);
  EXPECT_FALSE(plan.asked.test);
  EXPECT_EQ(plan.asked.settings.limit, 20.0);
  EXPECT_EQ(plan.asked.teams[1].disturbance, "configs/disturbances/everything.yaml");
  EXPECT_EQ(plan.folder, before.at("folder").get<std::string>());
  const campaign::Job first = job(plan, Calendar(plan).at(0));
  EXPECT_THAT(first.overrides, testing::ElementsAre("away.sender.params.reserve=20"));
  EXPECT_EQ(first.away_disturbance, "configs/disturbances/everything.yaml");
  EXPECT_EQ(first.common_inputs[3].name, "away disturbance everything");
  EXPECT_EQ(plan.teams[0].label, "paper (a)");
}

TEST(OlderPlans, OfAnExperiment) {
  const std::string text = plan_of_before("experiment");
  const Json before = Json::parse(text);
  const ExperimentPlan plan = experiment_plan_from_json(text);
  ASSERT_EQ(plan.conditions.size(), before.at("conditions").size());
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    expect_same_match(plan.conditions[i].jobs[0], before.at("conditions")[i].at("home"));
    expect_same_match(plan.conditions[i].jobs[1], before.at("conditions")[i].at("away"));
  }
  EXPECT_EQ(plan.comparisons().size(), before.at("comparisons").size());
  EXPECT_EQ(plan.measures, before.at("measures").get<std::vector<std::string>>());
  EXPECT_EQ(plan.primary(), "packets");
  EXPECT_EQ(plan.sweep(), "robot.walk.forward");
  EXPECT_THAT(plan.value_texts(), testing::ElementsAre("0.2", "0.3"));
  EXPECT_EQ(plan.pairs, 1u);
}

TEST(OlderPlans, OfATuning) {
  const std::string text = plan_of_before("tuning");
  const Json before = Json::parse(text);
  const TuningPlan plan = tuning_plan_from_json(text);
  ASSERT_EQ(plan.opponents.size(), 2u);
  for (std::size_t i = 0; i < plan.opponents.size(); ++i) {
    expect_same_match(plan.opponents[i].jobs[0], before.at("opponents")[i].at("home"));
    expect_same_match(plan.opponents[i].jobs[1], before.at("opponents")[i].at("away"));
    EXPECT_EQ(plan.opponents[i].weight, before.at("opponents")[i].at("weight").get<double>());
  }
  expect_same_match(plan.base.jobs[0], before.at("base").at("home"));
  EXPECT_EQ(plan.settings, before.at("settings").get<std::vector<std::string>>());
  EXPECT_EQ(plan.parameters.size(), before.at("parameters").size());
  EXPECT_EQ(plan.search_pairs, before.at("search_pairs").get<std::uint64_t>());
  EXPECT_EQ(plan.verification_pairs, before.at("verification_pairs").get<std::uint64_t>());
  EXPECT_TRUE(plan.symmetric());
  EXPECT_EQ(plan.slice_points(), 0u);
}

TEST(OlderPlans, WhatIsNoneIsRefused) {
  for (const char* const study : {"tournament", "experiment", "tuning"}) {
    const Json sound = Json::parse(plan_of_before(study));
    for (const auto& [name, value] : sound.items()) {
      if (name == "name" || name == "question" || name == "match_wall_seconds") continue;  // may be missing
      Json damaged = sound;
      damaged.erase(name);
      const auto read = [&] {
        if (study == std::string("tournament")) tournament_plan_from_json(damaged.dump());
        if (study == std::string("experiment")) experiment_plan_from_json(damaged.dump());
        if (study == std::string("tuning")) tuning_plan_from_json(damaged.dump());
      };
      if (name == "file" || name == "overrides") continue;  // say nothing that a plan of today has
      if (name == "limits" || name == "conditions" || name == "teams" || name == "opponents" || name == "folder") {
        EXPECT_THROW(read(), std::invalid_argument) << study << " without " << name;
      }
    }
  }
  Json comparison = Json::parse(plan_of_before("tuning"));
  comparison["compared"] = {"spsa"};
  EXPECT_THROW(tuning_plan_from_json(comparison.dump()), std::invalid_argument);
}

}  // namespace
}  // namespace regista::study
