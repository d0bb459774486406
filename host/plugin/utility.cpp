// SPDX-License-Identifier: MIT
#include "plugin/utility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace regista::plugin {
namespace {

// Utilities are at most this, so that sums of weighted terms stay finite.
constexpr double largest = 1e12;

// Whether an entry may be other than in [0, largest]. Looks at bits, so that the compiler can check several entries at
// once: the sign bit is set, or adding so much to the exponent that 2^40, a little more than `largest`, reaches it
// sets it. -0 is suspect too.
bool suspect(std::span<const double> values) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63, exponent_step = std::uint64_t{2048 - 1023 - 40} << 52;
  static_assert(std::numeric_limits<double>::is_iec559);
  std::uint64_t seen = 0;
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    seen |= bits | (bits + exponent_step);
  }
  return (seen & sign) != 0;
}

void check_each(const Instance& instance, std::span<const double> values, std::size_t columns) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (value >= 0.0 && value <= largest) continue;
    const char* const rule = !std::isfinite(value) ? ""
                             : value < 0.0         ? "; utilities are at least 0"
                                                   : "; utilities are at most 1e12";
    instance.fail("score", fmt::format("row {}, column {} is {}{}", i / columns, i % columns, value, rule));
  }
}

}  // namespace

Utility::Utility(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_utility>(REGISTA_KIND_UTILITY)) {
  // The largest there can be, so that no call allocates.
  const regista_environment& environment = instance_->environment();
  instance_->rooms().utilities.open(std::size_t{environment.team_size} * environment.roles.count);
}

std::span<const double> Utility::score(const regista_frame& frame, std::size_t rows, std::size_t columns) {
  const std::size_t count = rows * columns;
  if (count == 0) return {};
  GuardedRoom<double>& entries = instance_->rooms().utilities;
  double* const room = instance_->open(entries, count);
  std::fill_n(room, count, 0.0);
  const regista_matrix_room shown{room, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
                                  static_cast<std::uint32_t>(columns), 0};
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_matrix_room* written_to) {
        inputs.add("frame", seen);
        inputs.add("out", written_to, sizeof *written_to);
      },
      "score", calls_->score, instance_->shown(&frame), &shown);
  instance_->check("score", Instance::Written{entries, "utilities"});
  const std::span<const double> answer = entries.first(count);
  if (suspect(answer)) [[unlikely]]
    check_each(*instance_, answer, columns);
  instance_->answered(answer);
  return answer;
}

}  // namespace regista::plugin
