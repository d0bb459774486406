// SPDX-License-Identifier: MIT
// Estimates and tests of means and differences from pairs of matches. All statistics are over pairs, because the two
// matches of a pair share a seed and are not independent. NaN: a missing value. Means and differences omit NaN.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "study/experiment_plan.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

struct MeanEstimate {
  std::int64_t pairs = 0;                        // number of pairs with a value
  double mean = 0.0, standard_deviation = 0.0;   // mean: 0 without pairs; deviation: 0 for fewer than 2 pairs
  std::optional<statistics::Interval> interval;  // Student's t; nullopt for fewer than 2 pairs or equal values
};

// The mean of the values, one per pair.
MeanEstimate mean_of(std::span<const double> values, double confidence);

// first[i] - second[i]. The shorter list determines the number of pairs.
std::vector<double> paired_differences(std::span<const double> first, std::span<const double> second);

// The method that computed a p-value.
enum class PairMethod {
  student_t,
  sign_flip,             // exact: counts all combinations of signs
  sign_flip_normal_law,  // approximate, for many differences; without continuity correction
};
const char* name(PairMethod method);

struct PairP {
  double p;  // two-sided p-value of the hypothesis "no difference"
  PairMethod by;
};

// Tests the values, one per pair. Returns nullopt for fewer than two values, and p = 1 if all values are 0. Student's t
// is undefined if all values are equal but not 0; the sign-flip test then replaces Student's t.
std::optional<PairP> p_of_values(std::span<const double> values, PairTest test);

// --- The trend of a measure over the values of a sweep: the slope of the straight line that fits the values of a pair
// best (least squares). Each pair gives one slope. A trend's test is a test of the pairs' mean slope. ---

// The values of the sweep as numbers; empty if a value is not a number.
std::vector<double> swept_numbers(const ExperimentPlan& plan);

// Returns whether the plan's arms have trends: the sweep's values are numbers and not all equal. A single arm at two
// values has no trend, because its trend would be the comparison of the two values.
bool has_trends(const ExperimentPlan& plan);

// The weights of the slope: the sum of weight times value is the slope. places: the values of the sweep, not all equal.
std::vector<double> slope_weights(std::span<const double> places);

// --- Pairs that could not be played. A finding must hold for every result that these pairs could have had. Measures
// have no bounds, so one such pair could outweigh all other pairs in a mean. So the program makes two tests:
//   - by size: the plan's test, with the largest or smallest value of all conditions in place of each missing value.
//     The test by size alone is not enough, because the missing values could be more extreme;
//   - by signs, which need no bounds: a test of the signs of pairs, with one sign for all missing pairs.
// The program makes each test twice: with all missing pairs in favour of one side, then in favour of the other side. A
// finding must pass all these tests, and all tests must find the same side. ---

// The values of a measure in one condition, by pair; NaN if a value is missing.
struct PartlyPlayed {
  std::span<const double> values;
  const std::vector<bool>& unplayed;  // by pair: whether a match could not be played
};

// One number per pair: the sum of weight times value over conditions. A difference has the weights 1 and -1; a trend
// has the weights of slope_weights(). The condition with the fewest pairs sets the number of pairs.
struct Contrast {
  std::vector<PartlyPlayed> conditions;
  std::vector<double> weights;  // one per condition
};

// The contrast's number for each pair; NaN if one of the pair's values is missing.
std::vector<double> values_of(const Contrast& contrast);

// The number of pairs that could not be played in one or more conditions.
std::uint64_t unplayed_pairs(const Contrast& contrast);

// The largest two-sided p-value among five tests of the hypothesis that the mean number is 0. One test leaves out the
// unplayed pairs. Two tests by size and two tests by signs count these pairs for either side, see above. Returns 1 if
// the five tests do not all find the same side. If all pairs were played, returns p_of_values() (1 for nullopt).
double p_either_way(const Contrast& contrast, PairTest test);

// --- The differences of one number between each two teams or arms of a study, pair by pair. Their spread tells how
// many pairs the study's test needs (statistics/paired_tests.hpp).

struct ComparedPairs {
  std::string first, second;
  bool equal = false;               // `first` and `second` have the same inputs, byte by byte
  statistics::Moments differences;  // first minus second, for each pair that has a value
};

struct PairDifferences {
  std::string measure, unit;
  std::vector<ComparedPairs> compared;
  std::vector<std::string> known;  // all measures of a match; empty if no match is complete
};

// The differences for each pairing of teams. The difference of a pair is the mean of its two matches. measure: "goals"
// or the path of a metric. The differences are in the unit of this measure. Both overloads throw campaign::StoreError.
PairDifferences pair_differences(const TournamentPlan& plan, const campaign::Store& store, const std::string& measure);
// The differences for each comparison of the experiment, in the unit of the measure (measure.hpp).
PairDifferences pair_differences(const ExperimentPlan& plan, const campaign::Store& store, const std::string& measure);

inline constexpr double usual_difference = 0.5;  // goals a match: what a study is to find unless another is named

// The design of a power calculation: test for a fixed number of pairs, number of comparisons at its level, usual power.
statistics::PowerDesign design_of(const TournamentPlan& plan);
statistics::PowerDesign design_of(const ExperimentPlan& plan);

}  // namespace regista::study
