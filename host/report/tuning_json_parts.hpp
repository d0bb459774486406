// SPDX-License-Identifier: MIT
// Parts of the JSON of every study that searches the values of a team.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/number_json.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::report {

// A score, or a difference of scores, in the words of the objective.
nlohmann::ordered_json json_of_score(const study::TuningObjective& objective, const std::optional<double>& score);

// Name, team, objective, parameters, opponents: what is searched for.
nlohmann::ordered_json problem_json(const study::TuningPlan& plan);
nlohmann::ordered_json budget_json(const study::TuningPlan& plan);
// What was counted of the matches beside their scores.
nlohmann::ordered_json tally_json(const study::TuningPlan& plan, const study::MatchTally& tally);

}  // namespace regista::report
