// SPDX-License-Identifier: MIT
// The numbers of matches (study/metric.hpp) as a page shows them: of each team the mean over all matches it played to
// their end; of two teams also their difference, pair by pair. In memory that does not grow with the matches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "statistics/moments.hpp"
#include "study/tournament.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

struct TeamNumber {
  std::string path;             // "striker.overlap_seconds", "packets_by_reason.goal"; "overlap_seconds": of all roles
  statistics::Moments matches;  // a value per match
};

struct PairedNumber {
  std::string path;
  study::MetricDifference difference;  // first team less second, a value per pair
};

// Of a path of a role, its last part is one of these.
inline constexpr std::array<const char*, 3> role_measures{"overlap_seconds", "uncovered_seconds", "switches"};
inline constexpr const char* packets_prefix = "packets_by_reason.";

class MatchNumbers {
 public:
  explicit MatchNumbers(const study::TournamentPlan& plan);

  // The next match that counts, in the order of the schedule.
  void take(const study::Fixture& fixture, const campaign::Decided& decided);

  // In the order in which they came up; the first six hundred.
  const std::vector<TeamNumber>& of_team(std::size_t team) const { return teams_[team]; }
  // Nothing where there are more than two teams.
  const std::vector<PairedNumber>& of_pairs() const { return pairs_; }
  const statistics::Moments* find(std::size_t team, const std::string& path) const;
  const study::MetricDifference* difference(const std::string& path) const;

 private:
  struct Value {
    std::string path;
    double number;
  };
  using Values = std::vector<Value>;
  static Values values(const match::MetricNumbers& metrics, int side);
  void finish_pair(const Values& a1, const Values& b1, const Values& a2, const Values& b2);

  std::vector<std::vector<TeamNumber>> teams_;
  std::vector<PairedNumber> pairs_;
  bool paired_;
  std::optional<std::array<Values, 2>> first_of_pair_;  // of the first team, of the second
};

}  // namespace regista::report
