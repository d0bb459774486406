// SPDX-License-Identifier: MIT
// What a behaviour acts on: the facts, the game and what the robot believes, as plain values. SI units, field frame
// unless said otherwise.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include <Eigen/Core>

namespace behaviours {

// --- Plane geometry that behaviours need: angles, and the change between the field's frame and the robot's. Radians,
// metres.

using Eigen::Vector2d;

struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

inline constexpr double pi = std::numbers::pi;

// The same angle in (-pi, pi].
inline double wrap(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

// In (-pi, pi]; 0 for no direction at all.
inline double angle_of(const Vector2d& v) {
  const double angle = std::atan2(v.y(), v.x());
  return angle == -pi ? pi : angle;  // atan2 says -pi for a y of -0
}

// Turned to the left by an angle of this cosine and sine.
inline Vector2d turned(const Vector2d& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

// A pose with its direction as a vector, so that changing frames costs no trigonometry.
class Frame2 {
 public:
  explicit Frame2(const Pose& pose)
      : origin_(pose.x, pose.y), cos_(std::cos(pose.heading)), sin_(std::sin(pose.heading)) {}
  Vector2d direction_to_robot(const Vector2d& v) const {
    return {cos_ * v.x() + sin_ * v.y(), cos_ * v.y() - sin_ * v.x()};
  }
  Vector2d to_robot(const Vector2d& v) const { return direction_to_robot(v - origin_); }
  const Vector2d& origin() const { return origin_; }

 private:
  Vector2d origin_;
  double cos_, sin_;
};

// The point of the segment a-b nearest to p.
inline Vector2d nearest_on_segment(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return a;
  const double t = std::fmin(1.0, std::fmax(0.0, (p - a).dot(along) / length2));
  return a + t * along;
}

// As in abi.h, and in its order.
enum class Phase { initial, ready, set, playing, finished };
enum class SetPlay { none, kick_off, kick_in, goal_kick, corner_kick, pushing_free_kick, penalty_kick };

// What the robot is there for: the rules of a set play let who plays the ball, and who keeps the goal, stand elsewhere.
enum class Duty { other, plays_ball, keeps_goal };

// Between the centres of the lines.
struct Field {
  double length = 9.0, width = 6.0;
  double goal_width = 1.5;  // inner
  double goal_area_length = 0.6, goal_area_width = 2.2;
  double penalty_area_length = 1.65;
  double penalty_mark_distance = 1.3;  // from the goal line
  double centre_circle_radius = 0.75;
};

// What stays the same through a match. The values here are those of the SPL rule book 2023 and of a NAO.
struct Facts {
  Field field;
  double ball_radius = 0.05;
  double ball_deceleration = 0.32;  // of a rolling ball
  double set_play_distance = 0.75;  // that opponents keep from the ball of a set play
  double robot_radius = 0.15;
  double reach = 0.22;         // from its centre to that of a ball that it can kick
  double walk_forward = 0.25;  // highest speed
  double head_yaw = 1.5707963267948966;
  bool can_kick = true;
  int own_number = 1;
};

// Of the own team, in play and on its feet.
struct Teammate {
  Vector2d position{0, 0};
  double age = 0.0;  // s since the last news of it
  int number = 0;    // on its shirt
};

// An opponent.
struct Blocker {
  Vector2d position{0, 0};
  double weight = 1.0;  // probability that it is there
};

struct Edge {
  std::uint32_t from = 0, to = 0;  // undirected
};

// Places, and the ways between them. Owns nothing.
struct Graph {
  std::span<const Vector2d> nodes;
  std::span<const Edge> edges;  // each between two of the nodes
};

struct Situation {
  Facts facts;
  Duty duty = Duty::other;
  Phase phase = Phase::playing;
  SetPlay set_play = SetPlay::none;
  bool own_kick = false;  // the set play, or the last kick-off, is the own team's
  double time = 0.0;
  Pose pose;
  Frame2 frame{Pose{}};    // of the pose
  bool incapable = false;  // lies, is penalised or in the middle of a kick
  bool has_task = false;
  Pose target;                               // of the own task; the pose without one
  std::span<const Vector2d> more_important;  // targets of the tasks before the own one in the list of tasks
  bool along_edges = false;                  // the team wants robots to walk to it along the edges of the graph
  Graph graph;                               // empty unless along_edges
  bool sees_ball = false;
  bool ball_trusted = false;  // known, and young enough to act on
  Vector2d ball{0, 0}, ball_velocity{0, 0};
};

// The set play, or the kick-off until the ball is free, is the opponent's: the ball must not be touched.
inline bool ball_is_theirs(const Situation& situation) {
  return situation.set_play != SetPlay::none && !situation.own_kick;
}

// From the own set play no goal can be scored before the ball has been played a second time (SPL rule book 2023, 3.9);
// but from a kick-off and a penalty kick it can.
inline bool is_indirect(const Situation& situation) {
  if (!situation.own_kick) return false;
  switch (situation.set_play) {
    case SetPlay::kick_in:
    case SetPlay::goal_kick:
    case SetPlay::corner_kick:
    case SetPlay::pushing_free_kick:
      return true;
    case SetPlay::none:
    case SetPlay::kick_off:
    case SetPlay::penalty_kick:
      break;
  }
  return false;
}

}  // namespace behaviours
