// SPDX-License-Identifier: MIT
// Reads a recording (match_recording.hpp): the teams, the state at a given moment, and what a robot's plugins had drawn
// (topic /draw) and logged (topic /log) before this moment. World frame, metres, seconds, radians.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/rules.hpp"
#include "mind/percepts.hpp"

namespace regista::recording {

struct RobotName {
  int side = 0;    // 0: home, 1: away
  int number = 1;  // from 1
};

struct RecordedColour {
  std::uint8_t red = 0, green = 0, blue = 0, opacity = 255;
  friend bool operator==(const RecordedColour&, const RecordedColour&) = default;
};

struct RecordedShape {
  enum class Kind : std::uint8_t { points, line, polygon, text };
  Kind kind = Kind::points;
  std::vector<std::array<double, 2>> at;
  std::optional<RecordedColour> colour;  // missing: the picture chooses a colour
  std::optional<double> width;           // m; width of a line or diameter of points; missing: the picture chooses
  bool filled = false;                   // for a polygon
  std::string text;
};

struct RecordedDrawing {
  std::string plugin, layer;
  std::vector<RecordedShape> shapes;  // empty: the drawing was removed
  std::string name() const { return plugin + ": " + layer; }
};

struct RecordedLogLine {
  double time = 0.0;
  std::string plugin, level, text;  // level: debug, info, warning, error
};

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
  std::string name;  // for people: the team's title
  double robot_radius = 0.0;
  std::vector<std::string> roles;  // index: row of the table of roles
  std::vector<RecordedContext> contexts;
};

// The true state of the game. Arrays are by side. Robot n has index n - 1.
struct RecordedGame {
  double time = 0.0, clock = 0.0;
  int half = 1;
  std::string phase, set_play, kicking;
  std::array<int, 2> score{}, packets_left{};
  std::array<std::vector<int>, 2> penalised, fallen;  // numbers of robots
  std::array<double, 2> ball{};
  std::array<std::vector<mind::Pose>, 2> robots;
  std::array<std::vector<int>, 2> roles;  // row of the table of roles for each robot; -1: no role, -2: not known
};

struct RecordedCovariance {
  double xx = 0.0, xy = 0.0, yy = 0.0;  // m^2
};

struct RecordedTeammate {
  int number = 0, role = -1;
  mind::Pose pose;
  RecordedCovariance covariance;
  double age = 0.0;
};

// A believed opponent or ball.
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
  mind::Pose pose;
  RecordedWorld mine;
  std::optional<RecordedWorld> common;
};

struct RecordedTask {
  int role = 0;
  mind::Pose before;
  std::optional<mind::Pose> after;  // missing: the task was not kept
};

using RecordedMatrix = std::vector<std::vector<std::optional<double>>>;  // by row and column; missing: forbidden pair

struct RecordedDecision {
  double time = 0.0;
  int context = -1;
  std::string knowledge;  // knowledge behind the utilities: "mine" or "common"
  std::vector<std::array<double, 3>> waypoints;
  std::vector<std::array<int, 2>> edges;
  std::vector<RecordedTask> tasks;
  std::vector<int> columns, rows, assigned;
  RecordedMatrix utility;
  std::vector<RecordedMatrix> terms;
  int role = -1;
};

// The state of a recording at one time: for each topic the last message before or at this time.
struct RecordedMoment {
  RecordedGame game;
  std::optional<RecordedDecision> decision;
  std::optional<RecordedBelief> belief;
  // Drawings of the robot's plugins, in the order in which their layers first appeared. Empty layers keep their index.
  std::vector<RecordedDrawing> drawings;
  std::vector<RecordedLogLine> log;  // log lines of the robot's plugins: at most 5, from the last 2 s
};

class RecordedMatch {
 public:
  // Reads damaged files as far as possible. Throws mcap::Error for another kind of file or another format version.
  explicit RecordedMatch(const std::filesystem::path& file);

  const config::FieldSize& field() const { return field_; }
  double ball_radius() const { return ball_radius_; }
  const std::array<RecordedTeam, 2>& teams() const { return teams_; }
  int team_size() const { return team_size_; }
  // Times of the first and the last readable state of the game.
  double begin() const { return begin_; }
  double end() const { return end_; }
  // Describes where the file is cut off or damaged; empty for an undamaged file.
  const std::string& damage() const { return damage_; }
  // Returns whether the viewer's page can read the file: messages are in the order of time, log times count from the
  // beginning of the match, and no chunk uses LZ4. A file that another program has rewritten may not fit.
  bool fits_page() const { return fits_page_; }
  // Writes a copy that fits; of a cut-off file, a cut-off copy. Throws mcap::Error; also if a chunk is damaged.
  void write_for_page(const std::filesystem::path& to) const;

  // Returns the first time at which the clock of this half shows `clock` seconds or more; nothing if it never does.
  std::optional<double> time_of(int half, double clock) const;
  // Precondition: the match has the robot. Throws mcap::Error for unreadable messages, and before the first /game.
  RecordedMoment at(double time, const std::optional<RobotName>& robot) const;

 private:
  std::uint64_t log_time(double time) const;

  std::filesystem::path file_;
  config::FieldSize field_;
  double ball_radius_ = 0.05, begin_ = 0.0, end_ = 0.0;
  std::uint64_t log_begin_ = 0;  // log time of the first state of the game
  int team_size_ = 0;
  bool in_order_ = true, fits_page_ = true;
  std::array<RecordedTeam, 2> teams_;
  std::string damage_;
};

}  // namespace regista::recording
