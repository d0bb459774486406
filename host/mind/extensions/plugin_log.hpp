// SPDX-License-Identifier: MIT
// Additional output of one robot's plugins: lines for people (extension regista.log), drawings (regista.draw) and
// numbers of a match (regista.metric); see <regista/extensions/*.h>. These classes apply the limits of each extension,
// so that no plugin can fill a disk. The log reports the first time that an instance exceeds a limit.
#pragma once

#include <regista/extensions/draw.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/description.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::mind {

// Returns the beginning of `text`, at most `bytes` long, without cutting a character of UTF-8.
inline std::string_view cut_text(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u; };
  std::size_t end = bytes;
  // A character has at most three continuation bytes. Text with longer runs is not UTF-8.
  for (int i = 0; i < 3 && end > 0 && continues(text[end]); ++i) --end;
  return text.substr(0, end);
}

struct LogLine {
  std::int32_t level = 0;   // REGISTA_LOG_*
  int side = 0;             // 0 home, 1 away
  int robot = 0;            // shirt number
  int place = 0;            // place of the plugin's instance in the robot's mind (see mailboxes.hpp)
  std::uint64_t tick = 0;   // number of the robot's decision, from 0
  double time = 0.0;        // match time of the decision, s
  const char* plugin = "";  // id; lives as long as the team's plan
  std::string_view text;    // one line of well-formed UTF-8; valid until the robot's next decision
};

// Receives each log line when the plugin writes the line, so that no line before a crash of the process is lost.
struct LogSink {
  std::int32_t least_level = 0;                // the sink does not receive lines of lower levels
  std::function<void(const LogLine&)> tell{};  // receives a line; empty: the sink drops all lines

  bool wants(std::int32_t level) const { return tell && level >= least_level; }
};

// The names are "debug", "info", "warning" and "error". level_of() returns nothing for an unknown name.
const char* level_name(std::int32_t level);
std::optional<std::int32_t> level_of(std::string_view name);

// Returns text such as "[warning] home 3, tick 124, voronoi: two points coincide".
std::string to_string(const LogLine& line);

// Limit of to_standard_error() in a process whose standard error is stored with the match: bytes for each side.
inline constexpr std::size_t most_kept_of_log = 1500;

// Returns a sink that writes lines of this level and above to standard error. most_bytes: limit of bytes for each side;
// 0: no limit. When a side exceeds the limit, the sink writes one more line, which says so.
LogSink to_standard_error(std::int32_t least_level, std::size_t most_bytes = 0);

struct LogUse {  // How much one instance has written to the log.
  const char* plugin = "";
  int place = 0;
  std::uint32_t lines = 0;  // number of lines in this decision
  std::size_t bytes = 0;    // number of bytes in this match
  bool told = false;        // the log has reported in this match that the instance exceeded a limit
};

class PluginLog {
 public:
  // `caller` must outlive the log. sink: receives each line; may be empty. keeps: whether lines() returns lines.
  PluginLog(const plugin::Caller& caller, LogSink sink, bool keeps);

  void begin(double time);
  void write(LogUse& use, std::int32_t level, std::string_view text);
  // Adds a line in which the host reports something about a plugin. The limits do not apply to this line.
  void remark(const char* plugin, int place, std::string_view text);

  std::span<const LogLine> lines() const { return lines_; }

 private:
  void add(const char* plugin, int place, std::int32_t level, std::string_view text);

  const plugin::Caller* caller_;
  LogSink sink_;
  bool keeps_;
  double time_ = 0.0;
  bool begun_ = false;
  std::deque<std::string> texts_;
  std::vector<LogLine> lines_;
};

// --- Drawings of a decision are kept until the next decision, and only if a recorder wants drawings. Memory is reused.

struct DrawnShape {
  const char* plugin = "";  // id; lives as long as the team's plan
  std::string layer, text;  // well-formed UTF-8
  std::int32_t shape = 0;   // REGISTA_SHAPE_*
  bool filled = false;
  std::uint32_t colour = 0;           // 0xRRGGBBAA; 0: the plugin chose no colour
  double width = 0.0;                 // m; 0: the plugin chose no width
  std::vector<regista_point> points;  // field frame of the robot's team, m; all finite
};

struct DrawUse {  // How much one instance has drawn.
  const char* plugin = "";
  int place = 0;
  std::uint32_t shapes = 0, points = 0;  // numbers in this decision
  std::vector<std::string> layers;       // names of the layers used in this match
  bool told = false;                     // the log has reported in this match that a shape was left out
};

class Drawings {
 public:
  // `log` receives reports of left-out shapes and must outlive this object. keeps: whether shapes() returns shapes.
  Drawings(PluginLog& log, bool keeps) : log_(&log), keeps_(keeps) {}

  bool wanted() const { return keeps_; }
  void begin();
  void draw(DrawUse& use, const regista_shape& shape);

  // Returns the shapes of the last decision, in the order of drawing.
  std::span<const DrawnShape> shapes() const { return {shapes_.data(), count_}; }

 private:
  PluginLog* log_;
  bool keeps_, begun_ = false;
  std::vector<DrawnShape> shapes_;
  std::size_t count_ = 0;
};

// --- Numbers of a match. MetricReports combines all reports of one instance for one metric in one decision.

// Largest absolute value of a report. With this limit no sum over a match is infinite.
inline constexpr double largest_report = 1e9;

struct TeamMetric {
  std::string name;          // "voronoi.crossings"
  std::int32_t combine = 0;  // REGISTA_METRIC_*
};

// All reports of one instance for one metric in one decision. `metric`: index into TeamPlan::metrics().
struct MetricReport {
  std::int32_t metric = 0;
  std::int32_t place = 0;  // place of the instance in the robot's mind
  std::uint64_t count = 0;
  double sum = 0.0, least = 0.0, greatest = 0.0, last = 0.0;

  void add(const MetricReport& later) {
    least = count == 0 ? later.least : std::min(least, later.least);
    greatest = count == 0 ? later.greatest : std::max(greatest, later.greatest);
    count += later.count;
    sum += later.sum;
    last = later.last;
  }
};

class MetricReports {
 public:
  // A report of an undeclared metric, or of a value that is NaN or beyond largest_report.
  struct Violation {
    const plugin::Found* plugin;
    std::string what;
  };

  // Adds a report. of_team: the plugin's metrics, as indices into TeamPlan::metrics(). metric: index into of_team.
  void report(const plugin::Found& plugin, std::span<const int> of_team, int place, std::uint32_t metric, double value);

  // take() fills `out` with the reports since the last take(), sorted by metric and then place. violation(): the first.
  void take(std::vector<MetricReport>& out);
  const std::optional<Violation>& violation() const { return violation_; }

 private:
  std::vector<MetricReport> reports_;
  std::optional<Violation> violation_;
};

}  // namespace regista::mind
