// SPDX-License-Identifier: MIT
// How little each robot would have to turn to face each target. The SPQR team's utility of 2022 takes (pi - |a|) / pi
// of the bearing error a, with weight 0.05 for the role's target and 0.05 for the goal. (1 + cos a) / 2 falls from 1 to
// 0 over the same angles, and equals it at 0, a right angle and pi; in between it differs by at most 0.105. It orders
// robots alike and comes from a dot product, so it is the default.
#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "../places.hpp"

namespace bearing_utility {

using places::Pose, places::Targets;

// Where a heading points: (cosine, sine). Robots that are silent are believed to stand, so most headings are those of
// the decision before: then nothing is computed.
class Direction {
 public:
  void turn(double heading) {
    if (std::bit_cast<std::uint64_t>(heading) == std::bit_cast<std::uint64_t>(heading_)) return;
    heading_ = heading;
    x_ = std::cos(heading);
    y_ = std::sin(heading);
  }
  double x() const { return x_; }
  double y() const { return y_; }

 private:
  double heading_ = 0.0, x_ = 1.0, y_ = 0.0;
};

struct Robot {
  double x, y;  // m
  Direction ahead;
};

inline Robot robot_at(const Pose& pose) {
  Robot out{pose.x, pose.y, {}};
  out.ahead.turn(pose.heading);
  return out;
}

enum class Form { cosine, angle };

// A target nearer than this has no bearing worth the name: a robot that is there need not turn, the utility is 1.
inline constexpr double here = 1e-6;  // m

// From the cosine of the bearing error to the utility of the form.
template <Form form>
double from_cosine(double cosine) {
  const double least = cosine < -1.0 ? -1.0 : cosine, bounded = least > 1.0 ? 1.0 : least;  // rounding
  return form == Form::cosine ? 0.5 + 0.5 * bounded : 1.0 - std::acos(bounded) * std::numbers::inv_pi;
}

// One robot. Without branches, so that the row is computed in vector registers. out: as many as targets.
template <Form form>
void score_row(const Robot& robot, const Targets& targets, double* out) {
  const double ahead_x = robot.ahead.x(), ahead_y = robot.ahead.y();
  const std::size_t columns = targets.x.size();
  for (std::size_t j = 0; j < columns; ++j) {
    const double dx = targets.x[j] - robot.x, dy = targets.y[j] - robot.y;
    const double distance = std::sqrt(dx * dx + dy * dy);
    const double cosine = (dx * ahead_x + dy * ahead_y) / (distance < here ? here : distance);
    const double value = from_cosine<form>(cosine);
    out[j] = distance < here ? 1.0 : value;
  }
}

// out[i * stride + j] in [0, 1] for robot i and target j. stride >= number of targets.
inline void score(std::span<const Robot> robots, const Targets& targets, Form form, double* out, std::size_t stride) {
  assert(targets.x.size() == targets.y.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    double* row = out + i * stride;
    if (form == Form::cosine) {
      score_row<Form::cosine>(robots[i], targets, row);
    } else {
      score_row<Form::angle>(robots[i], targets, row);
    }
  }
}

}  // namespace bearing_utility
