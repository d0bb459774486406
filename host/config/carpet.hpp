// SPDX-License-Identifier: MIT
// How far robots may go from the centre: the field and the strip about it.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "config/rules.hpp"
#include "config/scalar.hpp"

namespace regista::config {

struct Carpet {
  double x, y;  // m, of its edges

  explicit Carpet(const FieldSize& field)
      : x(field.length / 2.0 + field.border_strip), y(field.width / 2.0 + field.border_strip) {}

  bool holds(const std::array<double, 2>& point) const { return std::abs(point[0]) <= x && std::abs(point[1]) <= y; }

  // What is said of a place that is not on it: "... is off the field, ..."
  std::string off() const {
    return fmt::format("off the field, which with its border reaches from {} to {} m in x and from {} to {} m in y",
                       real_text(-x), real_text(x), real_text(-y), real_text(y));
  }
};

}  // namespace regista::config
