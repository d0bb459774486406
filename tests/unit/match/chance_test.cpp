// SPDX-License-Identifier: MIT
// Streams of chance against the published vectors of Philox, and against the moments of their laws.
#include "match/chance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace regista::match {
namespace {

// Random123, kat_vectors: philox4x32, 10 rounds, counter 0, key 0.
TEST(Chance, IsPhiloxOfTheNamedCounter) {
  Chance chance(0, Purpose::kick, Side::home, 0, 0, 0);
  const std::array<std::uint32_t, 4> words{chance.bits(), chance.bits(), chance.bits(), chance.bits()};
  EXPECT_EQ(words, (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Chance, EveryPartOfTheNameMakesAnotherStream) {
  std::set<std::uint64_t> first;
  int streams = 0;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32}) {
    for (const Purpose purpose : {Purpose::kick, Purpose::fall, Purpose::radio_loss}) {
      for (const Side side : both_sides) {
        for (const auto& [observer, object, tick] : {std::tuple{0, 0, 0u}, {1, 0, 0u}, {0, 1, 0u}, {0, 0, 1u}}) {
          Chance chance(seed, purpose, side, observer, object, tick);
          const std::uint64_t high = chance.bits();
          first.insert(high << 32 | chance.bits());
          ++streams;
        }
      }
    }
  }
  EXPECT_EQ(first.size(), static_cast<std::size_t>(streams));
}

TEST(Chance, DrawsInOneStreamDoNotShiftAnother) {
  Chance alone(7, Purpose::ball, Side::home, 1, 0, 5);
  const double wanted = alone.uniform();
  Chance other(7, Purpose::robot, Side::home, 1, 0, 5), again(7, Purpose::ball, Side::home, 1, 0, 5);
  for (int i = 0; i < 1000; ++i) other.normal();
  EXPECT_EQ(again.uniform(), wanted);
}

struct Moments {
  double mean = 0.0, variance = 0.0, kurtosis = 0.0, least = 1e9, largest = -1e9;
};

template <class Draw>
Moments moments(Draw draw) {
  constexpr int count = 400000;
  double sum = 0.0, squares = 0.0, fourths = 0.0;
  Moments out;
  for (int i = 0; i < count; ++i) {
    const double x = draw();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    out.least = std::fmin(out.least, x);
    out.largest = std::fmax(out.largest, x);
  }
  out.mean = sum / count;
  out.variance = squares / count - out.mean * out.mean;
  out.kurtosis = fourths / count / (out.variance * out.variance);
  return out;
}

TEST(Chance, NormalHasItsMoments) {
  Chance chance(3, Purpose::ball, Side::away, 2, 0, 9);
  const Moments m = moments([&] { return chance.normal(); });
  EXPECT_NEAR(m.mean, 0.0, 0.008);  // five standard errors
  EXPECT_NEAR(m.variance, 1.0, 0.012);
  EXPECT_NEAR(m.kurtosis, 3.0, 0.05);
  EXPECT_GT(m.largest, 4.0);
}

TEST(Chance, BothNormalsOfAPairAreUsedAndUncorrelated) {
  Chance chance(3, Purpose::ball, Side::away, 2, 0, 9);
  double product = 0.0;
  constexpr int pairs = 200000;
  for (int i = 0; i < pairs; ++i) {
    const double first = chance.normal();
    const double second = chance.normal();
    ASSERT_NE(first, second);
    product += first * second;
  }
  EXPECT_NEAR(product / pairs, 0.0, 0.012);
}

TEST(Chance, TriangularHasItsMoments) {
  Chance chance(4, Purpose::kick, Side::home, 1, 0, 0);
  const Moments m = moments([&] { return chance.triangular(); });
  EXPECT_NEAR(m.mean, 0.0, 0.004);
  EXPECT_NEAR(m.variance, 1.0 / 6.0, 0.002);
  EXPECT_NEAR(m.kurtosis, 2.4, 0.02);
  EXPECT_GT(m.least, -1.0);
  EXPECT_LT(m.largest, 1.0);
}

TEST(Chance, UniformAndBernoulli) {
  Chance chance(5, Purpose::kick, Side::home, 1, 0, 0);
  const Moments m = moments([&] { return chance.uniform(); });
  EXPECT_NEAR(m.mean, 0.5, 0.003);
  EXPECT_NEAR(m.variance, 1.0 / 12.0, 0.001);
  EXPECT_GE(m.least, 0.0);
  EXPECT_LT(m.largest, 1.0);
  const Moments b = moments([&] { return chance.bernoulli(0.3) ? 1.0 : 0.0; });
  EXPECT_NEAR(b.mean, 0.3, 0.004);
  EXPECT_FALSE(chance.bernoulli(0.0));
  EXPECT_TRUE(chance.bernoulli(1.0));
}

}  // namespace
}  // namespace regista::match
