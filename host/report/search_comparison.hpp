// SPDX-License-Identifier: MIT
// What a comparison of search algorithms found, for people and for programs. Everything here is a function of plan and
// record, so of the inputs: no times, no rates.
#pragma once

#include <string>
#include <vector>

#include "study/tuning/search_comparison.hpp"
#include "study/tuning/search_comparison_plan.hpp"

namespace regista::report {

struct SearchComparisonView {
  const study::SearchComparisonPlan& plan;
  const study::SearchComparisonRecord& record;
};

// How things stand, in a few lines that are shown while it runs: which run, and what the last one saw.
std::string search_comparison_standing(const SearchComparisonView& view);

// The whole report; also of a comparison that was stopped.
std::string search_comparison_text(const SearchComparisonView& view);

// One JSON object with a newline.
std::string search_comparison_json(const SearchComparisonView& view);

// A table with a head and a line for each run.
std::string search_comparison_csv(const SearchComparisonView& view);

// What was asked for, as words of the command line.
std::vector<std::string> search_comparison_arguments(const study::SearchComparisonPlan& plan);

}  // namespace regista::report
