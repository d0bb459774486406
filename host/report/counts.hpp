// SPDX-License-Identifier: MIT
// What counts of games or pairs say, wherever they come from: the sequential probability ratio test on scores, and
// strengths with their intervals.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/likelihood_ratio.hpp"
#include "statistics/rating.hpp"
#include "statistics/sequential_test.hpp"

namespace regista::report {

struct SequentialTestOfCounts {
  std::vector<statistics::Count> counts;
  std::string model;
  statistics::SequentialDesign design;
  statistics::SequentialBounds bounds;
  statistics::LogLikelihoodRatio ratio;
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  double superiority;
  std::optional<double> pair_ratio;
};

// counts: five of pairs (LL, LD, WL and DD, WD, WW) or three of games (L, D, W), of the first team; one at least is not
// zero. model: its name.
SequentialTestOfCounts test_counts(const std::vector<statistics::Count>& counts, const std::string& model,
                                   const statistics::SequentialDesign& design);

// Lines, each ended; one JSON object with a newline.
std::string counts_text(const SequentialTestOfCounts& test);
std::string counts_json(const SequentialTestOfCounts& test);

}  // namespace regista::report
