// SPDX-License-Identifier: MIT
// The numbers that a report shows of a comparison of search algorithms, worked out once for its text, its JSON, its
// figure and its page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "report/search_comparison.hpp"
#include "statistics/quantile.hpp"

namespace regista::report {

// Matches that the report rests on: of the runs that have come to their end, and of the judging once it has.
std::uint64_t searched_matches(const SearchComparisonView& view);
std::uint64_t judged_matches(const SearchComparisonView& view);

// How an algorithm did over its runs.
struct AlgorithmSummary {
  study::Algorithm algorithm = study::Algorithm::sbplx;
  std::vector<const study::ComparedRun*> runs;      // by repeat
  statistics::Quartiles evaluations{}, matches{};   // of a run
  std::size_t judged = 0;                           // runs that were, with a pair or more
  std::optional<statistics::Quartiles> difference;  // less the base team's; of those that were judged
  std::size_t better = 0;                           // of them, whose mean is better than the base team's
};
// In the plan's order; those without a run are there, too.
std::vector<AlgorithmSummary> algorithm_summaries(const SearchComparisonView& view);

}  // namespace regista::report
