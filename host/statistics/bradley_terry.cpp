// SPDX-License-Identifier: MIT
#include "statistics/bradley_terry.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "statistics/distributions.hpp"
#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

constexpr int most_rounds = 200'000;
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

// Standard deviations of ln g with their mean held at 0: the pseudo-inverse of the information matrix, whose only null
// direction is that of all strengths together.
Eigen::VectorXd deviations(const SquareTable& points, const std::vector<double>& strength) {
  const auto teams = static_cast<Eigen::Index>(strength.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Constant(teams, teams, 1.0 / static_cast<double>(teams));
  for (std::size_t i = 0; i < strength.size(); ++i) {
    for (std::size_t j = 0; j < strength.size(); ++j) {
      if (i == j) continue;
      const double sum = strength[i] + strength[j];
      const double weight = (points.at(i, j) + points.at(j, i)) * strength[i] * strength[j] / (sum * sum);
      information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += weight;
      information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) -= weight;
    }
  }
  const Eigen::MatrixXd covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(teams, teams));
  return (covariance.diagonal().array() - 1.0 / static_cast<double>(teams)).max(0.0).sqrt();
}

}  // namespace

std::optional<std::vector<Estimate>> bradley_terry(const SquareTable& points, double confidence, double drawn_before) {
  assert(drawn_before >= 0.0);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (points.teams() == 0) return std::vector<Estimate>{};
  if (points.teams() == 1) return std::vector<Estimate>{{0.0, {-infinite, infinite}}};
  const SquareTable all = with_draws(points, drawn_before);
  if (!connected(all)) return std::nullopt;
  std::vector<double> strength(points.teams(), 1.0);
  for (int round = 0; round < most_rounds && improve(all, strength) > settled; ++round) {
  }
  const Eigen::VectorXd deviation = deviations(all, strength);
  const double z = central_normal(confidence);
  std::vector<Estimate> out;
  for (std::size_t i = 0; i < strength.size(); ++i) {
    const double value = 400.0 * std::log10(strength[i]);
    const double margin = normalized_elo_scale / 2.0 * z * deviation(static_cast<Eigen::Index>(i));
    out.push_back({value, {value - margin, value + margin}});
  }
  return out;
}

}  // namespace regista::statistics
