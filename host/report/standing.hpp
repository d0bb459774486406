// SPDX-License-Identifier: MIT
// Numbers for the report of a tournament. The text and the JSON use the same numbers.
#pragma once

#include <optional>
#include <vector>

#include "statistics/counts.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/rating.hpp"
#include "study/tournament_course.hpp"

namespace regista::report {

// The strength of two teams in their pairing. strength(): nothing without a complete pair or a possible verdict.
struct Strength {
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  std::optional<double> superiority;  // likelihood of superiority (LOS) of the first team, in (0, 1)
  std::optional<double> pair_ratio;
  double draw_ratio;                               // share of pairs in which both teams score the same points
  std::optional<double> score_ratio, goals_ratio;  // statistics::variance_ratio() of scores and of goals
  // t test of a match's goal difference, for a fixed number of pairs. Missing for unplayed or fewer than six pairs.
  std::optional<statistics::PairedT> goals_t;
};
std::optional<Strength> strength(const study::Tournament& course, const study::Meeting& meeting);
// Returns whether the finding at the end depends on the results that unplayed pairs might have had.
bool is_prevented(const study::Tournament& course, const study::Meeting& meeting);
// Returns whether the headline is "No verdict". Then no table follows the headline.
bool is_without_verdict(const study::TournamentPlan& plan, const study::Tournament& course);

// Returns whether the number of pairs was fixed beforehand, without a sequential test, and all pairs are played.
bool is_of_fixed_number(const study::TournamentPlan& plan, const study::Tournament& course);

struct Ranked {
  std::size_t team = 0;
  std::optional<statistics::Estimate> elo;  // Bradley-Terry; missing if the results do not determine the strengths
  std::optional<double> nash;  // share of the team in the equilibrium (Nash averaging); missing until all have met
  double points = 0.0;
  std::uint64_t matches = 0, wins = 0, draws = 0, losses = 0, scored = 0, conceded = 0, failures = 0;
};

// Returns all teams from best to worst: by Elo, or by share of points if Elo is missing; ties keep the plan's order.
std::vector<Ranked> ranking(const study::TournamentPlan& plan, const study::Tournament& course);

// The deciding test for a fixed number of pairs. For every pairing: the two-sided p of "equal teams" by exact sign
// flips of the goal differences of its pairs (statistics/paired_tests.hpp), adjusted by Holm for the number of
// pairings. With unplayed pairs, p is the largest p of three ways to count these pairs: ignored, all lost by the first
// team, all won by the first team. p is 1 if the three ways favour different teams.
struct PValues {
  std::vector<double> single, adjusted;
  std::vector<bool> prevented;  // for each pairing: some of the three ways give a finding at 5 %, and some do not
};
PValues p_values(const study::Tournament& course);
inline constexpr double significance_level = 0.05;

// Returns 1 or -1 if the finished test found that the first or second team scores more goals, and 0 without a finding.
int decided_for(const study::Tournament& course, const PValues& p, std::size_t pairing);

// Returns whether `team` is the best team whatever the results of unplayed pairs: its Elo would be larger than the Elo
// of each other team even if `team` lost all its unplayed pairs and the other team won all its unplayed pairs.
bool leads_either_way(const study::TournamentPlan& plan, const study::Tournament& course, std::size_t team);

double points(const statistics::GameCounts& games);  // points of the first team: 1 for a win, 1/2 for a draw

std::vector<statistics::Encounter> encounters(const study::Tournament& course);  // all matches, by pairing

// Returns the points of each team (row) against each other team (column), for bradley_terry_elo().
statistics::SquareTable points_won(const study::TournamentPlan& plan, const study::Tournament& course);

}  // namespace regista::report
