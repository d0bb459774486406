// SPDX-License-Identifier: MIT
// The measures of an experiment: numbers of one team in one match. "goals", "goals_against", "goal_difference" and
// "points" (1 for a match won, 1/2 for one drawn) come from the score; all others are paths of the match's metrics, see
// match/metric_table.hpp. Times are given as minutes in 60 minutes of play, so that matches of any length compare;
// everything else per match, as it stands.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "study/metric.hpp"

namespace regista::study {

inline constexpr std::array<const char*, 4> measures_of_score{"goals", "goals_against", "goal_difference", "points"};

// How long something held, by match::metric_table(): "striker.overlap_seconds".
bool is_time(std::string_view measure);

// "min per 60 min" or "per match"
const char* unit_of(std::string_view measure);

// Of a pair of matches, in that unit: from the sum over both, and the time that both were in the phase Playing, s. Not
// a number for a time where nothing was played.
double pair_in_unit(std::string_view measure, double sum, double playing_seconds);

// One of the measures of the score, for the team on this side; nothing for any other measure.
std::optional<double> measure_of_score(std::string_view measure, const campaign::Decided& decided, int side);

// What a team did in a match that was played to its end.
class MatchMeasures {
 public:
  // side: of the team.
  MatchMeasures(const campaign::Decided& decided, int side);

  // As the match has it, times in seconds; nothing where it has none.
  std::optional<double> value(const std::string& measure) const;
  const std::vector<NamedValue>& all() const { return values_; }  // those of the score first
  double playing_seconds() const { return playing_seconds_; }

 private:
  std::vector<NamedValue> values_;
  double playing_seconds_;
};

}  // namespace regista::study
