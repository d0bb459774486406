// SPDX-License-Identifier: MIT
// A tuning as it was fixed before its first match: what may change, who is played, what counts as better, by which
// algorithm, how much, and which test decides. From it and the results of matches everything follows: which point is
// tried next, which ones are candidates, and what is said about them.
//
// Unit of everything is the pair: a match with the tuned team at home, then the same with the sides swapped, against
// every opponent. Pairs are numbered from 0 in each of four stages, whose seeds are disjoint:
//   seed = stage * 2^50 + first seed + number of the pair.
// Those of the verification begin at a number drawn from all that was chosen before, so that another choice is never
// verified on seeds that an earlier one was seen to do well on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/job.hpp"
#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "config/load.hpp"
#include "config/tuning.hpp"
#include "study/opening.hpp"
#include "study/tuning/algorithm.hpp"
#include "study/tuning/parameter.hpp"

namespace regista::study {

enum class TuningStage { search, selection, verification, slices };
const char* name(TuningStage stage);

struct ObjectiveTerm {
  std::string measure;  // see study/measure.hpp
  double weight = 1.0;
  friend bool operator==(const ObjectiveTerm&, const ObjectiveTerm&) = default;
};

// Sum of weighted measures, in the unit of the measure where it is one alone.
struct TuningObjective {
  std::vector<ObjectiveTerm> terms;  // one or more
  bool minimise = false;
  friend bool operator==(const TuningObjective&, const TuningObjective&) = default;
};

// Somebody whom the tuned team plays.
struct TuningOpponent {
  std::string label, file;
  double weight = 1.0;                // all of a plan sum up to 1
  std::array<campaign::Job, 2> jobs;  // the tuned team at home, away; it as the base team; without seed and opening
};

struct TuningPlan {
  config::Tuning asked;  // files as they are seen from `folder`

  std::string document;  // the team's, resolved, with every parameter in it, at its start
  std::vector<Parameter> parameters;
  // Of their jobs, and the base team's, the inputs were found, and their labels; all else is asked for: see complete().
  std::vector<TuningOpponent> opponents;
  TuningOpponent base;             // the base team as it is, as an opponent
  std::vector<Opening> openings;   // all scenes that are asked for; none: from kick-off
  int most_goals = 0;              // largest goal difference that a match can end with; a forfeit counts as that much
  std::uint64_t search_pairs = 0;  // against each opponent, of the whole search, at most
  std::uint64_t pairs = 1;         // of them for each point, with an algorithm that wants replication
  std::uint64_t selection_pairs = 0;     // of each finalist against each opponent
  std::uint64_t verification_pairs = 0;  // at most, of as many candidates as there may be
  std::string folder;                    // in which it was begun, absolute
  std::vector<std::string> plugins;      // folders of --plugins
  std::string program;                   // version that began it; empty: not known

  // What follows from what is asked: see complete().
  std::vector<std::string> settings;  // "path=value" of the team, laid over its file
  TuningObjective objective;

  std::uint64_t seed() const { return static_cast<std::uint64_t>(asked.seed); }
  Algorithm algorithm() const { return algorithm_named(asked.search.algorithm).value(); }
  std::uint64_t population() const { return static_cast<std::uint64_t>(asked.search.population.value_or(0)); }
  std::uint64_t finalists() const { return static_cast<std::uint64_t>(asked.selection.finalists); }  // at most
  std::uint64_t candidates() const { return static_cast<std::uint64_t>(asked.verification.candidates); }
  // Candidates and base team are compared playing each other.
  bool head_to_head() const { return asked.verification.against == config::Tuning::Against::base; }
  // Differences are taken to be symmetric, though the objective has bounds.
  bool symmetric() const { return asked.verification.test == config::Tuning::Test::symmetric; }
  double confidence() const { return asked.verification.confidence; }
  std::uint64_t slice_points() const { return static_cast<std::uint64_t>(asked.slices.points); }  // 0: none
  std::uint64_t slice_pairs() const {
    return asked.slices.points == 0 ? 0 : static_cast<std::uint64_t>(asked.slices.pairs);
  }
  campaign::Limits limits() const { return campaign::limits_of(asked.settings); }

  // All of them end before a match would.
  bool short_games() const { return !openings.empty() || asked.settings.limit; }
  std::size_t free_parameters() const;
  std::uint64_t pairs_of_evaluation() const { return asked.search.pairs || wants_replication(algorithm()) ? pairs : 1; }
  // Points that it can try, with the base team's.
  std::uint64_t evaluations() const { return search_pairs / pairs_of_evaluation(); }
  // Matches of one pair against all opponents.
  std::uint64_t matches_of_pair() const { return 2 * opponents.size(); }
};

// Settings and objective, and opponents with their jobs, as they are asked for; what was found of them stays. Throws
// config::Error for settings that cannot be.
void complete(TuningPlan& plan);

// Of matches against the opponents, or against the base team, in which it has all that is set for the tuned team.
config::Overrides settings_of(const TuningPlan& plan, bool against_base);

// What every search of its points relies on.
bool sound(const TuningPlan& plan);

// Values of all parameters, in the plan's order.
using ParameterValues = std::vector<double>;

ParameterValues start_values(const TuningPlan& plan);

// The free parameters as a point of the unit cube, and back.
Eigen::VectorXd point_of(const TuningPlan& plan, const ParameterValues& values);
ParameterValues values_of(const TuningPlan& plan, const Eigen::VectorXd& point);

// The base team's document with other values in it.
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
  std::vector<Place> places_;  // from the last to the first, so that those before stay where they are
};

// "path=value" for each parameter
std::vector<std::string> settings_of(const TuningPlan& plan, const ParameterValues& values);

// From the measures of a pair to one number: larger is better.
double score_of(const TuningObjective& objective, double value);
double value_of(const TuningObjective& objective, double score);
// "goal_difference", "10 points - 0.5 overlap_seconds"
std::string in_words(const TuningObjective& objective);

// The scores that a pair can have, where its measures have bounds.
struct ScoreBounds {
  double low, high;
};
std::optional<ScoreBounds> score_bounds(const TuningPlan& plan);

// The largest difference between candidate and base team that a pair can show, where betting is to test it.
std::optional<double> widest_difference(const TuningPlan& plan);

// The largest difference there can be, whatever it is tested by; nothing where there is no bound.
std::optional<double> difference_bound(const TuningPlan& plan);

// Pairs without which a verification cannot find anything, whatever they show.
std::uint64_t least_verification_pairs(const TuningPlan& plan);

// At most, of so many candidates: what fewer of them leave over goes to these.
std::uint64_t verification_pairs_of(const TuningPlan& plan, std::size_t candidates);

// What is looked at of the matches' metrics: by the objective, or for the packets of short games.
campaign::Metrics wanted_metrics(const TuningPlan& plan);

// How many matches each stage can take at most, and all of them.
std::uint64_t most_matches(const TuningPlan& plan, TuningStage stage);
std::uint64_t most_matches(const TuningPlan& plan);

// JSON; reading throws std::invalid_argument for what writing did not make.
std::string to_json(const TuningPlan& plan);
TuningPlan tuning_plan_from_json(const std::string& text);

// What differs between the plan of a file and the one that is asked for, in words; nothing when they are the same.
std::vector<std::string> differences(const TuningPlan& before, const TuningPlan& now);

}  // namespace regista::study
