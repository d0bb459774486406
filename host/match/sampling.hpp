// SPDX-License-Identifier: MIT
// How often the metrics look at a match. A sample counts 0.1 s.
#pragma once

#include <cstddef>
#include <cstdint>

#include "match/arena.hpp"

namespace regista::match {

constexpr int samples_per_second = 10;
constexpr std::uint32_t steps_per_sample = physics_steps_per_second / samples_per_second;

// Numbers of robots, roles and bodies as indices.
constexpr std::size_t at(int number) { return static_cast<std::size_t>(number); }

}  // namespace regista::match
