// SPDX-License-Identifier: MIT
// p-values of several comparisons, adjusted so that each may be compared with the level as if it were the only one.
#pragma once

#include <span>
#include <vector>

namespace regista::statistics {

// Both: p-values of [0, 1] in any order; result in the same order, of [0, 1]; ties stay ties.

// Against any false rejection at all. S. Holm, "A Simple Sequentially Rejective Multiple Test Procedure", Scandinavian
// Journal of Statistics 6, 1979.
std::vector<double> holm(std::span<const double> p);

// Against too large a share of false ones among the rejections, for independent or positively dependent tests.
// Y. Benjamini and Y. Hochberg, "Controlling the False Discovery Rate", Journal of the Royal Statistical Society B 57,
// 1995.
std::vector<double> benjamini_hochberg(std::span<const double> p);

}  // namespace regista::statistics
