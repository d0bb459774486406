// SPDX-License-Identifier: MIT
// The course of a tournament: what its results so far add up to. The class Tournament takes the results in the order of
// the schedule, keeps the counts, adds the results to the test, and decides when the tournament is over. The memory for
// each pairing is constant. The class counts pairs, because the two matches of a pair are not independent.
//
// A forfeit counts 0:10. The goal difference of a forfeit is limited to the largest possible difference of a match of
// its length, so that a forfeit does not outweigh played matches. A pair with a forfeit has no metrics.
//
// If a match could not be played, its whole pair does not count. The test then runs three times: without the unplayed
// pairs, with all of them as wins of the first team, and with all of them as wins of the second team. A verdict counts
// only if all three tests give it, so that no team gains by a match that cannot be played.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "campaign/job.hpp"
#include "statistics/anytime_valid_tests.hpp"
#include "statistics/counts.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/sequential_test.hpp"
#include "study/measure.hpp"
#include "study/study.hpp"
#include "study/tournament_calendar.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

// Compares a metric of two teams pair by pair. The metric may have any distribution. The deciding test bets on the sign
// of the difference. Reports also show the mean difference.
class MetricDifference {
 public:
  explicit MetricDifference(double alpha);

  // Adds a pair. first, second: the mean of the metric over the pair's matches, for each team.
  void add(double first, double second);

  const statistics::Moments& first() const { return first_; }
  const statistics::Moments& second() const { return second_; }
  const statistics::Moments& difference() const { return difference_; }
  // Numbers of pairs in which the first team's value was smaller, equal, larger.
  const std::array<std::uint64_t, 3>& signs() const { return signs_; }
  // The test that bets on the sign of the difference. The test is exact for any distribution of the metric.
  const statistics::BettingTest& test() const { return test_; }
  // The mean difference. Its interval is valid after each pair, but approximate for few pairs (estimated variance).
  statistics::Estimate estimate() const;

 private:
  double alpha_;
  statistics::Moments first_, second_, difference_;
  std::array<std::uint64_t, 3> signs_{};
  statistics::BettingTest test_;
};

// The test that decides a tournament: on the scores of pairs, goal differences, or signs of a metric's difference.
using ObjectiveTest = std::variant<statistics::SequentialTest, statistics::BettingGrid, statistics::BettingTest>;

// The results of one pairing, from its first team's point of view.
struct Meeting {
  Meeting(const TournamentPlan& plan, const Pairing& pairing);

  Pairing pairing;
  statistics::GameCounts games;
  statistics::PairCounts pairs;
  std::array<std::uint64_t, 2> goals{};    // goals of the first and the second team, with forfeits
  statistics::Moments goals_of_matches;    // goal difference of each match
  statistics::WholeCounts goals_by_pair;   // how often each sum of the two goal differences of a pair occurred
  statistics::Moments goals_of_pairs;      // mean goal difference of the matches of each pair
  statistics::BettingGrid goals_sequence;  // sequential estimate of the mean of goals_of_pairs
  std::optional<statistics::SequentialTest> score_test;
  std::optional<MetricDifference> metric;
  std::uint64_t pairs_without_metric = 0;  // pairs with a forfeit, or with a match that lacks the metric
  std::uint64_t unplayed_pairs = 0;        // pairs with a match that could not be played; other counts omit these pairs
  std::uint64_t set_aside = 0;             // matches that could not be played
  // After the first unplayed pair: the test with unplayed pairs counted for the second ([0]) or first ([1]) team.
  std::optional<std::array<ObjectiveTest, 2>> either_way;

  std::uint64_t matches() const { return static_cast<std::uint64_t>(total(games)); }
};

// The result of a test. none: the plan has no test. inconclusive: no decision yet. accept_h0, accept_h1: the accepted
// hypothesis; a test on a value accepts only H1, a difference. prevented: no verdict is possible, because the test's
// results with unplayed pairs counted for either team, and without these pairs, do not agree.
enum class Verdict { none, inconclusive, accept_h0, accept_h1, prevented };

// A team that plays no more matches because its plugin failed too often in a row.
struct SetAside {
  std::size_t team = 0;
  std::string plugin;
  std::uint64_t failures = 0;  // number of failures in a row
  std::uint64_t pair = 0;      // the team's last pair, from 0
};

class Tournament final : public Study {
 public:
  // The plan must outlive this object.
  explicit Tournament(const TournamentPlan& plan);

  const char* what() const override { return "tournament"; }
  std::string unplayable() const override { return unplayable_; }
  std::uint64_t most_matches() const override { return end(); }
  std::uint64_t counted() const override { return matches(); }
  campaign::Metrics metrics() const override;
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string_view open_end() const override { return plan_.ended_after ? "" : plan_.open_end(); }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(tournament_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  const Calendar& calendar() const { return calendar_; }
  int most_goals() const { return plan_.most_goals; }  // the largest goal difference that a match counts

  // False if a team of this match was set aside.
  bool wanted(std::uint64_t index) const;

  // Precondition: match 0, 1, ... in order; null: an unwanted match. Returns false when the tournament is over.
  bool take(const campaign::MatchResult* decided);

  std::uint64_t taken() const { return next_; }             // number of calls of take()
  bool complete() const { return at_its_end() || over(); }  // no more matches are needed
  std::uint64_t matches() const;                            // number of matches that counted
  const std::vector<Meeting>& meetings() const { return meetings_; }
  const ForfeitList& forfeits() const { return forfeits_; }  // teams: indices in the plan
  const std::vector<SetAside>& set_aside() const { return set_aside_; }
  const MatchRemarks& remarks() const { return remarks_; }
  // The packets that a team sent in short games that were played to their end. Whole matches do not count.
  const PacketsSpent& packets(std::size_t team) const { return packets_[team]; }
  std::uint64_t unplayed_pairs() const;  // sum over all pairings
  Verdict verdict() const;
  SwissStanding swiss_standing() const;  // points of the matches, and of byes as if they had been won
  // The team of a knock-out's meeting that goes on: by points, then by goals, then the team that the plan names first.
  std::size_t winner(const Meeting& meeting) const;
  bool first_has_more() const;  // for a test on a value: the first team's value is larger

 private:
  struct Row {
    std::string plugin;
    std::uint64_t failures = 0;
  };
  // The counts before the first match of the current pair. leave_out_pair() restores these counts.
  struct BeforePair {
    statistics::GameCounts games;
    std::array<std::uint64_t, 2> goals{};
    statistics::Moments goals_of_matches;
    ForfeitList forfeits{0};
    std::array<PacketsSpent, 2> packets;  // packets_ of the pairing's teams
  };
  bool is_set_aside(std::size_t team) const;
  void add(Meeting& meeting, const Fixture& fixture, const campaign::MatchResult& decided);
  void count_match(Meeting& meeting, const Fixture& fixture, const campaign::MatchResult& decided);
  void finish_pair(Meeting& meeting, const campaign::MatchResult& second);
  void leave_out_pair(Meeting& meeting, const Fixture& fixture);
  void count_row(const Fixture& fixture, const campaign::MatchResult& decided);
  bool nobody_is_left() const;
  Round round(std::uint64_t first, std::uint64_t end);  // the matches with indices from `first` on, before `end`
  std::vector<std::size_t> next_round() const;          // the pairings that meet
  std::uint64_t end() const { return 2 * plan_.meetings() * plan_.pairs_to_its_end(); }
  bool at_its_end() const {
    const bool all_drawn = calendar_.drawn().size() == calendar_.rounds();
    return next_ >= (calendar_.rounds() > 0 && all_drawn ? calendar_.drawn_matches() : end()) || nobody_is_left();
  }
  bool over() const;

  const TournamentPlan& plan_;
  const Objective objective_;
  Calendar calendar_;
  std::vector<Meeting> meetings_;
  std::optional<campaign::MatchResult> first_of_pair_;
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
