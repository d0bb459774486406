// SPDX-License-Identifier: MIT
// The page about a comparison of search algorithms: one HTML file.
#pragma once

#include <string>
#include <vector>

#include "report/page_parts.hpp"
#include "report/search_comparison.hpp"
#include "report/tuning_page_parts.hpp"

namespace regista::report {

struct SearchComparisonPage {
  SearchComparisonView view;
  std::vector<PageFigure> figures;
  PlayedBy played;
};

std::string search_comparison_page(const SearchComparisonPage& page);

}  // namespace regista::report
