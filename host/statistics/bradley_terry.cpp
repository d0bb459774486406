// SPDX-License-Identifier: MIT
#include "statistics/bradley_terry.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "statistics/distributions.hpp"
#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

constexpr int most_rounds = 2000;
constexpr int most_newton_steps = 100;
constexpr double settled = 1e-13;  // largest relative change of a strength in a round

SquareTable with_draws(const SquareTable& points, double drawn) {
  SquareTable out(points.teams());
  for (std::size_t i = 0; i < points.teams(); ++i) {
    for (std::size_t j = 0; j < points.teams(); ++j) {
      assert(i == j || points.at(i, j) >= 0.0);
      if (i != j) out.at(i, j) = points.at(i, j) + drawn / 2.0;
    }
  }
  return out;
}

// Whether a chain of points leads from the first team to every other one, and back.
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

// One round for all teams, in order, each with the newest strengths of the others. Returns the largest relative change.
double improve(const SquareTable& points, std::vector<double>& strength) {
  double change = 0.0;
  for (std::size_t i = 0; i < strength.size(); ++i) {
    double wins = 0.0, weighted = 0.0;
    for (std::size_t j = 0; j < strength.size(); ++j) {
      if (j == i) continue;
      wins += points.at(i, j);
      weighted += (points.at(i, j) + points.at(j, i)) / (strength[i] + strength[j]);
    }
    const double next = wins / weighted;
    change = std::max(change, std::abs(next / strength[i] - 1.0));
    strength[i] = next;
  }
  // Only ratios matter; the scale would run away.
  double log_mean = 0.0;
  for (const double each : strength) log_mean += std::log(each) / static_cast<double>(strength.size());
  for (double& each : strength) each /= std::exp(log_mean);
  return change;
}

// The pseudo-inverse of the curvature by ln g, whose only null direction is that of all strengths together.
Eigen::MatrixXd inverse_curvature(const SquareTable& points, const std::vector<double>& elo) {
  const auto teams = static_cast<Eigen::Index>(elo.size());
  const Eigen::MatrixXd mean = Eigen::MatrixXd::Constant(teams, teams, 1.0 / static_cast<double>(teams));
  Eigen::MatrixXd curvature = mean;
  for (std::size_t i = 0; i < elo.size(); ++i) {
    for (std::size_t j = 0; j < elo.size(); ++j) {
      if (i == j) continue;
      const double expected = score_of_elo(elo[i] - elo[j]);
      const double weight = (points.at(i, j) + points.at(j, i)) * expected * (1.0 - expected);
      curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += weight;
      curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) -= weight;
    }
  }
  return curvature.ldlt().solve(Eigen::MatrixXd::Identity(teams, teams)) - mean;
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

// Newton's steps to the maximum, each halved until the likelihood does not fall: for chains of teams, along which
// minorisation-maximisation carries news by one team a round.
void settle(const SquareTable& points, std::vector<double>& elo) {
  const double to_elo = normalized_elo_scale / 2.0;  // of ln g
  double reached = log_likelihood(points, elo);
  for (int step = 0; step < most_newton_steps; ++step) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(elo.size()));
    for (std::size_t i = 0; i < elo.size(); ++i) {
      for (std::size_t j = 0; j < elo.size(); ++j) {
        if (i == j) continue;
        const double games = points.at(i, j) + points.at(j, i);
        gradient(static_cast<Eigen::Index>(i)) += points.at(i, j) - games * score_of_elo(elo[i] - elo[j]);
      }
    }
    const Eigen::VectorXd direction = to_elo * (inverse_curvature(points, elo) * gradient);
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

// Points of the first of two teams, of units that are independent: how uncertain their sum is.
struct PointsSpread {
  Eigen::Index first, second;
  double variance;  // of the sum
  double degrees;   // of freedom, of the variance
};

// expected: score of a unit, for the only unit of a kind, which has no spread of its own.
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

// Half the width of each interval; infinite where there is no spread.
std::vector<double> margins(const SquareTable& points, std::span<const Encounter> encounters,
                            const std::vector<double>& elo, double confidence) {
  const Eigen::MatrixXd inverse = inverse_curvature(points, elo);
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

// Of pairs and single games alike, from one team's point of view.
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

}  // namespace

std::optional<std::vector<double>> bradley_terry_elo(const SquareTable& points, double drawn_before) {
  assert(drawn_before >= 0.0);
  const SquareTable all = with_draws(points, drawn_before);
  if (points.teams() > 1 && !connected(all)) return std::nullopt;
  std::vector<double> strength(points.teams(), 1.0);
  bool is_settled = points.teams() < 2;
  for (int round = 0; !is_settled && round < most_rounds; ++round) is_settled = improve(all, strength) <= settled;
  for (double& each : strength) each = 400.0 * std::log10(each);
  if (!is_settled) settle(all, strength);
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

std::optional<std::vector<Estimate>> bradley_terry(std::size_t teams, std::span<const Encounter> encounters,
                                                   double confidence) {
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
      teams > 1 ? margins(points, encounters, *elo, confidence) : std::vector<double>(teams, infinite);
  std::vector<Estimate> out;
  for (std::size_t i = 0; i < teams; ++i) {
    const double value = (*elo)[i], half = units[i].tell_the_spread() ? margin[i] : infinite;
    out.push_back({value, {value - half, value + half}});
  }
  return out;
}

}  // namespace regista::statistics
