// SPDX-License-Identifier: MIT
#include "statistics/analysis_of_variance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "statistics/distributions.hpp"

namespace regista::statistics {

std::optional<TwoWayAnalysis> two_way_analysis(std::span<const std::vector<double>> values) {
  const std::size_t rows = values.size();
  if (rows < 2) return std::nullopt;
  std::vector<std::size_t> blocks;  // whole ones
  for (std::size_t block = 0; block < values.front().size(); ++block) {
    const auto known = [&](const std::vector<double>& row) { return block < row.size() && !std::isnan(row[block]); };
    if (std::ranges::all_of(values, known)) blocks.push_back(block);
  }
  if (blocks.size() < 2) return std::nullopt;
  const auto r = static_cast<double>(rows), b = static_cast<double>(blocks.size());
  std::vector<double> of_row(rows, 0.0), of_block(blocks.size(), 0.0);
  double mean = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      of_row[i] += values[i][blocks[j]] / b;
      of_block[j] += values[i][blocks[j]] / r;
    }
    mean += of_row[i] / r;
  }
  double between = 0.0, residual = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    between += b * (of_row[i] - mean) * (of_row[i] - mean);
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      const double rest = values[i][blocks[j]] - of_row[i] - of_block[j] + mean;
      residual += rest * rest;
      largest = std::max(largest, std::abs(values[i][blocks[j]]));
    }
  }
  // Equal values have means that differ in their last digits: what is no more than that is nothing.
  const double rounding = std::numeric_limits<double>::epsilon() * largest * (r + b);
  if (between <= r * b * rounding * rounding) between = 0.0;
  if (residual <= r * b * rounding * rounding) residual = 0.0;
  const double row_degrees = r - 1.0, residual_degrees = (r - 1.0) * (b - 1.0);
  const double row_square = between / row_degrees, residual_square = residual / residual_degrees;
  TwoWayAnalysis out;
  out.variance_of_rows = std::max(0.0, (row_square - residual_square) / b);
  if (residual_square > 0.0) {
    out.f = row_square / residual_square;
    out.p = fisher_f_above(out.f, row_degrees, residual_degrees);
  } else if (row_square > 0.0) {
    out.f = std::numeric_limits<double>::infinity();
    out.p = 0.0;
  }
  return out;
}

}  // namespace regista::statistics
