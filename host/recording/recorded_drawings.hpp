// SPDX-License-Identifier: MIT
// What the plugins of a robot drew in the field (topic /draw) and wrote for people (topic /log), read back. World
// frame, metres, seconds.
//
// Only changes are recorded: a drawing may be minutes old, and of thousands of messages the last one about each layer
// counts. So messages are taken as text, their first keys say whose they are, and only what stands at the end is read
// whole.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::recording {

struct RobotName {
  int side = 0;    // 0 home, 1 away
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
  std::optional<RecordedColour> colour;  // none: as the picture likes
  std::optional<double> width;           // m, of lines, or the diameter of points; none: as the picture likes
  bool filled = false;                   // of a polygon
  std::string text;
};

struct RecordedDrawing {
  std::string plugin, layer;
  std::vector<RecordedShape> shapes;  // none: what was drawn here was taken away
  std::string name() const { return plugin + ": " + layer; }
};

struct RecordedLogLine {
  double time = 0.0;
  std::string plugin, level, text;  // level: debug, info, warning, error
};

// To be given the messages of /draw from the beginning of the match. Every function throws nlohmann::json::exception or
// Senseless (recorded_json.hpp) for a message that cannot be read.
class DrawingsOfRobot {
 public:
  explicit DrawingsOfRobot(const RobotName& robot) : robot_(robot) {}
  void take(std::string_view message);
  // In the order in which the layers first appeared, also those that are empty now: a layer keeps its place.
  std::vector<RecordedDrawing> drawings() const;

 private:
  RobotName robot_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // of plugin and layer
  std::vector<std::string> messages_;                                  // by place: the last one
};

// To be given the messages of /log. Keeps the last `most`; throws as DrawingsOfRobot does.
class LogOfRobot {
 public:
  LogOfRobot(const RobotName& robot, std::size_t most) : robot_(robot), most_(most) {}
  void take(std::string_view message);
  std::vector<RecordedLogLine> lines() const;

 private:
  RobotName robot_;
  std::size_t most_;
  std::deque<std::string> last_;
};

}  // namespace regista::recording
