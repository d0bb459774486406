// SPDX-License-Identifier: MIT
// Parts of all pictures of the field: lines, scale, clipping and labels. Plugins may draw at any distance, but viewers
// have a limited range of numbers. Therefore shapes are clipped to the neighbourhood of the picture.
#pragma once

#include <array>
#include <optional>
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

// --- Places labels in a picture so that no label lies over another label or over a body. Each label in turn takes the
// first free place: below, above, right, left and at the corners of its object, then farther away, where a line leads
// to it. A label without a free place is left out. The viewer's page places labels by the same rule (viewer/src/field).

// px; y grows downwards.
struct Area {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct WantedLabel {
  double x = 0.0, y = 0.0, radius = 0.0;  // px: centre and radius of the object
  double width = 0.0, height = 0.0;       // px: size of the label
  bool far = false;                       // the label may stand farther away
};

struct PlacedLabel {
  double x = 0.0, y = 0.0;  // px: centre of the label
  bool far = false;         // a line must lead to it
};

// Returns a place in `within` for each label; earlier labels choose first. taken: areas that no label may cover.
std::vector<std::optional<PlacedLabel>> place_labels(std::span<const WantedLabel> labels, std::span<const Area> taken,
                                                     const Area& within);

// The labels of one picture. They are gathered while the picture is drawn, and written last, over everything else.
class Labels {
 public:
  // No label covers the square with this centre and half side, px.
  void take(double x, double y, double half) { taken_.push_back({x - half, y - half, x + half, y + half}); }

  // classes: of the style sheet. rank: the lowest choose first. letter: size, px. far: it may stand farther away.
  struct Style {
    const char* classes;
    int rank;
    double letter;
    bool far;
  };
  void add(double x, double y, double radius, std::string words, const Style& style);

  // Returns the labels that have a place. Lines to them have the style class lead.
  Html written(const Area& within) const;

 private:
  struct Label {
    std::string words;
    WantedLabel wanted;
    Style style;
  };
  std::vector<Label> labels_;
  std::vector<Area> taken_;
};

}  // namespace regista::recording::picture

namespace regista::recording {

// --- A picture for the documentation of a team: where the rules of roles place robots for given ball positions.

inline constexpr std::string_view roles_svg_begin = "<!-- regista config draw -->";

struct RolesToDraw {
  std::string team, of;                               // title: "<team>: roles of <of>", such as "the list playing"
  std::span<const config::Role* const> roles;         // the picture of a single role also shows the parts of its rule
  std::span<const std::array<double, 2>> balls = {};  // m; several balls are numbered; empty: the ball is unknown
};

// Returns SVG 1.1 in UTF-8. The picture assumes that the ball is at rest.
std::string roles_svg(const RolesToDraw& what, const config::FieldSize& field);

}  // namespace regista::recording
