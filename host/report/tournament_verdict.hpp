// SPDX-License-Identifier: MIT
// What came out, as a sentence for somebody who knows football but no statistics, and the sentences that it needs
// beside it lest it say too much.
#pragma once

#include <string>
#include <vector>

#include "report/sentence.hpp"
#include "report/tournament.hpp"

namespace regista::report {

struct TournamentVerdict {
  Sentence sentence;
  std::vector<Sentence> beside;  // what it rests on, and what it does not say
};

// "Stronger", "weaker" are said of a test that was fixed beforehand and is at its end: a sequential test at its
// verdict, or for a fixed number of pairs the sign-flip test at 5 %, adjusted by Holm for the number of pairings. The
// interval of Elo stands beside it only where interval_use() (elo_interval.hpp) lets it.
TournamentVerdict tournament_verdict(const TournamentView& view);

// Of a study that was given more pairs after it was begun. before: those that it had.
std::string more_pairs_sentence(const std::string& before);

}  // namespace regista::report
