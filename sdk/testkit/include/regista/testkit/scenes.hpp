// SPDX-License-Identifier: MIT
// The situations in which every plugin is tried: the usual, the degenerate and the absurd. In this order they are a
// course: ticks and times rise.
#pragma once

#include <vector>

#include <regista/testkit/scene.hpp>

namespace regista::testkit {

// Sizes of team that every plugin is tried with.
inline constexpr int team_sizes[] = {3, 7, 11};

std::vector<Scene> scenes(int team_size);

}  // namespace regista::testkit
