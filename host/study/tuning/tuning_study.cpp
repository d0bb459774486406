// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_study.hpp"

#include <utility>

#include "study/tuning/match_rounds.hpp"

namespace regista::study {

TuningStudy::TuningStudy(const TuningPlan& plan, OutOfTime out_of_time)
    : plan_(plan), out_of_time_(std::move(out_of_time)), record_(plan) {}

void TuningStudy::run(const PlayRound& play) { tune(plan_, {in_rounds(play, counted_), out_of_time_}, record_); }

}  // namespace regista::study
