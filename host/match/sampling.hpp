// SPDX-License-Identifier: MIT
// How often the metrics look at a match, and what they make of what they have counted. A sample counts 0.1 s.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "match/arena.hpp"

namespace regista::match {

constexpr int samples_per_second = 10;
constexpr std::uint32_t steps_per_sample = physics_steps_per_second / samples_per_second;

constexpr double seconds(int samples) { return static_cast<double>(samples) / samples_per_second; }

// Of so many; nothing of none.
constexpr std::optional<double> mean(double sum, int count) {
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}
constexpr std::optional<double> share(int part, int whole) { return mean(part, whole); }

// Numbers of robots, roles and bodies as indices.
constexpr std::size_t at(int number) { return static_cast<std::size_t>(number); }

}  // namespace regista::match
