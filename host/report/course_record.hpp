// SPDX-License-Identifier: MIT
// What a page wants to know of a tournament beyond how it ended: how it came there. Taken down while the results pass
// in the order of the schedule, in memory that does not grow with their number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/fingerprint.hpp"
#include "report/match_numbers.hpp"
#include "report/thinned.hpp"
#include "statistics/interval.hpp"
#include "study/tournament.hpp"
#include "study/tournament_plan.hpp"

namespace regista::report {

// After so many pairs of two teams. What is not known is nothing or infinite.
struct PairPoint {
  std::uint64_t pair = 0;
  std::optional<statistics::Estimate> elo;
  bool enough = false;              // pairs for its interval (elo_interval.hpp)
  std::optional<double> ratio;      // log-likelihood ratio of a test of scores, nats
  double lower = 0.0, upper = 0.0;  // where it stops
  statistics::Estimate value;       // difference of goals, or of the metric that is tested
};

// After so many pairs of each pairing of several teams: Elo by team; empty where the results do not determine it.
struct RankingPoint {
  std::uint64_t pair = 0;
  std::vector<double> elo;
};

// How often each goal difference came up, from one team's point of view; what is larger counts as the largest.
struct GoalDifferences {
  static constexpr int largest = 10;
  using Counts = std::array<std::uint64_t, 2 * largest + 1>;  // of -largest, ..., largest
  Counts played{}, forfeited{};
};

// A match of which there may be a recording: a file of its number.
struct RecordedRow {
  std::uint64_t index = 0;  // in the schedule, from 0
  std::array<int, 2> score{};
  bool forfeited = false;
  std::optional<double> packets;  // of both teams; none where it is not known
};

class CourseRecord {
 public:
  static constexpr std::size_t most_recorded = 200;  // that are looked into for the page
  static constexpr std::size_t most_ranked = 24;     // teams of which the ranking is followed

  // recorded: places in the schedule, ascending, that recordings are called by; whatever these hold.
  CourseRecord(const study::TournamentPlan& plan, const study::Tournament& course,
               std::vector<std::uint64_t> recorded = {});

  // To be called after every course.take(), with the same.
  void take(const campaign::Decided* decided);
  // No more matches come: the first of a pair whose second is missing counts, too.
  void end();

  std::vector<PairPoint> pair_curve() const;        // of two teams
  std::vector<RankingPoint> ranking_curve() const;  // of more
  const GoalDifferences& goals_of(std::size_t team) const { return goals_[team]; }
  const MatchNumbers& numbers() const { return numbers_; }
  const std::vector<RecordedRow>& recorded() const { return recorded_; }
  std::uint64_t recorded_matches() const { return recorded_count_; }
  // 32 hexadecimal digits over scores, state hashes and forfeits in order: equal where the same matches were played.
  const std::string& fingerprint() const { return fingerprint_.text(); }

 private:
  struct Match {
    std::uint64_t index;
    campaign::Decided decided;
  };
  enum class Pair { counted, could_not_be_played };
  void record(const Match& match, Pair pair);
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
  // Of the pair under way: whether it counts is known at its end.
  std::optional<Match> first_of_pair_;
  Fingerprint fingerprint_;
};

}  // namespace regista::report
