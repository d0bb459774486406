// SPDX-License-Identifier: MIT
#include "recording/drawing_record.hpp"

#include <algorithm>
#include <cstddef>

namespace regista::recording {
namespace {

constexpr std::string_view nothing = "[]";
constexpr double period = 0.5;  // s

const char* word(std::int32_t shape) {
  switch (shape) {
    case REGISTA_SHAPE_POINTS:
      return "points";
    case REGISTA_SHAPE_LINE:
      return "line";
    case REGISTA_SHAPE_POLYGON:
      return "polygon";
    default:
      return "text";
  }
}

std::string colour(std::uint32_t rgba) {
  constexpr char digits[] = "0123456789abcdef";
  std::string out = "#";
  for (int shift = 28; shift >= 0; shift -= 4) out += digits[rgba >> shift & 15u];
  return out;
}

void write(texts::JsonText& json, const mind::DrawnShape& shape, double direction) {
  json.open('{').key("shape").word(word(shape.shape)).key("at").open('[');
  for (const regista_point& each : shape.points) {
    json.open('[').number(direction * each.x, 2).number(direction * each.y, 2).close(']');
  }
  json.close(']');
  if (shape.colour != 0) json.key("colour").word(colour(shape.colour));
  if (shape.width > 0.0) json.key("width").number(shape.width);
  if (shape.filled) json.key("filled").boolean(true);
  if (shape.shape == REGISTA_SHAPE_TEXT) json.key("text").string(shape.text);
  json.close('}');
}

}  // namespace

std::size_t DrawnLayers::layer(std::vector<Layer>& of_robot, const mind::DrawnShape& shape) {
  const std::string_view plugin = shape.plugin;
  const auto found = std::ranges::find_if(
      of_robot, [&](const Layer& each) { return each.plugin == plugin && each.name == shape.layer; });
  const auto place = static_cast<std::size_t>(found - of_robot.begin());
  if (found == of_robot.end()) of_robot.push_back({shape.plugin, shape.layer, std::string(nothing), -period});
  return place;
}

std::span<const DrawnLayers::Change> DrawnLayers::follow(match::Side side, int robot, double time,
                                                         std::span<const mind::DrawnShape> shapes, double direction) {
  changes_.clear();
  std::vector<std::vector<Layer>>& robots = layers_[match::index(side)];
  if (robots.size() < static_cast<std::size_t>(robot)) robots.resize(static_cast<std::size_t>(robot));
  std::vector<Layer>& own = robots[static_cast<std::size_t>(robot - 1)];
  layer_of_.clear();
  for (const mind::DrawnShape& shape : shapes) layer_of_.push_back(layer(own, shape));
  for (std::size_t i = 0; i < own.size(); ++i) {
    Layer& each = own[i];
    if (time - each.told < period - 1e-9) continue;
    json_.clear();
    json_.open('[');
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (layer_of_[k] == i) write(json_, shapes[k], direction);
    }
    json_.close(']');
    if (json_.text() == each.shapes) continue;
    each.shapes = json_.text();
    each.told = time;
    changes_.push_back({each.plugin, each.name, each.shapes});
  }
  return changes_;
}

}  // namespace regista::recording
