// SPDX-License-Identifier: MIT
// PhysicsWorld simulates field border, goals, robots and ball with Box2D. Only physics_world.cpp uses Box2D.
// PhysicsWorld knows no rules and no teams. World frame, SI units; Box2D computes in float. Operations can be recorded
// and replayed. Bodies are created in this order, which affects Box2D's results: walls, goals, robots by id, ball.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// One change of a body by PhysicsWorld. body: robot id; for the ball, the number of robots. x, y, turn: a
// velocity (m/s, rad/s) for Kind::velocity, a pose (m, rad) for Kind::place.
struct Operation {
  enum class Kind : std::uint16_t { velocity, place };
  std::uint16_t body;
  Kind kind;
  float x, y, turn;
};

struct PhysicsLog {  // the recording of a match for replay(), from before its first step
  config::FieldSize field;
  config::BallSize ball;
  std::vector<config::Body> robots;
  std::vector<Operation> operations;  // of all steps, in order
  // Element n is the number of operations up to the end of step n (from 0). operations[step_ends[n - 1]] begins step n.
  std::vector<std::uint32_t> step_ends;
};

constexpr double physics_step = 0.02;  // s
constexpr int physics_steps_per_second = 50;
constexpr double instant = physics_step / 2.0;  // s; tolerance for comparing a moment with the time of a step

// State of a robot or the ball, m and m/s. heading: rad, not wrapped; cosine, sine: of `heading`; turn: rad/s.
struct BodyState {
  float x, y, heading, cosine, sine, vx, vy, turn;
};

// The contacts of the last physics step. The sets contain the robots that touched the ball, another robot or a wall.
struct Contacts {
  RobotSet robots_on_ball = 0;
  RobotSet robots_on_robots = 0;
  RobotSet robots_on_walls = 0;                        // walls are the border, goal posts and nets
  std::array<std::array<std::int8_t, 2>, 64> pairs{};  // ids of two robots that touched; at most 64 pairs
  int pair_count = 0;                                  // number of pairs in `pairs`
  int hardest_on_ball = -1;  // id of the robot that hit the ball with the largest impulse; -1: no robot hit it
};

class PhysicsWorld {
 public:
  // Creates the bodies of robots and ball, at the origin. The id of a robot is its index in `robots`.
  PhysicsWorld(const config::FieldSize& field, const config::BallSize& ball, std::span<const config::Body> robots);
  ~PhysicsWorld();
  PhysicsWorld(PhysicsWorld&&) noexcept;

  // Changes the velocity of a robot towards `velocity` (m/s, world frame) and `turn` (rad/s). The accelerations (m/s^2,
  // rad/s^2) limit the change in one step. Must be called for each robot before each step(), or the robot slides on.
  void drive(int robot, Vector velocity, double turn, double acceleration, double turn_acceleration);

  // place() and place_ball() put a body down at rest. kick() sets the ball's velocity. For a value that is not finite,
  // they throw std::invalid_argument, which names the body: Box2D would abort, or pass the value on to other bodies.
  void place(int robot, const mind::Pose& pose);
  void place_ball(Vector position);
  void kick(Vector ball_velocity);

  void step();  // simulates one physics step

  // The states of the robots by id, then the ball. The states include changes since the last step().
  std::span<const BodyState> states() const { return states_; }
  const BodyState& robot(int id) const { return states()[at(id)]; }
  const BodyState& ball() const { return states().back(); }
  Vector ball_position() const { return {ball().x, ball().y}; }
  const Contacts& contacts() const;

  // Appends all further operations to `log`, which the caller owns. Null: records nothing.
  void record(PhysicsLog* log);

  // Replays a match, without minds and rules, in a new world that is made as for the match; benchmarks compare the
  // times. Then states() is as after the match, only the ball is faster, by half a step's friction.
  void replay(const PhysicsLog& log);

 private:
  struct World;
  std::unique_ptr<World> world_;
  std::span<const BodyState> states_;  // memory in world_
};

}  // namespace regista::match
