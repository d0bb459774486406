// SPDX-License-Identifier: MIT
// A figure before it is drawn: its data as a table, and the commands for gnuplot that draw it from that table. Whoever
// has both files gets the picture again, or changes it for a publication.
//
// Colours: M. Okabe and K. Ito, "Color Universal Design", 2008, which people with any colour vision can tell apart.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace regista::report {

struct Figure {
  std::string name;         // of its files, and before every id of its picture: letters, digits and _ alone
  std::string title;        // what is seen, in one line
  std::string description;  // what is to be known to read it; for those who cannot see it, too
  std::string csv;          // with a line of names; every line ended
  std::string commands;     // of gnuplot, for `name`.csv; every line ended
  int width = 620, height = 290;
};

// Of series 0, 1, ...: the page shows them in the shades that its background wants (svg.hpp).
inline constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
inline constexpr std::string_view grid_colour = "#cccccc";

// The text of a user as a string of gnuplot, in quotes: nothing in it is a command, and it is not too long to be
// drawn.
std::string gnuplot_text(std::string_view text);
// The same for a mark of an axis, which gnuplot takes for a format of numbers.
std::string gnuplot_mark(std::string_view text);

// The text of a user as a field of a figure's table: in one line, and without quotes, for gnuplot 5.4 loses the line of
// a field in which there are some.
std::string figure_field(std::string_view text);

// Distance of the marks of an axis from 0 to `end` such that there are at most so many of them beyond 0: 1, 2 or 5
// times a power of ten. The whole one is 1 at least, for what is counted.
double tic_step(double end, int most);
double whole_tic_step(double end, int most);

// The commands for gnuplot that draw a figure as a file beside its table.
enum class Picture { svg, png };
std::string gnuplot_script(const Figure& figure, Picture picture);

}  // namespace regista::report
