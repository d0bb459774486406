// SPDX-License-Identifier: MIT
// UEM, the paper's Utility Estimation Matrix: how well each active robot (a row) would play each kept task (a column).
// An entry is the weighted sum of what the utility plugins of the context in force say, and minus infinity where the
// robot must not take the task. The paper filters the columns of the full matrix; here the filter comes first, so that
// only the columns that stay are computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mind/team_plan.hpp"
#include "plugin/utility.hpp"
#include "regista/abi.h"

namespace regista::mind {

// rows x columns values without gaps.
inline regista_matrix matrix(const std::vector<double>& values, std::size_t rows, std::size_t columns) {
  return {values.data(), static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
          static_cast<std::uint32_t>(columns), 0};
}

class UtilityEstimationMatrix {
 public:
  static constexpr double forbidden = -std::numeric_limits<double>::infinity();

  // Asks every plugin about the frame, whose world has `active` robots and whose tasks are `columns`. plugins[k]
  // belongs to terms[k]. A task that is bound to a robot is for that robot alone, and that robot for it.
  void estimate(std::span<plugin::Utility> plugins, std::span<const TermPart> terms, const regista_frame& frame,
                std::span<const std::int32_t> active, std::span<const regista_task> columns);
  void clear() { values_.clear(); }

  // For the assigner.
  regista_matrix view(std::size_t rows, std::size_t columns) const { return matrix(values_, rows, columns); }
  const std::vector<double>& values() const { return values_; }             // rows x columns
  const std::vector<std::vector<double>>& terms() const { return terms_; }  // of each plugin, unweighted

 private:
  void forbid(std::span<const std::int32_t> active, std::span<const regista_task> columns);

  std::vector<double> values_;
  std::vector<std::vector<double>> terms_;
};

}  // namespace regista::mind
