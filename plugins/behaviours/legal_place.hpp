// SPDX-License-Identifier: MIT
// Where a robot may stand: the rules of kick-off and set plays (SPL rule book 2023) laid over the place that its task
// asks for.
#pragma once

#include <algorithm>
#include <cmath>

#include "situation.hpp"

namespace behaviours {

struct LegalPlaceSettings {
  double margin = 0.2;  // m beyond what a rule asks for, because nobody knows exactly where it stands
};

namespace detail {

inline Vector2d outside_circle(const Vector2d& point, const Vector2d& centre, double radius) {
  const Vector2d out = point - centre;
  const double distance = out.norm();
  if (distance >= radius) return point;
  // From the centre itself, back towards the own goal.
  return distance < 1e-6 ? Vector2d(centre.x() - radius, centre.y()) : Vector2d(centre + out * (radius / distance));
}

inline bool takes(const Situation& situation) { return situation.duty == Duty::plays_ball; }

inline Vector2d at_kick_off(const Situation& situation, const LegalPlaceSettings& settings, Vector2d point) {
  const Facts& facts = situation.facts;
  const double line = -facts.robot_radius - settings.margin;
  if (situation.own_kick && takes(situation)) {
    return situation.phase == Phase::playing ? point : Vector2d(line, 0.0);
  }
  point.x() = std::min(point.x(), line);
  if (!situation.own_kick) {
    const double circle = facts.field.centre_circle_radius + facts.robot_radius + settings.margin;
    point = outside_circle(point, {0.0, 0.0}, circle);
    point.x() = std::min(point.x(), line);
  }
  return point;
}

// The taker waits behind the mark, the goalkeeper on its line; everybody else stays out of the penalty area.
inline Vector2d at_penalty_kick(const Situation& situation, const LegalPlaceSettings& settings, const Vector2d& point) {
  const Facts& facts = situation.facts;
  const Field& field = facts.field;
  const double end = situation.own_kick ? 1.0 : -1.0;
  if (situation.own_kick && takes(situation)) {
    if (situation.phase == Phase::playing) return point;
    const double behind = facts.robot_radius + 2.0 * facts.ball_radius + settings.margin;
    return {field.length / 2.0 - field.penalty_mark_distance - behind, 0.0};
  }
  if (!situation.own_kick && facts.own_number == 1) {
    const double between = std::max(0.0, field.goal_width / 2.0 - facts.robot_radius);
    return {-field.length / 2.0, std::clamp(point.y(), -between, between)};
  }
  const double edge = field.length / 2.0 - field.penalty_area_length - facts.robot_radius - settings.margin;
  return {end * std::min(end * point.x(), edge), point.y()};
}

// Three of a team may stand there; who has no business at the ball leaves the room to those who have.
inline Vector2d outside_own_goal_area(const Field& field, const LegalPlaceSettings& settings, const Vector2d& point) {
  const double edge = -field.length / 2.0 + field.goal_area_length + settings.margin;
  if (point.x() >= edge || std::abs(point.y()) >= field.goal_area_width / 2.0 + settings.margin) return point;
  return {edge, point.y()};
}

}  // namespace detail

// The nearest legal pose to the wanted one.
inline Pose legal_place(const Situation& situation, const LegalPlaceSettings& settings, const Pose& wanted) {
  const Facts& facts = situation.facts;
  const Field& field = facts.field;
  Vector2d point(std::clamp(wanted.x, -field.length / 2.0, field.length / 2.0),
                 std::clamp(wanted.y, -field.width / 2.0, field.width / 2.0));
  double heading = wanted.heading;
  if (situation.set_play == SetPlay::penalty_kick) {
    point = detail::at_penalty_kick(situation, settings, point);
    // The taker and the goalkeeper face each other.
    if (situation.own_kick && detail::takes(situation)) heading = 0.0;
  } else if (situation.phase == Phase::ready || situation.phase == Phase::set ||
             situation.set_play == SetPlay::kick_off) {
    point = detail::at_kick_off(situation, settings, point);
  } else if (ball_is_theirs(situation) && situation.ball_trusted) {
    const double distance = facts.set_play_distance + facts.robot_radius + settings.margin;
    point = detail::outside_circle(point, situation.ball, distance);
  }
  if (situation.duty == Duty::other) point = detail::outside_own_goal_area(field, settings, point);
  return {point.x(), point.y(), heading};
}

}  // namespace behaviours
