// SPDX-License-Identifier: MIT
// A figure: its data as a table, for other ways to draw them, and as a chart, which is drawn here.
//
// Colours: M. Okabe and K. Ito, "Color Universal Design", 2008, which people with any colour vision can tell apart.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "report/chart.hpp"
#include "report/html.hpp"
#include "study/paired_estimates.hpp"

namespace regista::report {

struct Figure {
  std::string name{};         // of its files: letters, digits and _ alone
  std::string title{};        // what is seen, in one line
  std::string description{};  // what a reader needs to understand it; also for those who cannot see it
  std::string csv{};          // with a line of names; every line ended
  Chart chart{};
};

// Of series 0, 1, ...: the page shows them in the shades that its background wants (page_style.hpp).
inline constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
inline constexpr std::size_t black = 6, grey = 7;  // of these
Shape shape_of(std::size_t series);                // so that series can be told apart without colours, too

// Page: a part of a page, in the colours and letters of that one. File: one of its own, on white.
enum class Look { page, file };
Html svg(const Figure& figure, Look look);

// --- What figures are made with --------------------------------------------------------------------------------------

inline constexpr double page_width = 1130.0;  // of a chart as wide as the page

// "slice_12" is of "slice_".
bool is_numbered(std::string_view name, std::string_view prefix);

// The text of a user within a title of an axis: not too long to be drawn. Names of rows and series are cut short where
// they are drawn, to `longest_name` characters.
std::string in_title(std::string_view text);
inline constexpr std::size_t longest_name = 32;

// The name of a series made of the text of a user and a few words, such as " wins": the text is cut short so far that
// the words are drawn in full.
std::string name_with(std::string_view text, std::string_view words);

// The text of a user as a field of a figure's table: in one line, and without quotes, because gnuplot 5.4, with which
// many draw such tables, drops the line of a field that has some.
std::string figure_field(std::string_view text);
std::string figure_field(double number);  // empty where there is none

// "mean,low,high" as fields, as a point over `x`, and as one in a row; without an interval both ends are the mean.
std::string mean_fields(const study::MeanEstimate& mean);
Point mean_over(double x, const study::MeanEstimate& mean);
Point mean_in_row(double row, const study::MeanEstimate& mean);
void take(Range& range, const study::MeanEstimate& mean);  // with its interval

}  // namespace regista::report
