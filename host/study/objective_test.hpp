// SPDX-License-Identifier: MIT
// The test that decides a tournament, fed pair by pair, whatever it looks at: the scores of pairs, their goals, or the
// sign of the difference of a metric.
//
// It is fed three times where pairs could not be played, because nobody can be blamed for the deaths over a match of
// them: without these pairs, and with all of them counted for either team. A verdict that all three reach is the one
// that would have come out had the team gained by these pairs all that can be gained, or lost as much. So nobody gains
// by a match that cannot be played.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "statistics/betting.hpp"
#include "statistics/betting_grid.hpp"
#include "statistics/counts.hpp"
#include "statistics/sequential_test.hpp"

namespace regista::study {

// A pair of matches, from the first team's point of view.
struct PairResult {
  statistics::PairOutcome outcome = statistics::PairOutcome::even;
  double goals = 0.0;       // mean difference of a match, within the bounds of the test
  std::optional<int> sign;  // of the difference of the metric; nothing where a match has no such number
};

// All that a pair can bring one team. As a difference of signs that is the whole of what the test of a metric looks at,
// so it needs no bounds of the metric itself.
PairResult all_for_second(double most_goals);
PairResult all_for_first(double most_goals);

// What a test has found: nothing yet; of scores H0 or H1; of values which team's are the larger.
enum class Found { open, h0, h1, first_more, second_more };

using ScoreSequence = statistics::SequentialTest<statistics::PairCounts>;
using ObjectiveTest = std::variant<ScoreSequence, statistics::BettingGrid, statistics::BettingTest>;

void add(ObjectiveTest& test, const PairResult& pair);

Found found_by(const ScoreSequence& test);
Found found_by(const statistics::BettingGrid& goals);
Found found_by(const statistics::BettingTest& signs);
Found found_by(const ObjectiveTest& test);

}  // namespace regista::study
