// SPDX-License-Identifier: MIT
// Draws figures with gnuplot (http://www.gnuplot.info), a process for each, in a folder of its own that is gone
// afterwards. Without gnuplot there is no picture, and a reason.
#pragma once

#include <string>

#include "report/figure.hpp"

namespace regista::report {

struct Drawing {
  Figure figure;
  std::string svg;      // as gnuplot wrote it; empty: there is none
  std::string png;      // bytes; empty where it was not wanted
  std::string why_not;  // one line; empty where it is drawn
  bool no_gnuplot = false;
};

enum class Png { wanted, left_out };

// What the user's own settings of gnuplot say does not count. What goes wrong stands in `why_not`.
Drawing draw(Figure figure, Png png);

}  // namespace regista::report
