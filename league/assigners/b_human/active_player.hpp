// SPDX-License-Identifier: MIT
// The active player of B-Human (Roefer et al., "B-Human 2022 - More Team Play with Less Communication", RoboCup 2022,
// LNCS 13561; numbers of the code release of 2025): the one that is first at the ball, as this robot sees it. It
// computes every time itself, from the ball that it sees and from where teammates should be by now, so that nobody is
// asked. Two robots may take themselves for it; that is part of the published design.
//
// Decided by us, where the sources leave it open:
//   - the form of the time: see time_to_ball();
//   - who is blind: its ball is older than the age at which it could become active;
//   - the distance by which a teammate's ball may be off grows with the distance of that teammate from its ball. Balls
//     are compared once, when the packet is heard. Later the ball may have been kicked away from where all teammates
//     said it was; a robot that sees that and compared again would take itself for the only one with a good ball;
//   - what a teammate said of its ball's age stays so until it says something else: a robot whose sender has no news is
//     silent.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace b_human {

struct Point {
  double x = 0.0, y = 0.0;  // m, field frame
};

struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

inline double distance(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

struct ActiveRule {
  double forward = 0.26, sideways = 0.22;  // m/s
  double turn_rate = 1.7453292519943295;   // rad/s, 100 degrees
  double holder_bonus = 1.0;               // s less for who is active already
  double longest_get_up = 5.0;             // s more at most for who lies on the ground
  double blind_penalty = 2.0;              // s more for who does not see the ball
  double age_to_become = 1.0;              // s: who is not active needs a ball at most so old
  double age_to_stay = 5.0;                // s: who is
  // A teammate whose ball is farther off than this is ignored: linear in its distance from its ball.
  double near = 2.5, far = 7.5;                      // m
  double off_when_near = 0.78, off_when_far = 1.55;  // m
};

struct Candidate {
  Pose pose;  // by now
  bool knows_ball = false;
  bool ball_is_off = false;  // of a teammate: the ball that it told was another one than the own
  double ball_age = 0.0;     // s; of a teammate: as it said
  bool is_active = false;
  double until_up = 0.0;  // s
};

// ms to the ball: the way ahead and aside in the robot frame, each at its speed, after the turn towards the ball.
inline std::int64_t time_to_ball(const Candidate& robot, const Point& ball, const ActiveRule& rule) {
  const double dx = ball.x - robot.pose.x, dy = ball.y - robot.pose.y;
  const double c = std::cos(robot.pose.heading), s = std::sin(robot.pose.heading);
  const double ahead = c * dx + s * dy, left = c * dy - s * dx;
  const double along = ahead / rule.forward, across = left / rule.sideways;
  double time = std::sqrt(along * along + across * across);
  if (dx != 0.0 || dy != 0.0) time += std::abs(std::atan2(left, ahead)) / rule.turn_rate;
  time += std::clamp(robot.until_up, 0.0, rule.longest_get_up);
  if (robot.ball_age > rule.age_to_become) time += rule.blind_penalty;
  if (robot.is_active) time -= rule.holder_bonus;
  return std::llround(1000.0 * time);
}

// How far the ball of a teammate may be from the own one.
inline double ball_may_be_off(double distance_from_ball, const ActiveRule& rule) {
  if (rule.far <= rule.near) return distance_from_ball < rule.far ? rule.off_when_near : rule.off_when_far;
  const double share = std::clamp((distance_from_ball - rule.near) / (rule.far - rule.near), 0.0, 1.0);
  return rule.off_when_near + share * (rule.off_when_far - rule.off_when_near);
}

// Whether a teammate that stood at `place` and told of a ball means another one than the own.
inline bool is_another_ball(const Point& place, const Point& told, const Point& own, const ActiveRule& rule) {
  return distance(told, own) > ball_may_be_off(distance(place, told), rule);
}

inline bool may_be_active(const Candidate& robot, const ActiveRule& rule) {
  if (!robot.knows_ball || robot.ball_is_off) return false;
  return robot.ball_age <= (robot.is_active ? rule.age_to_stay : rule.age_to_become);
}

// Index of the active player; the first of those with equal times. candidates: in order of their numbers. ball: the own
// one.
inline std::optional<std::size_t> active_player(std::span<const Candidate> candidates, const Point& ball,
                                                const ActiveRule& rule) {
  std::optional<std::size_t> best;
  std::int64_t least = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!may_be_active(candidates[i], rule)) continue;
    const std::int64_t time = time_to_ball(candidates[i], ball, rule);
    if (best && time >= least) continue;
    best = i;
    least = time;
  }
  return best;
}

}  // namespace b_human
