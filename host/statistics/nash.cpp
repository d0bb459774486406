// SPDX-License-Identifier: MIT
#include "statistics/nash.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace regista::statistics {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// An equilibrium of an antisymmetric game is a mix against which no team wins: game * share <= 0. Of all of them, that
// of the largest entropy, by a primal-dual interior-point method from outside of the feasible set (S. Boyd and L.
// Vandenberghe, "Convex Optimization", section 11.7): minimise sum share ln(share) with game * share + room = slack,
// sum share = 1, room >= 0. The slack gives the set of equilibria, often a point, an inside. Entries are within +-1.
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
  static constexpr double negligible = 1e-40;  // a smaller share only strains the arithmetic
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

  // How far to go until one of the values that still matter has lost nine tenths.
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
