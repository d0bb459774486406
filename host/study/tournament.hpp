// SPDX-License-Identifier: MIT
// The course of a tournament: takes the results in the order of the schedule, keeps the counts, feeds the test, and
// says when it is over. Constant memory for each pairing. What is counted are pairs, because the two matches of one are
// not independent. A forfeit counts 0:10, but as a difference of goals no more than a match of its length can end with,
// lest one of them outweigh all that was played; its metrics are missing, and with them those of its pair. A match that
// could not be played is counted nowhere, and neither is the other one of its pair; what the test says then has to hold
// with all such pairs counted for either team (objective_test.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "statistics/betting_grid.hpp"
#include "statistics/counts.hpp"
#include "statistics/moments.hpp"
#include "statistics/sequential_test.hpp"
#include "study/forfeits.hpp"
#include "study/match_remarks.hpp"
#include "study/metric_difference.hpp"
#include "study/objective_test.hpp"
#include "study/packets_spent.hpp"
#include "study/study.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

// What is known of one pairing, from its first team's point of view.
struct Meeting {
  Meeting(const TournamentPlan& plan, const Pairing& pairing);

  Pairing pairing;
  statistics::GameCounts games;
  statistics::PairCounts pairs;
  std::array<std::uint64_t, 2> goals{};    // of the first team, of the second; those of forfeits too
  statistics::Moments goals_of_matches;    // goal difference of each match
  statistics::Moments goals_of_pairs;      // mean goal difference of the matches of each pair
  statistics::BettingGrid goals_sequence;  // of the latter
  std::optional<statistics::SequentialTest<statistics::PairCounts>> score_test;
  std::optional<MetricDifference> metric;
  std::uint64_t pairs_without_metric = 0;  // a match of them was forfeited, or has no such number
  std::uint64_t unplayed_pairs = 0;        // a match of them could not be played; counted nowhere above
  std::uint64_t set_aside = 0;             // matches of them
  // From the first of these on: the test with all of them counted for the second team, and for the first.
  std::optional<std::array<ObjectiveTest, 2>> either_way;

  std::uint64_t matches() const { return static_cast<std::uint64_t>(total(games)); }
};

// How a test ended. A test on a value never accepts that there is no difference. prevented: it would come out
// otherwise, or would not come out, if the pairs that could not be played were counted for one of the teams.
enum class Verdict { none, inconclusive, accept_h0, accept_h1, prevented };

// A team that does not play on: its plugin failed too often in a row.
struct SetAside {
  std::size_t team = 0;
  std::string plugin;
  std::uint64_t failures = 0;  // in a row
  std::uint64_t pair = 0;      // the last in which it played, from 0
};

class Tournament final : public Study {
 public:
  // The plan outlives it.
  explicit Tournament(const TournamentPlan& plan);

  const char* what() const override { return "tournament"; }
  std::string unplayable() const override { return unplayable_; }
  std::uint64_t most_matches() const override { return calendar_.matches(); }
  std::uint64_t counted() const override { return matches(); }
  campaign::Metrics metrics() const override;
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(tournament_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  const Calendar& calendar() const { return calendar_; }

  // False for a match of a team that was set aside.
  bool wanted(std::uint64_t index) const;

  // Precondition: match 0, then 1, ...; nothing for one that is not wanted. False: it is over.
  bool take(const campaign::Decided* decided);

  std::uint64_t taken() const { return next_; }  // places of the schedule so far
  // All was played, or nothing more is needed.
  bool complete() const { return at_its_end() || over(); }
  std::uint64_t matches() const;  // that counted
  const std::vector<Meeting>& meetings() const { return meetings_; }
  const ForfeitList& forfeits() const { return forfeits_; }  // by team
  const std::vector<SetAside>& set_aside() const { return set_aside_; }
  const MatchRemarks& remarks() const { return remarks_; }
  // Of the matches of short games that a team played to their end; of none where they are whole matches.
  const PacketsSpent& packets(std::size_t team) const { return packets_[team]; }
  std::uint64_t unplayed_pairs() const;  // of all pairings
  Verdict verdict() const;
  // Of a test on a value: whether the first team's is the larger.
  bool first_has_more() const;

 private:
  struct Row {
    std::string plugin;
    std::uint64_t failures = 0;
  };
  // What the first match of a pair adds to, as it was before.
  struct BeforePair {
    statistics::GameCounts games;
    std::array<std::uint64_t, 2> goals{};
    statistics::Moments goals_of_matches;
    std::array<PacketsSpent, 2> packets;  // of the pairing's teams
  };
  bool is_set_aside(std::size_t team) const;
  void add(Meeting& meeting, const Fixture& fixture, const campaign::Decided& decided);
  void count_match(Meeting& meeting, const Fixture& fixture, const campaign::Decided& decided);
  void count_packets(const Fixture& fixture, const campaign::Decided& decided);
  void finish_pair(Meeting& meeting, const campaign::Decided& second);
  void leave_out_pair(Meeting& meeting, const Fixture& fixture);
  void count_row(const Fixture& fixture, const campaign::Decided& decided);
  bool nobody_is_left() const;
  bool at_its_end() const { return next_ == calendar_.matches() || nobody_is_left(); }
  bool over() const;

  const TournamentPlan& plan_;
  const Objective objective_;
  Calendar calendar_;
  std::vector<Meeting> meetings_;
  std::optional<campaign::Decided> first_of_pair_;
  BeforePair before_pair_;
  ForfeitList forfeits_;
  std::string unplayable_;
  MatchRemarks remarks_;
  PacketsOfShortGames short_games_;
  std::vector<PacketsSpent> packets_;  // by team
  std::vector<Row> rows_;              // by team
  std::vector<SetAside> set_aside_;
  std::uint64_t next_ = 0;
};

}  // namespace regista::study
