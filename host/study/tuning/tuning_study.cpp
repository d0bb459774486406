// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_study.hpp"

#include <algorithm>
#include <utility>

#include "study/measure.hpp"

namespace regista::study {

TuningStudy::TuningStudy(const TuningPlan& plan, std::function<bool(std::uint64_t evaluations)> out_of_time)
    : plan_(plan), out_of_time_(std::move(out_of_time)), record_(plan) {}

std::uint64_t TuningStudy::most_matches() const { return study::most_matches(plan_); }

campaign::Metrics TuningStudy::metrics() const {
  const auto of_score = [](const ObjectiveTerm& each) {
    return std::ranges::find(measures_of_score, each.measure) != measures_of_score.end();
  };
  const bool of_scores = std::ranges::all_of(plan_.objective.terms, of_score);
  return of_scores && !plan_.short_games() ? campaign::Metrics::left_out : campaign::Metrics::wanted;  // for packets
}

void TuningStudy::run(const PlayRound& play) {
  TuningHooks hooks;
  hooks.out_of_time = out_of_time_;
  hooks.play = [this, &play](const MatchList& list, const TakeMatch& take) {
    Round round;
    round.matches = list.matches.size();
    round.first_row = list.first_row;
    round.fixtures = list.fixtures;
    round.at = [&list](std::uint64_t index) -> std::optional<Round::Place> {
      return Round::Place{list.matches[index].fixture, list.matches[index].seed};
    };
    round.job = [&list](std::uint64_t index) { return list.job(index); };
    round.take = [this, &take](std::uint64_t index, const campaign::Decided* decided) {
      ++counted_;
      return take(index, *decided);  // all matches are wanted
    };
    // Candidates differ in numbers alone: the first match of all speaks for them.
    round.first_of_pairing = [&list](std::uint64_t index) { return list.first_row + index == 0; };
    play(round);
  };
  tune(plan_, hooks, record_);
}

}  // namespace regista::study
