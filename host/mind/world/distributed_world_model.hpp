// SPDX-License-Identifier: MIT
// One consistent picture of the game (DWM of the paper), in the form in which plugins see it, with the memory behind
// it.
#pragma once

#include <cstdint>
#include <vector>

#include "mind/geometry.hpp"
#include "regista/abi.h"

namespace regista::mind {

class DistributedWorldModel {
 public:
  explicit DistributedWorldModel(int team_size) : robots(static_cast<std::size_t>(team_size)) {
    for (int number = 1; number <= team_size; ++number) {
      robot(number).number = number;
      robot(number).role = -1;
    }
    active.reserve(robots.size());
    game.size = sizeof game;
    ball_state.size = sizeof ball_state;
    raw.size = sizeof raw;
    raw.game = &game;
    raw.ball = &ball_state;
  }
  // `raw` points into the other members.
  DistributedWorldModel(const DistributedWorldModel&) = delete;
  DistributedWorldModel& operator=(const DistributedWorldModel&) = delete;

  regista_robot& robot(int number) { return robots[static_cast<std::size_t>(number - 1)]; }
  const regista_robot& robot(int number) const { return robots[static_cast<std::size_t>(number - 1)]; }
  bool is_active(int number) const { return (robot(number).flags & REGISTA_ROBOT_ACTIVE) != 0; }
  bool ball_known() const { return (ball_state.flags & REGISTA_BALL_KNOWN) != 0; }
  Vector2d ball() const { return {ball_state.position[0], ball_state.position[1]}; }
  Vector2d ball_velocity() const { return {ball_state.velocity[0], ball_state.velocity[1]}; }

  // To be called when robots and opponents are complete: lists the active robots, points `raw` at everything.
  void close() {
    active.clear();
    for (const regista_robot& each : robots) {
      if ((each.flags & REGISTA_ROBOT_ACTIVE) != 0) active.push_back(each.number);
    }
    game.size = sizeof game;
    ball_state.size = sizeof ball_state;
    raw.robots = span(robots);
    raw.opponents = span(opponents);
    raw.active = span(active);
  }

  regista_world raw{};
  regista_game game{};
  regista_ball ball_state{};
  std::vector<regista_robot> robots;
  std::vector<regista_opponent> opponents;
  std::vector<std::int32_t> active;

 private:
  template <class T>
  static regista_span span(const std::vector<T>& elements) {
    return {elements.data(), static_cast<std::uint32_t>(elements.size()), sizeof(T)};
  }
};

}  // namespace regista::mind
