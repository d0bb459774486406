// SPDX-License-Identifier: MIT
// The numbers that a report shows of a tournament, worked out once for its text and for its JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/encounter.hpp"
#include "statistics/interval.hpp"
#include "statistics/likelihood_ratio.hpp"
#include "statistics/nash.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/score_law.hpp"
#include "statistics/square_table.hpp"
#include "study/tournament.hpp"

namespace regista::report {

// Of one pairing with at least one complete pair, unless its pairs that could not be played prevent a verdict.
struct Strength {
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  double superiority;  // LOS, in [0, 1]
  std::optional<double> pair_ratio;
  double draw_ratio;                               // of pairs that ended even
  std::optional<double> score_ratio, goals_ratio;  // variance ratio of pairing
  std::optional<statistics::PairedT> goals_t;      // goal difference of a match; for a fixed number of pairs
};
std::optional<Strength> strength(const study::Tournament& course, const study::Meeting& meeting);
// Whether that is so, at the end: some way to count those pairs makes a finding, but not all do.
bool is_prevented(const study::Tournament& course, const study::Meeting& meeting);
// Whether the headline is "No verdict": then no table follows.
bool is_without_verdict(const study::TournamentPlan& plan, const study::Tournament& course);

struct Ranked {
  std::size_t team = 0;
  std::optional<statistics::Estimate>
      elo;            // Bradley-Terry; nothing where the results do not determine it, or who leads
  double nash = 0.0;  // share in the equilibrium
  double points = 0.0;
  std::uint64_t matches = 0, wins = 0, draws = 0, losses = 0, scored = 0, conceded = 0, failures = 0;
};

// All teams, the best first: by Elo, else by their share of points, then in the order of the plan.
std::vector<Ranked> ranking(const study::TournamentPlan& plan, const study::Tournament& course);

// Two-sided p of "equal strength" of every pairing, from the signs of its pairs (statistics/sign_flip.hpp), and the
// same adjusted by Holm for their number. Only for a number of pairs that was fixed beforehand.
//
// Of a pairing some of whose pairs could not be played: the largest of its p without these pairs, with all of them lost
// by the first team, and with all of them won by it; 1 where these do not speak for the same team. So what is below a
// level is so in each of the three ways.
struct PValues {
  std::vector<double> single, adjusted;
  // Of such a pairing: some way to count those pairs makes a finding at 5 %, but not all do.
  std::vector<bool> prevented;
};
PValues p_values(const study::Tournament& course);
inline constexpr double significance_level = 0.05;

// The team, the first of the ranking, also has the larger Elo than each other one with all pairs that could not be
// played lost by it, and won by that other one.
bool leads_either_way(const study::TournamentPlan& plan, const study::Tournament& course, std::size_t team);

double points(const statistics::GameCounts& games);  // of the first team

// All that was played, by pairing.
std::vector<statistics::Encounter> encounters(const study::Tournament& course);

// Points that each team (row) won against each other one (column), as bradley_terry_elo() wants them.
statistics::SquareTable points_won(const study::TournamentPlan& plan, const study::Tournament& course);

}  // namespace regista::report
