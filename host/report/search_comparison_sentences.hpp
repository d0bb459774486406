// SPDX-License-Identifier: MIT
// What a comparison of search algorithms is, and what came of it, in sentences for a terminal and for a page. They
// order the algorithms, and never say that one is the better one.
#pragma once

#include <string>
#include <vector>

#include "report/search_comparison.hpp"

namespace regista::report {

// "weights: 3 parameters of paper.yaml, goal_difference as large as possible, by 2 algorithms"
std::string comparison_title(const SearchComparisonView& view);

// "Not at its end: ..."; empty where all is done.
std::string unfinished_sentence(const SearchComparisonView& view);

// What was asked for, by what, with which budget.
std::vector<std::string> setup_sentences(const SearchComparisonView& view);

struct ComparisonVerdict {
  std::string headline;
  std::vector<std::string> beside;  // what is to be known to read it
};
ComparisonVerdict comparison_verdict(const SearchComparisonView& view);

}  // namespace regista::report
