// SPDX-License-Identifier: MIT
#include "mind/extensions/plugin_log.hpp"

#include <fmt/format.h>
#include <regista/extensions/log.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "texts/message.hpp"

namespace regista::mind {
namespace {

bool is_level(std::int32_t level) { return level >= REGISTA_LOG_DEBUG && level <= REGISTA_LOG_ERROR; }

constexpr double farthest = 1e4;  // m; largest coordinate that a plugin may give
constexpr double widest = 10.0;   // m; largest width of a line

std::string_view at_most(const char* text) {
  if (text == nullptr) return {};
  return cut_text({text, strnlen(text, REGISTA_DRAW_MOST_BYTES + 1)}, REGISTA_DRAW_MOST_BYTES);
}

// Returns why a shape is left out; empty: the shape is drawn. Reads no points if the shape has too many points.
std::string wrong_with(const regista_shape& shape) {
  constexpr std::uint32_t most_points = REGISTA_DRAW_MOST_POINTS;
  if (shape.size < sizeof shape) {
    return fmt::format("a shape is {} bytes; {} needs {}", shape.size, REGISTA_DRAW_EXTENSION, sizeof shape);
  }
  if (shape.shape < REGISTA_SHAPE_POINTS || shape.shape > REGISTA_SHAPE_TEXT) {
    return fmt::format("there is no shape {}", shape.shape);
  }
  if (shape.layer == nullptr || *shape.layer == '\0') return "a shape names no layer";
  const auto in_layer = [&shape](std::string_view what) {
    return fmt::format("layer {}: {}", texts::visible(at_most(shape.layer)), what);
  };
  if (shape.shape == REGISTA_SHAPE_TEXT && shape.text == nullptr) return in_layer("a text is null");
  if (shape.count > most_points) {
    return in_layer(fmt::format("a shape has {} points; at most {} are taken", shape.count, most_points));
  }
  if (shape.count == 0 || shape.points == nullptr) return in_layer("a shape has no points");
  if (!(shape.width >= 0.0 && shape.width <= widest)) return in_layer(fmt::format("a shape is {} m wide", shape.width));
  for (std::uint32_t i = 0; i < shape.count; ++i) {
    const regista_point& point = shape.points[i];
    if (!(std::abs(point.x) <= farthest && std::abs(point.y) <= farthest)) {
      return in_layer(fmt::format("point {} is at ({}, {})", i, point.x, point.y));
    }
  }
  return {};
}

// Returns why a shape is left out, as wrong_with() does; also checks the instance's limits. Counts an accepted shape.
std::string wrong_with_use(DrawUse& use, const regista_shape& shape) {
  constexpr std::uint32_t most_shapes = REGISTA_DRAW_MOST_SHAPES, most_points = REGISTA_DRAW_MOST_POINTS_OF_ALL,
                          most_layers = REGISTA_DRAW_MOST_LAYERS;
  if (use.shapes >= most_shapes) return fmt::format("more than {} shapes in one decision", most_shapes);
  if (std::string wrong = wrong_with(shape); !wrong.empty()) return wrong;
  if (use.points + shape.count > most_points) return fmt::format("more than {} points in one decision", most_points);
  const std::string_view layer = at_most(shape.layer);
  if (std::ranges::find(use.layers, layer) == use.layers.end()) {
    if (use.layers.size() >= most_layers) {
      return fmt::format("layer {}: more than {} layers in one match", texts::visible(layer), most_layers);
    }
    use.layers.emplace_back(layer);
  }
  ++use.shapes;
  use.points += shape.count;
  return {};
}

}  // namespace

const char* level_name(std::int32_t level) {
  constexpr std::array names{"debug", "info", "warning", "error"};  // index 0 is REGISTA_LOG_DEBUG
  return is_level(level) ? names[static_cast<std::size_t>(level - REGISTA_LOG_DEBUG)] : "info";
}

std::string to_string(const LogLine& line) {
  return fmt::format("[{}] {} {}, tick {}, {}: {}", level_name(line.level), line.side == 0 ? "home" : "away",
                     line.robot, line.tick, line.plugin, line.text);
}

std::optional<std::int32_t> level_of(std::string_view name) {
  for (std::int32_t level = REGISTA_LOG_DEBUG; level <= REGISTA_LOG_ERROR; ++level) {
    if (name == level_name(level)) return level;
  }
  return std::nullopt;
}

LogSink to_standard_error(std::int32_t least_level, std::size_t most_bytes) {
  // Bytes written so far, by side. All copies of the sink share these counts.
  const auto written = std::make_shared<std::array<std::size_t, 2>>();
  return {least_level, [most_bytes, written](const LogLine& line) {
            std::string text = to_string(line) + '\n';  // one write for the line, because other threads may write too
            std::size_t& bytes = (*written)[line.side == 0 ? 0 : 1];
            if (most_bytes != 0) {
              if (bytes > most_bytes) return;
              bytes += text.size();
              if (bytes > most_bytes) {
                text = fmt::format("[more lines of {} are left out]\n", line.side == 0 ? "home" : "away");
              }
            }
            std::fwrite(text.data(), 1, text.size(), stderr);
          }};
}

PluginLog::PluginLog(const plugin::Caller& caller, LogSink sink, bool keeps)
    : caller_(&caller), sink_(std::move(sink)), keeps_(keeps) {}

// The first call drops no lines, because lines that plugins wrote during their creation belong to the first decision.
void PluginLog::begin(double time) {
  time_ = time;
  if (!std::exchange(begun_, true)) return;
  lines_.clear();
  texts_.clear();
}

void PluginLog::write(LogUse& use, std::int32_t level, std::string_view text) {
  constexpr std::uint32_t most_lines = REGISTA_LOG_MOST_LINES;
  constexpr std::size_t most_bytes = REGISTA_LOG_MOST_OF_MATCH;
  if (!is_level(level)) level = REGISTA_LOG_INFO;
  text = cut_text(text, REGISTA_LOG_MOST_BYTES);
  const bool too_many = ++use.lines > most_lines;
  if (too_many || use.bytes + text.size() > most_bytes) {
    if (std::exchange(use.told, true)) return;
    remark(use.plugin, use.place,
           too_many
               ? fmt::format("log: wrote more than {} lines in one decision; what is more is left out", most_lines)
               : fmt::format("log: wrote more than {} KiB in this match; what is more is left out", most_bytes >> 10));
    return;
  }
  use.bytes += text.size();
  if (keeps_ || sink_.wants(level)) add(use.plugin, use.place, level, text);
}

void PluginLog::remark(const char* plugin, int place, std::string_view text) {
  if (keeps_ || sink_.wants(REGISTA_LOG_WARNING)) add(plugin, place, REGISTA_LOG_WARNING, text);
}

void PluginLog::add(const char* plugin, int place, std::int32_t level, std::string_view text) {
  const std::string shown = texts::visible(text);
  LogLine line{level, caller_->tracing.side, caller_->robot, place, caller_->tick, time_, plugin, shown};
  if (sink_.wants(level)) sink_.tell(line);
  if (!keeps_) return;
  line.text = texts_.emplace_back(shown);
  lines_.push_back(line);
}

void Drawings::begin() {
  if (std::exchange(begun_, true)) count_ = 0;
}

void Drawings::draw(DrawUse& use, const regista_shape& shape) {
  if (!keeps_) return;
  if (const std::string wrong = wrong_with_use(use, shape); !wrong.empty()) {
    if (std::exchange(use.told, true)) return;
    return log_->remark(use.plugin, use.place, fmt::format("draw: {}; it is left out", wrong));
  }
  if (count_ == shapes_.size()) shapes_.emplace_back();
  DrawnShape& out = shapes_[count_++];
  out.plugin = use.plugin;
  out.layer = texts::visible(at_most(shape.layer));
  out.text = shape.shape == REGISTA_SHAPE_TEXT ? texts::visible(at_most(shape.text)) : "";
  out.shape = shape.shape;
  out.filled = shape.shape == REGISTA_SHAPE_POLYGON && (shape.flags & REGISTA_SHAPE_FILLED) != 0;
  out.colour = shape.colour;
  out.width = shape.width;
  const std::uint32_t count = shape.shape == REGISTA_SHAPE_TEXT ? 1 : shape.count;
  out.points.assign(shape.points, shape.points + count);
}

void MetricReports::report(const plugin::Found& plugin, std::span<const int> of_team, int place, std::uint32_t metric,
                           double value) {
  if (violation_) return;
  if (metric >= of_team.size()) {
    violation_ = {&plugin,
                  fmt::format("reported metric number {}; it declares {}, counted from 0", metric, of_team.size())};
    return;
  }
  const int index = of_team[metric];
  if (!(std::abs(value) <= largest_report)) {
    violation_ = {&plugin,
                  fmt::format("reported {} as metric \"{}\"", value, plugin.description->metrics()[metric].name)};
    return;
  }
  const auto key = [](const MetricReport& each) { return std::pair(each.metric, each.place); };
  const std::pair own(index, place);
  const auto known = std::ranges::lower_bound(reports_, own, {}, key);
  const MetricReport told{index, place, 1, value, value, value, value};
  if (known == reports_.end() || key(*known) != own) {
    reports_.insert(known, told);
  } else {
    known->add(told);
  }
}

void MetricReports::take(std::vector<MetricReport>& out) {
  out.assign(reports_.begin(), reports_.end());
  reports_.clear();
}

}  // namespace regista::mind
