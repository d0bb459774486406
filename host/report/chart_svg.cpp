// SPDX-License-Identifier: MIT
// Draws a chart as SVG. The program itself cuts off the parts outside of the axes. A clip path would do this too, but
// it needs an id, and ids must be unique on a page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <span>
#include <utility>

#include "report/figure.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using texts::Html;
using texts::text;
using texts::operator""_html;

using texts::drawn;
using texts::label;

constexpr double margin = 10.0, line_height = 18.0, key_height = 20.0, sample = 24.0, tick_length = 4.0,
                 between_panels = 34.0, cap = 3.0;

std::string shown(std::string_view words) { return texts::visible_at_most(words, longest_name); }

struct Spot {
  double x, y;
};

struct Box {
  double left, top, right, bottom;

  bool holds(const Spot& spot) const {
    constexpr double nearly = 0.01;
    return spot.x >= left - nearly && spot.x <= right + nearly && spot.y >= top - nearly && spot.y <= bottom + nearly;
  }
  Spot nearest(const Spot& spot) const { return {std::clamp(spot.x, left, right), std::clamp(spot.y, top, bottom)}; }
};

Html way(std::span<const Spot> spots) {
  Html out;
  for (std::size_t i = 0; i < spots.size(); ++i)
    out << drawn("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', spots[i].x, spots[i].y);
  return out;
}
Html line(const Spot& from, const Spot& end) { return way(std::initializer_list<Spot>{from, end}); }

bool is_finite(const Spot& spot) { return std::isfinite(spot.x) && std::isfinite(spot.y); }

// Returns the path with additional points at the upper and lower edge of the box. Infinite segments get no such point.
std::vector<Spot> with_crossings(const std::vector<Spot>& spots, const Box& box) {
  std::vector<Spot> out;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    out.push_back(spots[i]);
    if (i + 1 == spots.size()) break;
    const Spot &from = spots[i], &to = spots[i + 1];
    if (!is_finite(from) || !is_finite(to)) continue;
    const bool down = from.y < to.y;
    for (const double edge : {down ? box.top : box.bottom, down ? box.bottom : box.top}) {
      if ((from.y - edge) * (to.y - edge) >= 0.0) continue;
      out.push_back({from.x + (edge - from.y) / (to.y - from.y) * (to.x - from.x), edge});
    }
  }
  return out;
}

// Returns the parts of a path inside of the box. A point with an infinite or NaN coordinate is outside.
Html way_within(const std::vector<Spot>& spots, const Box& box) {
  const std::vector<Spot> all = with_crossings(spots, box);
  Html out;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && box.holds(all[end])) ++end;
    if (end > begin + 1) out << way(std::span(all).subspan(begin, end - begin));
    begin = std::max(end, begin + 1);
  }
  return out;
}

// Returns the corners of a shape with its centre at 0 and a half height of about 1. A cross goes through it.
std::vector<Spot> corners_of(Shape shape) {
  if (shape == Shape::triangle) return {{0.0, -1.25}, {1.15, 0.85}, {-1.15, 0.85}};
  if (shape == Shape::square) return {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
  if (shape == Shape::diamond) return {{0.0, -1.3}, {1.3, 0.0}, {0.0, 1.3}, {-1.3, 0.0}};
  return {{-0.9, -0.9}, {0.9, 0.9}, {0.0, 0.0}, {-0.9, 0.9}, {0.9, -0.9}, {0.0, 0.0}};
}

Html mark(Shape shape, const Spot& at, double size) {
  if (shape == Shape::circle) return drawn(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", at.x, at.y, size);
  std::vector<Spot> corners = corners_of(shape);
  for (Spot& each : corners) each = {at.x + size * each.x, at.y + size * each.y};
  return Html("<path d=\""_html) << way(corners) << "z\"/>"_html;
}

// Returns whether the key shows a piece of line for the series. Otherwise the key shows a shape or a bar.
bool has_line(const Series& series) {
  return series.bar == 0.0 && (series.join != Join::nothing || series.interval == Interval::whiskers);
}
double sample_width(const Series& series) { return has_line(series) ? sample : 12.0; }

// The key of a chart: the names of the series, in as many columns as fit.
struct Key {
  std::vector<const Series*> entries{};
  std::vector<double> columns{};  // widths of the columns

  Key(const std::vector<Panel>& panels, double width) {
    if (panels.empty()) return;
    for (const Series& each : panels.front().series) {
      if (!each.name.empty()) entries.push_back(&each);
    }
    for (std::size_t count = entries.size(); count > 0; --count) {
      columns.assign(count, 0.0);
      for (std::size_t i = 0; i < entries.size(); ++i) {
        double& column = columns[i % count];
        column = std::max(column, sample_width(*entries[i]) + text_width(shown(entries[i]->name)) + 24.0);
      }
      if (total() <= width) break;
    }
  }
  double total() const { return std::accumulate(columns.begin(), columns.end(), 0.0); }
  double height() const {
    if (entries.empty()) return 0.0;
    return key_height * std::ceil(static_cast<double>(entries.size()) / static_cast<double>(columns.size()));
  }
};

class Painter {
 public:
  Painter(const Chart& chart, Medium medium) : chart_(chart), medium_(medium), rows_(!chart.rows.empty()) {}

  Html picture() {
    const Key key(chart_.panels, chart_.width - 2.0 * margin);
    const double top = margin + key.height(), bottom = top + chart_.height;
    y_ = rows_ ? Scale{{-0.5, static_cast<double>(chart_.rows.size()) - 0.5}, false, top, bottom}
               : Scale{range_of(chart_.y, false, chart_.panels), chart_.y.logarithmic, bottom, top};
    for (const std::string& row : chart_.rows) y_ticks_.push_back({static_cast<double>(y_ticks_.size()), shown(row)});
    if (!rows_) y_ticks_ = ticks(y_, chart_.y.whole, true);
    double names = 0.0;
    for (const Tick& each : y_ticks_) names = std::max(names, text_width(each.text));
    const std::vector<std::string> title = in_lines(chart_.y.title, chart_.height);
    const double left = margin + line_height * static_cast<double>(title.size()) + names + 2.0 * tick_length;

    out_ << keyed(key);
    for (std::size_t i = 0; i < title.size(); ++i) {
      out_ << texts::turned_label(margin + line_height * (static_cast<double>(i) + 0.6), 0.5 * (top + bottom), -90.0,
                                  "text-anchor", "middle", title[i]);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(chart_.panels.size(), 1));
    const double width = (chart_.width - left - margin + between_panels) / count - between_panels;
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
      const double begin = left + static_cast<double>(i) * (width + between_panels);
      panel(chart_.panels[i], {begin, top, begin + width, bottom}, i == 0);
    }
    return std::move(out_);
  }
  double height() const { return lowest_ + margin - 4.0; }

 private:
  std::string colour(std::size_t series) const {
    series %= colours.size();
    return medium_ == Medium::page ? fmt::format("var(--series-{})", series + 1) : std::string(colours[series]);
  }

  // Returns the range of the values along an axis. Intervals and bars lie along x if there are rows, otherwise along y.
  Range range_of(const Axis& axis, bool x, std::span<const Panel> panels) const {
    if (axis.range) return axis.range->high > axis.range->low ? *axis.range : axis.range->with_room();
    Range values, ends;
    const auto take = [&axis](Range& range, double value) {
      if (value > 0.0 || !axis.logarithmic) range.take(value);
    };
    bool from_zero = axis.from_zero;
    for (const Panel& panel : panels) {
      for (const Series& series : panel.series) {
        from_zero = from_zero || (x == rows_ && series.bar > 0.0);
        for (const Point& each : series.points) {
          take(values, x ? each.x : each.y);
          if (x != rows_ || series.interval == Interval::nothing) continue;
          take(ends, each.low);
          take(ends, each.high);
        }
      }
    }
    if (from_zero) take(values, 0.0);
    for (const double each : {values.low, values.high}) take(ends, each);
    if (axis.logarithmic) return ends.empty() ? Range{1.0, 10.0} : Range{ends.low / 1.1, ends.high * 1.1};
    Range out = ends.with_room();
    // If all values of an axis with zero are on one side of 0, the axis ends at 0. Whiskers that cross 0 also end at 0.
    if (from_zero && (values.low == 0.0 || values.high == 0.0)) (values.low == 0.0 ? out.low : out.high) = 0.0;
    return out;
  }

  Html keyed(const Key& key) const {
    Html out;
    for (std::size_t i = 0; i < key.entries.size(); ++i) {
      const Series& series = *key.entries[i];
      const std::size_t column = i % key.columns.size(), row = i / key.columns.size();
      const double left = 0.5 * (chart_.width - key.total());
      const Spot at{
          std::accumulate(key.columns.begin(), key.columns.begin() + static_cast<std::ptrdiff_t>(column), left),
          margin + key_height * (static_cast<double>(row) + 0.4)};
      const double width = sample_width(series);
      const Spot middle{at.x + 0.5 * width, at.y};
      if (series.bar > 0.0) {
        out << drawn(R"(<rect x="{:.1f}" y="{:.1f}" width="12" height="12" fill="{}"/>)", at.x, at.y - 6.0,
                     colour(series.colour));
      } else {
        if (has_line(series)) out << joined(line(at, {at.x + width, at.y}), series);
        out << marks(series, {middle});
      }
      out << label(at.x + width + 6.0, at.y + 5.0, "text-anchor", "start", shown(series.name));
    }
    return out;
  }

  static Html stroked(const Html& path, const std::string& stroke, double width, bool dashes = false) {
    if (path.empty()) return {};
    Html out = "<path d=\""_html;
    return out << path
               << drawn("\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", stroke, width,
                        dashes ? " stroke-dasharray=\"6 4\"" : "");
  }
  Html joined(const Html& path, const Series& series) const {
    const bool dashes = series.join == Join::dashes;
    return stroked(path, colour(series.colour), dashes || series.interval == Interval::whiskers ? 1.5 : 2.0, dashes);
  }

  Html marks(const Series& series, const std::vector<Spot>& at) const {
    if (series.shape == Shape::nothing || at.empty()) return {};
    const bool cross = series.shape == Shape::cross;
    Html out = drawn(R"(<g fill="{}" stroke="{}" stroke-width="1.5">)", cross ? "none" : colour(series.colour),
                     cross ? colour(series.colour) : "none");
    for (const Spot& each : at) out << mark(series.shape, each, series.size);
    return out << "</g>\n"_html;
  }

  void panel(const Panel& of, Box box, bool first) {
    Scale x;
    std::vector<Tick> x_ticks;
    // The first round measures how far the last tick's text exceeds the chart. The second round shortens the axis.
    for (const bool known : {false, true}) {
      if (known && !x_ticks.empty()) {
        const Tick& last = x_ticks.back();
        box.right -= std::max(0.0, x.at(last.at) + 0.5 * text_width(last.text) - (chart_.width - 4.0));
      }
      x = {range_of(of.x, true, {&of, 1}), of.x.logarithmic, box.left, box.right};
      x_ticks = ticks(x, of.x.whole, false);
    }
    const Scale& values = rows_ ? x : y_;
    const auto level = [&](double value) {
      const double at = values.at(value);
      return rows_ ? line({at, box.top}, {at, box.bottom}) : line({box.left, at}, {box.right, at});
    };
    Html lines, ends, texts;
    for (const Tick& each : rows_ ? x_ticks : y_ticks_) lines << level(each.at);
    for (double row = 0.5; rows_ && row < y_.range.high; ++row)
      lines << line({box.left, y_.at(row)}, {box.right, y_.at(row)});
    out_ << stroked(lines, medium_ == Medium::page ? "var(--grid)" : "#cccccc", 0.7);
    if (!values.logarithmic && values.range.low < 0.0 && values.range.high > 0.0)
      out_ << stroked(level(0.0), colour(grey), 0.8);
    for (const Series& each : of.series) {
      if (each.interval == Interval::band) band(each, box, x);
    }
    for (const Series& each : of.series) series(each, box, x);

    for (const Tick& each : x_ticks) {
      const double at = x.at(each.at);
      ends << line({at, box.bottom}, {at, box.bottom + tick_length});
      texts << label(at, box.bottom + tick_length + 15.0, "text-anchor", "middle", each.text);
    }
    for (const Tick& each : y_ticks_) {
      const double at = y_.at(each.at);
      if (!rows_) ends << line({box.left - tick_length, at}, {box.left, at});
      if (first) texts << label(box.left - 2.0 * tick_length, at + 5.0, "text-anchor", "end", each.text);
    }
    ends << way(std::initializer_list<Spot>{{box.left, box.top}, {box.left, box.bottom}, {box.right, box.bottom}});
    out_ << stroked(ends, medium_ == Medium::page ? "currentColor" : "#000000", 0.8) << texts;
    double below = box.bottom + tick_length + 17.0;
    const double centre = 0.5 * (box.left + box.right);
    const double room = chart_.panels.size() == 1 ? 2.0 * std::min(centre, chart_.width - centre) - 2.0 * margin
                                                  : box.right - box.left + 0.5 * between_panels;
    for (const std::string& each : in_lines(of.x.title, room)) {
      below += line_height;
      out_ << label(centre, below - 1.0, "text-anchor", "middle", each);
    }
    out_ << "\n"_html;
    lowest_ = std::max(lowest_, below);
  }

  // spot() returns the position of a point. end_of() returns the position of an end of its interval.
  Spot spot(const Point& point, const Scale& x) const { return {x.at(point.x), y_.at(point.y)}; }
  Spot end_of(const Point& point, double end, const Scale& x) const {
    return rows_ ? Spot{x.at(end), y_.at(point.y)} : Spot{x.at(point.x), y_.at(end)};
  }
  static bool bounded(const Point& point) {
    return !std::isnan(point.low) && !std::isnan(point.high) && (std::isfinite(point.low) || std::isfinite(point.high));
  }

  void band(const Series& of, const Box& box, const Scale& x) {
    std::vector<Spot> upper, lower;
    const auto end_band = [&] {
      const auto cut = [&](const std::vector<Spot>& spots) {
        std::vector<Spot> out = with_crossings(spots, box);
        for (Spot& each : out) each = box.nearest(each);
        return out;
      };
      if (upper.size() > 1) {
        std::vector<Spot> all = cut(upper);
        std::ranges::reverse(lower);
        std::ranges::copy(cut(lower), std::back_inserter(all));
        out_ << "<path d=\""_html << way(all) << drawn("z\" fill=\"{}\" fill-opacity=\"0.18\"/>\n", colour(of.colour));
      }
      upper.clear();
      lower.clear();
    };
    for (const Point& each : of.points) {
      const double at = x.at(each.x);
      if (!std::isfinite(at) || !bounded(each)) {
        end_band();
        continue;
      }
      const double low = y_.at(each.low), high = y_.at(each.high);
      lower.push_back({at, std::isfinite(low) ? low : box.bottom});
      upper.push_back({at, std::isfinite(high) ? high : box.top});
    }
    end_band();
  }

  void bars(const Series& of, const Box& box, const Scale& x) {
    Html rects;
    for (const Point& each : of.points) {
      const Spot middle = spot(each, x);
      if (!is_finite(middle)) continue;
      const double half = 0.5 * of.bar;
      const Spot base = end_of(each, std::isnan(each.low) ? 0.0 : each.low, x);
      const Spot one = box.nearest(rows_ ? Spot{base.x, y_.at(each.y - half)} : Spot{x.at(each.x - half), base.y});
      const Spot other =
          box.nearest(rows_ ? Spot{middle.x, y_.at(each.y + half)} : Spot{x.at(each.x + half), middle.y});
      if (std::abs(one.x - other.x) < 0.05 || std::abs(one.y - other.y) < 0.05) continue;
      rects << drawn(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", std::min(one.x, other.x),
                     std::min(one.y, other.y), std::abs(one.x - other.x), std::abs(one.y - other.y));
    }
    if (!rects.empty()) out_ << drawn("<g fill=\"{}\">", colour(of.colour)) << rects << "</g>\n"_html;
  }

  void whiskers(const Series& of, const Box& box, const Scale& x) {
    Html path;
    for (const Point& each : of.points) {
      if (!is_finite(spot(each, x)) || !bounded(each)) continue;
      const Spot low = end_of(each, each.low, x), high = end_of(each, each.high, x);
      path << line(box.nearest(low), box.nearest(high));
      for (const Spot& end : {low, high}) {
        if (!box.holds(end)) continue;
        path << (rows_ ? line({end.x, end.y - cap}, {end.x, end.y + cap})
                       : line({end.x - cap, end.y}, {end.x + cap, end.y}));
      }
    }
    out_ << joined(path, of);
  }

  void series(const Series& of, const Box& box, const Scale& x) {
    if (of.bar > 0.0) bars(of, box, x);
    if (of.interval == Interval::whiskers) whiskers(of, box, x);
    std::vector<Spot> run, shapes;
    for (std::size_t i = 0; i < of.points.size(); ++i) {
      const Spot at = spot(of.points[i], x);
      if (of.join == Join::steps && !run.empty()) run.push_back({at.x, run.back().y});
      run.push_back(at);
      if (i % of.every == 0 && box.holds(at)) shapes.push_back(at);
    }
    if (of.join != Join::nothing) out_ << joined(way_within(run, box), of);
    out_ << marks(of, shapes);
  }

  const Chart& chart_;
  Medium medium_;
  bool rows_;
  Scale y_;
  std::vector<Tick> y_ticks_;
  Html out_;
  double lowest_ = 0.0;
};

}  // namespace

Html svg(const Figure& figure, Medium medium) {
  Painter painter(figure.chart, medium);
  const Html picture = painter.picture();
  const double width = figure.chart.width, height = painter.height();
  if (medium == Medium::page) {
    return drawn(R"(<svg role="img" viewBox="0 0 {:.0f} {:.0f}" font-size="14" fill="currentColor" aria-label=")",
                 width, height)
           << text(figure.title) << ": "_html << text(figure.description) << "\">\n"_html << picture << "</svg>\n"_html;
  }
  return Html("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"_html)
         << texts::sheet(width, height) << "<title>"_html << text(figure.title) << "</title><desc>"_html
         << text(figure.description) << "</desc>\n<g font-family=\"sans-serif\" font-size=\"14\">\n"_html << picture
         << "</g></svg>\n"_html;
}

}  // namespace regista::report
