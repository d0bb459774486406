// SPDX-License-Identifier: MIT
// The assignment of least total cost, by shortest augmenting paths: R. Jonker and A. Volgenant, "A Shortest Augmenting
// Path Algorithm for Dense and Sparse Linear Assignment Problems", Computing 38, 1987 (without its initialisation);
// O(rows^2 columns). For what the host itself has to pair; teams choose an assigner.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace regista::mind {

// Reuse one object: it keeps its memory.
class LeastCostAssignment {
 public:
  void reserve(std::size_t rows, std::size_t columns);

  // Gives every row a column of its own. Costs are finite, row by row; rows <= columns. Returns their least sum.
  double solve(std::span<const double> costs, std::size_t rows, std::size_t columns);

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  // By column, of the last call: its row, or none.
  std::span<const std::size_t> row_of() const { return result_; }

 private:
  // Index 0 stands for nobody.
  std::vector<double> row_price_, column_price_, slack_;
  std::vector<std::size_t> row_of_, before_, result_;
  std::vector<char> visited_;
};

}  // namespace regista::mind
