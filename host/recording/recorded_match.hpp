// SPDX-License-Identifier: MIT
// A recording (match_recording.hpp) read back: who played, and how things stood at a moment. World frame, metres,
// seconds, radians.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/rules.hpp"
#include "mcap/reader.hpp"
#include "recording/recorded_drawings.hpp"

namespace regista::recording {

struct RecordedTerm {
  std::string name;
  double weight = 0.0;
};

struct RecordedContext {
  std::string name, plugin, parameters;
  int priority = 0;
  std::vector<RecordedTerm> terms;
};

struct RecordedTeam {
  std::string name;
  double robot_radius = 0.0;
  std::vector<std::string> roles;  // by row of the table of roles
  std::vector<RecordedContext> contexts;
};

struct RecordedPose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

// The truth, as the referee sees it. Arrays by side; robots by number - 1.
struct RecordedGame {
  double time = 0.0, clock = 0.0;
  int half = 1;
  std::string phase, set_play, kicking;
  std::array<int, 2> score{}, packets_left{};
  std::array<std::vector<int>, 2> penalised, fallen;  // numbers
  std::array<double, 2> ball{};
  std::array<std::vector<RecordedPose>, 2> robots;
  std::array<std::vector<int>, 2> roles;  // rows; -1 none, -2 not known
};

struct RecordedCovariance {
  double xx = 0.0, xy = 0.0, yy = 0.0;  // m^2
};

struct RecordedTeammate {
  int number = 0, role = -1;
  RecordedPose pose;
  RecordedCovariance covariance;
  double age = 0.0;
};

// An opponent, or the ball.
struct RecordedObject {
  double x = 0.0, y = 0.0, age = 0.0, weight = 1.0;
  RecordedCovariance covariance;
};

struct RecordedWorld {
  std::optional<RecordedObject> ball;
  std::vector<RecordedTeammate> teammates;
  std::vector<RecordedObject> opponents;
};

struct RecordedBelief {
  double time = 0.0;
  RecordedPose pose;
  RecordedWorld mine;
  std::optional<RecordedWorld> common;
};

struct RecordedTask {
  int role = 0;
  RecordedPose before;
  std::optional<RecordedPose> after;  // none: it was not kept
};

using RecordedMatrix = std::vector<std::vector<std::optional<double>>>;  // by row and column; none where forbidden

struct RecordedDecision {
  double time = 0.0;
  int context = -1;
  std::string knowledge;  // "mine", "common"
  std::vector<std::array<double, 3>> waypoints;
  std::vector<std::array<int, 2>> edges;
  std::vector<RecordedTask> tasks;
  std::vector<int> columns, rows, assigned;
  RecordedMatrix utility;
  std::vector<RecordedMatrix> terms;
  int role = -1;
};

// What is known at a time; nothing of what had not been written by then.
struct RecordedMoment {
  RecordedGame game;
  std::optional<RecordedDecision> decision;
  std::optional<RecordedBelief> belief;
  std::vector<RecordedDrawing> drawings;  // of the robot's plugins, as DrawingsOfRobot tells them
  std::vector<RecordedLogLine> log;       // likewise: the last 5 lines of the last 2 s
};

class RecordedMatch {
 public:
  // Throws mcap::Error for a file that is no recording of a match, or one of a later version of Regista. Of a file that
  // is damaged, what can be read counts.
  explicit RecordedMatch(const std::filesystem::path& file);

  const config::FieldSize& field() const { return field_; }
  double ball_radius() const { return ball_radius_; }
  const std::array<RecordedTeam, 2>& teams() const { return teams_; }
  int team_size() const { return team_size_; }
  // Of the first and the last state of the game that can be read.
  double begin() const { return begin_; }
  double end() const { return end_; }
  // Where the file was cut off or damaged, in words; empty when it is whole.
  const std::string& damage() const { return damage_; }

  // The first time at which the clock of this half shows so much; nothing when it never does.
  std::optional<double> time_of(int half, double clock) const;
  // Precondition: the robot is one of the match. Throws mcap::Error for a message that cannot be read, and when nothing
  // had been written by then.
  RecordedMoment at(double time, const std::optional<RobotName>& robot) const;

 private:
  std::filesystem::path file_;
  config::FieldSize field_;
  double ball_radius_ = 0.05, begin_ = 0.0, end_ = 0.0;
  int team_size_ = 0;
  std::array<RecordedTeam, 2> teams_;
  std::string damage_;
};

}  // namespace regista::recording
