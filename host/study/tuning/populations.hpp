// SPDX-License-Identifier: MIT
// How many points make a generation. Those of NLopt 2.7.1 are its own defaults, named here because the points of one
// generation play the same pairs of matches.
#pragma once

#include <cstddef>
#include <cstdint>

#include "study/tuning/algorithm.hpp"

namespace regista::study {

// Of an algorithm with population, as many as it is given; 0: its own. Of sep_cma_es, whose own depends on the budget,
// the least that it takes.
std::uint64_t first_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population);

// The generations after it.
std::uint64_t later_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population);

}  // namespace regista::study
