// SPDX-License-Identifier: MIT
// Where somebody touched the ball of a recording: its velocity before and after differ by more than rolling and sliding
// explain. Predictions of untouched balls are judged apart, for no filter foretells a kick.
#pragma once

#include <span>
#include <vector>

#include "study/prediction/recording.hpp"

namespace regista::study {

// samples: of one ball, by time. For each, whether nobody touched the ball there: the velocities of lines of least
// squares through `window` seconds before and after differ by less than 0.4 m/s, besides a deceleration of at most
// 3.6 m/s^2 (a kicked ball that slides on carpet). False as well where fewer than three samples are left in a window.
std::vector<bool> untouched(std::span<const Sample> samples, double window);

}  // namespace regista::study
