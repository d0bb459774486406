// SPDX-License-Identifier: MIT
// Drawings in the field: see <regista/extensions/draw.h>. Field frame of the own team, metres.
//
//   void setup(const regista::Environment&, const regista::Host& host) { draw_ = regista::Draw(host); }
//   ...
//   draw_.polygon("cells", corners);
//   if (draw_.wanted()) draw_.text("cells", {x, y}, std::to_string(area));
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <regista/extensions/draw.h>
#include <regista/host.hpp>

namespace regista {

using Point = regista_point;

struct Pen {
  std::uint32_t colour = 0;  // 0xRRGGBBAA; 0: as the viewer likes
  double width = 0.0;        // m; 0: as the viewer likes
  bool filled = false;       // polygons
};

// Without a host that takes drawings nothing happens.
class Draw {
 public:
  Draw() = default;
  explicit Draw(const Host& host) : table_(host.extension<regista_draw>(REGISTA_DRAW_EXTENSION)) {}

  // Whether somebody looks. Nothing but drawing may depend on it.
  bool wanted() const { return table_ != nullptr && table_->wanted(table_->context) != 0; }

  void points(const char* layer, std::span<const Point> at, const Pen& pen = {}) const {
    draw(REGISTA_SHAPE_POINTS, layer, at, pen, nullptr);
  }
  void line(const char* layer, std::span<const Point> through, const Pen& pen = {}) const {
    draw(REGISTA_SHAPE_LINE, layer, through, pen, nullptr);
  }
  void polygon(const char* layer, std::span<const Point> corners, const Pen& pen = {}) const {
    draw(REGISTA_SHAPE_POLYGON, layer, corners, pen, nullptr);
  }
  void text(const char* layer, const Point& at, const std::string& text, const Pen& pen = {}) const {
    draw(REGISTA_SHAPE_TEXT, layer, {&at, 1}, pen, text.c_str());
  }

 private:
  void draw(std::int32_t shape, const char* layer, std::span<const Point> at, const Pen& pen, const char* text) const {
    if (!wanted()) return;
    regista_shape out{};
    out.size = sizeof out;
    out.shape = shape;
    out.flags = pen.filled ? REGISTA_SHAPE_FILLED : 0;
    out.colour = pen.colour;
    out.width = pen.width;
    out.layer = layer;
    out.text = text;
    out.points = at.data();
    out.count = static_cast<std::uint32_t>(at.size());
    table_->draw(table_->context, &out);
  }
  const regista_draw* table_ = nullptr;
};

}  // namespace regista
