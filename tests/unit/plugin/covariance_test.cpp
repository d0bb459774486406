// SPDX-License-Identifier: MIT
// The check against Eigen's eigenvalues, on random matrices whose rank and signs are known by construction.
#include "plugin/predictor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>

namespace regista::plugin {
namespace {

// The upper triangle, as abi.h packs it.
struct Packed {
  double place[3], rest[7];
  explicit Packed(const Eigen::Matrix4d& m)
      : place{m(0, 0), m(0, 1), m(1, 1)}, rest{m(0, 2), m(0, 3), m(1, 2), m(1, 3), m(2, 2), m(2, 3), m(3, 3)} {}
};

Covariance examine(const Eigen::Matrix4d& matrix) {
  const Packed packed(matrix);
  return examine_covariance(packed.place, packed.rest);
}

Covariance examine_place(const Eigen::Matrix4d& matrix) { return examine_covariance(Packed(matrix).place); }

Eigen::Matrix4d random_matrix(std::mt19937& chance) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::Matrix4d out;
  for (int i = 0; i < 16; ++i) out(i / 4, i % 4) = uniform(chance);
  return out;
}

// Symmetric to the last bit, with these eigenvalues, in units that differ by orders of magnitude.
Eigen::Matrix4d with_eigenvalues(const Eigen::Vector4d& values, std::mt19937& chance) {
  const Eigen::Matrix4d axes = Eigen::HouseholderQR<Eigen::Matrix4d>(random_matrix(chance)).householderQ();
  const Eigen::Vector4d units(1e-3, 1.0, 20.0, 1e3);
  const Eigen::Matrix4d out = units.asDiagonal() * axes * values.asDiagonal() * axes.transpose() * units.asDiagonal();
  return (out + out.transpose()) / 2.0;
}

TEST(ExamineCovariance, AcceptsEveryRank) {
  std::mt19937 chance(1);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.3, 0.02, 1e-4}, chance)), Covariance::valid);
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.3, 0.02, 0.0}, chance)), Covariance::valid);
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.3, 0.0, 0.0}, chance)), Covariance::valid);
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.0, 0.0, 0.0}, chance)), Covariance::valid);
  }
  EXPECT_EQ(examine(Eigen::Matrix4d::Zero()), Covariance::valid);
}

TEST(ExamineCovariance, RefusesEveryNegativeEigenvalue) {
  std::mt19937 chance(2);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.3, 0.02, -1e-3}, chance)), Covariance::not_semi_definite);
    EXPECT_EQ(examine(with_eigenvalues({1.0, 0.3, -0.3, 0.0}, chance)), Covariance::not_semi_definite);
    EXPECT_EQ(examine(with_eigenvalues({-1.0, -0.3, -0.02, -1.0}, chance)), Covariance::not_semi_definite);
  }
}

TEST(ExamineCovariance, AgreesWithEigenvaluesOfArbitraryMatrices) {
  std::mt19937 chance(3);
  int semi_definite = 0, decided = 0;
  for (int i = 0; i < 20000; ++i) {
    Eigen::Matrix4d matrix = random_matrix(chance);
    matrix = (matrix + matrix.transpose()).eval() + 2.0 * Eigen::Matrix4d::Identity();
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(matrix).eigenvalues().minCoeff();
    if (std::abs(least) < 1e-6) continue;
    ++decided;
    semi_definite += least > 0.0 ? 1 : 0;
    EXPECT_EQ(examine(matrix), least > 0.0 ? Covariance::valid : Covariance::not_semi_definite);
  }
  EXPECT_GT(semi_definite, 1000);
  EXPECT_LT(semi_definite, decided - 1000);
}

// Clearly definite implies valid, for matrices on both sides of the border and for every kind of odd entry.
TEST(ExamineCovariance, TheShortCutNeverContradictsTheElimination) {
  std::mt19937 chance(4);
  int short_cuts = 0, short_cuts_of_places = 0;
  for (int i = 0; i < 20000; ++i) {
    Eigen::Matrix4d matrix = random_matrix(chance);
    const double shift = 0.1 * (i % 30);
    matrix =
        std::pow(10.0, i % 300 - 150) * ((matrix + matrix.transpose()).eval() + shift * Eigen::Matrix4d::Identity());
    if (i % 7 == 0) matrix(i % 4, i / 4 % 4) *= std::numeric_limits<double>::infinity();
    if (i % 11 == 0) matrix(i % 4, i / 4 % 4) = std::numeric_limits<double>::quiet_NaN();
    if (i % 13 == 0) matrix.rightCols<2>() *= 0.0;  // what stands still
    matrix = matrix.selfadjointView<Eigen::Upper>();
    const Packed packed(matrix);
    if (clearly_definite(packed.place)) {
      ++short_cuts_of_places;
      const double place[4] = {matrix(0, 0), matrix(0, 1), matrix(1, 0), matrix(1, 1)};
      EXPECT_EQ(examine_covariance_by_elimination<2>(place), Covariance::valid);
    }
    if (!clearly_definite(packed.place, packed.rest)) continue;
    ++short_cuts;
    double raw[16];
    for (int k = 0; k < 16; ++k) raw[k] = matrix(k / 4, k % 4);
    EXPECT_EQ(examine_covariance_by_elimination<4>(raw), Covariance::valid);
  }
  EXPECT_GT(short_cuts, 500);
  EXPECT_GT(short_cuts_of_places, 2000);
}

TEST(ExamineCovariance, RefusesWhatIsBelowAZeroPivot) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(1, 1) = 0.0;
  EXPECT_EQ(examine(matrix), Covariance::valid);
  matrix(1, 2) = matrix(2, 1) = 0.1;
  EXPECT_EQ(examine(matrix), Covariance::not_semi_definite);
}

// Truth: of two by two the determinant tells it.
TEST(ExamineCovariance, OfAPlaceAlone) {
  std::mt19937 chance(5);
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix4d matrix = random_matrix(chance);
    matrix(0, 0) = std::abs(matrix(0, 0)) + 1e-3;
    matrix(1, 1) = 1e6 * std::abs(matrix(1, 1)) + 1e-3;
    const double border = std::sqrt(matrix(0, 0) * matrix(1, 1));
    matrix(0, 1) = 0.999 * border;
    EXPECT_EQ(examine_place(matrix), Covariance::valid);
    matrix(0, 1) = -border;
    EXPECT_EQ(examine_place(matrix), Covariance::valid);
    matrix(0, 1) = 1.001 * border;
    EXPECT_EQ(examine_place(matrix), Covariance::not_semi_definite);
    matrix(0, 1) = 0.0;
    matrix(i % 2, i % 2) *= -1.0;
    EXPECT_EQ(examine_place(matrix), Covariance::not_semi_definite);
    matrix(i % 2, i % 2) = 0.0;
    EXPECT_EQ(examine_place(matrix), Covariance::valid);
    matrix(0, 1) = 0.1;
    EXPECT_EQ(examine_place(matrix), Covariance::not_semi_definite);
    matrix(0, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(examine_place(matrix), Covariance::not_finite);
  }
  EXPECT_EQ(examine_place(Eigen::Matrix4d::Zero()), Covariance::valid);
}

TEST(ExamineCovariance, RefusesWhatIsNotFiniteButNotWhatIsLarge) {
  for (int i = 0; i < 16; ++i) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()}) {
      Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
      matrix(i / 4, i % 4) = matrix(i % 4, i / 4) = value;
      EXPECT_EQ(examine(matrix), Covariance::not_finite);
    }
  }
  EXPECT_EQ(examine(1e150 * Eigen::Matrix4d::Identity()), Covariance::valid);
}

}  // namespace
}  // namespace regista::plugin
