// SPDX-License-Identifier: MIT
// What the parts of a moment's picture share.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "recording/field_svg.hpp"
#include "recording/recorded_match.hpp"
#include "texts/visible.hpp"

namespace regista::recording::moment {

using texts::visible;
using texts::visible_at_most;
using namespace picture;

// "7:42.3", as in the viewer.
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

// What the robot's plugins drew, to be clipped to #field. A layer keeps its colour while others come and go. Classes:
// layer, said (texts), light-said (in light colours).
Html layers(const std::vector<RecordedDrawing>& drawings, const Scale& to);
// The entries of the legend for what layers() shows; `top` is where the letters of the first stand. Class: swatch.
Panel names_of_layers(const std::vector<RecordedDrawing>& drawings, double left, double top);

// The panel beside the field: why the robot does what it does, and what its plugins logged.
inline constexpr double panel_width = 430.0;
Panel panel(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left, double top);

}  // namespace regista::recording::moment
