// SPDX-License-Identifier: MIT
#include "match/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace regista::match {
namespace {

double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

}  // namespace

mind::Pose start_pose(const config::FieldSize& field, double direction, int number, int team_size) {
  const int places = (team_size + 1) / 2, place = (number - 1) / 2;
  const double deepest = field.length / 2.0 - field.goal_area_length, nearest = deepest / 4.0;
  const double step = places > 1 ? (deepest - nearest) / (places - 1) : 0.0;
  const double touch_line = (number % 2 == 1 ? direction : -direction) * field.width / 2.0;
  return {-direction * (deepest - step * place), touch_line, -sign(touch_line) * std::numbers::pi / 2.0};
}

mind::Pose re_entry_pose(const config::FieldSize& field, double direction, Vector ball, int self,
                         std::span<const Vector> robots, double gap) {
  const double touch_line = -sign(ball.y) * field.width / 2.0;
  const double mark = -direction * (field.length / 2.0 - field.penalty_mark_distance);
  const auto is_free = [&](double x) {
    for (std::size_t id = 0; id < robots.size(); ++id) {
      if (static_cast<int>(id) != self && squared_length(robots[id] - Vector{x, touch_line}) < gap * gap) return false;
    }
    return true;
  };
  const double away = mark >= ball.x ? 1.0 : -1.0;
  const auto in_own_half = [&](double x) { return x * direction <= 0.0 && std::fabs(x) <= field.length / 2.0; };
  double x = mark;
  for (int k = 1; k <= 100 && !(in_own_half(x) && is_free(x)); ++k) {
    // Away, towards the ball, farther away, ...
    x = mark + (k % 2 == 1 ? away : -away) * gap * ((k + 1) / 2);
  }
  if (!in_own_half(x)) x = mark;
  return {x, touch_line, -sign(touch_line) * std::numbers::pi / 2.0};
}

mind::Pose waiting_pose(const config::FieldSize& field, int id, double robot_radius) {
  const double gap = 4.0 * robot_radius;
  return {gap * id - field.length / 2.0, field.width / 2.0 + field.border_strip + gap, -std::numbers::pi / 2.0};
}

Vector kick_in_spot(const config::FieldSize& field, Vector left_at) {
  const double x = std::clamp(left_at.x, -field.length / 2.0, field.length / 2.0);
  return {x, sign(left_at.y) * field.width / 2.0};
}

Vector goal_kick_spot(const config::FieldSize& field, Vector left_at) {
  return {sign(left_at.x) * (field.length / 2.0 - field.goal_area_length),
          sign(left_at.y) * field.goal_area_width / 2.0};
}

Vector corner_spot(const config::FieldSize& field, Vector left_at) {
  return {sign(left_at.x) * field.length / 2.0, sign(left_at.y) * field.width / 2.0};
}

Vector free_spot(const config::FieldSize& field, Vector wanted, int self, std::span<const Vector> robots,
                 double robot_gap, Vector ball, double ball_gap) {
  constexpr int rings = 20, places = 16;
  const double x = field.length / 2.0, y = field.width / 2.0;
  const auto is_free = [&](Vector spot) {
    if (squared_length(spot - ball) < ball_gap * ball_gap) return false;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (static_cast<int>(i) != self && squared_length(spot - robots[i]) < robot_gap * robot_gap) return false;
    }
    return true;
  };
  if (is_free(wanted)) return wanted;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int place = 0; place < places; ++place) {
      const double angle = 2.0 * std::numbers::pi * place / places, distance = 0.5 * robot_gap * ring;
      const Vector spot = wanted + Vector{distance * std::cos(angle), distance * std::sin(angle)};
      if (std::fabs(spot.x) <= x && std::fabs(spot.y) <= y && is_free(spot)) return spot;
    }
  }
  return wanted;
}

}  // namespace regista::match
