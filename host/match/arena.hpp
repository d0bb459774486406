// SPDX-License-Identifier: MIT
// The physical world: field border, goals, robots and ball in Box2D. The only place that knows Box2D; it knows no
// rules and no teams. World frame, SI units; in memory of Box2D floats.
//
// Bodies are created in a fixed order (walls, goals, robots by id, ball), because Box2D's results depend on it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/geometry.hpp"
#include "match/physics_log.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

constexpr double physics_step = 0.02;  // s
constexpr int physics_steps_per_second = 50;
constexpr double instant = physics_step / 2.0;  // s: moments are met at the nearest physics step

// heading is not wrapped; cosine and sine belong to it. turn: rad/s.
struct BodyState {
  float x, y, heading, cosine, sine, vx, vy, turn;
};

// What touched what during the last step. Sets have bit `id` for a robot.
struct Contacts {
  RobotSet robots_on_ball = 0;
  RobotSet robots_on_robots = 0;
  RobotSet robots_on_walls = 0;                        // border, goal posts, nets
  std::array<std::array<std::int8_t, 2>, 64> pairs{};  // ids of robots in contact; the first 64 of them
  int pair_count = 0;
  int hardest_on_ball = -1;  // robot that touched the ball with the largest impulse; -1: none
};

class Arena {
 public:
  // One torso for each robot; the id of a robot is its index. Everything stands at the origin until it is placed.
  Arena(const config::FieldSize& field, const config::BallSize& ball, std::span<const config::Body> robots);
  ~Arena();
  Arena(Arena&&) noexcept;
  Arena& operator=(Arena&&) noexcept;

  // Changes the velocity of a robot towards the wanted one (m/s world frame, rad/s), by no more than the accelerations
  // (m/s^2, rad/s^2) allow in one step. To be called before each step; a robot that is not driven slides on.
  void drive(int robot, Vector velocity, double turn, double acceleration, double turn_acceleration);

  // Puts a body down at rest. A pose or velocity that is not finite is refused with std::invalid_argument that names
  // the body, because Box2D aborts on the one and is silently poisoned by the other.
  void place(int robot, const mind::Pose& pose);
  void place_ball(Vector position);
  void kick(Vector ball_velocity);

  void step();

  // Robots by id, then the ball; as after the last change.
  std::span<const BodyState> states() const { return states_; }
  const BodyState& robot(int id) const { return states()[static_cast<std::size_t>(id)]; }
  const BodyState& ball() const { return states().back(); }
  Vector ball_position() const { return {ball().x, ball().y}; }
  const Contacts& contacts() const;

  // From now on everything that is done to the bodies is appended to `log`, which is the caller's; null: no more.
  void record(PhysicsLog* log);

  // Does what was recorded, then steps Box2D, and nothing else: no contacts, no states (see observe()).
  void replay_step(std::span<const Operation> operations);
  void observe();  // brings states() up to date after replay_step()

 private:
  struct World;
  std::unique_ptr<World> world_;
  std::span<const BodyState> states_;  // of world_
};

}  // namespace regista::match
