// SPDX-License-Identifier: MIT
#include "report/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/csv_text.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

constexpr std::size_t longest_text = 32;  // characters
constexpr int png_scale = 2;              // pixels for each unit of a figure

std::string terminal(const Figure& figure, Picture picture) {
  if (picture == Picture::svg) {
    return fmt::format("set terminal svg size {},{} noenhanced font 'sans-serif,14' name '{}' background '#ffffff'",
                       figure.width, figure.height, figure.name);
  }
  return fmt::format(
      "set terminal pngcairo size {},{} noenhanced font 'sans-serif,10.5' fontscale {} linewidth {} pointscale {}",
      png_scale * figure.width, png_scale * figure.height, png_scale, png_scale, png_scale);
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string out = "'";
  const std::string shown = texts::visible_at_most(text, longest_text);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    // Nothing is special within these quotes but their like. Two of them should mean one, but at the beginning of a
    // string gnuplot 5.4 takes them for its end; so there is none: it is drawn as U+2019.
    if (shown[i] == '\'')
      out += "\u2019";
    else
      out += shown[i];
    // SVG would take "&#65;" for a letter.
    if (shown[i] == '&' && i + 1 < shown.size() && shown[i + 1] == '#') out += ' ';
  }
  return out + '\'';
}

std::string gnuplot_mark(std::string_view text) {
  std::string out;
  for (const char c : gnuplot_text(text)) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out;
}

std::string figure_field(std::string_view text) {
  std::string out;
  for (const char c : texts::visible(text)) out += c == '"' ? std::string("\u201d") : std::string(1, c);
  return csv_field(out);
}

double tic_step(double end, int most) {
  if (!(end > 0.0) || !std::isfinite(end)) return 1.0;
  const double least = end / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * power >= least * (1.0 - 1e-9)) return times * power;
  }
  return 10.0 * power;
}

double whole_tic_step(double end, int most) { return std::max(1.0, tic_step(end, most)); }

std::string gnuplot_script(const Figure& figure, Picture picture) {
  return fmt::format(
      "# {0}. Draws {1}.{2} from {1}.csv: gnuplot {1}.gnuplot\n"
      "set encoding utf8\n"
      "{3}\n"
      "set output '{1}.{2}'\n"
      "set datafile separator ','\n"
      "set datafile columnheaders\n"
      "set border 3 lc rgb '#000000' lw 0.7\n"
      "set tics nomirror scale 0.5\n"
      "set grid ytics lt 1 lc rgb '{4}' lw 0.7\n"
      "set key top right noopaque samplen 2\n"
      "{5}",
      figure.title, figure.name, picture == Picture::svg ? "svg" : "png", terminal(figure, picture), grid_colour,
      figure.commands);
}

}  // namespace regista::report
