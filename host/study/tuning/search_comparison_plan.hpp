// SPDX-License-Identifier: MIT
// A comparison of search algorithms as it was fixed before its first match: the tuning whose search each of them runs,
// with equal numbers of matches, how often, and how many pairs judge what each run came to.
//
// Seeds are those of a tuning (tuning_plan.hpp): of the search with the number of the repeat, then those of the
// verification, which begin at a number drawn from all that was recommended.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/tuning/algorithm.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

struct SearchComparisonPlan {
  // What is searched, by what budget; verification_pairs: on which every run is judged. Its own algorithm is not run,
  // and it has neither selection nor slices.
  TuningPlan tuning;
  std::vector<Algorithm> algorithms;  // one or more, each once
  std::uint64_t repeats = 1;          // of each of them, with other seeds

  std::uint64_t runs() const { return algorithms.size() * repeats; }
};

// How many matches searching and judging can take at most.
std::uint64_t most_search_matches(const SearchComparisonPlan& plan);
std::uint64_t judging_matches(const SearchComparisonPlan& plan);
std::uint64_t most_matches(const SearchComparisonPlan& plan);

// JSON; reading throws std::invalid_argument for what writing did not make. Results of before hold a comparison as a
// tuning that has a list of algorithms; these are read as well.
std::string to_json(const SearchComparisonPlan& plan);
SearchComparisonPlan search_comparison_plan_from_json(const std::string& text);

// What differs between the plan of a file and the one that is asked for, in words; nothing when they are the same.
std::vector<std::string> differences(const SearchComparisonPlan& before, const SearchComparisonPlan& now);

}  // namespace regista::study
