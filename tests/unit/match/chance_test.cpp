// SPDX-License-Identifier: MIT
// Streams of chance against the published vectors of Philox, and against the moments of their laws.
#include "match/chance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
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

// The same transformation in double precision from the standard library.
TEST(Noise, IsBoxAndMullersTransformation) {
  Chance chance(1, Purpose::ball, Side::home, 1, 0, 0);
  for (int i = 0; i < 200000; ++i) {
    // The ends of the ranges too.
    const std::uint32_t radius_bits = i == 0 ? 0u : i == 1 ? 0xffffffffu : chance.bits();
    const std::uint32_t angle_bits = i == 2 ? 0u : i == 3 ? 0xffffffffu : i == 4 ? 0x80000000u : chance.bits();
    const NormalPair pair = box_muller(radius_bits, angle_bits);
    const double u = static_cast<double>(static_cast<float>(radius_bits >> 8) + 0.5f) * 0x1p-24;
    const double radius = std::sqrt(-2.0 * std::log(u));
    // Two bits of quarter, thirty of angle within it, as documented; the direction is what matters.
    const double within = static_cast<std::int32_t>(angle_bits << 2) * 0x1p-32 * std::numbers::pi / 2.0;
    const std::array<double, 2> at{std::cos(within), std::sin(within)};
    const bool swap = (angle_bits >> 30 & 1u) != 0;
    const double sign = angle_bits >> 31 != 0 ? -1.0 : 1.0;
    ASSERT_NEAR(pair.first, sign * radius * (swap ? at[1] : at[0]), 3e-6);
    ASSERT_NEAR(pair.second, sign * radius * (swap ? -at[0] : at[1]), 3e-6);
  }
}

TEST(Noise, DrawsEachObjectFromItsOwnStream) {
  const std::array<Draw, 5> objects{Draw{Purpose::robot, 3},
                                    {Purpose::ball, 0},
                                    {Purpose::robot, 12},
                                    {Purpose::landmark, 12},
                                    {Purpose::landmark, 20}};
  Draws all, one;
  draw(5, Side::away, 4, 77, objects, all);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    draw(5, Side::away, 4, 77, std::span(objects).subspan(i, 1), one);
    EXPECT_EQ(all.uniform[i], one.uniform[0]);
    EXPECT_EQ(all.first[i], one.first[0]);
    EXPECT_EQ(all.second[i], one.second[0]);
    Chance chance(5, objects[i].purpose, Side::away, 4, objects[i].object, 77);
    EXPECT_FLOAT_EQ(all.uniform[i], static_cast<float>(chance.uniform()));
  }
}

TEST(Noise, NormalPairsHaveTheirMoments) {
  std::uint32_t tick = 0;
  bool second = false;
  Draws draws;
  const std::array<Draw, 1> object{Draw{Purpose::ball, 0}};
  double product = 0.0;
  const Moments m = moments([&] {
    second = !second;
    if (!second) return double(draws.second[0]);
    draw(5, Side::home, 1, ++tick, object, draws);
    product += double(draws.first[0]) * draws.second[0];
    return double(draws.first[0]);
  });
  EXPECT_NEAR(m.mean, 0.0, 0.008);
  EXPECT_NEAR(m.variance, 1.0, 0.012);
  EXPECT_NEAR(m.kurtosis, 3.0, 0.05);
  EXPECT_GT(m.largest, 4.0);
  EXPECT_NEAR(product / tick, 0.0, 0.012);
}

}  // namespace
}  // namespace regista::match
