// SPDX-License-Identifier: MIT
// Plans of tournaments and results of matches, made by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "study/tournament_calendar.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

// What a document asks for that has this test.
inline std::optional<config::TournamentTest> test_of(const Objective& objective) {
  if (std::holds_alternative<FixedNumber>(objective)) return std::nullopt;
  config::TournamentTest out;
  if (const auto* const value = std::get_if<ValueTest>(&objective)) {
    out.metric = value->value;
    out.alpha = value->alpha;
    return out;
  }
  const auto& design = std::get<ScoreTest>(objective).design;
  out.elo = {design.hypotheses.elo0, design.hypotheses.elo1};
  using Model = config::TournamentTest::Model;
  out.model = design.model == statistics::Model::logistic ? Model::logistic : Model::normalized;
  out.alpha = design.rates.alpha;
  out.beta = design.rates.beta;
  return out;
}

// Teams "team 0", "team 1", ... of which no two are equal.
inline TournamentPlan plan_of(std::size_t teams, std::uint64_t pairs, const Objective& objective = FixedNumber{}) {
  TournamentPlan plan;
  plan.asked.name = "trial";
  plan.asked.settings.seeds = config::Seeds::consecutive;
  for (std::size_t team = 0; team < teams; ++team) {
    const std::string number = std::to_string(team);
    plan.asked.teams.push_back({number + ".yaml", ""});
    plan.teams.push_back({"team " + number, {{"team " + number + ".yaml", "hash " + number}}});
  }
  plan.asked.pairs = static_cast<int>(pairs);
  plan.asked.test = test_of(objective);
  plan.most_goals = 10;
  plan.common_inputs = {{"program", "1"}, {"rules spl2023", "2"}};
  return plan;
}

inline campaign::MatchResult match(int home, int away, const std::string& metrics = "{}") {
  return {{home, away}, "full_time", "h", campaign::metrics_from_json(metrics), std::nullopt, 1.0};
}

// side: 0 home, 1 away
inline campaign::MatchResult failed(int side, const std::string& plugin = "greedy",
                                    const std::string& what = "Segmentation fault") {
  return campaign::forfeit({side, plugin, "assign", 3, 417, what}, 1.0);
}

// One that could not be played.
inline campaign::MatchResult unplayed(const std::string& why = "Segmentation fault, in no plugin's call") {
  campaign::MatchResult out;
  out.ended = "set_aside";
  out.why_set_aside = why;
  return out;
}

}  // namespace regista::study
