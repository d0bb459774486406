// SPDX-License-Identifier: MIT
// Uniformly drawn points, all compared with each other: what every other search has to beat.
#pragma once

#include "study/tuning/inquiry.hpp"

namespace regista::study {

// The start, then points drawn from the whole cube, all on the pairs of number 0. Recommends the best by the mean of
// their values.
SearchResult random_search(const SearchSettings& settings, Inquiry& inquiry);

}  // namespace regista::study
