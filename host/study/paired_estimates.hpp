// SPDX-License-Identifier: MIT
// What the pairs of matches of an experiment say about means and differences. The unit is the pair: its two matches
// share a seed and are not independent. A value that is missing is no number (NaN) and leaves its pair out, of a
// difference from both sides.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "statistics/interval.hpp"
#include "study/experiment_plan.hpp"

namespace regista::study {

struct MeanEstimate {
  std::int64_t pairs = 0;                        // that have a value
  double mean = 0.0, standard_deviation = 0.0;   // of a pair; 0 without pairs, of fewer than two
  std::optional<statistics::Interval> interval;  // Student's t; nothing of fewer than two pairs, or without any spread
};

// Values by pair.
MeanEstimate mean_of(std::span<const double> values, double confidence);

// first less second, pair by pair. As many values in both, or what the shorter one has.
MeanEstimate difference_of(std::span<const double> first, std::span<const double> second, double confidence);

// What a p was worked out by.
enum class PairMethod {
  student_t,
  sign_flip,             // all signs, each counted
  sign_flip_normal_law,  // of too many differences to count all signs of; without continuity correction
};
const char* name(PairMethod method);

struct PairP {
  double p;  // two-sided, of "no difference"
  PairMethod by;
};

// Nothing where fewer than two pairs have both values. 1 where all differences are 0. All differences equal, and not 0,
// have no spread, so Student's t is not defined: then by signs, whatever the test.
std::optional<PairP> p_of_difference(std::span<const double> first, std::span<const double> second, PairTest test);

}  // namespace regista::study
