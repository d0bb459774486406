// SPDX-License-Identifier: MIT
#include "statistics/rating.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace regista::statistics {
namespace {

bool has_student_law(const ScoreLaw& law) { return law.variation == Variation::some && law.uneven() >= fewest_uneven; }

// The uncertainty of the effect (mean - 1/2) / sd.
struct EffectSpread {
  double variance;  // variance of the effect times (units - 1)
  double degrees;   // degrees of freedom of this estimated variance
};

// The influence function of the effect d is z - d (z^2 - 1) / 2, where z is the standardised score. Its variance is 1 -
// d skewness + d^2 (kurtosis - 1) / 4. If only this variance were uncertain, its kurtosis k would give 2 units / (k -
// 1) degrees of freedom. This number is too small, because the variance is large where the effect is large. Of all
// tried multiples, twice this number gave the best coverage for twelve families of distributions.
EffectSpread spread_of_effect(const ScoreLaw& law) {
  const double sd = std::sqrt(law.variance), d = (law.mean - 0.5) / sd;
  double squares = 0.0, fourths = 0.0;
  for (std::size_t i = 0; i < law.outcomes; ++i) {
    const double z = (law.scores[i] - law.mean) / sd, influence = z - d * (z * z - 1.0) / 2.0;
    squares += law.probabilities[i] * influence * influence;
    fourths += law.probabilities[i] * influence * influence * influence * influence;
  }
  const double most = law.units - 1.0, excess = fourths / (squares * squares) - 1.0;
  return {squares, excess * most > 4.0 * law.units ? 4.0 * law.units / excess : most};
}

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_rounds = 2000;
constexpr int most_newton_steps = 100;
constexpr double settled = 1e-13;  // largest relative change of a strength in a round

// Returns whether a chain of points leads from the first team to every other team and back.
bool connected(const SquareTable& points) {
  for (const bool forwards : {true, false}) {
    std::vector<bool> reached(points.teams(), false);
    std::vector<std::size_t> open{0};
    reached[0] = true;
    while (!open.empty()) {
      const std::size_t from = open.back();
      open.pop_back();
      for (std::size_t to = 0; to < points.teams(); ++to) {
        if (reached[to] || !((forwards ? points.at(from, to) : points.at(to, from)) > 0.0)) continue;
        reached[to] = true;
        open.push_back(to);
      }
    }
    if (std::find(reached.begin(), reached.end(), false) != reached.end()) return false;
  }
  return true;
}

// Runs one round for all teams in order, using the newest strengths. Returns the largest relative change of a strength.
double improve(const SquareTable& points, std::vector<double>& strength) {
  double change = 0.0;
  for (std::size_t i = 0; i < strength.size(); ++i) {
    double wins = 0.0, weighted = 0.0;
    for (std::size_t j = 0; j < strength.size(); ++j) {
      if (j == i) continue;
      assert(points.at(i, j) >= 0.0);
      wins += points.at(i, j);
      weighted += (points.at(i, j) + points.at(j, i)) / (strength[i] + strength[j]);
    }
    const double next = wins / weighted;
    change = std::max(change, std::abs(next / strength[i] - 1.0));
    strength[i] = next;
  }
  // Only ratios of strengths matter. Without this normalisation the scale of the strengths would drift.
  double log_mean = 0.0;
  for (const double each : strength) log_mean += std::log(each) / static_cast<double>(strength.size());
  for (double& each : strength) each /= std::exp(log_mean);
  return change;
}

// Returns the pseudo-inverse of the curvature in ln g. Its only null direction changes all strengths together.
MatrixXd inverse_curvature(const SquareTable& points, const std::vector<double>& elo) {
  const auto teams = static_cast<Eigen::Index>(elo.size());
  const MatrixXd mean = MatrixXd::Constant(teams, teams, 1.0 / static_cast<double>(teams));
  MatrixXd curvature = mean;
  for (std::size_t i = 0; i < elo.size(); ++i) {
    for (std::size_t j = 0; j < elo.size(); ++j) {
      if (i == j) continue;
      const double expected = score_of_elo(elo[i] - elo[j]);
      const double weight = (points.at(i, j) + points.at(j, i)) * expected * (1.0 - expected);
      curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += weight;
      curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) -= weight;
    }
  }
  return curvature.ldlt().solve(MatrixXd::Identity(teams, teams)) - mean;
}

double log_likelihood(const SquareTable& points, const std::vector<double>& elo) {
  double out = 0.0;
  for (std::size_t i = 0; i < elo.size(); ++i) {
    for (std::size_t j = 0; j < elo.size(); ++j) {
      if (i == j || !(points.at(i, j) > 0.0)) continue;
      out -= points.at(i, j) * std::log1p(std::exp((elo[j] - elo[i]) * 2.0 / normalized_elo_scale));
    }
  }
  return out;
}

// Takes Newton steps to the maximum of the likelihood and halves each step until the likelihood does not fall. In a
// chain of teams, minorisation-maximisation is too slow: each round moves information by only one team.
void settle(const SquareTable& points, std::vector<double>& elo) {
  const double to_elo = normalized_elo_scale / 2.0;  // factor from ln g to Elo
  double reached = log_likelihood(points, elo);
  for (int step = 0; step < most_newton_steps; ++step) {
    VectorXd gradient = VectorXd::Zero(static_cast<Eigen::Index>(elo.size()));
    for (std::size_t i = 0; i < elo.size(); ++i) {
      for (std::size_t j = 0; j < elo.size(); ++j) {
        if (i == j) continue;
        const double games = points.at(i, j) + points.at(j, i);
        gradient(static_cast<Eigen::Index>(i)) += points.at(i, j) - games * score_of_elo(elo[i] - elo[j]);
      }
    }
    const VectorXd direction = to_elo * (inverse_curvature(points, elo) * gradient);
    double share = 1.0;
    std::vector<double> next(elo.size());
    for (;; share /= 2.0) {
      for (std::size_t i = 0; i < elo.size(); ++i) next[i] = elo[i] + share * direction(static_cast<Eigen::Index>(i));
      const double there = log_likelihood(points, next);
      if (there >= reached || share < 1e-6) {
        reached = there;
        break;
      }
    }
    elo = next;
    if (direction.cwiseAbs().maxCoeff() < 1e-9) return;
  }
}

// The uncertainty of the points of team `first` against team `second`, from independent units.
struct PointsSpread {
  Eigen::Index first, second;
  double variance;  // variance of the sum of points
  double degrees;   // degrees of freedom of the variance
};

// expected: expected score of a unit. It replaces the observed mean if there is only one unit, which has no spread.
template <class Counts>
void add_spread(const Encounter& encounter, const Counts& counts, double points_of_unit, double expected,
                std::vector<PointsSpread>& out) {
  const auto units = static_cast<double>(total(counts));
  if (units == 0.0) return;
  double mean = 0.0, squares = 0.0;
  const double step = 1.0 / static_cast<double>(counts.seen.size() - 1);
  for (std::size_t i = 0; i < counts.seen.size(); ++i) {
    mean += static_cast<double>(counts.seen[i]) * static_cast<double>(i) * step / units;
  }
  const double centre = units > 1.0 ? mean : expected;
  for (std::size_t i = 0; i < counts.seen.size(); ++i) {
    const double deviation = static_cast<double>(i) * step - centre;
    squares += static_cast<double>(counts.seen[i]) * deviation * deviation;
  }
  const double degrees = std::max(units - 1.0, 1.0);
  out.push_back({static_cast<Eigen::Index>(encounter.first), static_cast<Eigen::Index>(encounter.second),
                 points_of_unit * points_of_unit * squares * units / degrees, degrees});
}

// Returns half the width of each team's interval; infinite for a team without a spread.
std::vector<double> margins(const SquareTable& points, std::span<const Encounter> encounters,
                            const std::vector<double>& elo) {
  const MatrixXd inverse = inverse_curvature(points, elo);
  std::vector<PointsSpread> spreads;
  for (const Encounter& each : encounters) {
    const double expected = score_of_elo(elo[each.first] - elo[each.second]);
    add_spread(each, each.pairs, 2.0, expected, spreads);
    add_spread(each, each.games, 1.0, expected, spreads);
  }
  std::vector<double> out;
  for (Eigen::Index team = 0; team < inverse.rows(); ++team) {
    double variance = 0.0, by_degrees = 0.0;
    for (const PointsSpread& each : spreads) {
      const double weight = inverse(team, each.first) - inverse(team, each.second);
      const double part = weight * weight * each.variance;
      variance += part;
      by_degrees += part * part / each.degrees;
    }
    const double t =
        variance > 0.0 ? student_t_quantile(0.5 + confidence / 2.0, variance * variance / by_degrees) : infinite;
    out.push_back(variance > 0.0 ? normalized_elo_scale / 2.0 * t * std::sqrt(variance) : infinite);
  }
  return out;
}

// Units (pairs and single games) from one team's point of view.
struct UnitsOfTeam {
  Count won = 0, even = 0, lost = 0;

  template <class Counts>
  void add(const Counts& counts) {
    const std::size_t middle = counts.seen.size() / 2;
    even += counts.seen[middle];
    for (std::size_t i = 0; i < middle; ++i) {
      lost += counts.seen[i];
      won += counts.seen[counts.seen.size() - 1 - i];
    }
  }
  bool tell_the_spread() const { return won + lost >= fewest_uneven && even + lost > 0 && even + won > 0; }
};

// An equilibrium of an antisymmetric game is a mix against which no team wins: game * share <= 0. This class finds the
// equilibrium with the largest entropy by a primal-dual interior-point method with infeasible start (S. Boyd and L.
// Vandenberghe, "Convex Optimization", section 11.7): minimise sum share ln(share) with game * share + room = slack,
// sum share = 1, room >= 0. The set of equilibria is often a point; the slack gives it an interior. game: within +-1.
class LargestEntropy {
 public:
  explicit LargestEntropy(const MatrixXd& game)
      : game_(game),
        share_(ArrayXd::Constant(game.rows(), 1.0 / static_cast<double>(game.rows()))),
        room_(ArrayXd::Ones(game.rows())),
        price_(ArrayXd::Ones(game.rows())) {}

  VectorXd find() {
    for (int step = 0; step < most_steps && !settled(); ++step) improve();
    return share_.matrix();
  }

 private:
  static constexpr double slack = 1e-9;
  static constexpr double negligible = 1e-40;  // smaller shares cause numerical trouble
  static constexpr int most_steps = 500;

  ArrayXd excess() const { return (game_ * share_.matrix()).array() + room_ - slack; }
  ArrayXd slope() const { return share_.log() + 1.0 + (game_.transpose() * price_.matrix()).array() + level_; }
  double gap() const { return (room_ * price_).mean(); }

  bool settled() const {
    return gap() < 1e-12 && excess().abs().maxCoeff() < 1e-12 && (share_ * slope()).abs().maxCoeff() < 1e-10;
  }

  void improve() {
    const ArrayXd stiffness = price_ / room_, above = excess();
    const ArrayXd pull = std::max(0.1 * gap(), 5e-13) / room_ - price_ + stiffness * above;
    MatrixXd curvature = game_.transpose() * stiffness.matrix().asDiagonal() * game_;
    curvature.diagonal().array() += share_.inverse();
    const Eigen::LDLT<MatrixXd> solver(curvature);
    const VectorXd target = -(slope().matrix() + game_.transpose() * pull.matrix());
    const VectorXd free = solver.solve(target), even = solver.solve(VectorXd::Ones(share_.size()));
    const double of_level = (free.sum() + share_.sum() - 1.0) / even.sum();
    const ArrayXd of_share = (free - of_level * even).array();
    const ArrayXd of_room = -above - (game_ * of_share.matrix()).array();
    const ArrayXd of_price = pull + stiffness * (game_ * of_share.matrix()).array();
    const double length =
        std::min({1.0, longest(share_, of_share), longest(room_, of_room), longest(price_, of_price)});
    share_ = (share_ + length * of_share).max(negligible);
    room_ += length * of_room;
    price_ += length * of_price;
    level_ += length * of_level;
  }

  // Returns the longest step, at most 1, at which every relevant value keeps at least one tenth of its size.
  static double longest(const ArrayXd& values, const ArrayXd& direction) {
    double length = 1.0;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (direction(i) < 0.0 && values(i) > negligible) length = std::min(length, -0.9 * values(i) / direction(i));
    }
    return length;
  }

  const MatrixXd& game_;
  ArrayXd share_, room_, price_;
  double level_ = 0.0;
};

}  // namespace

double elo_of_score(double score) {
  if (score <= 0.0) return -infinite;
  if (score >= 1.0) return infinite;
  return 400.0 * std::log10(score / (1.0 - score));
}

double score_of_elo(double elo) { return 1.0 / (1.0 + std::pow(10.0, -elo / 400.0)); }

Interval score_interval(const ScoreLaw& law) {
  const double tail = (1.0 - confidence) / 2.0;
  const SeenScores seen = seen_scores(law);
  const auto n = static_cast<double>(seen.units);
  if (law.variation == Variation::one_sided) {
    const double least = std::max(seen.mean, 1.0 - seen.mean) * std::pow(tail, 1.0 / n);
    return seen.mean > 0.5 ? Interval{least, 1.0} : Interval{0.0, 1.0 - least};
  }
  if (!has_student_law(law)) return {0.0, 1.0};
  const double margin = student_t_quantile(1.0 - tail, n - 1.0) * std::sqrt(seen.squares / (n - 1.0) / n);
  if (margin < std::min(seen.mean, 1.0 - seen.mean)) return {seen.mean - margin, seen.mean + margin};
  const bool leads = seen.mean > 0.5;
  const double least = binomial_share_at_least(leads ? law.seen[law.outcomes - 1] : law.seen[0], seen.units, tail);
  return leads ? Interval{least, 1.0} : Interval{0.0, 1.0 - least};
}

Estimate elo(const ScoreLaw& law) {
  const Interval score = score_interval(law);
  return {elo_of_score(seen_scores(law).mean), {elo_of_score(score.low), elo_of_score(score.high)}};
}

Estimate normalized_elo(const ScoreLaw& law) {
  const double games_per_unit = law.unit == Unit::pair ? 2.0 : 1.0;
  const double value = normalized_elo_scale * (law.mean - 0.5) / std::sqrt(games_per_unit * law.variance);
  if (few_for_spread(law) != FewForSpread::no) return {value, {-infinite, infinite}};
  const EffectSpread spread = spread_of_effect(law);
  const double t = student_t_quantile(0.5 + confidence / 2.0, spread.degrees);
  const double error = std::sqrt(spread.variance / (games_per_unit * (law.units - 1.0)));
  const double margin = normalized_elo_scale * t * error;
  return {value, {value - margin, value + margin}};
}

FewForSpread few_for_spread(const ScoreLaw& law) {
  if (law.uneven() < fewest_uneven) return FewForSpread::uneven;
  const std::size_t even = (law.outcomes - 1) / 2;
  Count not_won = 0;  // units that the leading team did not win
  for (std::size_t i = 0; i <= even; ++i) not_won += law.mean > 0.5 ? law.seen[i] : law.seen[law.outcomes - 1 - i];
  return not_won == 0 ? FewForSpread::won : FewForSpread::no;
}

std::optional<double> likelihood_of_superiority(const ScoreLaw& law) {
  const Interval share = score_interval(law);
  if (!has_student_law(law) || share.low <= 0.0 || share.high >= 1.0) return std::nullopt;
  const SeenScores seen = seen_scores(law);
  const auto n = static_cast<double>(seen.units);
  const double t = (seen.mean - 0.5) / std::sqrt(seen.squares / (n - 1.0) / n),
               beyond = student_t_outside(t, n - 1.0) / 2.0;
  return t > 0.0 ? 1.0 - beyond : beyond;
}

std::optional<double> pair_ratio(const PairCounts& counts) {
  const auto& seen = counts.seen;
  if (seen[0] + seen[1] == 0) return std::nullopt;
  return static_cast<double>(seen[3] + seen[4]) / static_cast<double>(seen[0] + seen[1]);
}

std::optional<std::vector<double>> bradley_terry_elo(const SquareTable& points) {
  if (points.teams() > 1 && !connected(points)) return std::nullopt;
  std::vector<double> strength(points.teams(), 1.0);
  bool is_settled = points.teams() < 2;
  for (int round = 0; !is_settled && round < most_rounds; ++round) is_settled = improve(points, strength) <= settled;
  for (double& each : strength) each = 400.0 * std::log10(each);
  if (!is_settled) settle(points, strength);
  return strength;
}

SquareTable points_won(std::size_t teams, std::span<const Encounter> encounters) {
  SquareTable out(teams);
  for (const Encounter& each : encounters) {
    assert(each.first < teams && each.second < teams && each.first != each.second);
    out.at(each.first, each.second) += each.points();
    out.at(each.second, each.first) += static_cast<double>(each.games_played()) - each.points();
  }
  return out;
}

std::vector<std::size_t> groups_that_met(std::size_t teams, std::span<const Encounter> encounters) {
  std::vector<std::size_t> group(teams);
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (const Encounter& each : encounters) {
    const std::size_t one = group[each.first], other = group[each.second];
    if (each.games_played() > 0) std::ranges::replace(group, std::max(one, other), std::min(one, other));
  }
  return group;
}

std::optional<std::vector<Estimate>> bradley_terry(std::size_t teams, std::span<const Encounter> encounters) {
  const SquareTable points = points_won(teams, encounters);
  const std::optional<std::vector<double>> elo = bradley_terry_elo(points);
  if (!elo) return std::nullopt;
  std::vector<UnitsOfTeam> units(teams);
  for (const Encounter& each : encounters) {
    units[each.first].add(each.pairs);
    units[each.first].add(each.games);
    units[each.second].add(swapped(each.pairs));
    units[each.second].add(swapped(each.games));
  }
  const std::vector<double> margin =
      teams > 1 ? margins(points, encounters, *elo) : std::vector<double>(teams, infinite);
  std::vector<Estimate> out;
  for (std::size_t i = 0; i < teams; ++i) {
    const double value = (*elo)[i], half = units[i].tell_the_spread() ? margin[i] : infinite;
    out.push_back({value, {value - half, value + half}});
  }
  return out;
}

NashAverage nash_average(const SquareTable& payoff) {
  const auto teams = static_cast<Eigen::Index>(payoff.teams());
  if (teams == 0) return {};
  MatrixXd game(teams, teams);
  for (Eigen::Index i = 0; i < teams; ++i) {
    for (Eigen::Index j = 0; j < teams; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      game(i, j) = (payoff.at(row, column) - payoff.at(column, row)) / 2.0;
      assert(std::isfinite(game(i, j)));
    }
  }
  const double largest = game.array().abs().maxCoeff();
  VectorXd share = VectorXd::Constant(teams, 1.0 / static_cast<double>(teams));
  if (largest > 0.0) {
    game /= largest;
    share = LargestEntropy(game).find();
    share /= share.sum();
  }
  const VectorXd value = game * share * (largest > 0.0 ? largest : 1.0);
  return {{share.begin(), share.end()}, {value.begin(), value.end()}};
}

}  // namespace regista::statistics
