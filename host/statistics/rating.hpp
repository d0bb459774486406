// SPDX-License-Identifier: MIT
// Computes the strength of teams from counts of results. For two teams: Elo, normalised Elo, likelihood of superiority
// and pair ratio. For several teams: strengths, and a ranking that shows cycles.
//
// Elo (A. E. Elo, "The Rating of Chessplayers, Past and Present", 1978): a team that scores the share s of the points
// is stronger by -400 log10(1/s - 1).
//
// Normalised Elo (M. Van den Bergh, "Normalized Elo", 2021): (mean score - 1/2) / (standard deviation of one game's
// score), times 800/ln 10. With this factor, normalised Elo is close to Elo if few games are drawn. Unlike Elo, it
// tells how many games are needed to see a difference. Without the factor, normalised Elo is a Sharpe ratio, so its
// interval follows E. Mertens, "Comments on variance of the IID estimator in Lo (2002)", 2002.
//
// After a sequential test has stopped, every estimate here is biased towards the side that won the test.
#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "statistics/counts.hpp"
#include "statistics/moments.hpp"

namespace regista::statistics {

// The spread of scores is estimated only from at least this number of units with a score other than 1/2.
inline constexpr Count fewest_uneven = 10;

inline constexpr double normalized_elo_scale = 347.43558552260146;  // 800 / ln 10

// Converts a score in (0, 1) to Elo; Elo is infinite at 0 and 1.
double elo_of_score(double score);
double score_of_elo(double elo);  // 1 / (1 + 10^(-elo/400))

// All intervals in this file have this confidence.
inline constexpr double confidence = 0.95;

// Returns the interval of the true mean score, a part of [0, 1]. If the units do not bound the score: {0, 1}. Methods:
//   - With fewest_uneven or more units that did not score 1/2: Student's t, units - 1 degrees of freedom.
//   - If Student's interval exceeds [0, 1]: the method of C. J. Clopper and E. S. Pearson, "The Use of Confidence or
//     Fiducial Limits Illustrated in the Case of the Binomial", 1934, bounds the share of units that the leading team
//     won outright. The score of this team is at least this share. The other bound is 0 or 1.
//   - If all n units scored the same s other than 1/2: at least s tail^(1/n), for any n, by Markov's inequality: a team
//     with mean score m reaches s or more with a probability of at most m / s. Each tail is (1 - confidence) / 2.
Interval score_interval(const ScoreLaw& law);

// Returns Elo of the observed mean score and its interval from score_interval(). Elo is infinite if all units were won.
Estimate elo(const ScoreLaw& law);

// Normalised Elo: 347.44 (mean - 1/2) / sd of one game; for pairs, sd of one game = sqrt(2 variance).
//
// The interval of the effect d = (mean - 1/2) / sd follows from the delta method, which includes the uncertainty of sd:
// d +- t sqrt((1 - d skewness + d^2 (kurtosis - 1) / 4) / (units - 1)). Skewness and kurtosis (3 for a normal
// distribution) refer to the scores of units. t is Student's t with units - 1 degrees of freedom, or fewer if few units
// cause most of this variance. If few_for_spread() is not `no`, the interval is infinite on both sides.
Estimate normalized_elo(const ScoreLaw& law);

// The reason why the units are too few to estimate the spread, so that normalised Elo has no interval. In simulations
// (benchmarks/statistics/coverage.cpp), intervals from so few units contained the truth in less than 90 % of cases.
enum class FewForSpread {
  no,
  uneven,  // fewer than fewest_uneven units scored other than 1/2
  won,     // the leading team won every unit, so no unit shows how this team loses points
};
FewForSpread few_for_spread(const ScoreLaw& law);

// Returns the likelihood of superiority, in (0, 1): the part above 1/2 of Student's distribution around the mean score.
// Returns nothing if score_interval() uses another method than Student's t.
std::optional<double> likelihood_of_superiority(const ScoreLaw& law);

// Returns pairs won over pairs lost: (WD + WW) / (LL + LD), or nothing without a lost pair.
std::optional<double> pair_ratio(const PairCounts& counts);

// A table with a number for each team (row) against each team (column).
class SquareTable {
 public:
  explicit SquareTable(std::size_t teams) : teams_(teams), values_(teams * teams, 0.0) {}

  std::size_t teams() const { return teams_; }
  double& at(std::size_t row, std::size_t column) { return values_[index(row, column)]; }
  double at(std::size_t row, std::size_t column) const { return values_[index(row, column)]; }

 private:
  std::size_t index(std::size_t row, std::size_t column) const {
    assert(row < teams_ && column < teams_);
    return row * teams_ + column;
  }
  std::size_t teams_;
  std::vector<double> values_;
};

// --- Strengths of several teams from their results: R. A. Bradley and M. E. Terry, "Rank Analysis of Incomplete Block
// Designs", Biometrika 39, 1952. Team i beats team j with probability g_i / (g_i + g_j). The minorisation-maximisation
// of D. R. Hunter, "MM Algorithms for Generalized Bradley-Terry Models", Annals of Statistics 32, 2004, maximises the
// likelihood: g_i = wins_i / sum_j games_ij / (g_i + g_j). Newton's method continues if this needs too many rounds.
//
// A draw counts as half a win, and the two games of a pair are dependent. So this likelihood is not the true likelihood
// of the results, and its curvature does not measure certainty. The intervals use the sandwich A B A (P. J. Huber, "The
// Behavior of Maximum Likelihood Estimates under Nonstandard Conditions", Fifth Berkeley Symposium, 1967). A is the
// pseudo-inverse of the curvature. B is the covariance of the points, estimated from the spread of pairs.

// `points.at(i, j)`: points of team i against team j, 0 or more: 1 for a win, 1/2 for a draw. The diagonal is ignored.
// Returns Elo (400 log10 g) of each team; the sum is 0. The list is empty without teams. A single team has Elo 0.
//
// Returns nothing if the points do not determine the strengths: a team or a group of teams took no point from all
// others or never met them (the condition of L. R. Ford, "Solution of a Ranking Problem from Binary Comparisons",
// American Mathematical Monthly 64, 1957).
std::optional<std::vector<double>> bradley_terry_elo(const SquareTable& points);

// Returns the points of all encounters as bradley_terry_elo() needs them. Two teams may have several encounters.
SquareTable points_won(std::size_t teams, std::span<const Encounter> encounters);

// Teams that met, at once or by others, are a group. Returns for each team the first team of its group.
std::vector<std::size_t> groups_that_met(std::size_t teams, std::span<const Encounter> encounters);

// Returns the Elo of bradley_terry_elo() with intervals. The intervals hold if the number of pairs of each encounter
// was fixed in advance and if pairs and single games are independent. They use Student's t with degrees of freedom by
// F. E. Satterthwaite, "An Approximate Distribution of Estimates of Variance Components", Biometrics Bulletin 2, 1946.
// A team has an infinite interval if fewer than `fewest_uneven` of its units were uneven or if it won or lost all.
std::optional<std::vector<Estimate>> bradley_terry(std::size_t teams, std::span<const Encounter> encounters);

// --- Nash averaging: a ranking that shows cycles and does not change if a team is copied. The ranking is the
// equilibrium of the largest entropy in a symmetric zero-sum game in which both players choose a team. D. Balduzzi et
// al., "Re-evaluating Evaluation", NeurIPS 2018.

struct NashAverage {
  std::vector<double> share;  // probability of each team in the equilibrium: in [0, 1], sum 1
  std::vector<double> value;  // expected payoff of each team against the equilibrium: 0 for teams in it, others <= 0
};

// `payoff.at(i, j)`: average gain of team i against team j, finite, in any unit with 0 for equality: Elo, goal
// difference, score - 1/2. Only the antisymmetric part (payoff(i, j) - payoff(j, i)) / 2 counts. Accuracy: 1e-6 of the
// largest payoff. Empty without teams; equal shares if all payoffs are 0.
NashAverage nash_average(const SquareTable& payoff);

}  // namespace regista::statistics
