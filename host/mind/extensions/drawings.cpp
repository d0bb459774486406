// SPDX-License-Identifier: MIT
#include "mind/extensions/drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "mind/extensions/cut_text.hpp"
#include "texts/visible.hpp"

namespace regista::mind {
namespace {

constexpr double farthest = 1e4;  // m, as all places that plugins give
constexpr double widest = 10.0;   // m

std::string_view at_most(const char* text) {
  if (text == nullptr) return {};
  return cut_text({text, strnlen(text, REGISTA_DRAW_MOST_BYTES + 1)}, REGISTA_DRAW_MOST_BYTES);
}

// Why a shape is left out, whose points are not looked at when there are too many; empty: it is not.
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

// The same, with what the instance has drawn already; counts what is taken.
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

void Drawings::begin() {
  if (begun_) count_ = 0;
  begun_ = true;
}

void Drawings::draw(DrawUse& use, const regista_shape& shape) {
  if (!keeps_) return;
  const std::string wrong = wrong_with_use(use, shape);
  if (!wrong.empty()) {
    if (!std::exchange(use.told, true)) {
      log_->remark(use.plugin, use.place, fmt::format("draw: {}; it is left out", wrong));
    }
    return;
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

}  // namespace regista::mind
