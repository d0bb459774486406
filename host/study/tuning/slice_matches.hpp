// SPDX-License-Identifier: MIT
// The matches of the slices: the point that was found, and each of its parameters at other values by itself, all on the
// same pairs.
#pragma once

#include <vector>

#include "study/tuning/match_tally.hpp"
#include "study/tuning/slices.hpp"

namespace regista::study {

// One for each free parameter, the largest importance first; none where the plan wants none. Throws what the source's
// `play` throws.
std::vector<Slice> slices_around(const MatchSource& source, const ParameterValues& tuned);

}  // namespace regista::study
