// SPDX-License-Identifier: MIT
#include "match/placement.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

namespace regista::match {
namespace {

double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

bool taken(Vector spot, int self, std::span<const Vector> robots, double gap) {
  for (std::size_t id = 0; id < robots.size(); ++id) {
    if (static_cast<int>(id) != self && squared_length(spot - robots[id]) < gap * gap) return true;
  }
  return false;
}

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
  const auto is_free = [&](double x) { return !taken({x, touch_line}, self, robots, gap); };
  const double away = mark >= ball.x ? 1.0 : -1.0;
  const auto in_own_half = [&](double x) { return x * direction <= 0.0 && std::fabs(x) <= field.length / 2.0; };
  double x = mark;
  for (int k = 1; k <= 100 && !(in_own_half(x) && is_free(x)); ++k) {
    // The tried places alternate: away from the ball, towards the ball, farther away from the ball, ...
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
    return squared_length(spot - ball) >= ball_gap * ball_gap && !taken(spot, self, robots, robot_gap);
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

RobotSet intruders_at_kick_off(const config::Rules& rules, const GameState& state, Roster roster,
                               std::span<const Vector> robots, RobotSet playing) {
  const config::FieldSize& field = rules.field;
  const auto in_own_half = [&](int id) { return robots[at(id)].x * attack(roster.side(id), state.half) <= 0.0; };
  const RobotSet kicking = those(playing, [&](int id) { return roster.side(id) == state.kicking; });
  const RobotSet beyond = those(playing, [&](int id) { return !in_own_half(id); });
  const RobotSet may = those(beyond & kicking, [&](int id) { return in_centre_circle(field, robots[at(id)]); });
  const int taker = with_least(may, [&](int id) { return squared_length(robots[at(id)] - state.spot); });
  const RobotSet in_circle = those(playing & ~kicking, [&](int id) { return in_centre_circle(field, robots[at(id)]); });
  return (taker >= 0 ? beyond & ~only(taker) : beyond) | in_circle;
}

RobotSet intruders_at_penalty_kick(const config::Rules& rules, const GameState& state, Roster roster,
                                   std::span<const Vector> robots, RobotSet playing) {
  const double end = attack(state.kicking, state.half);
  RobotSet inside = those(playing, [&](int id) { return in_penalty_area(rules.field, end, robots[at(id)]); });
  inside &= ~only(roster.id(opposite(state.kicking), 1));
  const RobotSet attackers = those(inside, [&](int id) { return roster.side(id) == state.kicking; });
  const int taker = with_least(attackers, [&](int id) { return squared_length(robots[at(id)] - state.spot); });
  return taker >= 0 ? inside & ~only(taker) : inside;
}

RobotSet illegal_in_set(const config::Rules& rules, const GameState& state, Roster roster,
                        std::span<const Vector> robots, RobotSet playing, double robot_radius) {
  const config::FieldSize& field = rules.field;
  const double on_ball = robot_radius + rules.ball.diameter / 2.0;
  RobotSet out = those(playing, [&](int id) {
    return on_border_strip(field, robots[at(id)], robot_radius) ||
           squared_length(robots[at(id)] - state.spot) < on_ball * on_ball;
  });
  const bool penalty_kick = state.set_play == mind::SetPlay::penalty_kick;
  out |= (penalty_kick ? intruders_at_penalty_kick : intruders_at_kick_off)(rules, state, roster, robots, playing);
  // If too many robots are in their own goal area, the superfluous robots nearest to the area's border are illegal.
  for (const Side side : both_sides) {
    const double end = -attack(side, state.half);
    RobotSet inside = those(
        playing & ~out, [&](int id) { return roster.side(id) == side && in_goal_area(field, end, robots[at(id)]); });
    while (std::popcount(inside) > rules.offences.most_in_own_goal_area) {
      const int first = with_least(inside, [&](int id) {
        return std::min(end * robots[at(id)].x - (field.length / 2.0 - field.goal_area_length),
                        field.goal_area_width / 2.0 - std::fabs(robots[at(id)].y));
      });
      inside &= ~only(first);
      out |= only(first);
    }
  }
  return out;
}

}  // namespace regista::match
