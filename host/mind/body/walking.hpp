// SPDX-License-Identifier: MIT
// Walking to a pose: straight and fast from afar, sideways near the target, around whoever stands in the way. A robot
// yields: it never pushes (pushing is punished by the rules).
#pragma once

#include <span>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "mind/body/body.hpp"
#include "mind/command.hpp"
#include "mind/geometry.hpp"

namespace regista::mind {

// A disc to keep away from; field frame.
struct Obstacle {
  Vector2d position{0, 0};
  double radius = 0.0;  // distance that the own centre should keep
};

// Up to so many obstacles are looked at, the nearest ones.
class Obstacles {
 public:
  static constexpr std::size_t most = 24;
  void add(const Vector2d& position, double radius) {
    if (count_ < most) list_[count_++] = {position, radius};
  }
  std::span<const Obstacle> list() const { return {list_, count_}; }

 private:
  Obstacle list_[most];
  std::size_t count_ = 0;
};

// Robots that are seen now, opponents and teammates that are believed to be near, and goal posts.
Obstacles obstacles_around(const Body& body);

// The point to walk to next on the way from `from` to `to`: `to` itself, or beside the first obstacle in the way.
Vector2d way_around(const Vector2d& from, const Vector2d& to, std::span<const Obstacle> obstacles);

// The point to walk to first on the way from `from` to `to`, so that nobody walks against the side of a goal: into it
// and out of it leads its mouth, behind the line beside it a way around the post. `radius`: of the robot.
Vector2d around_goals(const config::FieldSize& field, double radius, const Vector2d& from, const Vector2d& to);

// Velocity towards a pose. `brisk`: do not slow down to arrive.
Walk walk_to(const Body& body, const Pose& target, std::span<const Obstacle> obstacles, bool brisk = false);

// A wanted velocity (robot frame) and turn, scaled into what the walk can do.
Walk limited(const config::Walk& walk, Vector2d velocity, double turn);

}  // namespace regista::mind
