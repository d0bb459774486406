// SPDX-License-Identifier: MIT
#include "statistics/moments.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace regista::statistics {
namespace {

// Miles per gallon of 32 cars (Motor Trend, 1974), the data set "mtcars" of R, whose summary() gives by type 7
// 10.40, 15.43, 19.20, 22.80, 33.90.
TEST(Quantile, OfAPublishedSample) {
  const std::vector<double> cars{21.0, 21.0, 22.8, 21.4, 18.7, 18.1, 14.3, 24.4, 22.8, 19.2, 17.8,
                                 16.4, 17.3, 15.2, 10.4, 10.4, 14.7, 32.4, 30.4, 33.9, 21.5, 15.5,
                                 15.2, 13.3, 19.2, 27.3, 26.0, 30.4, 15.8, 19.7, 15.0, 21.4};
  EXPECT_NEAR(quantile(cars, 0.25), 15.425, 1e-12);
  EXPECT_NEAR(quantile(cars, 0.5), 19.2, 1e-12);
  EXPECT_NEAR(quantile(cars, 0.75), 22.8, 1e-12);
  EXPECT_EQ(quantile(cars, 0.0), 10.4);
  EXPECT_EQ(quantile(cars, 1.0), 33.9);
}

// The k-th of n ordered values stands at (k - 1)/(n - 1).
TEST(Quantile, IsLinearBetweenOrderedValues) {
  const std::vector<double> nine{9, 1, 8, 2, 7, 3, 6, 4, 5};
  for (int i = 0; i <= 10; ++i) EXPECT_NEAR(quantile(nine, 0.1 * i), 1.0 + 0.8 * i, 1e-12);
}

TEST(Quantile, OfOneAndOfTwo) {
  const std::vector<double> one{3.5}, two{2.0, 0.0};
  EXPECT_EQ(quantile(one, 0.25), 3.5);
  EXPECT_EQ(quantile(one, 0.75), 3.5);
  EXPECT_EQ(quantile(two, 0.25), 0.5);
  EXPECT_EQ(quantile(two, 0.5), 1.0);
  EXPECT_EQ(quantile(two, 0.75), 1.5);
}

}  // namespace
}  // namespace regista::statistics
