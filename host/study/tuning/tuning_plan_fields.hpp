// SPDX-License-Identifier: MIT
// The fields of a tuning's plan, which the plan of another study may hold.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "study/plan_fields.hpp"
#include "study/tuning/algorithm.hpp"
#include "study/tuning/parameter.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

inline bool named(const std::string& text, Algorithm& algorithm) {
  const auto found = algorithm_named(text);
  if (found) algorithm = *found;
  return found.has_value();
}

template <Like<Parameter> Value, class Visit>
void fields(Value& parameter, Visit& visit) {
  visit("path", parameter.path);
  visit("start", parameter.start);
  visit("least", parameter.least);
  visit("most", parameter.most);
  visit("integer", parameter.integer);
  visit("log_scale", parameter.log_scale);
  visit("unit", parameter.unit);
  visit("doc", parameter.doc);
}
inline std::string in_words(const Parameter& each) {
  return fmt::format("{} {} to {} from {}{}{}", each.path, each.least, each.most, each.start,
                     each.integer ? ", whole" : "", each.log_scale ? ", logarithmic" : "");
}

template <Like<TuningOpponent> Value, class Visit>
void fields(Value& opponent, Visit& visit) {
  visit("label", opponent.label);
  visit("file", opponent.file);
  visit("weight", opponent.weight);
  visit("home", opponent.jobs[0]);
  visit("away", opponent.jobs[1]);
}
inline std::string in_words(const TuningOpponent& each) { return fmt::format("{} ({})", each.label, each.weight); }

template <Like<ObjectiveTerm> Value, class Visit>
void fields(Value& term, Visit& visit) {
  visit("measure", term.measure);
  visit("weight", term.weight);
}

template <Like<TuningObjective> Value, class Visit>
void fields(Value& objective, Visit& visit) {
  visit("minimise", objective.minimise);
  visit("terms", objective.terms);
}

template <Like<TuningPlan> Plan, class Visit>
void fields(Plan& plan, Visit& visit) {
  visit("name", plan.name, "the tuning");
  visit("question", plan.question);
  visit("team", plan.team);
  visit("document", plan.document);
  visit("settings", plan.settings);
  visit("parameters", plan.parameters, "the parameters");
  visit("opponents", plan.opponents, "the opponents");
  visit("base", plan.base);
  visit("objective", plan.objective, "the objective", [](const TuningObjective& objective) {
    return (objective.minimise ? "minimise " : "maximise ") + in_words(objective);
  });
  visit("openings", plan.openings);
  visit("most_goals", plan.most_goals);
  visit("seed", plan.seed, "the seed");
  visit("algorithm", plan.algorithm, "the algorithm");
  visit("search_pairs", plan.search_pairs, "pairs of the search");
  visit("pairs", plan.pairs, "pairs for each evaluation", [&plan](std::uint64_t pairs) {
    return std::to_string(pairs) + (plan.pairs_for_all ? "" : " where replicated");
  });
  visit("pairs_for_all", plan.pairs_for_all);
  visit("minutes", plan.minutes, "the minutes of the search");
  visit("population", plan.population, "the population");
  visit("finalists", plan.finalists, "the finalists");
  visit("selection_pairs", plan.selection_pairs, "pairs of the selection");
  visit("candidates", plan.candidates, "the candidates");
  visit("head_to_head", plan.head_to_head, "verification.against",
        [](bool head_to_head) { return std::string(head_to_head ? "base" : "opponents"); });
  visit("verification_pairs", plan.verification_pairs, "pairs of the verification");
  visit("symmetric", plan.symmetric, "verification.test",
        [](bool symmetric) { return std::string(symmetric ? "symmetric" : "betting"); });
  visit("confidence", plan.confidence, "the confidence");
  visit("slice_points", plan.slice_points, "points of the slices");
  visit("slice_pairs", plan.slice_pairs, "pairs of the slices");
  visit.inner("limits", [&plan](auto& inner) { limit_fields(plan.limits, inner); });
  visit("folder", plan.folder);
  visit("file", plan.file);
  visit("overrides", plan.overrides);
}

// What every search of its points relies on. Does not ask whether its budget is enough for its algorithm: can_search()
// does.
bool sound(const TuningPlan& plan);

// Its budget is enough for this algorithm's first round, the base team's evaluation aside.
bool can_search(const TuningPlan& plan, Algorithm algorithm);

}  // namespace regista::study
