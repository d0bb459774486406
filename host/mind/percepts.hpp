// SPDX-License-Identifier: MIT
// I of the paper: all that reaches one robot between two of its decisions: what its body measured, what its camera saw,
// what it was told, what it heard. There is no other way into a mind, so nothing of the truth can leak: a real robot or
// another simulator can fill these structs as well.
//
// Units SI and radians. Robot frame: x ahead, y to the left, origin between the feet. Field frame of the own team.
// Robots are numbered from 1.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace regista::mind {

struct Pose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

// Put down by hand, or let back in at a known spot: an absolute pose with its standard deviations.
struct PlacedPose {
  Pose pose;
  double position_deviation = 0.0, heading_deviation = 0.0;
};

// Standard deviations are along and across the line of sight; robot frame.
struct BallSighting {
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
};

struct RobotSighting {
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
  bool own_team = false;  // by the colour of the jersey; the number is not seen
};

struct LandmarkSighting {
  int kind = 0;  // REGISTA_LANDMARK_*; which one of that kind is not seen
  Eigen::Vector2d position;
  double along = 0.0, across = 0.0;
};

// What the camera could have seen in this frame; heading relative to the body.
struct View {
  double heading = 0.0, half_angle = 0.0;
  double ball_range = 0.0, robot_range = 0.0;
};

enum class Phase { initial, ready, set, playing, finished };
enum class SetPlay { none, kick_off, kick_in, goal_kick, corner_kick, pushing_free_kick, penalty_kick };

// The game as the game controller told it (late) and the robot pieced it together (a whistle is early).
struct GameTold {
  Phase phase = Phase::initial;
  SetPlay set_play = SetPlay::none;
  bool own_kick = false;  // the set play, or the last kick-off, is the own team's
  int half = 1;
  int own_score = 0, opponent_score = 0;
  double phase_time = 0.0;  // s since phase or set play began
  double half_time_left = 0.0, match_time_left = 0.0;
  int packets_left = 0;             // of the own team
  std::uint32_t own_penalised = 0;  // bit n - 1: robot n is penalised
  std::uint32_t opponent_penalised = 0;
};

// The whole of a robot's input at one decision. The vectors are reused by whoever fills them.
struct Percepts {
  double time = 0.0;                 // s since the start of the match
  Pose odometry;                     // motion since the last decision, in the robot frame at its beginning
  std::optional<PlacedPose> placed;  // only when it has just been put down
  bool camera = true;                // false: no image this time (lying, penalised); the three below are empty
  View view;
  std::vector<BallSighting> balls;  // false ones included
  std::vector<RobotSighting> robots;
  std::vector<LandmarkSighting> landmarks;
  std::optional<double> contact;  // bearing of a robot that it feels against its arms or feet, rad
  bool whistle = false;           // heard since the last decision
  bool fallen = false;
  double time_until_up = 0.0;  // s; 0 when it stands
  bool kicking = false;        // a kick is under way: commands to walk or kick are ignored
  bool penalised = false;      // the robot itself, which is told at once
  GameTold game;
};

// A packet of a teammate as it came out of the air. The bytes belong to the radio and live through the decision.
struct HeardPacket {
  double time_heard = 0.0;
  std::span<const std::uint8_t> bytes;
};

}  // namespace regista::mind
