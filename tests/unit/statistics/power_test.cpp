// SPDX-License-Identifier: MIT
#include "statistics/paired_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "statistics/moments.hpp"

namespace regista::statistics {
namespace {

PowerDesign t_test(double power = 0.8, double alpha = 0.05) { return {alpha, 1, power, PairedTest::student_t}; }

// P((Z + delta) / sqrt(V / degrees) > t), by Simpson's rule over the law of sqrt(V).
double above_by_integration(double t, double degrees, double delta) {
  const double middle = std::sqrt(degrees), least = std::max(0.0, middle - 12.0), most = middle + 12.0;
  constexpr int steps = 20000;
  const double width = (most - least) / steps;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double root = least + i * width;
    if (root <= 0.0) continue;
    const double log_density = (1.0 - degrees / 2.0) * std::numbers::ln2 - std::lgamma(degrees / 2.0) +
                               (degrees - 1.0) * std::log(root) - root * root / 2.0;
    const double above = 0.5 * std::erfc((t * root / std::sqrt(degrees) - delta) / std::numbers::sqrt2);
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * std::exp(log_density) * above;
  }
  return sum * width / 3.0;
}

// Cohen 1988, as power.t.test(type = "paired") of R gives it: 33.4, 198.2, 14.3; 44.0, 264.6, 18.4; 53.9 pairs.
TEST(Power, NeedsThePairsOfPublishedTables) {
  EXPECT_EQ(pairs_needed(0.5, 1.0, t_test()), 34);
  EXPECT_EQ(pairs_needed(0.2, 1.0, t_test()), 199);
  EXPECT_EQ(pairs_needed(0.8, 1.0, t_test()), 15);
  EXPECT_EQ(pairs_needed(0.5, 1.0, t_test(0.9)), 44);
  EXPECT_EQ(pairs_needed(0.2, 1.0, t_test(0.9)), 265);
  EXPECT_EQ(pairs_needed(0.8, 1.0, t_test(0.9)), 19);
  EXPECT_EQ(pairs_needed(0.5, 1.0, t_test(0.95)), 54);
}

TEST(Power, NoncentralTIsItsIntegral) {
  for (const double degrees : {2.0, 4.0, 19.0, 300.0}) {
    for (const double delta : {-3.0, 0.0, 0.7, 2.5, 12.0}) {
      for (const double t : {-1.0, 0.5, 2.1, 9.0}) {
        EXPECT_NEAR(noncentral_t_above(t, degrees, delta), above_by_integration(t, degrees, delta), 1e-8)
            << t << ' ' << degrees << ' ' << delta;
      }
    }
  }
}

// Where one way of computing ends and the other begins.
TEST(Power, NoncentralTHasNoStep) {
  EXPECT_NEAR(noncentral_t_above(1.96, 9999.0, 2.8), noncentral_t_above(1.96, 10001.0, 2.8), 2e-6);
  EXPECT_NEAR(noncentral_t_above(31.0, 2000.0, 29.9999), noncentral_t_above(31.0, 2000.0, 30.0001), 2e-4);
  EXPECT_EQ(pairs_needed(0.02, 1.0, t_test()),
            19625);  // 2.8016^2 / 0.02^2 + 1.96^2 / 2, Cohen's approximation: 19624.7
}

TEST(Power, FewestPairsOfSignFlips) {
  EXPECT_EQ(smallest_pairs({0.05, 1}), 6);
  EXPECT_EQ(smallest_pairs({0.05, 2}), 7);
  EXPECT_EQ(smallest_pairs({0.05, 3}), 7);  // 2/128 is below 0.05/3
  EXPECT_EQ(smallest_pairs({0.05, 10}), 9);
  EXPECT_EQ(smallest_pairs({0.01, 1}), 8);
  EXPECT_EQ(smallest_pairs({0.05, 1, 0.8, PairedTest::student_t}), 2);
  for (std::int64_t pairs = 1; pairs < 12; ++pairs) {
    const std::vector<double> won_all(static_cast<std::size_t>(pairs), 1.5);
    for (const std::int64_t family : {1, 2, 3, 6, 10}) {
      const bool can = sign_flip_p_of_values(won_all) <= 0.05 / static_cast<double>(family);
      EXPECT_EQ(can, pairs >= smallest_pairs({0.05, family})) << pairs << ' ' << family;
    }
  }
}

TEST(Power, IsNothingWhereNothingCanBeFound) {
  const PowerDesign one;
  EXPECT_EQ(power_of(5, 100.0, 1.0, one), 0.0);
  EXPECT_FALSE(difference_found(5, 1.0, one));
  EXPECT_EQ(pairs_needed(100.0, 1.0, one), 6);
  EXPECT_FALSE(pairs_needed(1e-6, 1.0, one));
}

// A difference that N pairs find needs N pairs, in any unit and with any sign.
TEST(Power, BothQuestionsHaveOneAnswer) {
  for (const std::int64_t pairs : {6, 7, 10, 34, 150, 4000}) {
    for (const std::int64_t family : {1, 3}) {
      if (pairs < smallest_pairs({0.05, family})) continue;
      const PowerDesign design{0.05, family, 0.8, PairedTest::sign_flip};
      const double found = *difference_found(pairs, 2.5, design);
      EXPECT_NEAR(power_of(pairs, found, 2.5, design), 0.8, 1e-6);
      EXPECT_EQ(pairs_needed(found * 1.0001, 2.5, design), pairs);
      EXPECT_EQ(pairs_needed(-found * 1.0001, 2.5, design), pairs);
      EXPECT_GT(pairs_needed(found * 0.9, 2.5, design), pairs);
    }
  }
}

// How often sign flips of so many normal differences find a mean.
double found_by_simulation(std::int64_t pairs, double mean, double level, int studies) {
  std::mt19937_64 chance(static_cast<std::uint64_t>(pairs));
  std::normal_distribution<double> difference(mean, 1.0);
  int found = 0;
  std::vector<double> values(static_cast<std::size_t>(pairs));
  for (int i = 0; i < studies; ++i) {
    for (double& value : values) value = difference(chance);
    found += sign_flip_p_of_values(values) <= level ? 1 : 0;
  }
  return static_cast<double>(found) / studies;
}

// The law of t is a little better than that of signs where these have few steps.
TEST(Power, IsThatOfSignFlipsPlayedOut) {
  for (const std::int64_t family : {1, 3}) {
    const PowerDesign design{0.05, family, 0.8, PairedTest::sign_flip};
    for (const std::int64_t pairs : {7, 8, 10, 14, 20, 40}) {
      const double difference = *difference_found(pairs, 1.0, design);
      const double found = found_by_simulation(pairs, difference, 0.05 / static_cast<double>(family), 4000);
      EXPECT_NEAR(found, 0.8, pairs < 10 ? 0.11 : 0.03) << pairs << ' ' << family;
    }
  }
}

// Pairs of scenes: three of four are even, goals come in halves. As many as are said to be enough find such a mean
// about as often as they should.
TEST(Power, HoldsForEvenPairsAndHalfGoals) {
  const std::vector<double> values{-0.5, 0.0, 0.5, 1.0}, chances{0.05, 0.75, 0.15, 0.05};
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    mean += chances[i] * values[i];
    square += chances[i] * values[i] * values[i];
  }
  const PowerDesign design;
  const std::int64_t pairs = *pairs_needed(mean, {std::sqrt(square - mean * mean), 0.25, 0.5}, design);
  std::mt19937_64 chance(1);
  std::discrete_distribution<std::size_t> law(chances.begin(), chances.end());
  constexpr int studies = 4000;
  int found = 0;
  for (int i = 0; i < studies; ++i) {
    std::vector<double> seen;
    for (std::int64_t pair = 0; pair < pairs; ++pair) seen.push_back(values[law(chance)]);
    found += sign_flip_p_of_values(seen) <= 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(found) / studies, 0.8, 0.05) << pairs;
}

// R: sqrt(9 / qchisq(c(0.975, 0.025), 9)) is 0.6878 and 1.8256.
TEST(Power, TenPairsKnowTheSpreadRoughly) {
  const auto [low, high] = spread_interval(2.0, 10);
  EXPECT_NEAR(low.deviation, 2.0 * 0.6878, 2e-4);
  EXPECT_NEAR(high.deviation, 2.0 * 1.8256, 2e-4);
}

// R: binom.test(1, 40)$conf.int is 0.000633 to 0.1316; the chi squared law alone would give 0.82 to 1.28 times.
TEST(Power, OneUnevenPairKnowsTheSpreadHardly) {
  const auto [low, high] = spread_interval({1.0, 0.025, 0.5}, 40);
  EXPECT_NEAR(low.deviation, std::sqrt(0.000633 / 0.025), 2e-4);
  EXPECT_NEAR(high.deviation, std::sqrt(0.1316 / 0.025), 2e-3);
}

// How often the program's own test finds a difference in studies of so many pairs. A share of the pairs is uneven; of
// these, every fourth differs by `larger`, the others by 0.5, and (1 + lead) / 2 are in favour of one side.
double found_with_even_pairs(std::int64_t pairs, double uneven, double larger, double lead) {
  constexpr int studies = 4000;
  std::mt19937_64 chance(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int found = 0;
  for (int study = 0; study < studies; ++study) {
    WholeCounts seen;
    for (std::int64_t pair = 0; pair < pairs; ++pair) {
      if (share(chance) >= uneven) continue;
      const double size = share(chance) < 0.25 ? larger : 0.5;
      ++seen[std::lround((share(chance) < (1.0 + lead) / 2.0 ? 2.0 : -2.0) * size)];
    }
    found += sign_flip_p(seen) <= 0.05 ? 1 : 0;
  }
  return static_cast<double>(found) / studies;
}

// Nine of ten pairs were won by half a goal: the pilot's spread is far too small for a difference of a quarter of a
// goal, for which 7 of 10 uneven pairs are enough. By binomials: 30 pairs find it in 80 % of studies, 9 in 24 %.
TEST(Power, APilotThatIsWonClearlyDoesNotPromiseTooMuch) {
  Moments pilot;
  for (int i = 0; i < 9; ++i) pilot.add(0.5);
  pilot.add(0.0);
  const std::int64_t pairs = *pairs_needed(0.25, Spread(pilot), PowerDesign{});
  EXPECT_NEAR(found_with_even_pairs(pairs, 0.9, 0.5, 0.25 / 0.45), 0.8, 0.05) << pairs;
}

// All pairs of this pilot were won, by 1 to 5.5 goals in steps of 1/2: there are small differences, too, and the
// pilot's spread is what counts.
TEST(Power, APilotOfUnequalTeamsDoesNotPromiseTooLittle) {
  const Moments pilot(std::vector{1.0, 2.5, 2.5, 3.0, 3.5, 5.5, 2.0, 2.5});
  EXPECT_DOUBLE_EQ(pilot.unit(), 0.5);
  EXPECT_EQ(pairs_needed(0.5, Spread(pilot), PowerDesign{}),
            pairs_needed(0.5, pilot.standard_deviation(), PowerDesign{}));
}

TEST(Moments, KnowTheUnitOfTheirValues) {
  EXPECT_EQ(Moments().unit(), 0.0);
  EXPECT_EQ(Moments(std::vector{1.5, 0.0, -2.5}).unit(), 0.5);
  EXPECT_EQ(Moments(std::vector{-4.0, 6.0}).unit(), 2.0);
  EXPECT_EQ(Moments(std::vector{0.5, 0.3}).unit(), 0.0);
}

// The number of pairs gives about the power that was asked for, whatever share of them is even.
TEST(Power, CountsThatEvenPairsDecideNothing) {
  for (const double even : {0.1, 0.5, 0.9}) {
    for (const double larger : {0.5, 1.0, 1.5}) {
      for (const double lead : {0.3, 0.5, 0.8}) {
        const double uneven = 1.0 - even, mean = uneven * lead * (0.75 * 0.5 + 0.25 * larger);
        const double square = uneven * (0.75 * 0.25 + 0.25 * larger * larger);
        const PowerDesign design;
        const std::int64_t pairs = *pairs_needed(mean, {std::sqrt(square - mean * mean), uneven, 0.5}, design);
        EXPECT_NEAR(found_with_even_pairs(pairs, uneven, larger, lead), 0.8, 0.05)
            << pairs << " pairs, even " << even << ", " << larger << ", " << lead;
      }
    }
  }
}

// 20 Elo, a difference of 0.0575 points a match, after one uneven pair of 40: its spread alone would let 17 pairs find
// that. Where all uneven pairs go one way, 0.0575 / 0.5 of the pairs are uneven, and six of them have to be seen.
TEST(Power, IsNotFooledByAPilotOfEvenPairs) {
  Moments pilot;
  for (int pair = 0; pair < 40; ++pair) pilot.add(pair == 7 ? 0.5 : 0.0);
  const PowerDesign design;
  EXPECT_EQ(pairs_needed(0.0575, pilot.standard_deviation(), design), 17);
  const std::int64_t pairs = *pairs_needed(0.0575, Spread(pilot), design);
  EXPECT_NEAR(found_with_even_pairs(pairs, 0.115, 0.5, 1.0), 0.8, 0.02) << pairs;
  EXPECT_LT(found_with_even_pairs(17, 0.115, 0.5, 1.0), 0.02);
  EXPECT_GT(*difference_found(pairs, Spread(pilot), design), 0.0560);
  EXPECT_LE(*difference_found(pairs, Spread(pilot), design), 0.0575);
}

}  // namespace
}  // namespace regista::statistics
