// SPDX-License-Identifier: MIT
#include "plugin/utility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista::plugin {
namespace {

bool valid(double value) { return value >= 0.0 && value <= std::numeric_limits<double>::max(); }

[[noreturn]] void report(const Instance& instance, const regista_matrix& m) {
  for (std::uint32_t i = 0; i < m.rows; ++i) {
    for (std::uint32_t j = 0; j < m.columns; ++j) {
      const double value = m.values[std::size_t{i} * m.stride + j];
      if (valid(value)) continue;
      instance.fail("score", fmt::format("row {}, column {} is {}{}", i, j, value,
                                         std::isfinite(value) ? "; utilities are at least 0" : ""));
    }
  }
  instance.fail("score", "the matrix changed while it was checked");
}

}  // namespace

Utility::Utility(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_utility>(REGISTA_KIND_UTILITY)) {}

void Utility::score(const regista_frame& frame, const regista_matrix& out) {
  for (std::uint32_t i = 0; i < out.rows; ++i) std::fill_n(out.values + std::size_t{i} * out.stride, out.columns, 0.0);
  if (out.rows == 0 || out.columns == 0) return;
  instance_->call("score", calls_->score, &frame, &out);
  // No early exit, so that the compiler can check several entries at once.
  bool all = true;
  for (std::uint32_t i = 0; i < out.rows; ++i) {
    const double* const row = out.values + std::size_t{i} * out.stride;
    for (std::uint32_t j = 0; j < out.columns; ++j) all &= valid(row[j]);
  }
  if (!all) [[unlikely]]
    report(*instance_, out);
}

}  // namespace regista::plugin
