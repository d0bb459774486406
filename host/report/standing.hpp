// SPDX-License-Identifier: MIT
// The numbers that a report tells of a tournament, worked out once for its text and for its JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.hpp"
#include "statistics/likelihood_ratio.hpp"
#include "statistics/nash.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/score_law.hpp"
#include "statistics/square_table.hpp"
#include "study/tournament.hpp"

namespace regista::report {

// Of one pairing with at least one complete pair.
struct Strength {
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  double superiority;  // LOS, in [0, 1]
  std::optional<double> pair_ratio;
  double draw_ratio;                               // of pairs that ended even
  std::optional<double> score_ratio, goals_ratio;  // variance ratio of pairing
  std::optional<statistics::PairedT> goals_t;      // goal difference of a match; for a fixed number of pairs
};
std::optional<Strength> strength(const study::Meeting& meeting);

struct Ranked {
  std::size_t team = 0;
  std::optional<statistics::Estimate> elo;  // Bradley-Terry; nothing where the results do not tell it
  double nash = 0.0;                        // share in the equilibrium
  double points = 0.0;
  std::uint64_t matches = 0, wins = 0, draws = 0, losses = 0, scored = 0, conceded = 0, failures = 0;
};

// All teams, the best first: by Elo, else by their share of points, then in the order of the plan.
std::vector<Ranked> ranking(const study::TournamentPlan& plan, const study::Tournament& course);

// Two-sided p of "equal strength" of every pairing, from the signs of its pairs (statistics/sign_flip.hpp), and the
// same adjusted by Holm for their number. Only for a number of pairs that was fixed beforehand.
struct PValues {
  std::vector<double> single, adjusted;
};
PValues p_values(const study::Tournament& course);

double points(const statistics::GameCounts& games);  // of the first team

// Points that each team (row) won against each other one (column), as bradley_terry() wants them.
statistics::SquareTable points_won(const study::TournamentPlan& plan, const study::Tournament& course);

}  // namespace regista::report
