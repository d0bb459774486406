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

// An equilibrium of an antisymmetric game is a mix against which no team wins: payoff * share <= 0. Entropy is raised
// over the mixes that lose less than `slack`, with logarithmic barriers (S. Boyd and L. Vandenberghe, "Convex
// Optimization", chapter 11), while slack and barrier shrink: the first mix of equal shares then always lies inside.
class Path {
 public:
  explicit Path(const MatrixXd& payoff)
      : payoff_(payoff), share_(VectorXd::Constant(payoff.rows(), 1.0 / static_cast<double>(payoff.rows()))) {}

  VectorXd follow() {
    double slack = 2.0;  // payoffs are within +-1
    while (true) {
      centre(slack);
      if (slack <= least_slack) return share_;
      // Halfway to the worst loss of the present mix, so that it stays inside.
      const double worst = (payoff_ * share_).maxCoeff();
      slack = std::max(least_slack, std::max(worst, 0.0) + (slack - std::max(worst, 0.0)) / 2.0);
    }
  }

 private:
  static constexpr double least_slack = 1e-9;

  double cost(const VectorXd& share, double slack) const {
    const ArrayXd room = slack - (payoff_ * share).array();
    if (!(share.minCoeff() > 0.0) || !(room.minCoeff() > 0.0)) return HUGE_VAL;
    return (share.array() * share.array().log()).sum() - barrier(slack) * room.log().sum();
  }

  static double barrier(double slack) { return 0.1 * slack; }

  // Newton's method with the sum of the shares kept at 1.
  void centre(double slack) {
    const Eigen::Index teams = share_.size();
    for (int step = 0; step < 100; ++step) {
      const ArrayXd room = slack - (payoff_ * share_).array();
      const ArrayXd force = barrier(slack) / room;
      const VectorXd gradient = (share_.array().log() + 1.0).matrix() + payoff_.transpose() * force.matrix();
      MatrixXd curvature = payoff_.transpose() * (force / room).matrix().asDiagonal() * payoff_;
      curvature.diagonal().array() += share_.array().inverse();
      const Eigen::LDLT<MatrixXd> solver(curvature);
      const VectorXd free = solver.solve(gradient), even = solver.solve(VectorXd::Ones(teams));
      const VectorXd direction = even * (free.sum() / even.sum()) - free;
      const double decrease = -gradient.dot(direction);
      if (!(decrease > 1e-18)) return;
      const double before = cost(share_, slack);
      double length = 1.0;
      while (!(cost(share_ + length * direction, slack) <= before - 0.1 * length * decrease)) {
        length /= 2.0;
        if (length < 1e-12) return;  // rounding allows no better
      }
      share_ += length * direction;
    }
  }

  const MatrixXd& payoff_;
  VectorXd share_;
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
    share = Path(game).follow();
    share /= share.sum();
  }
  const VectorXd value = game * share * (largest > 0.0 ? largest : 1.0);
  return {{share.begin(), share.end()}, {value.begin(), value.end()}};
}

}  // namespace regista::statistics
