// SPDX-License-Identifier: MIT
// Evolution strategy with adaptation of a diagonal covariance matrix: R. Ros and N. Hansen, "A Simple Modification in
// CMA-ES Achieving Linear Time and Space Complexity", PPSN 2008; constants of N. Hansen, "The CMA Evolution Strategy: A
// Tutorial", 2016. Against noise it has a large population instead of repeated evaluations.
#pragma once

#include "study/tuning/inquiry.hpp"

namespace regista::study {

// What the publications take without noise: 4 + 3 ln n.
std::uint64_t least_sep_cma_es_population(std::size_t dimensions);

// Its own choice against noise: grows with the square root of the budget, so that twice as many evaluations give more
// of both, points per generation and generations.
std::uint64_t sep_cma_es_population(std::size_t dimensions, std::uint64_t evaluations);

// A generation is one question with a set of pairs of its own. Points beyond the cube are set on its surface, and count
// as drawn there. Recommends the last mean, then the mean of the means of the last quarter and of the last half of the
// generations, then the start.
SearchResult sep_cma_es(const SearchSettings& settings, Inquiry& inquiry);

}  // namespace regista::study
