// SPDX-License-Identifier: MIT
// What the parts of a moment's picture share: numbers and words as SVG.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "config/visible_text.hpp"
#include "markup/html_text.hpp"
#include "recording/recorded_match.hpp"

namespace regista::recording::moment {

using config::visible;
using config::visible_at_most;
using markup::Html;
using markup::Markup;
using markup::text;
using markup::operator""_html;

// Numbers, and literals of our own.
template <class... Numbers>
Html drawn(fmt::format_string<Numbers...> format, Numbers... numbers) {
  return Html::made_by_us(fmt::vformat(format, fmt::make_format_args(numbers...)));
}

inline Html label(double x, double y, const char* classes, std::string_view words) {
  Html out = drawn(R"(<text x="{:.1f}" y="{:.1f}" class="{}">)", x, y, classes);
  return out << text(words) << "</text>"_html;
}

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

// The panel beside the field: why the robot does what it does.
struct Panel {
  Html drawing;
  double bottom = 0.0;
};
inline constexpr double panel_width = 430.0;
Panel panel(const RecordedMatch& match, const RecordedMoment& moment, const RobotName& robot, double left, double top);

}  // namespace regista::recording::moment
