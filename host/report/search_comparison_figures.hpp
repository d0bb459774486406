// SPDX-License-Identifier: MIT
// The figure of a comparison of search algorithms: what the runs of each came to.
#pragma once

#include <string_view>
#include <vector>

#include "report/figure.hpp"
#include "report/search_comparison.hpp"

namespace regista::report {

// "algorithms"; none before a run has been judged.
std::vector<Figure> search_comparison_figures(const SearchComparisonView& view);

// Whether figures of some comparison are called so.
bool is_search_comparison_figure(std::string_view name);

}  // namespace regista::report
