// SPDX-License-Identifier: MIT
// Percepts and HeardPacket are the input I of the paper: all information that reaches one robot between two of its
// decisions: measurements of the body, sightings of the camera, messages of the game controller, and packets. A mind
// gets no other input, so it cannot know true positions. A real robot or another simulator can fill these structs.
//
// SI units, radians. Robot frame: x ahead, y left, origin between the feet. Field frame: of the robot's own team.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/rules.hpp"

namespace regista::mind {

struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

// An absolute pose (field frame) with standard deviations, given after a person has put the robot down.
struct PlacedPose {
  Pose pose;
  double position_deviation = 0.0, heading_deviation = 0.0;
};

// Sightings are in the robot frame. along, across: standard deviations along and across the line of sight, m.
struct BallSighting {
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
};

struct RobotSighting {
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
  bool own_team = false;  // recognised by the colour of the jersey; the camera cannot read the number
};

struct LandmarkSighting {
  int kind = 0;  // REGISTA_LANDMARK_*; the camera cannot distinguish landmarks of one kind
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
};

// The sector of this image and the ranges of the camera. heading: axis of the sector, relative to the body.
struct View {
  double heading = 0.0, half_angle = 0.0;
  double ball_range = 0.0, robot_range = 0.0;
};

enum class Phase { initial, ready, set, playing, finished };
enum class SetPlay { none, kick_off, kick_in, goal_kick, corner_kick, pushing_free_kick, penalty_kick };

// What the robot knows of the game. The game controller's messages may be late. A whistle reveals a change earlier.
struct GameTold {
  Phase phase = Phase::initial;
  SetPlay set_play = SetPlay::none;
  bool own_kick = false;  // the robot's team takes the current set play; without a set play: took the last set play
  int half = 1;
  int own_score = 0, opponent_score = 0;
  double phase_time = 0.0;                             // time since the phase or set play began, s
  double half_time_left = 0.0, match_time_left = 0.0;  // s
  int packets_left = 0;                                // number of packets that the robot's team may still send
  std::uint32_t own_penalised = 0;                     // bit n - 1: robot n is penalised
  std::uint32_t opponent_penalised = 0;
};

// All input of a robot at one decision, except packets. The caller reuses the vectors at the next decision.
struct Percepts {
  double time = 0.0;                 // match time, s
  Pose odometry;                     // motion since the last decision, in the robot frame of the last decision
  std::optional<PlacedPose> placed;  // set if the robot was put down since the last decision
  bool camera = true;                // false: no image and no sightings (robot lies or is penalised)
  View view;
  std::vector<BallSighting> balls;  // may contain false sightings
  std::vector<RobotSighting> robots;
  std::vector<LandmarkSighting> landmarks;
  std::optional<double> contact;  // bearing of a robot that touches this robot, rad; empty: none
  bool whistle = false;           // the robot heard a whistle since its last decision
  bool fallen = false;
  double time_until_up = 0.0;  // s; 0 if the robot stands
  bool kicking = false;        // the robot kicks; the body ignores commands to walk or kick
  bool penalised = false;      // this robot is penalised; a robot learns of its own penalty without delay
  GameTold game;
};

// A received packet of a teammate. The radio owns the bytes, which are valid during the decision.
struct HeardPacket {
  double time_heard = 0.0;
  std::span<const std::uint8_t> bytes;
};

// Returns the time (s) in which the team may still send packets in this match, as far as the robot knows: the rest of
// the clock time, and Ready and Set before each half, when the clock does not run. The value decreases by one second
// each second, except in Initial. The value does not jump if the game controller's messages are on time.
inline double sending_time_left(const config::Durations& durations, const GameTold& game) {
  double until_kick_off = 0.0;  // s until the kick-off that begins this half
  // While the clock runs, Ready and Set after a goal are part of the clock time.
  if (!(game.half_time_left < durations.half)) {
    if (game.phase == Phase::initial) until_kick_off = durations.ready + durations.set;
    if (game.phase == Phase::ready) until_kick_off = std::max(0.0, durations.ready - game.phase_time) + durations.set;
    if (game.phase == Phase::set) until_kick_off = std::max(0.0, durations.set - game.phase_time);
  }
  const double later_halves = (durations.halves - game.half) * (durations.ready + durations.set);
  return game.match_time_left + later_halves + until_kick_off;
}

}  // namespace regista::mind
