// SPDX-License-Identifier: MIT
// What an assigner's algorithm reads: one number for each pair of a robot and a task.
#pragma once

#include <cstddef>
#include <limits>

namespace assignment {

// Row-major view, owned by the caller: rows are robots, columns tasks, stride >= columns in elements. Whether entries
// are utilities or costs, the algorithm says.
struct Matrix {
  const double* values;
  std::size_t rows, columns, stride;
  double operator()(std::size_t i, std::size_t j) const { return values[i * stride + j]; }
};

// The utility of a pair that must not be assigned; the others are finite.
inline constexpr double forbidden = -std::numeric_limits<double>::infinity();

}  // namespace assignment
