// SPDX-License-Identifier: MIT
// The derivative-free algorithms of NLopt (S. G. Johnson) that are worth having on noisy values, made safe: exceptions
// pass through, its random state is seeded, its idea of the result is not believed.
#pragma once

#include "study/tuning/inquiry.hpp"

namespace regista::study {

// One of sbplx, bobyqa, nelder_mead, cobyla, direct_l (all questions of number 0) and crs2_lm, isres, esch (a number
// for each generation; of crs2_lm, which has none, for as many points as its population). Recommends the points of the
// best mean values; of those with generations, whose points have a single value each, the best 200 of them are put in
// order by the mean value of their neighbours (study/tuning/neighbours.hpp). May be called by several threads at once.
SearchResult nlopt_search(Algorithm algorithm, const SearchSettings& settings, Inquiry& inquiry);

}  // namespace regista::study
