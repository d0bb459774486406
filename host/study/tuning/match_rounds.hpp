// SPDX-License-Identifier: MIT
// Lists of matches as rounds of a study: what an engine plays, or a file of results answers.
#pragma once

#include <cstdint>

#include "study/study.hpp"
#include "study/tuning/pair_batch.hpp"

namespace regista::study {

// Every list is a round, all matches of which are wanted. counted: goes up by one with each match that was taken. Both
// outlive what is returned.
PlayMatches in_rounds(const PlayRound& play, std::uint64_t& counted);

}  // namespace regista::study
