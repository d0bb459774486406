// SPDX-License-Identifier: MIT
#include "study/tuning/match_rounds.hpp"

#include <optional>

namespace regista::study {

PlayMatches in_rounds(const PlayRound& play, std::uint64_t& counted) {
  return [&play, &counted](const MatchList& list, const TakeMatch& take) {
    Round round;
    round.matches = list.matches.size();
    round.first_row = list.first_row;
    round.fixtures = list.fixtures;
    round.at = [&list](std::uint64_t index) -> std::optional<Round::Place> {
      return Round::Place{list.matches[index].fixture, list.matches[index].seed};
    };
    round.job = [&list](std::uint64_t index) { return list.job(index); };
    round.take = [&take, &counted](std::uint64_t index, const campaign::Decided* decided) {
      ++counted;
      return take(index, *decided);
    };
    // Candidates differ in numbers alone: the first match of all speaks for them.
    round.first_of_pairing = [&list](std::uint64_t index) { return list.first_row + index == 0; };
    play(round);
  };
}

}  // namespace regista::study
