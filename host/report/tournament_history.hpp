// SPDX-License-Identifier: MIT
// The history of a tournament for its page: curves over pairs, goal differences, numbers of matches. The history takes
// the results in the order of the schedule. Its memory does not grow with the number of results.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/figure.hpp"
#include "report/study_report.hpp"
#include "statistics/moments.hpp"
#include "study/measure.hpp"
#include "study/tournament_course.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

// --- The numbers of matches (study/measure.hpp): for each team the mean over all matches that ended without a forfeit.
// For two teams also the difference between the teams in each pair.

struct TeamNumber {
  std::string path;             // "striker.overlap_seconds", "packets_by_reason.goal"; for all roles "overlap_seconds"
  statistics::Moments matches;  // one value per match
};

struct PairedNumber {
  std::string path;
  study::MetricDifference difference;  // first team minus second team, one value per pair
};

// Last parts of the paths of roles' numbers, such as "switches" of "striker.switches".
inline constexpr std::array<const char*, 3> role_measures{"overlap_seconds", "uncovered_seconds", "switches"};
inline constexpr const char* packets_prefix = "packets_by_reason.";

class MatchNumbers {
 public:
  explicit MatchNumbers(const study::TournamentPlan& plan);

  // Adds the next counted match in the order of the schedule.
  void take(const study::Fixture& fixture, const campaign::MatchResult& decided);

  // Returns the numbers of a team, at most 600, in the order of their first appearance.
  const std::vector<TeamNumber>& of_team(std::size_t team) const { return teams_[team]; }
  const statistics::Moments* find(std::size_t team, const std::string& path) const;  // null: the number does not exist
  const study::MetricDifference* difference(const std::string& path) const;  // null for an unknown path or more than
                                                                             // two teams

 private:
  using Values = std::vector<study::NamedValue>;
  static Values values(const match::MetricNumbers& metrics, int side);
  void finish_pair(const Values& a1, const Values& b1, const Values& a2, const Values& b2);

  std::vector<std::vector<TeamNumber>> teams_;
  std::vector<PairedNumber> pairs_;
  bool paired_;
  std::optional<std::array<Values, 2>> first_of_pair_;  // values of the first and of the second team
};

// These functions return the names of roles, the causes of packets, and the paths of plugins' numbers of the first
// `teams` teams: first the names of the first team in its order, then names that only other teams have.
std::vector<std::string> role_names(const MatchNumbers& numbers, std::size_t teams);
std::vector<std::string> packet_reasons(const MatchNumbers& numbers, std::size_t teams);
std::vector<std::string> plugin_metrics(const MatchNumbers& numbers, std::size_t teams);

// Returns whether the mean of this number is 0 or missing for each of the first `teams` teams.
bool all_zero(const MatchNumbers& numbers, std::size_t teams, const std::string& path);

// A point of the curves of two teams: estimates from the first `pair` pairs. An unknown value is missing or infinite.
struct PairPoint {
  std::uint64_t pair = 0;
  std::optional<statistics::Estimate> elo;
  std::optional<double> ratio;      // log-likelihood ratio in nats, if the test uses scores
  double lower = 0.0, upper = 0.0;  // bounds at which the test stops
  statistics::Estimate value;       // difference of goals or of the tested metric
};

// A point of the curves of more than two teams: estimates from the first `pair` pairs of each pairing.
struct RankingPoint {
  std::uint64_t pair = 0;
  std::vector<double> elo;  // Elo of each team; empty if the results do not determine Elo
};

// Numbers of matches with each goal difference, from one team's point of view. Differences above `largest` count as
// `largest`, differences below -`largest` as -`largest`.
struct GoalDifferences {
  static constexpr int largest = 10;
  using Counts = std::array<std::uint64_t, 2 * largest + 1>;  // index: goal difference plus `largest`
  Counts played{}, forfeited{};
};

// A match with a recording. The number of the match is the name of the recording.
struct RecordedRow {
  std::uint64_t index = 0;  // index in the schedule, from 0
  std::array<int, 2> score{};
  bool forfeited = false;
  std::optional<double> packets;  // packets of both teams; missing: unknown
};

class TournamentHistory {
 public:
  static constexpr std::size_t most_recorded = 200;  // largest number of recordings that the page reads
  static constexpr std::size_t most_ranked = 24;     // largest number of teams for which ranking_curve() has points

  // recorded: ascending indices of matches for which a recording file exists, with any content.
  TournamentHistory(const study::TournamentPlan& plan, const study::Tournament& course,
                    std::vector<std::uint64_t> recorded = {});

  // Takes the result that the course took just now. Call it after every Tournament::take() of the `course` given to the
  // constructor, with the same argument: the function reads from the course whether the match counted.
  void take(const campaign::MatchResult* decided);
  // Ends the history. The first match of the last pair counts even if the second match of this pair is missing.
  void end();

  std::vector<PairPoint> pair_curve() const;        // for two teams
  std::vector<RankingPoint> ranking_curve() const;  // for three or more teams
  const GoalDifferences& goals_of(std::size_t team) const { return goals_[team]; }
  const MatchNumbers& numbers() const { return numbers_; }
  const std::vector<RecordedRow>& recorded() const { return recorded_; }
  std::uint64_t recorded_matches() const { return recorded_count_; }
  // Returns 32 hexadecimal digits of scores, state hashes and forfeits in order. Equal matches give equal digits.
  const std::string& fingerprint() const { return fingerprint_.text(); }

 private:
  struct Match {
    std::uint64_t index;
    campaign::MatchResult decided;
  };
  void record(const Match& match, bool counts);  // counts: true if the pair of the match could be played
  PairPoint pair_point() const;
  RankingPoint ranking_point() const;

  const study::TournamentPlan& plan_;
  const study::Tournament& course_;
  Thinned<PairPoint> pair_points_;
  Thinned<RankingPoint> ranking_points_;
  std::vector<GoalDifferences> goals_;
  MatchNumbers numbers_;
  std::vector<std::uint64_t> wanted_;
  std::vector<RecordedRow> recorded_;
  std::uint64_t recorded_count_ = 0, matches_ = 0, unplayed_pairs_ = 0;
  std::optional<Match> first_of_pair_;  // kept until the second match shows whether the pair counts
  Fingerprint fingerprint_;
};

}  // namespace regista::report
