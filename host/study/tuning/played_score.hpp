// SPDX-License-Identifier: MIT
// What matches said about some values, and what a search is told of that: always a number, also where the values made
// their team forfeit, or no match has a number for the objective.
#pragma once

#include <cstddef>

#include "study/paired_estimates.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// Scores: larger is better, whatever the objective.
struct PlayedScore {
  MeanEstimate score;    // over pairs
  bool failed = false;   // its plugin forfeited a match
  double counted = 0.0;  // what the search was told: the mean, or of a failed one the worst there is
};

// Of a batch's candidate. worst: the least score seen so far; infinite: none was.
PlayedScore played_score(const TuningPlan& plan, const PairBatch& batch, std::size_t candidate, double worst);

// The least of `worst` and all scores of the batch's first candidates.
double worst_of(const PairBatch& batch, std::size_t candidates, double worst);

}  // namespace regista::study
