// SPDX-License-Identifier: MIT
#include "statistics/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace regista::statistics {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
using Table = std::vector<std::vector<double>>;  // by treatment, then block

// D. C. Montgomery, "Design and Analysis of Experiments", randomised complete blocks: the yield of vascular grafts by
// extrusion pressure, in six batches of resin.
TEST(AnalysisOfVariance, VascularGrafts) {
  const Table yields{{90.3, 89.2, 98.2, 93.9, 87.4, 97.9},
                     {92.5, 89.5, 90.6, 94.7, 87.0, 95.8},
                     {85.5, 90.8, 89.6, 86.2, 88.0, 93.4},
                     {82.5, 89.5, 85.6, 87.4, 78.9, 90.7}};
  const auto found = two_way_analysis(yields);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->f, 8.11, 0.005);
  EXPECT_NEAR(found->p, 0.0019, 0.00005);
  EXPECT_NEAR(found->variance_of_rows, (59.39 - 7.33) / 6.0, 0.005);
}

// The same book: hardness by four tips, on four specimens of metal, coded.
TEST(AnalysisOfVariance, HardnessTips) {
  const Table hardness{{-2, -1, 1, 5}, {-1, -2, 3, 4}, {-3, -1, 0, 2}, {2, 1, 5, 7}};
  const auto found = two_way_analysis(hardness);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->f, 14.44, 0.005);
  EXPECT_NEAR(found->p, 0.0009, 0.00005);
  EXPECT_NEAR(found->variance_of_rows, (12.83 - 0.89) / 4.0, 0.005);
}

// Of two treatments it is the paired t test: F is the square of t, and p the same.
TEST(AnalysisOfVariance, TwoTreatmentsAreAPairedTest) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 50; ++round) {
    Table values(2);
    const int blocks = 2 + round;
    double sum = 0.0, squares = 0.0;
    for (int block = 0; block < blocks; ++block) {
      const double shared = 10.0 * normal(random), first = shared + normal(random), second = shared + normal(random);
      values[0].push_back(first);
      values[1].push_back(second);
      sum += first - second;
      squares += (first - second) * (first - second);
    }
    const double mean = sum / blocks, variance = (squares - blocks * mean * mean) / (blocks - 1);
    const double t = mean / std::sqrt(variance / blocks);
    const auto found = two_way_analysis(values);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->f / (t * t), 1.0, 1e-6);
    EXPECT_NEAR(found->p, student_t_outside(t, blocks - 1.0), 1e-7);
    EXPECT_NEAR(found->variance_of_rows, std::max(0.0, (mean * mean - variance / blocks) / 2.0), 1e-9);
  }
}

// What the blocks have in common is nothing to the treatments, nor is a constant.
TEST(AnalysisOfVariance, BlocksDoNotMatter) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  Table values(4, std::vector<double>(7)), moved = values;
  for (auto& row : values) {
    for (double& each : row) each = normal(random);
  }
  for (std::size_t j = 0; j < 7; ++j) {
    const double shift = 5.0 * normal(random);
    for (std::size_t i = 0; i < 4; ++i) moved[i][j] = values[i][j] + shift;
  }
  const auto plain = two_way_analysis(values), shifted = two_way_analysis(moved);
  ASSERT_TRUE(plain && shifted);
  EXPECT_NEAR(plain->f, shifted->f, 1e-9);
  EXPECT_NEAR(plain->p, shifted->p, 1e-9);
}

TEST(AnalysisOfVariance, ABlockWithoutAValueIsLeftOut) {
  const Table whole{{1, 5, 2, 4}, {2, 4, 4, 6}, {0, 3, 1, 1}};
  Table damaged = whole;
  for (auto& row : damaged) row.insert(row.begin() + 1, 100.0);
  damaged[1][1] = missing;
  damaged[0].push_back(7.0);  // a block that others do not have
  const auto a = two_way_analysis(whole), b = two_way_analysis(damaged);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->f, b->f);
  EXPECT_EQ(a->p, b->p);
}

TEST(AnalysisOfVariance, TooLittleIsNothing) {
  EXPECT_FALSE(two_way_analysis(Table{}));
  EXPECT_FALSE(two_way_analysis(Table{{1, 2, 3}}));
  EXPECT_FALSE(two_way_analysis(Table{{1}, {2}}));
  EXPECT_FALSE(two_way_analysis(Table{{1, missing}, {2, 3}}));
  EXPECT_FALSE(two_way_analysis(Table{{}, {1, 2}}));
}

// Sums of numbers such as 0.1 are not exact; the difference of their means is no finding all the same.
TEST(AnalysisOfVariance, EqualValuesSayNothing) {
  for (const double value : {0.0, 0.1, 1.0 / 3.0, -1e6 / 7.0}) {
    for (std::size_t rows = 2; rows < 8; ++rows) {
      for (std::size_t blocks = 2; blocks < 12; ++blocks) {
        const auto found = two_way_analysis(Table(rows, std::vector<double>(blocks, value)));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->f, 0.0) << value << ' ' << rows << ' ' << blocks;
        EXPECT_EQ(found->p, 1.0);
        EXPECT_EQ(found->variance_of_rows, 0.0);
      }
    }
  }
}

TEST(AnalysisOfVariance, TreatmentsWithoutAnyResidualAreCertain) {
  Table values(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (int j = 0; j < 7; ++j) values[i].push_back(0.1 * static_cast<double>(i) + 0.7 * j);
  }
  const auto found = two_way_analysis(values);
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::isinf(found->f));
  EXPECT_EQ(found->p, 0.0);
  EXPECT_NEAR(found->variance_of_rows, 0.01, 1e-12);
}

// Under the null p is uniform; the variance of the rows is on average what was put in.
TEST(AnalysisOfVariance, KeepsItsLevelAndFindsTheVariance) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  constexpr int rounds = 4000;
  int rejected = 0, silent = 0;
  double variance = 0.0;
  for (int round = 0; round < rounds; ++round) {
    Table noise(5, std::vector<double>(6)), effects = noise;
    for (std::size_t j = 0; j < 6; ++j) {
      const double block = 3.0 * normal(random);
      for (std::size_t i = 0; i < 5; ++i) {
        noise[i][j] = block + normal(random);
        effects[i][j] = noise[i][j] + 2.0 * static_cast<double>(i);
      }
    }
    const auto null = two_way_analysis(noise);
    rejected += null->p <= 0.05 ? 1 : 0;
    silent += null->variance_of_rows == 0.0 ? 1 : 0;
    variance += two_way_analysis(effects)->variance_of_rows / rounds;
  }
  EXPECT_NEAR(rejected, 0.05 * rounds, 4.0 * std::sqrt(0.05 * 0.95 * rounds));
  EXPECT_GT(silent, rounds / 2);      // F has a median below 1
  EXPECT_NEAR(variance, 10.0, 0.05);  // of 0, 2, 4, 6, 8
}

// Closed forms: with 2 degrees (1 + 2 f / m)^(-m / 2); with 1 Student's t; the reciprocal has the degrees exchanged.
TEST(FisherF, ClosedForms) {
  for (const double m : {1.0, 2.0, 5.0, 12.0, 100.0}) {
    for (const double f : {0.0, 0.01, 0.5, 1.0, 3.7, 40.0, 1000.0}) {
      EXPECT_NEAR(fisher_f_above(f, 2.0, m), std::pow(1.0 + 2.0 * f / m, -m / 2.0), 1e-12);
      EXPECT_NEAR(fisher_f_above(f, 1.0, m), student_t_outside(std::sqrt(f), m), 1e-12);
      if (f == 0.0) continue;
      EXPECT_NEAR(fisher_f_above(f, 3.0, m), 1.0 - fisher_f_above(1.0 / f, m, 3.0), 1e-12);
    }
  }
  // Tables of its upper 5 % and 1 % points.
  EXPECT_NEAR(fisher_f_above(4.9646, 1.0, 10.0), 0.05, 1e-5);
  EXPECT_NEAR(fisher_f_above(3.2874, 3.0, 15.0), 0.05, 1e-5);
  EXPECT_NEAR(fisher_f_above(5.4170, 3.0, 15.0), 0.01, 1e-5);
}

}  // namespace
}  // namespace regista::statistics
