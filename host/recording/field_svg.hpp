// SPDX-License-Identifier: MIT
// What pictures of the field share: its lines, and where a place of it lies.
#pragma once

#include "config/rules.hpp"
#include "texts/svg.hpp"

namespace regista::recording::picture {

using texts::drawn;
using texts::Html;
using texts::label;
using texts::Markup;
using texts::sheet;
using texts::text;
using texts::turned_label;
using texts::operator""_html;

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
