// SPDX-License-Identifier: MIT
// The plan of a tuning: parameters, opponents, objective, algorithm, budget and test.
//
// The program scores pairs of matches. For each opponent, a pair has a match with the tuned team at home, and the same
// match with the sides swapped. Pairs are numbered from 0 in each of four stages. The stages have disjoint seeds:
//   seed = stage * 2^50 + first seed + number of the pair.
// In the verification, drawn_seed() replaces the first seed. drawn_seed() depends on the values that are verified.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/overlay.hpp"
#include "config/tuning.hpp"
#include "plugin/catalogue.hpp"
#include "study/settings.hpp"
#include "study/tuning/parameter.hpp"
#include "study/tuning/search.hpp"

namespace regista::study {

enum class TuningStage { search, selection, verification, slices };
const char* name(TuningStage stage);

struct ObjectiveTerm {
  std::string measure;  // see study/measure.hpp
  double weight = 1.0;
  friend bool operator==(const ObjectiveTerm&, const ObjectiveTerm&) = default;
};

// A weighted sum of measures. A sum of a single measure has the unit of that measure.
struct TuningObjective {
  std::vector<ObjectiveTerm> terms;  // one or more
  bool minimise = false;
  friend bool operator==(const TuningObjective&, const TuningObjective&) = default;
};

struct TuningOpponent {
  std::string label, file;
  double weight = 1.0;                // the weights of a plan's opponents sum up to 1
  std::array<campaign::Job, 2> jobs;  // [0]: base team at home, [1]: away; without seed and opening
};

// Values of all parameters, in the plan's order.
using ParameterValues = std::vector<double>;

struct TuningPlan : StudyPlan<config::Tuning> {
  std::string document;  // resolved document of the base team, with every parameter at its start value
  std::vector<Parameter> parameters;
  // JSON keeps only the labels and job inputs of `opponents` and `base`. complete() makes their other members.
  std::vector<TuningOpponent> opponents;
  TuningOpponent base;                   // the base team as an opponent
  std::vector<ParameterValues> starts;   // the points of search.start_from
  int most_goals = 0;                    // largest goal difference that a match can have, also a forfeit
  std::uint64_t search_pairs = 0;        // most pairs of the whole search, against each opponent
  std::uint64_t pairs = 1;               // pairs for each point; see pairs_of_evaluation()
  std::uint64_t selection_pairs = 0;     // pairs of each finalist against each opponent
  std::uint64_t verification_pairs = 0;  // most pairs of each candidate if there are candidates() candidates

  // complete() makes these members from `asked`. JSON does not keep them.
  std::vector<std::string> settings;  // "path=value" that replace values of the team's file
  TuningObjective objective;

  std::uint64_t seed() const { return static_cast<std::uint64_t>(asked.seed); }
  Algorithm algorithm() const { return algorithm_named(asked.search.algorithm).value(); }
  std::uint64_t population() const { return static_cast<std::uint64_t>(asked.search.population.value_or(0)); }
  std::uint64_t finalists() const { return static_cast<std::uint64_t>(asked.selection.finalists); }  // most finalists
  std::uint64_t candidates() const { return static_cast<std::uint64_t>(asked.verification.candidates); }
  // Returns whether candidates play against the base team instead of the opponents.
  bool head_to_head() const { return asked.verification.against == config::Tuning::Against::base; }
  // Returns whether the test assumes symmetric differences even if the objective has bounds.
  bool symmetric() const { return asked.verification.test == config::Tuning::Test::symmetric; }
  double confidence() const { return asked.verification.confidence; }
  std::uint64_t slice_points() const { return static_cast<std::uint64_t>(asked.slices.points); }  // 0: no slices
  std::uint64_t slice_pairs() const {
    return asked.slices.points == 0 ? 0 : static_cast<std::uint64_t>(asked.slices.pairs);
  }

  std::size_t free_parameters() const;
  std::uint64_t pairs_of_evaluation() const { return asked.search.pairs || wants_replication(algorithm()) ? pairs : 1; }
  // The number of points that the search can try, including the point of the base team.
  std::uint64_t evaluations() const { return search_pairs / pairs_of_evaluation(); }
  // The number of matches of one pair: of one team; of `candidates` candidates (and the base team) in the verification.
  std::uint64_t matches_of_pair() const { return 2 * opponents.size(); }
  std::uint64_t matches_of_verified_pair(std::uint64_t candidates) const {
    return head_to_head() ? 2 * candidates : (candidates + 1) * matches_of_pair();
  }
};

// Makes settings, objective, opponents and their jobs from `asked`. Keeps the inputs and labels that the plan already
// has. Throws config::Error for impossible settings.
void complete(TuningPlan& plan);

// Settings of matches against opponents or base team. As an opponent, the base team has the tuned team's settings.
config::Overrides settings_of(const TuningPlan& plan, bool against_base);

// Returns whether all numbers of the plan are in the ranges that a search needs.
bool sound(const TuningPlan& plan);

ParameterValues start_values(const TuningPlan& plan);

// point_of(): the free parameters as a point of the unit cube. values_of(): all parameters at a point.
Eigen::VectorXd point_of(const TuningPlan& plan, const ParameterValues& values);
ParameterValues values_of(const TuningPlan& plan, const Eigen::VectorXd& point);

// The base team's document with new values for the parameters.
class TunedDocument {
 public:
  // Throws std::invalid_argument for a plan that is damaged.
  explicit TunedDocument(const TuningPlan& plan);
  std::string with(const ParameterValues& values) const;

 private:
  struct Place {
    std::size_t begin, length, parameter;
  };
  const TuningPlan& plan_;
  std::vector<Place> places_;  // last place first, so that a replacement does not move the places before it
};

// Returns a setting "path=value" for each parameter of the plan, with these values.
std::vector<std::string> settings_of(const TuningPlan& plan, const ParameterValues& values);

// score_of(): the objective's value, negated if the objective is minimised: larger is better. value_of(): the inverse.
double score_of(const TuningObjective& objective, double value);
double value_of(const TuningObjective& objective, double score);
// The text of an objective, such as "goal_difference" or "10 points - 0.5 overlap_seconds".
std::string in_words(const TuningObjective& objective);

// The least and the greatest score of a pair. score_bounds() returns nullopt if a measure has no bounds.
struct ScoreBounds {
  double low, high;
};
std::optional<ScoreBounds> score_bounds(const TuningPlan& plan);

// The largest possible score difference of candidate and base team in a pair; nullopt if there is no bound.
std::optional<double> difference_bound(const TuningPlan& plan);
// The difference_bound() for a test by betting; nullopt also if the plan asks for the test by symmetry.
std::optional<double> widest_difference(const TuningPlan& plan);

// The fewest pairs with which a verification can find a difference.
std::uint64_t least_verification_pairs(const TuningPlan& plan);

// The most pairs of each candidate. Candidates share the verification's matches, so fewer candidates play more pairs.
std::uint64_t verification_pairs_of(const TuningPlan& plan, std::size_t candidates);

// The metrics to read of each match: what the objective needs, and the packet metrics if short_games() is true.
campaign::Metrics wanted_metrics(const TuningPlan& plan);

// The most matches of one stage, and of all stages.
std::uint64_t most_matches(const TuningPlan& plan, TuningStage stage);
std::uint64_t most_matches(const TuningPlan& plan);

// Convert a plan to JSON and back. Reading throws std::invalid_argument for a text that to_json() cannot have written.
std::string to_json(const TuningPlan& plan);
TuningPlan tuning_plan_from_json(const std::string& text);

// The differences between the plan of a file and the new plan, in words; empty if the plans are equal.
std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now);

// Makes the plan of a document. Finds all mistakes before the first match. plugins: folders of the catalogue. mistakes:
// gets the mistakes in algorithm, opponents, parameters, openings and objective; with any, the plan is incomplete.
// Throws config::BadInput, and config::Error at the place of a mistake that leaves nothing else to check.
TuningPlan planned_tuning(const config::Node& document, const std::vector<std::string>& plugins,
                          const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

// Notes on a plan that is unusual but allowed, one line each: for example that an opponent is the base team itself.
std::vector<std::string> notes_on(const TuningPlan& plan);

// A tuned team as YAML, with only the lines that differ from the base team. name: the new team's name. base: the base
// team's file, for the key `extends` of the new file. A document with `extends` cannot change a part of a list, so a
// list with a tuned value is written whole. Throws config::Error if the base team's settings do not fit its document.
std::string tuned_team(const TuningPlan& plan, const ParameterValues& values, const std::string& name,
                       const std::string& base);

}  // namespace regista::study
