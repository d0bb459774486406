// SPDX-License-Identifier: MIT
// Are we more than they at the ball: own robots minus opponents within 1.5 m of it, in a closed range. The SPQR team
// planned it for its contexts. That a robot once near stays so up to a margin beyond is ours, so that it does not
// flicker.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace numbers_near_ball {

struct Body {
  int label;    // tells the robots of one side apart, and stays with its robot
  double x, y;  // m, field frame
};

struct Point {
  double x, y;  // m, field frame
};

// The robots of one side that are near.
class Near {
 public:
  void reserve(std::size_t robots) {
    labels_.reserve(robots);
    before_.reserve(robots);
  }
  // How many are within `reach` of the ball, or were at the last call and are within `reach` + `margin`. m, >= 0.
  int update(const Point& ball, std::span<const Body> robots, double reach, double margin) {
    std::swap(labels_, before_);
    labels_.clear();
    const double enter = reach * reach, stay = (reach + margin) * (reach + margin);
    for (const Body& robot : robots) {
      const double dx = robot.x - ball.x, dy = robot.y - ball.y;
      const double squared = dx * dx + dy * dy;
      if (squared > stay) continue;
      if (squared <= enter || std::ranges::find(before_, robot.label) != before_.end()) labels_.push_back(robot.label);
    }
    return static_cast<int>(labels_.size());
  }
  void forget() { labels_.clear(); }

 private:
  std::vector<int> labels_, before_;
};

}  // namespace numbers_near_ball
