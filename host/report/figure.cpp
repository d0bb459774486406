// SPDX-License-Identifier: MIT
#include "report/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "report/number.hpp"
#include "texts/message.hpp"

// Computes the ranges of axes, the ticks of axes, and the room for texts.
namespace regista::report {
namespace {

constexpr double letter = 8.2, wide_letter = 14.0;  // widths of characters in charts, in units of the picture
constexpr double between_texts = 12.0, between_lines = 24.0;
constexpr double farthest = 100.0;  // limit for the number of steps, against an endless loop; no axis has so many steps

// Formats a tick with enough decimals to distinguish it from the next tick.
std::string number(double value, double step) {
  const int decimals = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  if (value == 0.0) return "0";
  if (std::abs(value) < 1e6 && decimals <= 5) return fmt::format("{:.{}f}", value, std::max(decimals, 0));
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9)) + 1;
  return fmt::format("{:.{}g}", value, std::clamp(before + decimals, 1, 17));
}

std::vector<Tick> linear_ticks(const Range& range, double step) {
  std::vector<Tick> out;
  const double first = std::ceil(range.low / step - 1e-9), last = std::floor(range.high / step + 1e-9);
  for (double i = 0.0; first + i <= last && i < farthest; ++i) {
    const double at = (first + i) * step + 0.0;  // avoids -0
    out.push_back({at, number(at, step)});
  }
  return out;
}

std::vector<Tick> decades(const Range& range, std::initializer_list<double> digits, int stride) {
  std::vector<Tick> out;
  for (int power = static_cast<int>(std::floor(std::log10(range.low))); power <= std::log10(range.high); ++power) {
    if (power % stride != 0) continue;
    for (const double digit : digits) {
      const double unit = std::pow(10.0, power), at = digit * unit;
      if (at >= range.low * (1.0 - 1e-9) && at <= range.high * (1.0 + 1e-9)) out.push_back({at, number(at, unit)});
    }
  }
  return out;
}

bool apart(const std::vector<Tick>& ticks, const Scale& scale, bool upright) {
  return std::ranges::adjacent_find(ticks, [&](const Tick& one, const Tick& next) {
           const double room = std::abs(scale.at(next.at) - scale.at(one.at));
           return room <
                  (upright ? between_lines : 0.5 * (text_width(one.text) + text_width(next.text)) + between_texts);
         }) == ticks.end();
}

std::size_t next_character(std::string_view text, std::size_t at) {
  do ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80);
  return at;
}

}  // namespace

void Range::take(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

Range Range::with_room() const {
  if (empty()) return {0.0, 1.0};
  // Rounding may make equal values slightly different, so they are treated as one value.
  const double room = high - low > 1e-9 ? 0.06 * (high - low) : std::max(0.5, 0.1 * std::abs(high));
  return {low - room, high + room};
}

double Scale::at(double value) const {
  const auto place = [this](double each) { return logarithmic ? std::log10(each) : each; };
  return begin + (place(value) - place(range.low)) / (place(range.high) - place(range.low)) * (end - begin);
}

double tick_step(double length, int most) {
  if (!(length > 0.0) || !std::isfinite(length)) return 1.0;
  const double least = length / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * power >= least * (1.0 - 1e-9)) return times * power;
  }
  return 10.0 * power;
}

std::vector<Tick> ticks(const Scale& scale, bool whole, bool upright) {
  const Range& range = scale.range;
  // A logarithmic axis that spans less than one power of ten gets linear ticks.
  if (scale.logarithmic && range.low > 0.0 && range.high >= 10.0 * range.low) {
    if (std::vector<Tick> out = decades(range, {1.0, 2.0, 5.0}, 1); apart(out, scale, upright)) return out;
    for (int stride = 1;; ++stride) {
      if (std::vector<Tick> out = decades(range, {1.0}, stride); apart(out, scale, upright)) return out;
    }
  }
  std::vector<Tick> out;
  for (int most = 10; most > 0; --most) {
    const double step = tick_step(range.high - range.low, most);
    std::vector<Tick> fewer = linear_ticks(range, whole ? std::max(1.0, step) : step);
    if (fewer.empty()) break;
    out = std::move(fewer);
    if (apart(out, scale, upright)) return out;
  }
  if (out.size() > 1) out.resize(1);
  return out;
}

// Treats characters of three or more bytes in UTF-8 as wide, because most of them are East Asian.
double text_width(std::string_view text) {
  double out = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0) != 0x80) out += byte >= 0xe3 ? wide_letter : letter;
  }
  return out;
}

std::vector<std::string> in_lines(std::string_view text, double width) {
  const auto broken = [text](double within) {
    std::vector<std::string> out;
    std::string_view rest = text;
    while (text_width(rest) > within) {
      std::size_t fits = next_character(rest, 0), space = 0, sign = 0;
      for (std::size_t end = fits; end < rest.size() && text_width(rest.substr(0, end)) <= within;
           end = next_character(rest, end)) {
        fits = end;
        if (rest[end] == ' ') space = end;
        if (std::string_view("._-/,").find(rest[end - 1]) != std::string_view::npos) sign = end;
      }
      const std::size_t end = space > 0 ? space : sign > 0 ? sign : std::min(fits, rest.size());
      out.emplace_back(rest.substr(0, end));
      rest.remove_prefix(end == space ? end + 1 : end);
    }
    if (!rest.empty()) out.emplace_back(rest);
    return out;
  };
  std::vector<std::string> out = broken(width);
  // Makes the lines narrower while their number stays equal, so that the lines get similar widths.
  while ((width -= letter) > letter) {
    std::vector<std::string> even = broken(width);
    if (even.size() > out.size()) break;
    out = std::move(even);
  }
  return out;
}

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
  constexpr std::size_t dots = 3;  // dots after a cut text
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
  const auto [low, high] = mean.interval.value_or(statistics::Interval{mean.mean, mean.mean});
  return {x, mean.mean, low, high};
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
