// SPDX-License-Identifier: MIT
#include "report/figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/csv_text.hpp"
#include "texts/visible.hpp"

namespace regista::report {

Shape shape_of(std::size_t series) {
  constexpr std::array shapes{Shape::circle, Shape::triangle, Shape::square, Shape::diamond, Shape::cross};
  return shapes[series % shapes.size()];
}

bool is_numbered(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return false;
  const std::string_view number = name.substr(prefix.size());
  return !number.empty() && number.size() <= 3 && number.find_first_not_of("0123456789") == number.npos;
}

std::string in_title(std::string_view text) { return texts::visible_at_most(text, longest_name); }

std::string name_with(std::string_view text, std::string_view words) {
  constexpr std::size_t dots = 3;  // that follow what is cut
  const std::size_t room = longest_name - words.size();
  std::string name = texts::visible(text);
  if (texts::visible_at_most(name, room) != name) name = texts::visible_at_most(name, room - dots);
  return name += words;
}

std::string figure_field(std::string_view text) {
  std::string out;
  for (const char c : texts::visible(text)) out += c == '"' ? std::string("\u201d") : std::string(1, c);
  return csv_field(out);
}

std::string figure_field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : std::string(); }

Point mean_over(double x, const study::MeanEstimate& mean) {
  if (mean.pairs == 0) return {x, unknown};
  return {x, mean.mean, mean.interval ? mean.interval->low : mean.mean,
          mean.interval ? mean.interval->high : mean.mean};
}

Point mean_in_row(double row, const study::MeanEstimate& mean) {
  const Point over = mean_over(row, mean);
  return {over.y, row, over.low, over.high};
}

std::string mean_fields(const study::MeanEstimate& mean) {
  const Point point = mean_over(0.0, mean);
  return figure_field(point.y) + ',' + figure_field(point.low) + ',' + figure_field(point.high);
}

void take(Range& range, const study::MeanEstimate& mean) {
  const Point point = mean_over(0.0, mean);
  for (const double each : {point.y, point.low, point.high}) range.take(each);
}

}  // namespace regista::report
