// SPDX-License-Identifier: MIT
// The situations in which every plugin is tried: the usual, the degenerate and the absurd. In this order they are a
// scenario: ticks and times rise.
#pragma once

#include <cstdint>
#include <vector>

#include <regista/testkit/scene.hpp>

namespace regista::testkit {

// Sizes of team that every plugin is tried with.
inline constexpr int team_sizes[] = {3, 7, 11};

// Which robot this is in a team of that size: not always the same one.
constexpr int own_number(int team_size) { return team_size <= 3 ? 1 : team_size <= 7 ? 2 : team_size; }

// seed: of those that are drawn by chance.
std::vector<Scene> scenes(int team_size, std::uint64_t seed = 0);

}  // namespace regista::testkit
