// SPDX-License-Identifier: MIT
#include "match/set_positions.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "match/areas.hpp"

namespace regista::match {
namespace {

template <class Condition>
RobotSet those(RobotSet among, Condition condition) {
  RobotSet out = 0;
  for (RobotSet rest = among; rest != 0; rest &= rest - 1) {
    const int id = std::countr_zero(rest);
    if (condition(id)) out |= only(id);
  }
  return out;
}

// The robot of the set with the least value; -1: the set is empty. Of equals the first.
template <class Value>
int least(RobotSet among, Value value) {
  int best = -1;
  double lowest = std::numeric_limits<double>::infinity();
  for (RobotSet rest = among; rest != 0; rest &= rest - 1) {
    const int id = std::countr_zero(rest);
    if (value(id) < lowest) {
      lowest = value(id);
      best = id;
    }
  }
  return best;
}

}  // namespace

RobotSet intruders_at_kick_off(const config::Rules& rules, const GameState& state, Roster roster,
                               std::span<const Vector> robots, RobotSet playing) {
  const config::FieldSize& field = rules.field;
  const auto at = [&](int id) { return robots[static_cast<std::size_t>(id)]; };
  const auto in_own_half = [&](int id) { return at(id).x * attack(roster.side(id), state.half) <= 0.0; };
  const RobotSet kicking = those(playing, [&](int id) { return roster.side(id) == state.kicking; });
  const RobotSet beyond = those(playing, [&](int id) { return !in_own_half(id); });
  const RobotSet may = those(beyond & kicking, [&](int id) { return in_centre_circle(field, at(id)); });
  const int taker = least(may, [&](int id) { return squared_length(at(id) - state.spot); });
  const RobotSet in_circle = those(playing & ~kicking, [&](int id) { return in_centre_circle(field, at(id)); });
  return (taker >= 0 ? beyond & ~only(taker) : beyond) | in_circle;
}

RobotSet intruders_at_penalty_kick(const config::Rules& rules, const GameState& state, Roster roster,
                                   std::span<const Vector> robots, RobotSet playing) {
  const auto at = [&](int id) { return robots[static_cast<std::size_t>(id)]; };
  const double end = attack(state.kicking, state.half);
  RobotSet inside = those(playing, [&](int id) { return in_penalty_area(rules.field, end, at(id)); });
  inside &= ~only(roster.id(opposite(state.kicking), 1));
  const RobotSet attackers = those(inside, [&](int id) { return roster.side(id) == state.kicking; });
  const int taker = least(attackers, [&](int id) { return squared_length(at(id) - state.spot); });
  return taker >= 0 ? inside & ~only(taker) : inside;
}

RobotSet illegal_in_set(const config::Rules& rules, const GameState& state, Roster roster,
                        std::span<const Vector> robots, RobotSet playing, double robot_radius) {
  const config::FieldSize& field = rules.field;
  const auto at = [&](int id) { return robots[static_cast<std::size_t>(id)]; };
  const double on_ball = robot_radius + rules.ball.diameter / 2.0;
  RobotSet out = those(playing, [&](int id) {
    return on_border_strip(field, at(id), robot_radius) || squared_length(at(id) - state.spot) < on_ball * on_ball;
  });
  if (state.set_play == mind::SetPlay::penalty_kick) {
    out |= intruders_at_penalty_kick(rules, state, roster, robots, playing);
  } else {
    out |= intruders_at_kick_off(rules, state, roster, robots, playing);
  }
  // Too many in the own goal area: those nearest to its border.
  for (const Side side : both_sides) {
    const double end = -attack(side, state.half);
    RobotSet inside =
        those(playing & ~out, [&](int id) { return roster.side(id) == side && in_goal_area(field, end, at(id)); });
    while (std::popcount(inside) > rules.offences.most_in_own_goal_area) {
      const int first = least(inside, [&](int id) {
        return std::min(end * at(id).x - (field.length / 2.0 - field.goal_area_length),
                        field.goal_area_width / 2.0 - std::fabs(at(id).y));
      });
      inside &= ~only(first);
      out |= only(first);
    }
  }
  return out;
}

}  // namespace regista::match
