// SPDX-License-Identifier: MIT
// Minds for tests: they use percepts alone. A chaser counts its steps from where it was put down, runs to the ball when
// it sees it and kicks it towards the opponent's goal; the rest of its team waits at places of its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "match/match.hpp"
#include "match/plane.hpp"

namespace regista::match::scripted {

inline std::vector<config::Kick> three_kicks() {
  return {{"fast", 1.6, 4.5, 1.6, 0.65, 0.07, 0.122},
          {"long", 5.4, 5.4, 1.65, 0.65, 0.07, 0.122},
          {"in_walk", 0.4, 1.0, 0.5, 0.25, 0.07, 0.122}};
}

inline Setup setup(std::uint64_t seed = 1, int team_size = 7) {
  Setup out;
  out.seed = seed;
  out.rules.team_size = team_size;
  for (auto& robot : out.robots) robot.kicks = three_kicks();
  return out;
}

// Where a robot waits in its own half, field frame.
inline Vector post_of(int number, int team_size) {
  if (number == 1) return {-4.2, 0.0};
  const double across = team_size > 2 ? 4.8 * (number - 2) / (team_size - 2) - 2.0 : 0.5;
  return {number % 2 == 0 ? -1.0 : -2.5, across};
}

inline mind::Walk walk_to(Vector relative, double turn) {
  const double distance = length(relative);
  const double scale = distance > 0.25 ? 0.25 / distance : 1.0;
  return {scale * relative.x, scale * relative.y, turn};
}

struct Chaser {
  int number, team_size;
  int send_every = 0;      // decisions between packets, 0 = silent
  bool chase_all = false;  // everybody chases, not only the two at the front
  int packet_size = 40;

  mind::Pose pose;
  Vector ball;  // robot frame
  double ball_age = 1e9;
  int decisions = 0, heard = 0;

  void operator()(const mind::Percepts& percepts, std::span<const mind::HeardPacket> packets, mind::Outcome& out) {
    ++decisions;
    heard += static_cast<int>(packets.size());
    move(percepts);
    const double swing = std::sin(0.3 * decisions);
    out.command.head_yaw = ball_age < 0.5 ? std::atan2(ball.y, ball.x) : 1.2 * swing;
    out.role = -1;
    if (send_every > 0 && decisions % send_every == 0) {
      out.send = true;
      out.packet.assign(static_cast<std::size_t>(packet_size), static_cast<std::uint8_t>(number));
    }
    const mind::Phase phase = percepts.game.phase;
    if (phase == mind::Phase::ready) {
      Vector post = post_of(number, team_size);
      if (number == 2 && percepts.game.own_kick) post = {-0.4, 0.0};
      go(post, out);
    } else if (phase == mind::Phase::playing) {
      play(percepts, out);
    }
  }

 private:
  void move(const mind::Percepts& percepts) {
    const mind::Pose& step = percepts.odometry;
    const Vector moved = turned({step.x, step.y}, std::cos(pose.heading), std::sin(pose.heading));
    pose = {pose.x + moved.x, pose.y + moved.y, mind::wrap(pose.heading + step.heading)};
    if (percepts.placed) pose = percepts.placed->pose;
    ball = turned(ball - Vector{step.x, step.y}, std::cos(step.heading), -std::sin(step.heading));
    ball_age += 0.1;
    if (!percepts.balls.empty()) {
      ball = {percepts.balls[0].position.x(), percepts.balls[0].position.y()};
      ball_age = 0.0;
    }
  }

  Vector relative(Vector field) const {
    return turned(field - Vector{pose.x, pose.y}, std::cos(pose.heading), -std::sin(pose.heading));
  }

  void go(Vector target, mind::Outcome& out) const {
    const Vector way = relative(target);
    if (length(way) < 0.1) return;
    out.command.walk = walk_to(way, std::clamp(2.0 * std::atan2(way.y, way.x), -1.0, 1.0));
  }

  void play(const mind::Percepts& percepts, mind::Outcome& out) const {
    const bool theirs = percepts.game.set_play != mind::SetPlay::none && !percepts.game.own_kick;
    const bool chases = chase_all || number == 2 || number == 3 || team_size <= 3;
    if (theirs || !chases) {
      if (!theirs) go(post_of(number, team_size), out);
      return;
    }
    if (ball_age > 3.0) {
      out.command.walk.turn = 1.0;
      return;
    }
    const Vector goal = relative({4.5, 0.0});
    const double to_goal = std::atan2(goal.y, goal.x);
    if (length(ball) < 0.215 && ball.x > 0.0) {
      out.command.kick = mind::KickRequest{length(goal) < 3.0 ? 0 : 1, to_goal, length(goal) + 1.0};
    }
    // Stand behind the ball as seen from the goal.
    const Vector behind = ball - Vector{0.2 * std::cos(to_goal), 0.2 * std::sin(to_goal)};
    const bool in_front = dot(ball, goal) < 0.0 && length(ball) < 0.5;
    const Vector aside = in_front ? Vector{-0.4 * std::sin(to_goal), 0.4 * std::cos(to_goal)} : Vector{};
    out.command.walk = walk_to(behind + aside, std::clamp(2.0 * to_goal, -1.0, 1.0));
  }
};

inline std::vector<mind::Think> chasers(int team_size, int send_every = 0, bool chase_all = false) {
  std::vector<mind::Think> minds;
  for (int number = 1; number <= team_size; ++number) {
    Chaser chaser{};
    chaser.number = number;
    chaser.team_size = team_size;
    chaser.send_every = send_every;
    chaser.chase_all = chase_all;
    chaser.ball_age = 1e9;
    minds.emplace_back(chaser);
  }
  return minds;
}

// Nobody moves.
inline std::vector<mind::Think> statues(int team_size) {
  return std::vector<mind::Think>(static_cast<std::size_t>(team_size),
                                  [](const mind::Percepts&, std::span<const mind::HeardPacket>, mind::Outcome&) {});
}

}  // namespace regista::match::scripted
