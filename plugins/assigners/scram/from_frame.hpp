// SPDX-License-Identifier: MIT
// What the plugins have in common that assign by SCRAM: their parameters, and a frame as the solver's input. Glue.
//
// `incumbent` is no part of SCRAM: the robot that last claimed a role counts as so much nearer to its place, as in
// B-Human's assignment (Roefer et al., RoboCup 2022).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include <regista/assigner.hpp>

#include "../task_order.hpp"
#include "algorithm.hpp"

namespace scram {

enum class Cost { distance, utility };

struct Settings {
  Criterion criterion = Criterion::mmdr;
  Cost cost = Cost::distance;
  double incumbent = 0.0;  // m, >= 0
};

inline constexpr std::array criterion_names{"mmdr", "mmd_msd2"};
inline constexpr std::array cost_names{"distance", "utility"};
inline constexpr std::tuple parameters{
    regista::choice("criterion", &Settings::criterion, criterion_names,
                    "After the longest walk: mmdr minimises the next longest and so on, mmd_msd2 the sum of squared "
                    "distances (MacAlpine, Price and Stone 2015)"),
    regista::choice("cost", &Settings::cost, cost_names,
                    "What is long: distance is from the robot to the task's place as in the paper, utility how much "
                    "the pair's utility falls short of the largest one"),
    regista::real("incumbent", &Settings::incumbent, {0.0, 10.0}, "m",
                  "The robot that last claimed the role counts as so much nearer to its place, of several the one with "
                  "the lowest number; only for distances; B-Human 2022: 1; 0: not in the paper")
        .tunable()};

// Reuse one object: it allocates nothing within what was reserved.
class FrameSolver {
 public:
  void reserve(std::size_t robots, std::size_t roles) {
    solver_.reserve(robots, roles);
    values_.reserve(robots * roles);
    order_.reserve(roles);
    choice_.reserve(roles);
  }

  // assigned[row] := column, or Assignment::no_task.
  void assign(const Settings& settings, const regista::Frame& frame, const regista::UtilityMatrix& utilities,
              std::span<std::int32_t> assigned) {
    std::fill(assigned.begin(), assigned.end(), regista::Assignment::no_task);
    assignment::by_importance(frame.tasks(), order_);
    if (utilities.columns() == 0) return;
    assignment::by_need(frame.tasks(), order_, choice_);
    fill_costs(settings, frame, utilities);
    solver_.assign({values_.data(), utilities.rows(), utilities.columns(), utilities.columns()}, settings.criterion,
                   order_, choice_, assigned);
  }
  // The columns of the last frame, the most important first.
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  // Squared distances order pairs as distances do and are what mmd_msd2 sums. In place of a distance, a utility falls
  // short of the largest by a number whose square is summed; for mmdr its order is enough.
  void fill_costs(const Settings& settings, const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const std::size_t rows = utilities.rows(), columns = utilities.columns();
    values_.resize(rows * columns);
    const regista::World world = frame.world();
    const regista::Span<regista::Task> all = frame.tasks();
    double largest = 0.0;
    if (settings.cost == Cost::utility && settings.criterion == Criterion::mmd_msd2) {
      for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) largest = std::max(largest, utilities(i, j));
      }
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const double* pose = world.robot(world.active()[i]).pose;
      for (std::size_t j = 0; j < columns; ++j) {
        double& value = values_[i * columns + j];
        if (utilities(i, j) == regista::UtilityMatrix::forbidden) {
          value = infinity;
        } else if (settings.cost == Cost::distance) {
          const double dx = all[j].after[0] - pose[0], dy = all[j].after[1] - pose[1];
          value = dx * dx + dy * dy;
        } else if (settings.criterion == Criterion::mmdr) {
          value = -utilities(i, j);
        } else {
          const double shortfall = largest - utilities(i, j);
          value = shortfall * shortfall;
        }
      }
    }
    if (settings.incumbent > 0.0 && settings.cost == Cost::distance) favour_incumbents(settings, world, all);
  }

  // Who is nearer than the bonus has a distance below 0: mmdr keeps the order of these by squares with a sign, and a
  // sum of squares counts them as 0.
  void favour_incumbents(const Settings& settings, const regista::World& world,
                         const regista::Span<regista::Task>& all) {
    const regista::Span<std::int32_t> active = world.active();
    for (std::size_t j = 0; j < all.size(); ++j) {
      for (std::size_t i = 0; i < active.size(); ++i) {
        if (world.robot(active[i]).role != all[j].id) continue;
        double& value = values_[i * all.size() + j];
        if (value != infinity) {
          const double left = std::sqrt(value) - settings.incumbent;
          value = settings.criterion == Criterion::mmdr ? left * std::abs(left) : std::max(left, 0.0) * left;
        }
        break;
      }
    }
  }

  Solver solver_;
  std::vector<double> values_;
  std::vector<std::uint32_t> order_, choice_;
};

}  // namespace scram
