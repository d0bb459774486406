// SPDX-License-Identifier: MIT
// Offering a passing lane: a supporter leaves its place a little for one at which no opponent can get in the way of a
// pass to it. That receivers move out of the cover of opponents is common practice in all leagues of robot soccer; the
// model is ours: opponents walk towards the line of the pass as soon as they have seen it, and the room that is left
// between the nearest of them and the ball is how open the lane is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "legal_place.hpp"
#include "situation.hpp"

namespace behaviours {

// --- Room between the players of a team: a supporter stays clear of the ball, where a teammate plays it, and
// apart from the targets of more important tasks. Targets are given as places about the ball and collapse where the
// ball is near a line or a corner; then robots stand in each other's way. All robots of a team move the same targets
// alike, as far as they believe the same.

struct SpreadSettings {
  double clear_of_ball = 0.0;  // m: nobody stands nearer to the ball without playing it
  double apart = 0.0;          // m: least distance between two targets
  double moved_at_most = 1.2;  // m: a target is moved no farther, so that it keeps its sense
};

// The target, moved as little as needed. more_important: the targets of tasks that come first in the list of tasks.
inline Vector2d spread(const Situation& situation, const SpreadSettings& settings, const Vector2d& target,
                       std::span<const Vector2d> more_important) {
  if (settings.clear_of_ball <= 0.0 && settings.apart <= 0.0) return target;
  const Field& field = situation.facts.field;
  const Vector2d corner(field.length / 2.0, field.width / 2.0);
  Vector2d place = target;
  // Leaving one target may lead to another: a second round mends most of it.
  for (int round = 0; round < 2; ++round) {
    for (const Vector2d& other : more_important) place = detail::outside_circle(place, other, settings.apart);
    if (situation.ball_trusted) place = detail::outside_circle(place, situation.ball, settings.clear_of_ball);
    place = place.cwiseMin(corner).cwiseMax(-corner);
  }
  const Vector2d moved = place - target;
  const double distance = moved.norm();
  return distance <= settings.moved_at_most ? place : Vector2d(target + moved * (settings.moved_at_most / distance));
}

struct LaneSettings {
  double leaves = 0.0;      // m that it leaves its place for a lane at most; 0: it stays
  double clear = 0.4;       // m of room: a lane is open, and more does not count
  double cost = 0.25;       // m of room that each metre away from its place has to gain
  double constancy = 0.1;   // m of room that another place has to gain over the last one
  double pass_speed = 1.2;  // m/s, mean of a rolling pass
  double reaction = 0.8;    // s in which an opponent does not move yet
};

// What opponents leave open of the line from the ball to `place`, m; no more than `clear`. Negative: somebody is in the
// way.
inline double room_of_lane(const Situation& situation, const LaneSettings& settings, std::span<const Blocker> opponents,
                           const Vector2d& place) {
  const Facts& facts = situation.facts;
  constexpr double unlikely = 1.0;  // m farther away is an opponent that is surely not there
  double room = settings.clear;
  for (const Blocker& opponent : opponents) {
    const Vector2d nearest = nearest_on_segment(situation.ball, place, opponent.position);
    const double time = (nearest - situation.ball).norm() / settings.pass_speed;
    const double reach =
        facts.robot_radius + facts.ball_radius + facts.walk_forward * std::max(0.0, time - settings.reaction);
    room = std::min(room, (opponent.position - nearest).norm() - reach + unlikely * (1.0 - opponent.weight));
  }
  return room;
}

// Keeps the last offer, so that the robot does not turn to and fro between two that are as good.
class Lane {
 public:
  void forget() { last_ = 0; }

  // The place to stand at instead of `place`. Whoever is not ahead of the ball, too near or out of a kick's reach has
  // none to offer. It comes no nearer to `others` than spread() lets it.
  Vector2d offer(const Situation& situation, const LaneSettings& settings, const SpreadSettings& spread,
                 std::span<const Blocker> opponents, std::span<const Vector2d> others, const Vector2d& place) {
    constexpr double shortest = 1.0, longest = 5.0, behind = 0.5;  // m
    const double distance = (place - situation.ball).norm();
    const bool offers = settings.leaves > 0.0 && situation.ball_trusted && !ball_is_theirs(situation) &&
                        distance >= shortest && distance <= longest && place.x() >= situation.ball.x() - behind;
    if (!offers) {
      forget();
      return place;
    }
    const double least = std::min(spread.apart, distance_to(others, place));
    Vector2d best_place = place;
    std::size_t best = 0;
    double best_value = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= directions * rings; ++i) {
      const Vector2d there = place + settings.leaves * offset(i);
      const bool allowed = i == 0 || (within(situation.facts.field, there) &&
                                      (there - situation.ball).norm() >= std::max(shortest, spread.clear_of_ball) &&
                                      distance_to(others, there) >= least);
      if (!allowed) continue;
      const double value = room_of_lane(situation, settings, opponents, there) -
                           settings.cost * (there - place).norm() + (i == last_ ? settings.constancy : 0.0);
      if (value <= best_value) continue;
      best_value = value;
      best = i;
      best_place = there;
    }
    last_ = best;
    return best_place;
  }

 private:
  static constexpr std::size_t directions = 8, rings = 2;

  // 0: none; then the eight directions of an inner circle, then those of the unit circle.
  static Vector2d offset(std::size_t i) {
    constexpr double diagonal = std::numbers::sqrt2 / 2.0;
    constexpr double circle[directions][2] = {{1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
                                              {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
    if (i == 0) return {0.0, 0.0};
    const auto& direction = circle[(i - 1) % directions];
    const double radius = i <= directions ? 0.5 : 1.0;
    return {radius * direction[0], radius * direction[1]};
  }

  static double distance_to(std::span<const Vector2d> others, const Vector2d& place) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector2d& other : others) least = std::min(least, (other - place).norm());
    return least;
  }

  static bool within(const Field& field, const Vector2d& place) {
    return std::abs(place.x()) <= field.length / 2.0 && std::abs(place.y()) <= field.width / 2.0;
  }

  std::size_t last_ = 0;  // offset
};

}  // namespace behaviours
