// SPDX-License-Identifier: MIT
// What the plugins of one robot draw in the field: extension regista.draw, <regista/extensions/draw.h>. Shapes are kept
// for the decision in which they were drawn, and only where somebody records. Their memory is used again.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <regista/extensions/draw.h>

#include "mind/extensions/plugin_log.hpp"

namespace regista::mind {

struct DrawnShape {
  const char* plugin = "";  // id; lives as long as the team's plan
  std::string layer, text;  // well-formed UTF-8
  std::int32_t shape = 0;   // REGISTA_SHAPE_*
  bool filled = false;
  std::uint32_t colour = 0;           // 0xRRGGBBAA; 0: none was chosen
  double width = 0.0;                 // m; 0: none was chosen
  std::vector<regista_point> points;  // field frame of the own team, m; finite
};

// What one instance has drawn.
struct DrawUse {
  const char* plugin = "";
  int place = 0;
  std::uint32_t shapes = 0, points = 0;  // in this decision
  std::vector<std::string> layers;       // in this match
  bool told = false;                     // that a shape of it was left out, in this match
};

class Drawings {
 public:
  // log outlives the drawings.
  Drawings(PluginLog& log, bool keeps) : log_(&log), keeps_(keeps) {}

  bool wanted() const { return keeps_; }
  void begin();
  void draw(DrawUse& use, const regista_shape& shape);

  // Of the last decision, in the order of drawing.
  std::span<const DrawnShape> shapes() const { return {shapes_.data(), count_}; }

 private:
  PluginLog* log_;
  bool keeps_, begun_ = false;
  std::vector<DrawnShape> shapes_;
  std::size_t count_ = 0;
};

}  // namespace regista::mind
