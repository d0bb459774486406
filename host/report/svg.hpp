// SPDX-License-Identifier: MIT
// The picture that gnuplot wrote, as SVG that may be let into a page or given away. It is read as a tree of the few
// elements and attributes that pictures of gnuplot are made of, and written anew: what is not one of these is left out
// or refused, so nothing that another program wrote, or that hides in a name, gets any further. Names and versions of
// programs are left out too: the same data give the same bytes.
#pragma once

#include <string>
#include <string_view>

#include "report/figure.hpp"
#include "report/svg_tree.hpp"

namespace regista::report {

// For a page: no background, text and axes in the colour of the page's text, series in the page's colours (custom
// properties --series-1 ..., --grid), ids with the figure's name before them. Throws StrangePicture.
std::string svg_for_page(std::string_view svg, const Figure& figure);

// A file of its own, on white. Throws StrangePicture.
std::string svg_for_file(std::string_view svg, const Figure& figure);

}  // namespace regista::report
