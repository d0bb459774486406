// SPDX-License-Identifier: MIT
// A robot without the ball. Being where the team wants it: walks to the place of its task, legally, in the open where
// it offers a lane for a pass, and receives a ball that comes along.
#pragma once

#include <cmath>

#include "approach.hpp"
#include "edge_path.hpp"
#include "lane.hpp"
#include "legal_place.hpp"
#include "movement.hpp"
#include "situation.hpp"

namespace behaviours {

struct SupportSettings {
  double reception_reach = 1.0;  // m that it leaves its place for a ball that comes along
  EdgePathSettings path;
  SpreadSettings spread;
  LaneSettings lane;
};

// What supporting keeps from one decision to the next.
struct SupportMemory {
  EdgePath path;
  Lane lane;
};

// opponents: read only where the robot leaves its place for a lane.
inline Movement support(const Situation& situation, const SupportSettings& settings, const RollingSettings& rolling,
                        const LegalPlaceSettings& legal, std::span<const Blocker> opponents, SupportMemory& memory) {
  if (!ball_is_theirs(situation)) {
    if (const auto point = interception(situation, rolling, settings.reception_reach)) {
      return intercept(situation, *point);
    }
  }
  Pose wanted = situation.target;
  const Vector2d apart = spread(situation, settings.spread, {wanted.x, wanted.y}, situation.more_important);
  const Vector2d open =
      memory.lane.offer(situation, settings.lane, settings.spread, opponents, situation.more_important, apart);
  wanted.x = open.x();
  wanted.y = open.y();
  Pose target = legal_place(situation, legal, wanted);
  if (situation.along_edges) {
    const Vector2d next =
        memory.path.next(situation.graph, settings.path, situation.frame.origin(), {target.x, target.y});
    target = {next.x(), next.y(), target.heading};
  }
  return WalkTo{.target = target};
}

// --- Looking for the ball: walks to the place of the task and turns about there; without a task, where it stands.

struct SearchSettings {
  double at_target = 0.5;            // m
  double turn_rate = 0.6;            // rad/s: slow enough for the camera
  double search_turn_seconds = 0.0;  // s in which a search begins with a look about where the robot stands
};

inline Movement search(const Situation& situation, const SearchSettings& settings, const LegalPlaceSettings& legal) {
  const Pose target = legal_place(situation, legal, situation.target);
  const double distance = std::hypot(target.x - situation.pose.x, target.y - situation.pose.y);
  if (situation.has_task && distance > settings.at_target) return WalkTo{.target = target};
  // Neighbours turn in opposite directions, so that together they see more.
  return Turn{situation.facts.own_number % 2 == 0 ? settings.turn_rate : -settings.turn_rate};
}

}  // namespace behaviours
