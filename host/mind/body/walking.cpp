// SPDX-License-Identifier: MIT
#include "mind/body/walking.hpp"

#include <algorithm>
#include <cmath>

namespace regista::mind {
namespace {

constexpr double personal_space = 0.12;   // m between two torsos; the robot keeps this gap to other robots
constexpr double too_close = 0.06;        // m; a robot steps back if the gap is less than personal_space - too_close
constexpr double post_space = 0.08;       // m; gap between torso and goal post
constexpr double step_back = 0.10;        // m/s; speed of stepping back
constexpr double look_ahead = 1.2;        // m; the robot ignores obstacles that are farther along its way
constexpr double walk_turned_from = 0.7;  // m; to a nearer target the robot walks in its final heading
constexpr double turn_gain = 3.0;         // 1/s
constexpr double distance_gain = 1.5;     // 1/s
constexpr double arrived = 0.08;          // m; the robot is at its target if it is nearer
constexpr double heading_reached = 0.1;   // rad; the robot does not turn if its heading error is smaller

// Returns the velocity (field frame) without the part towards obstacles. Very close obstacles make the robot step back.
Vector2d yielding(Vector2d velocity, const Vector2d& own, std::span<const Obstacle> obstacles) {
  for (const Obstacle& obstacle : obstacles) {
    const Vector2d offset = obstacle.position - own;
    const double distance = offset.norm();
    if (distance >= obstacle.radius || distance < 1e-6) continue;
    const Vector2d towards = offset / distance;
    const double wanted = velocity.dot(towards);
    const double allowed = distance < obstacle.radius - too_close ? -step_back : 0.0;
    if (wanted > allowed) velocity += towards * (allowed - wanted);
  }
  return velocity;
}

Walk walk_to_pose(const Body& body, const regista_action& action) {
  Obstacles obstacles;
  if ((action.walk & REGISTA_WALK_STRAIGHT) == 0) obstacles = obstacles_around(body);
  for (const regista_disc& disc : std::span(action.avoid).first(action.avoid_count)) {
    obstacles.add({disc.x, disc.y}, disc.radius);
  }
  const bool brisk = (action.walk & REGISTA_WALK_BRISK) != 0;
  return walk_to(body, {action.pose[0], action.pose[1], action.pose[2]}, obstacles.list(), brisk);
}

constexpr double remembered_for = 1.0;  // s; in this time a robot walks about its own diameter
constexpr double same_within = 0.35;    // m; two positions closer together belong to the same robot
constexpr double near = 2.0;            // m; RobotMemory ignores robots that are farther away

}  // namespace

// The allowed velocities form an ellipse.
Walk limited(const config::Walk& walk, Vector2d velocity, double turn) {
  const double along = velocity.x() >= 0.0 ? walk.forward : walk.backward;
  // A limit of 0 means that the robot cannot walk in this direction.
  if (along == 0.0) velocity.x() = 0.0;
  if (walk.sideways == 0.0) velocity.y() = 0.0;
  const auto share_of = [](double speed, double limit) { return limit > 0.0 ? speed * speed / (limit * limit) : 0.0; };
  const double share = std::sqrt(share_of(velocity.x(), along) + share_of(velocity.y(), walk.sideways));
  if (share > 1.0) velocity /= share;
  return {velocity.x(), velocity.y(), std::clamp(turn, -walk.turn, walk.turn)};
}

Obstacles obstacles_around(const Body& body) {
  Obstacles out;
  const double radius = 2.0 * body.robot.body.radius + personal_space;
  for (const Vector2d& robot : body.robots_near) out.add(robot, radius);
  for (const regista_opponent& opponent : body.world.opponents) {
    const Vector2d position(opponent.position[0], opponent.position[1]);
    if ((position - body.frame.origin()).squaredNorm() < 2.25) out.add(position, radius);
  }
  for (const regista_robot& robot : body.world.robots) {
    if ((robot.flags & REGISTA_ROBOT_ACTIVE) == 0 || robot.number == body.own_number) continue;
    const Vector2d position(robot.pose[0], robot.pose[1]);
    // A position older than 3 s is left out, because the teammate may be anywhere.
    if (robot.age < 3.0 && (position - body.frame.origin()).squaredNorm() < 2.25) out.add(position, radius);
  }
  const config::FieldSize& field = body.rules.field;
  const Vector2d own = body.frame.origin();
  if (std::abs(own.x()) > field.length / 2.0 - look_ahead) {
    const double line = std::copysign(field.length / 2.0, own.x());
    const double post = (field.goal_width + field.post_diameter) / 2.0;
    const double apart = body.robot.body.radius + field.post_diameter / 2.0 + post_space;
    for (const double y : {-post, post}) out.add({line, y}, apart);
  }
  return out;
}

Vector2d way_around(const Vector2d& from, const Vector2d& to, std::span<const Obstacle> obstacles) {
  const Vector2d whole = to - from;
  const double distance = whole.norm();
  if (distance < 1e-9) return to;
  const Vector2d ahead = whole / distance;
  const Vector2d left(-ahead.y(), ahead.x());
  const Obstacle* first = nullptr;
  double first_along = std::min(distance, look_ahead);
  for (const Obstacle& obstacle : obstacles) {
    const Vector2d offset = obstacle.position - from;
    const double along = offset.dot(ahead), across = offset.dot(left);
    if (along <= 0.0 || std::abs(across) >= obstacle.radius || along >= first_along) continue;
    // The way cannot avoid an obstacle that is on the target itself.
    if ((obstacle.position - to).norm() < 0.5 * obstacle.radius) continue;
    first = &obstacle;
    first_along = along;
  }
  if (first == nullptr) return to;
  const double across = (first->position - from).dot(left);
  const double side = across > 0.0 ? -1.0 : 1.0;  // the way on this side of the obstacle is shorter
  return first->position + left * (side * first->radius * 1.1);
}

Vector2d around_goals(const config::FieldSize& field, double radius, const Vector2d& from, const Vector2d& to) {
  const double line = field.length / 2.0, post = (field.goal_width + field.post_diameter) / 2.0;
  const double room = radius + field.post_diameter / 2.0 + 2.0 * post_space;
  const double mouth = std::max(0.0, post - radius - post_space);  // m; largest |y| of a robot's centre in the mouth
  const auto beyond = [&](const Vector2d& point) { return std::abs(point.x()) > line; };
  const auto in_goal = [&](const Vector2d& point) { return beyond(point) && std::abs(point.y()) < post; };
  const auto in_mouth = [&](double y) { return std::clamp(y, -mouth, mouth); };
  // Moves a target that is too near to a side net away from the net. The target stays on its side of the net.
  Vector2d target = to;
  if (in_goal(to)) {
    const double deepest = line + std::max(0.0, field.goal_depth - radius - post_space);
    target = {std::clamp(to.x(), -deepest, deepest), in_mouth(to.y())};
  }
  if (beyond(to) && !in_goal(to)) target.y() = std::copysign(std::max(post + room, std::abs(to.y())), to.y());
  const bool same_end = from.x() * target.x() > 0.0;
  const double end = std::abs(from.x()) > line - room ? from.x() : target.x();
  const double before = std::copysign(line - room, end);  // x of a place in front of the goal line
  if (in_goal(from)) return in_goal(target) && same_end ? target : Vector2d(before, in_mouth(from.y()));
  const auto at_line = [&](const Vector2d& point) { return std::abs(point.x()) > line - room + 0.01; };
  if (at_line(from) && std::abs(from.y()) >= post) {
    const bool same_side = at_line(target) && same_end && from.y() * target.y() > 0.0 && std::abs(target.y()) >= post;
    const bool goal_between = at_line(target) || std::abs(target.y()) < post + room || from.y() * target.y() < 0.0;
    const double y = std::copysign(std::max(post + room, beyond(from) ? 0.0 : std::abs(from.y())), from.y());
    return !same_side && goal_between ? Vector2d(before, y) : target;
  }
  if (at_line(from) && std::abs(target.y()) >= post && !(at_line(target) && same_end))
    return {before, in_mouth(from.y())};
  // The robot is in front of the goal line. On a way behind the line, the robot keeps a distance from the posts.
  if (!at_line(target)) return target;
  const double edge = in_goal(target) ? mouth : beyond(target) ? post + room - 0.02 : post;
  const auto outside = [&](double y) { return std::abs(y) > edge + 0.01; };
  const bool other_side = outside(from.y()) && outside(target.y()) && from.y() * target.y() < 0.0;
  if (outside(from.y()) == outside(target.y()) && !other_side) return target;
  return {before, same_end && at_line(from) ? from.y() : target.y()};
}

Walk walk_to(const Body& body, const Pose& target, std::span<const Obstacle> obstacles, bool brisk) {
  const config::Walk& walk = body.robot.walk;
  const Vector2d goal =
      around_goals(body.rules.field, body.robot.body.radius, body.frame.origin(), {target.x, target.y});
  const double distance = (goal - body.frame.origin()).norm();
  if (distance < arrived && !brisk) {
    const double turn = wrap(target.heading - body.pose.heading);
    const Vector2d velocity = yielding(goal - body.frame.origin(), body.frame.origin(), obstacles);
    return limited(walk, body.frame.direction_to_robot(velocity),
                   std::abs(turn) < heading_reached ? 0.0 : turn_gain * turn);
  }
  const Vector2d next = way_around(body.frame.origin(), goal, obstacles);
  const Vector2d direction = body.frame.direction_to_robot(next - body.frame.origin());
  const double wanted = distance > walk_turned_from ? angle_of(direction) : wrap(target.heading - body.pose.heading);
  // For a far target the robot first turns to it, because walking forward is fastest.
  const double facing = distance > walk_turned_from ? std::max(0.0, std::cos(wanted)) : 1.0;
  const double speed = brisk ? walk.forward : std::min(walk.forward, distance_gain * distance);
  const Vector2d velocity = (next - body.frame.origin()).normalized() * (speed * facing);
  return limited(walk, body.frame.direction_to_robot(yielding(velocity, body.frame.origin(), obstacles)),
                 turn_gain * wanted);
}

Command carry_out(const Body& body, const regista_action& action) {
  Command command;
  command.head_yaw = action.gaze;
  if (action.kick != REGISTA_NO_KICK) {
    command.kick = KickRequest{action.kick, action.kick_direction, action.kick_distance};
    return command;
  }
  const Vector2d wanted(action.velocity[0], action.velocity[1]);
  if (action.motion == REGISTA_MOTION_VELOCITY) command.walk = limited(body.robot.walk, wanted, action.velocity[2]);
  if (action.motion == REGISTA_MOTION_WALK_TO) {
    command.walk = walk_to_pose(body, action);
    if ((action.walk & REGISTA_WALK_CREEP) != 0) {
      command.walk = limited(body.robot.walk, wanted, command.walk.turn);
    }
  }
  return command;
}

void RobotMemory::update(const Percepts& percepts, const Frame2& own, double touching) {
  while (count_ > 0 && percepts.time - times_[0] > remembered_for) forget(0);  // entry 0 is the oldest
  for (const RobotSighting& seen : percepts.robots) {
    if (seen.position.squaredNorm() < near * near) remember(own.to_field(seen.position), percepts.time);
  }
  if (percepts.contact) {
    const double bearing = *percepts.contact;
    remember(own.to_field(touching * Vector2d(std::cos(bearing), std::sin(bearing))), percepts.time);
  }
}

void RobotMemory::remember(const Vector2d& position, double time) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (times_[i] < time && (positions_[i] - position).squaredNorm() < same_within * same_within) {
      forget(i);
      break;
    }
  }
  if (count_ == most) forget(0);
  positions_[count_] = position;
  times_[count_] = time;
  ++count_;
}

void RobotMemory::forget(std::size_t index) {
  std::copy(positions_.begin() + index + 1, positions_.begin() + count_, positions_.begin() + index);
  std::copy(times_.begin() + index + 1, times_.begin() + count_, times_.begin() + index);
  --count_;
}

}  // namespace regista::mind
