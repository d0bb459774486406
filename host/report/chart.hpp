// SPDX-License-Identifier: MIT
// A chart as plain data: axes, and series of values with the ways in which they are drawn. chart_svg.cpp draws it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace regista::report {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// From the least to the largest of the values taken.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double value);  // one that is not finite is left out
  bool empty() const { return low > high; }
  // A little more on both sides; where all values are equal, enough that the axis has a length. Of no value: from 0
  // to 1.
  Range with_room() const;
};

struct Axis {
  std::string title{};
  std::optional<Range> range{};  // without one: what is drawn, with a little room
  bool from_zero = false;        // so it is where there are bars, too
  bool logarithmic = false;      // for positive values
  bool whole = false;            // ticks are whole numbers
};

// A value with the ends of its interval; an infinite end reaches to the edge of the chart.
struct Point {
  double x, y;
  double low = unknown, high = unknown;
};

enum class Join { nothing, line, dashes, steps };
enum class Shape { nothing, circle, triangle, square, diamond, cross };
enum class Interval { nothing, band, whiskers };

// A point whose x or y is not finite is left out, and interrupts a line.
struct Series {
  std::string name{};      // in the key; a series without a name is not in the key
  std::size_t colour = 0;  // place in `colours`; after the last colour comes the first again
  std::vector<Point> points{};
  Join join = Join::nothing;
  Shape shape = Shape::nothing;
  double size = 4.0;      // of a shape: half its height
  std::size_t every = 1;  // 1: every point has a shape; 2: every second one
  Interval interval = Interval::nothing;
  double bar = 0.0;  // thickness of bars, as the axis counts; they begin at 0, or at `low` where that is known
};

// What has an x axis of its own.
struct Panel {
  Axis x{};
  std::vector<Series> series{};
};

struct Chart {
  Axis y{};
  std::vector<std::string> rows{};  // where there are some: y of a point is 0 in the first row, which is on top, 1 in
                                    // the next one, and intervals and bars lie along x
  std::vector<Panel> panels{};      // beside each other
  double width = 620.0;             // of the whole
  double height = 220.0;            // of what the axes enclose
};

// --- What the painter is made of -------------------------------------------------------------------------------------

// Where the values of an axis lie in the picture.
struct Scale {
  Range range;  // that has a length
  bool logarithmic = false;
  double begin = 0.0, end = 1.0;  // of the axis, in units of the picture

  double at(double value) const;
};

// The distance of ticks on an axis of this length, such that at most `most` of them fit into it: 1, 2 or 5 times a
// power of ten.
double tick_step(double length, int most);

struct Tick {
  double at;
  std::string text;
};

// As many ticks as there is room for, texts included. Upright: the texts lie above each other.
std::vector<Tick> ticks(const Scale& scale, bool whole, bool upright);

// How much room a text takes at most, in units of the picture; a guess, because the reader's font is not known.
double text_width(std::string_view text);

// In lines of this width at most, each broken after a space or a sign where it can be.
std::vector<std::string> in_lines(std::string_view text, double width);

}  // namespace regista::report
