// SPDX-License-Identifier: MIT
// The assignment of robots to tasks with the largest sum of utilities: as many pairs as the forbidden ones leave room
// for, then the largest sum, then the lexicographically least of the optimal ones (see tie_rule.hpp).
//
// Ties: a pair counts as tight when its reduced cost is at most `tie_tolerance` times the largest |dual variable|. So
// utilities that differ by rounding only are equal, and the sum may fall short of the maximum by the tolerance per
// robot at most. Dual variables are what it costs to do without a robot or a task, and so where rounding comes from; an
// entry that no good assignment uses, as -1e9 for "never", does not occur in them, however large it is.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../matrix.hpp"
#include "../shortest_paths.hpp"
#include "../tie_rule.hpp"
#include "../tight_pairs.hpp"

namespace hungarian {

using assignment::Costs, assignment::forbidden, assignment::infinity, assignment::Matrix, assignment::nobody,
    assignment::Ranked, assignment::ShortestPaths, assignment::TieRule;

inline constexpr double tie_tolerance = 1e-12;  // far above what rounding adds up to for a thousand robots

// Reuse one object: it keeps its memory, and allocates only for a matrix larger than any before.
class Solver {
 public:
  void reserve(std::size_t rows, std::size_t columns) {
    costs_.reserve(rows * columns);
    const std::size_t longer = std::max(rows, columns);
    all_.reserve(longer, longer);
    some_.reserve(longer, longer);
    ties_.reserve(rows, columns);
  }

  // utilities: finite or `forbidden`. order: every column once, the most important first. out[row] := column, or -1.
  void assign(const Matrix& utilities, std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
    assert(order.size() == utilities.columns && out.size() == utilities.rows);
    solve(utilities, out, [&](auto& solution, const Costs& costs, bool transposed) {
      break_ties(solution, costs, transposed, order, out);
    });
  }

  // The same without the rule for ties: any of the optimal ones, for use where nobody has to agree.
  void assign_any(const Matrix& utilities, std::span<std::int32_t> out) {
    assert(out.size() == utilities.rows);
    solve(utilities, out, [&](auto& solution, const Costs&, bool transposed) {
      const std::vector<std::int32_t>& column_of = transposed ? solution.agent_of : solution.object_of;
      std::copy(column_of.begin(), column_of.end(), out.begin());
    });
  }

 private:
  // finish(solution, costs, transposed) writes to out.
  template <class Finish>
  void solve(const Matrix& utilities, std::span<std::int32_t> out, const Finish& finish) {
    std::fill(out.begin(), out.end(), nobody);
    if (utilities.rows == 0 || utilities.columns == 0) return;
    const bool transposed = utilities.rows > utilities.columns;  // agents are the fewer
    const Costs costs = copy(utilities, transposed);
    if (all_.solve(costs)) {
      finish(all_, costs, transposed);
    } else {
      some_.solve(costs);
      finish(some_, costs, transposed);
    }
  }

  Costs copy(const Matrix& utilities, bool transposed) {
    costs_.resize(utilities.rows * utilities.columns);
    double* to = costs_.data();
    const std::size_t agents = transposed ? utilities.columns : utilities.rows;
    const std::size_t objects = transposed ? utilities.rows : utilities.columns;
    for (std::size_t i = 0; i < agents; ++i) {
      for (std::size_t j = 0; j < objects; ++j) {
        *to++ = transposed ? -utilities(j, i) : -utilities(i, j);
      }
    }
    return {costs_.data(), agents, objects};
  }

  template <class Cost>
  void break_ties(ShortestPaths<Cost>& solution, const Costs& costs, bool transposed,
                  std::span<const std::uint32_t> order, std::span<std::int32_t> out) {
    double largest = 0.0;
    for (const Cost& dual : solution.agent_dual) largest = std::max(largest, magnitude(dual));
    for (const Cost& dual : solution.object_dual) largest = std::max(largest, magnitude(dual));
    name_tight_pairs(solution, costs, transposed, tie_tolerance * largest, ties_);
    std::vector<std::int32_t>& column_of = transposed ? solution.agent_of : solution.object_of;
    std::vector<std::int32_t>& row_of = transposed ? solution.object_of : solution.agent_of;
    ties_.apply(order, column_of, row_of);
    std::copy(column_of.begin(), column_of.end(), out.begin());
  }

  static double magnitude(double dual) { return std::abs(dual); }
  static double magnitude(const Ranked& dual) { return std::abs(dual.sum); }

  std::vector<double> costs_;
  ShortestPaths<double> all_;
  ShortestPaths<Ranked> some_;
  TieRule ties_;
};

}  // namespace hungarian
