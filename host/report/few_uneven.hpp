// SPDX-License-Identifier: MIT
// What is said where nearly all pairs ended even: the test and the spread that normalised Elo divides by rest on the
// few that did not. Of games, uneven means decided.
#pragma once

#include <string>

#include "statistics/score_law.hpp"

namespace regista::report {

// Why normalised Elo has no interval, as a sentence; "" where it has one.
std::string why_no_interval(const statistics::ScoreLaw& law);

// What a test of scores rests on, as a sentence: of even pairs alone, or of fewer than statistics::fewest_uneven uneven
// ones; else "".
std::string what_the_test_rests_on(const statistics::ScoreLaw& law);

// Why a team of a ranking may have an Elo and no margin, as a sentence.
std::string no_margin_of_team();

}  // namespace regista::report
