// SPDX-License-Identifier: MIT
// Converts a behaviour's action to the command for the body. A robot walks straight and fast to a target that is
// farther away than 0.7 m, in its final heading (perhaps sideways) to a nearer target, and around robots in the way. A
// robot never pushes other robots, because the rules punish pushing. SI units, field frame.
#pragma once

#include <regista/abi.h>

#include <array>
#include <span>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "mind/action.hpp"
#include "mind/geometry.hpp"
#include "mind/percepts.hpp"
#include "mind/world/world_model.hpp"

namespace regista::mind {

// What the functions of this header need to know: the robot's abilities, its pose, and robots that may be in its way.
struct Body {
  const config::Rules& rules;
  const config::Robot& robot;
  const DistributedWorldModel& world;  // the world model `mine` of this robot
  int own_number = 0;
  Pose pose;
  Frame2 frame;                           // converts between the robot frame of `pose` and the field frame
  std::span<const Vector2d> robots_near;  // robots of both teams; see RobotMemory::positions()
};

struct Obstacle {  // A disc that the robot should avoid; field frame.
  Vector2d position{0, 0};
  double radius = 0.0;  // m; the robot's centre should keep this distance from `position`
};

// A list of at most 24 obstacles. add() ignores an obstacle if the list is full.
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

// Returns what the robot must walk around: the robots in Body::robots_near, which it saw or touched in the last second;
// the opponents and active teammates that its world model places within 1.5 m, teammates only if their position is
// younger than 3 s; and, within 1.2 m of a goal line (measured along the field), the posts of that goal.
Obstacles obstacles_around(const Body& body);

// Returns the next point on the way: beside the first obstacle within the next 1.2 m of the way, or `to` itself.
Vector2d way_around(const Vector2d& from, const Vector2d& to, std::span<const Obstacle> obstacles);

// Returns the next point on a way from `from` to `to` that avoids the side nets of the goals. Ways into and out of a
// goal lead through its mouth. Ways to places behind the goal line lead around the post. `radius`: radius of the robot.
Vector2d around_goals(const config::FieldSize& field, double radius, const Vector2d& from, const Vector2d& to);

// Returns the velocity with which to walk to `target`. `brisk`: the robot does not slow down before the target.
Walk walk_to(const Body& body, const Pose& target, std::span<const Obstacle> obstacles, bool brisk = false);

// Scales a wanted velocity (m/s, robot frame) and turn (rad/s) down to the limits of the walk.
Walk limited(const config::Walk& walk, Vector2d velocity, double turn);

// Converts an action to a command. plugin::Behaviour must have checked the action. A robot that kicks does not walk.
Command carry_out(const Body& body, const regista_action& action);

// --- RobotMemory remembers for one second the robots of both teams that this robot saw within 2 m or touched, so that
// it walks around them although the camera misses every third robot or looks elsewhere.

class RobotMemory {
 public:
  static constexpr std::size_t most = 16;
  // `own`: frame of this robot's pose at the time of the percepts. touching: m between the centres of touching robots.
  void update(const Percepts& percepts, const Frame2& own, double touching);
  // Returns the remembered positions in the field frame, in the order of their last sightings.
  std::span<const Vector2d> positions() const { return {positions_.data(), count_}; }

 private:
  void remember(const Vector2d& position, double time);
  void forget(std::size_t index);

  std::array<Vector2d, most> positions_;
  std::array<double, most> times_{};
  std::size_t count_ = 0;
};

}  // namespace regista::mind
