// SPDX-License-Identifier: MIT
#include "study/prediction/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace regista::study {
namespace {

TEST(ErrorRatios, IsTheRatioOfTheQuantiles) {
  std::vector<PairedError> errors;
  for (std::size_t i = 1; i <= 10; ++i) {
    const auto error = static_cast<double>(i);
    errors.push_back({i, 2.0 * error, error});
  }
  const ErrorRatios found = error_ratios(errors);
  for (const ErrorRatio& each : {found.median, found.ninetieth}) {
    EXPECT_DOUBLE_EQ(each.value, 2.0);
    EXPECT_DOUBLE_EQ(each.low, 2.0) << "each pair has this ratio, whatever is drawn";
    EXPECT_DOUBLE_EQ(each.high, 2.0);
  }
}

// Errors of a block share a factor. The interval must cover the true ratio about as often as it says, which one that
// takes every error for a draw of its own does not.
TEST(ErrorRatios, IntervalsCoverWhereBlocksShareTheirErrors) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const int studies = 120, blocks = 40, size = 8;
  int covered = 0, covered_alone = 0;
  for (int s = 0; s < studies; ++s) {
    std::vector<PairedError> together, alone;
    for (std::size_t block = 0; block < blocks; ++block) {
      const double predictor = std::exp(0.5 * normal(random)), baseline = std::exp(0.5 * normal(random));
      for (std::size_t i = 0; i < size; ++i) {
        const double a = predictor * std::exp(0.2 * normal(random)), b = baseline * std::exp(0.2 * normal(random));
        together.push_back({block, a, b});
        alone.push_back({block * size + i, a, b});
      }
    }
    const auto covers = [](const ErrorRatio& each) { return each.low <= 1.0 && 1.0 <= each.high; };
    covered += covers(error_ratios(together).median);
    covered_alone += covers(error_ratios(alone).median);
  }
  // Binomial: 114 expected, standard deviation 2.4.
  EXPECT_GE(covered, 107);
  EXPECT_LT(covered_alone, 90);
}

}  // namespace
}  // namespace regista::study
