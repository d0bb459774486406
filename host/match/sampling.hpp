// SPDX-License-Identifier: MIT
// The sampling rate of the metrics, and functions for means and shares over samples. A sample counts 0.1 s.
#pragma once

#include <cstdint>
#include <optional>

#include "match/physics_world.hpp"

namespace regista::match {

constexpr int samples_per_second = 10;
constexpr std::uint32_t steps_per_sample = physics_steps_per_second / samples_per_second;

constexpr double seconds(int samples) { return static_cast<double>(samples) / samples_per_second; }

// Return sum / count and part / whole; nothing if the divisor is 0.
constexpr std::optional<double> mean(double sum, int count) {
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}
constexpr std::optional<double> share(int part, int whole) { return mean(part, whole); }

}  // namespace regista::match
