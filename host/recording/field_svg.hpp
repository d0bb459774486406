// SPDX-License-Identifier: MIT
// Parts of all pictures of the field: lines, scale and clipping. Plugins may draw at any distance, but viewers have a
// limited range of numbers. Therefore shapes are clipped to the neighbourhood of the picture.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/rules.hpp"
#include "config/team.hpp"
#include "texts/html.hpp"

namespace regista::recording::picture {

using Point = std::array<double, 2>;

struct Rectangle {
  double left = 0.0, low = 0.0, right = 0.0, high = 0.0;

  bool holds(const Point& p) const { return p[0] >= left && p[0] <= right && p[1] >= low && p[1] <= high; }
};

// Returns the parts of an open line inside the rectangle. Both clipping functions need finite numbers.
std::vector<std::vector<Point>> clipped_line(std::span<const Point> line, const Rectangle& to);

// Returns the part of a polygon inside the rectangle, by Sutherland and Hodgman (Reentrant polygon clipping,
// Communications of the ACM 17(1), 1974). If there are several parts, edges of the rectangle connect them.
std::vector<Point> clipped_polygon(std::span<const Point> corners, const Rectangle& to);

using texts::drawn;
using texts::Html;
using texts::label;
using texts::Markup;
using texts::sheet;
using texts::text;
using texts::turned_label;
using texts::operator""_html;

// Converts field coordinates (metres, y up) into picture coordinates (px, y down).
struct Scale {
  double left, top, per_metre;
  double half_length, half_width;  // m: half of the field's size plus the border strip

  double x(double metres) const { return left + (metres + half_length) * per_metre; }
  double y(double metres) const { return top + (half_width - metres) * per_metre; }
};

// Returns the lines of the field, in the style classes grass and line.
Html field_lines(const config::FieldSize& field, const Scale& to);

}  // namespace regista::recording::picture

namespace regista::recording {

// --- A picture for the documentation of a team: where the rules of roles place robots for given ball positions.

// The first bytes of every picture of roles.
inline constexpr std::string_view roles_svg_begin = "<!-- regista config draw -->";

struct RolesToDraw {
  std::string team, of;                               // title: "<team>: roles of <of>", such as "the list playing"
  std::span<const config::Role* const> roles;         // the picture of a single role also shows the parts of its rule
  std::span<const std::array<double, 2>> balls = {};  // m; several balls are numbered; empty: the ball is unknown
};

// Returns SVG 1.1 in UTF-8. The picture assumes that the ball is at rest.
std::string roles_svg(const RolesToDraw& what, const config::FieldSize& field);

}  // namespace regista::recording
