// SPDX-License-Identifier: MIT
// What pictures of the field share: its lines, and numbers and words as SVG.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "config/rules.hpp"
#include "texts/html.hpp"

namespace regista::recording::picture {

using texts::Html;
using texts::Markup;
using texts::text;
using texts::operator""_html;

// Numbers, and literals of our own.
template <class... Numbers>
Html drawn(fmt::format_string<Numbers...> format, Numbers... numbers) {
  return Html::made_by_us(fmt::vformat(format, fmt::make_format_args(numbers...)));
}

Html label(double x, double y, const char* classes, std::string_view words);

// From metres of the field, y up, to the picture, y down.
struct Scale {
  double left, top, per_metre;
  double half_length, half_width;  // with the border

  double x(double metres) const { return left + (metres + half_length) * per_metre; }
  double y(double metres) const { return top + (half_width - metres) * per_metre; }
};

// Classes: grass, line.
Html field_lines(const config::FieldSize& field, const Scale& to);

}  // namespace regista::recording::picture
