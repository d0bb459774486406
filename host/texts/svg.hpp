// SPDX-License-Identifier: MIT
// Pictures as SVG (https://www.w3.org/TR/SVG2/), made of numbers and words; the one way in which this program writes
// them. Words enter through text(), which escapes them.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "texts/html.hpp"

namespace regista::texts {

// Numbers, and literals of our own.
template <class... Numbers>
Html drawn(fmt::format_string<Numbers...> format, Numbers... numbers) {
  return Html::made_by_us(fmt::vformat(format, fmt::make_format_args(numbers...)));
}

// `attribute`, "class" or "text-anchor", is a literal, and so is its value.
inline Html label(double x, double y, const char* attribute, const char* value, std::string_view words) {
  Html out = drawn(R"(<text x="{:.1f}" y="{:.1f}" {}="{}">)", x, y, attribute, value);
  return out << text(words) << "</text>"_html;
}
inline Html label(double x, double y, const char* classes, std::string_view words) {
  return label(x, y, "class", classes, words);
}

// Turned around its place by so many degrees.
inline Html turned_label(double x, double y, double degrees, const char* attribute, const char* value,
                         std::string_view words) {
  Html out =
      drawn(R"x(<text {}="{}" transform="translate({:.1f} {:.1f}) rotate({:.0f})">)x", attribute, value, x, y, degrees);
  return out << text(words) << "</text>"_html;
}

// The beginning of a picture that is a file of its own: a white sheet. "</svg>" ends it.
inline Html sheet(double width, double height) {
  return drawn(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
               R"(height="{1:.0f}"><rect width="100%" height="100%" fill="#fff"/>)",
               width, height);
}

}  // namespace regista::texts
