// SPDX-License-Identifier: MIT
// A game without physics: a test moves robots and ball by hand, the referee judges. Home attacks towards +x in the
// first half.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "match/physics_world.hpp"
#include "match/referee.hpp"

namespace regista::match {

using mind::Phase;
using mind::SetPlay;

struct Game : testing::Test {
  config::Rules rules;
  Referee referee{rules, 0.15};
  std::vector<Vector> robots = std::vector<Vector>(14);
  Vector ball;
  double time = 0.0;
  std::vector<Event> events;
  // Of every scene from now on:
  std::vector<Vector> legs = std::vector<Vector>(14);
  RobotSet turning = 0, fallen = 0, asleep = 0, at_walls = 0, touching = 0, kicking = 0;
  std::vector<std::array<std::int8_t, 2>> contacts;

  Game() { referee_step(-1, false); }
  void restart() {
    referee = Referee(rules, 0.15);
    robots.assign(static_cast<std::size_t>(2 * rules.team_size), {});
    legs.assign(robots.size(), {});
    time = 0.0;
    events.clear();
    referee_step(-1, false);
  }

  const GameState& state() const { return referee.state(); }
  const Calls& referee_step(int touched_by, bool kicked) {
    const Calls& calls = referee.update({.time = time,
                                         .ball = ball,
                                         .touched_by = touched_by,
                                         .kicked = kicked,
                                         .robots = robots,
                                         .steps = legs,
                                         .turning = turning,
                                         .touching = touching,
                                         .fallen = fallen,
                                         .kicking = kicking,
                                         .acted = ~asleep,
                                         .at_walls = at_walls,
                                         .contacts = contacts});
    for (const int id : calls.removed) robots[static_cast<std::size_t>(id)] = {-4.0, 5.0};
    for (const Placement& placement : calls.placements) {
      robots[static_cast<std::size_t>(placement.robot)] = {placement.pose.x, placement.pose.y};
    }
    if (calls.ball) ball = *calls.ball;
    events.insert(events.end(), calls.events.begin(), calls.events.end());
    return calls;
  }
  const Calls& step(int touched_by = -1) {
    time += physics_step;
    return referee_step(touched_by, false);
  }
  const Calls& kick(Side side, int number) {
    time += physics_step;
    return referee_step(id(side, number), true);
  }
  void wait(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / physics_step));
    for (int i = 0; i < steps; ++i) step();
  }
  void until(Phase phase) {
    for (int i = 0; i < 5000 && state().phase != phase; ++i) step();
    ASSERT_EQ(state().phase, phase);
  }
  int id(Side side, int number) const { return Roster{rules.team_size}.id(side, number); }
  Vector& robot(Side side, int number) { return robots[static_cast<std::size_t>(id(side, number))]; }
  Vector& legs_of(Side side, int number) { return legs[static_cast<std::size_t>(id(side, number))]; }
  void in_contact(Side side, int number, Side other_side, int other) {
    contacts = {{static_cast<std::int8_t>(id(side, number)), static_cast<std::int8_t>(id(other_side, other))}};
  }
  // The kick-off is taken, and a second robot has kicked the ball: everything is open.
  void play() {
    until(Phase::playing);
    const Side first = state().kicking;
    kick(first, 2);
    kick(first, 3);
    ASSERT_TRUE(state().in_play());
  }
  bool happened(EventKind kind) const { return std::ranges::find(events, kind, &Event::kind) != events.end(); }
  // The last penalty of this robot, or none.
  Offence penalty(Side side, int number) const {
    Offence last = Offence::none;
    for (const Event& event : events) {
      if (event.kind == EventKind::penalty && event.side == side && event.number == number) last = event.offence;
    }
    return last;
  }
};

}  // namespace regista::match
