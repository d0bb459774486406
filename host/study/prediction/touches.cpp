// SPDX-License-Identifier: MIT
#include "study/prediction/touches.hpp"

#include <algorithm>
#include <optional>

#include "study/prediction/baseline.hpp"

namespace regista::study {
namespace {

constexpr int least_samples = 3;
constexpr double least_change = 0.4;          // m/s
constexpr double sliding_deceleration = 3.6;  // m/s^2

}  // namespace

std::vector<bool> untouched(std::span<const Sample> samples, double window) {
  std::vector<bool> out(samples.size(), false);
  std::size_t first = 0, end = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    while (samples[i].time - samples[first].time > window) ++first;
    while (end < samples.size() && samples[end].time - samples[i].time <= window) ++end;
    const std::optional<Eigen::Vector2d> before = fitted_velocity(samples.subspan(first, i + 1 - first), least_samples);
    const std::optional<Eigen::Vector2d> after = fitted_velocity(samples.subspan(i, end - i), least_samples);
    if (!before || !after) continue;
    // The velocities are those at the middle of their windows.
    const double speed = before->norm();
    const double slowed = speed > 0.0 ? std::min(1.0, sliding_deceleration * window / speed) : 0.0;
    // The nearest that a ball comes to the new velocity by slowing down.
    const double kept = speed > 0.0 ? std::clamp(before->dot(*after) / (speed * speed), 1.0 - slowed, 1.0) : 0.0;
    out[i] = (*after - kept * *before).norm() < least_change;
  }
  return out;
}

}  // namespace regista::study
