// SPDX-License-Identifier: MIT
#include "statistics/analysis_of_variance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace regista::statistics {
namespace {

// Vascular grafts: yield by extrusion pressure in six batches of resin. D. C. Montgomery, "Design and Analysis of
// Experiments", example 4.1: mean squares 59.39 and 7.33, F 8.11, P 0.0019.
TEST(TwoWayAnalysis, OfAPublishedExperiment) {
  const std::vector<std::vector<double>> yield{{90.3, 89.2, 98.2, 93.9, 87.4, 97.9},
                                               {92.5, 89.5, 90.6, 94.7, 87.0, 95.8},
                                               {85.5, 90.8, 89.6, 86.2, 88.0, 93.4},
                                               {82.5, 89.5, 85.6, 87.4, 78.9, 90.7}};
  const auto found = two_way_analysis(yield);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->f, 8.11, 0.005);
  EXPECT_NEAR(found->p, 0.0019, 0.00005);
  EXPECT_NEAR(found->variance_of_rows, (59.39 - 7.33) / 6.0, 0.002);
}

// Sums of such values are rounded, and what rounding leaves must not look like a finding.
TEST(TwoWayAnalysis, TreatmentsThatDoNothingAreEqualToTheLastDigit) {
  for (const std::size_t rows : {2u, 3u, 6u, 10u}) {
    std::vector<double> row;
    for (int i = 0; i < 10; ++i) row.push_back(0.1 * i * i - 1.7 + 1.0 / 3.0);
    const auto found = two_way_analysis(std::vector<std::vector<double>>(rows, row));
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->variance_of_rows, 0.0);
    EXPECT_EQ(found->p, 1.0);
  }
}

TEST(TwoWayAnalysis, WithoutResidualsEveryDifferenceIsOne) {
  const auto found = two_way_analysis(std::vector<std::vector<double>>{{0.1, 0.4, 0.9}, {1.1, 1.4, 1.9}});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->p, 0.0);
  EXPECT_NEAR(found->variance_of_rows, 0.5, 1e-12);
}

TEST(TwoWayAnalysis, OfTooFew) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(two_way_analysis(std::vector<std::vector<double>>{{1.0, 2.0}}).has_value());
  EXPECT_FALSE(two_way_analysis(std::vector<std::vector<double>>{{1.0, none}, {2.0, 3.0}}).has_value());
}

}  // namespace
}  // namespace regista::statistics
