// SPDX-License-Identifier: MIT
#include "mind/coordination/utility_estimation_matrix.hpp"

#include <cassert>

namespace regista::mind {
namespace {

// sum += weight * term. By plain pointers that do not overlap: two entries at a time.
void add(double weight, std::span<const double> term, std::span<double> sum) {
  const double* const __restrict from = term.data();
  double* const __restrict to = sum.data();
  for (std::size_t i = 0; i < term.size(); ++i) to[i] += weight * from[i];
}

}  // namespace

void UtilityEstimationMatrix::estimate(std::span<plugin::Utility> plugins, std::span<const TermPart> terms,
                                       const regista_frame& frame, std::span<const std::int32_t> active,
                                       std::span<const regista_task> columns) {
  assert(plugins.size() == terms.size());
  const std::size_t entries = active.size() * columns.size();
  values_.assign(entries, 0.0);
  terms_.resize(plugins.size());
  for (std::size_t k = 0; k < plugins.size(); ++k) {
    const std::span<const double> scored = plugins[k].score(frame, active.size(), columns.size());
    terms_[k].assign(scored.begin(), scored.end());
    add(terms[k].weight, scored, values_);
  }
  forbid(active, columns);
}

void UtilityEstimationMatrix::forbid(std::span<const std::int32_t> active, std::span<const regista_task> columns) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const int bound = columns[j].robot;
    if (bound == 0) continue;
    for (std::size_t i = 0; i < active.size(); ++i) {
      double* const row = values_.data() + i * columns.size();
      if (active[i] != bound) {
        row[j] = forbidden;
        continue;
      }
      for (std::size_t other = 0; other < columns.size(); ++other) {
        if (columns[other].robot != bound) row[other] = forbidden;
      }
    }
  }
}

}  // namespace regista::mind
