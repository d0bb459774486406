// SPDX-License-Identifier: MIT
// How often the metrics look at a match. A sample counts 0.1 s.
#pragma once

#include <cstdint>

#include "match/arena.hpp"

namespace regista::match {

constexpr int samples_per_second = 10;
constexpr std::uint32_t steps_per_sample = physics_steps_per_second / samples_per_second;

}  // namespace regista::match
