// SPDX-License-Identifier: MIT
// A figure of a report: a chart, and a table with the data of the chart, from which users can draw their own figures. A
// chart is plain data: axes, series of values, and how to draw the series. chart_svg.cpp draws charts.
//
// People with any colour vision can distinguish the colours: M. Okabe and K. Ito, "Color Universal Design", 2008.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/paired_estimates.hpp"
#include "texts/html.hpp"

namespace regista::report {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The range from the least to the largest value that take() received.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double value);  // ignores infinite values and NaN
  bool empty() const { return low > high; }
  // Returns a slightly wider range, so that an axis always has a length. An empty range gives 0 to 1.
  Range with_room() const;
};

struct Axis {
  std::string title{};
  std::optional<Range> range{};  // missing: the range of the series, made slightly wider
  bool from_zero = false;        // true: the axis includes zero; an axis along which bars lie always includes zero
  bool logarithmic = false;      // true: a logarithmic scale, only for positive values
  bool whole = false;            // true: ticks are at whole numbers
};

// A point of a series, and the ends of its interval. An infinite end is drawn at the edge of the chart.
struct Point {
  double x, y;
  double low = unknown, high = unknown;
};

enum class Join { nothing, line, dashes, steps };
enum class Shape { nothing, circle, triangle, square, diamond, cross };
enum class Interval { nothing, band, whiskers };

// A series of points. A point with an infinite or NaN coordinate is not drawn and interrupts the line of the series.
struct Series {
  std::string name{};      // name in the key of the chart; empty: the key omits this series
  std::size_t colour = 0;  // index in `colours`, modulo the number of colours
  std::vector<Point> points{};
  Join join = Join::nothing;
  Shape shape = Shape::nothing;
  double size = 4.0;      // half of a shape's height
  std::size_t every = 1;  // N: every N-th point has a shape
  Interval interval = Interval::nothing;
  double bar = 0.0;  // thickness of bars in units of the axis; 0: no bars. A bar begins at `low` or, if unknown, at 0
};

// Several series over one x axis.
struct Panel {
  Axis x{};
  std::vector<Series> series{};
};

struct Chart {
  Axis y{};
  // Names of the rows. In a chart with rows, Point::y is the index of a row (0: top); intervals and bars lie along x.
  std::vector<std::string> rows{};
  std::vector<Panel> panels{};  // panels beside each other
  double width = 620.0;         // width of the whole figure
  double height = 220.0;        // height of the area between the axes
};

// Converts the values of an axis into positions in the picture.
struct Scale {
  Range range;  // precondition: low < high
  bool logarithmic = false;
  double begin = 0.0, end = 1.0;  // ends of the axis in units of the picture

  double at(double value) const;
};

// Returns the smallest step (1, 2 or 5 times a power of ten) that gives at most `most` ticks on an axis of this length.
double tick_step(double length, int most);

struct Tick {
  double at;
  std::string text;
};

// Returns ticks whose texts do not overlap. whole: only whole numbers get ticks. upright: the axis is vertical.
std::vector<Tick> ticks(const Scale& scale, bool whole, bool upright);

// Returns an upper bound for the width of a text in units of the picture. The exact width depends on the reader's font.
double text_width(std::string_view text);

// Breaks a text into lines of at most this width. If possible, a line ends at a space or after one of . _ - / ,
std::vector<std::string> in_lines(std::string_view text, double width);

struct Figure {
  std::string name{};         // name of the figure's files: only letters, digits and _
  std::string title{};        // one line that says what the figure shows
  std::string description{};  // explains the figure, also to people who cannot see it
  std::string csv{};          // the data with a header line; every line has a line end
  Chart chart{};
};

// Colours of series 0, 1, ... page.css has shades of these colours for light and for dark backgrounds.
inline constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
inline constexpr std::size_t black = 6, grey = 7;  // indices in `colours`
Shape shape_of(std::size_t series);                // a different shape for each of five series

// page: the picture is a part of a page and uses the page's colours and font. file: a separate file on white ground.
enum class Medium { page, file };
texts::Html svg(const Figure& figure, Medium medium);

inline constexpr double page_width = 1000.0;  // width of a chart that fills the page

// Returns whether `name` consists of `prefix` and a number of at most three digits, such as "slice_12" for "slice_".
bool is_numbered(std::string_view name, std::string_view prefix);

// Returns a user's text for the title of an axis, cut to `longest_name` characters. For names of rows and series this
// is not necessary, because svg() cuts these names.
std::string in_title(std::string_view text);
inline constexpr std::size_t longest_name = 32;

// Returns the name of a series: a user's text, cut to the room that is left, and then `words`, such as " wins".
std::string name_with(std::string_view text, std::string_view words);

// Returns a user's text as a field of a figure's table: one line without quotes, because gnuplot 5.4, which many
// readers use for such tables, ignores lines with quotes inside of a field.
std::string figure_field(std::string_view text);
std::string figure_field(double number);  // empty if the number is infinite or NaN

// These functions return a mean with its interval: as fields "mean,low,high", as a point at `x`, and as a point in a
// row. If a mean has no interval, `low` and `high` equal the mean.
std::string mean_fields(const study::MeanEstimate& mean);
Point mean_over(double x, const study::MeanEstimate& mean);
Point mean_in_row(double row, const study::MeanEstimate& mean);
void take(Range& range, const study::MeanEstimate& mean);  // extends the range by the interval

// --- A curve over any number of places in bounded memory. The curve keeps every place at first, later every second
// place, then every fourth place, and so on. Which places are kept depends only on the number of places.

template <class Point>
class Thinned {
 public:
  // most: largest number of kept points, an even number.
  explicit Thinned(std::size_t most) : most_(most) {}

  // Adds the next place. Calls `make` for its point only if the place is kept.
  template <class Make>
  void offer(Make make) {
    ++places_;
    last_is_kept_ = places_ % stride_ == 0;
    if (!last_is_kept_) return;
    points_.push_back(make());
    if (points_.size() < most_) return;
    // Keeps the points with odd indices, which include the last point.
    for (std::size_t i = 0; 2 * i + 1 < points_.size(); ++i) points_[i] = points_[2 * i + 1];
    points_.resize(points_.size() / 2);
    stride_ *= 2;
  }

  std::uint64_t stride() const { return stride_; }

  // Returns the kept points, plus a point for the last place if it was not kept. Calls `make` for this point.
  template <class Make>
  std::vector<Point> with_last(Make make) const {
    std::vector<Point> out = points_;
    if (places_ > 0 && !last_is_kept_) out.push_back(make());
    return out;
  }

 private:
  std::size_t most_;
  std::uint64_t places_ = 0, stride_ = 1;
  bool last_is_kept_ = false;
  std::vector<Point> points_;
};

}  // namespace regista::report
