// SPDX-License-Identifier: MIT
// A picture of one moment of a recorded match. It shows the true state of the field and, for one robot, its believed
// world, waypoints, tasks and utility estimation matrix, and the drawings and log lines of its plugins. The picture is
// for papers and slides: light, with selectable text and colours for colour-blind readers (Okabe and Ito 2008).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "recording/field_svg.hpp"
#include "recording/recorded_match.hpp"
#include "texts/message.hpp"

namespace regista::recording::moment {

// --- Functions that several parts of the picture use.

using texts::visible;
using texts::visible_at_most;
using namespace picture;

// Returns a time in the format of the viewer: "7:42.3".
inline std::string time_text(double seconds) {
  const auto tenths = std::llround(10.0 * std::clamp(seconds, 0.0, 1e6));
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

inline std::string role_name(const RecordedTeam& team, int row) {
  if (row == -1) return "no role";
  if (row == -2) return "not known yet";
  const auto index = static_cast<std::size_t>(row);
  return row >= 0 && index < team.roles.size() ? team.roles[index] : fmt::format("role {}", row);
}

struct Panel {
  Html drawing;
  double bottom = 0.0;
};

// Draws the plugin drawings of the robot, clipped to the element #field. A layer keeps its colour when other layers
// appear or disappear. Style classes: layer, said (texts), light-said (light texts).
Html layers(const std::vector<RecordedDrawing>& drawings, const Scale& to);
// Draws the legend for layers(). `top`: baseline of the first entry. Style class: swatch.
Panel names_of_layers(const std::vector<RecordedDrawing>& drawings, double left, double top);

// Draws the panel beside the field: the reasons of the robot's decision, and log lines of its plugins.
inline constexpr double panel_width = 430.0;
Panel panel(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left, double top);

}  // namespace regista::recording::moment

namespace regista::recording {

// Returns SVG 1.1 in UTF-8. Precondition: match.at() returned `moment` for `robot`.
std::string moment_svg(const RecordedMatch& match, const RecordedMoment& moment, const std::optional<RobotName>& robot);

// --- Moments, robots and layers as users type them. Moments: 7:42, 462.3, 2/3:10. Robots: 3, away/5. Layers: cells,
// "voronoi: cells". The functions throw BadInput; its text begins with the option.

struct Moment {
  std::string typed;
  int half = 0;          // 0: no half was typed
  double seconds = 0.0;  // since the match began; if a half was typed, on the clock of this half
};

Moment parse_moment(const std::string& typed);

// Returns the moment in seconds since the match began.
double time_of(const RecordedMatch& match, const Moment& moment);

RobotName parse_robot(const std::string& typed, int team_size);

// Empties all drawings except the typed ones. A name is "plugin: layer" or "layer". Without names all drawings stay.
void keep_layers(std::vector<RecordedDrawing>& drawings, const std::vector<std::string>& typed);

}  // namespace regista::recording
