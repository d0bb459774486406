// SPDX-License-Identifier: MIT
#include "recording/field_svg.hpp"

#include <algorithm>
#include <cmath>

namespace regista::recording::picture {

Html field_lines(const config::FieldSize& field, const Scale& to) {
  Html out;
  const auto box = [&](double x0, double y0, double x1, double y1) {
    out << drawn(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.x(std::min(x0, x1)),
                 to.y(std::max(y0, y1)), std::abs(x1 - x0) * to.per_metre, std::abs(y1 - y0) * to.per_metre);
  };
  const double x = field.length / 2.0, y = field.width / 2.0;
  out << drawn(R"(<rect class="grass" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.left, to.top,
               2.0 * to.half_length * to.per_metre, 2.0 * to.half_width * to.per_metre);
  out << R"(<g class="line">)"_html;
  box(-x, -y, x, y);
  for (const double side : {-1.0, 1.0}) {
    box(side * x, -field.goal_area_width / 2.0, side * (x - field.goal_area_length), field.goal_area_width / 2.0);
    box(side * x, -field.penalty_area_width / 2.0, side * (x - field.penalty_area_length),
        field.penalty_area_width / 2.0);
    box(side * x, -field.goal_width / 2.0, side * (x + field.goal_depth), field.goal_width / 2.0);
    out << drawn(R"(<circle cx="{:.1f}" cy="{:.1f}" r="1.5"/>)", to.x(side * (x - field.penalty_mark_distance)),
                 to.y(0.0));
  }
  out << drawn(R"(<path d="M{:.1f} {:.1f}V{:.1f}"/><circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(0.0), to.y(y),
               to.y(-y), to.x(0.0), to.y(0.0), field.centre_circle_diameter / 2.0 * to.per_metre);
  return out << "</g>"_html;
}

}  // namespace regista::recording::picture
