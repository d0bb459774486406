// SPDX-License-Identifier: MIT
// Likelihood ratios against numbers of other programs, and the constrained laws beneath them against brute force.
#include "statistics/sequential_test.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "statistics/rating.hpp"

namespace regista::statistics {
namespace {

double games(Count losses, Count draws, Count wins, Model model, double elo0, double elo1) {
  const LogLikelihoodRatio ratio =
      log_likelihood_ratio(score_law(GameCounts{{losses, draws, wins}}), model, {elo0, elo1});
  EXPECT_EQ(ratio.method, Method::exact);
  return ratio.value;
}

double pairs(const PairCounts& counts, Model model, double elo0, double elo1) {
  const LogLikelihoodRatio ratio = log_likelihood_ratio(score_law(counts), model, {elo0, elo1});
  EXPECT_EQ(ratio.method, Method::exact);
  return ratio.value;
}

TEST(LikelihoodRatio, PublishedGames) {
  using enum Model;
  EXPECT_NEAR(games(36027, 68692, 36433, normalized, 0, 2), 0.923293, 1e-6);
  EXPECT_NEAR(games(10650, 20431, 10871, normalized, -1.75, 0.25), 2.297500, 1e-6);
  EXPECT_NEAR(games(0, 0, 4250, normalized, 0, 10), 120.548268, 1e-6);
  EXPECT_NEAR(games(21184, 40708, 21404, logistic, 0.5, 2.5), -1.571889, 1e-6);
  EXPECT_NEAR(games(57030, 106593, 57433, logistic, 0, 2), -2.593024, 1e-6);
}

TEST(LikelihoodRatio, PublishedPairs) {
  using enum Model;
  EXPECT_NEAR(pairs({{365, 16618, 36229, 16974, 390}}, normalized, 0, 2), 2.250368, 1e-6);
  EXPECT_NEAR(pairs({{127, 4883, 10712, 5150, 104}}, normalized, -1.75, 0.25), 3.010154, 1e-6);
  EXPECT_NEAR(pairs({{0, 0, 0, 0, 5550}}, normalized, 0, 5), 111.797555, 1e-6);
  EXPECT_NEAR(pairs({{223, 9863, 21279, 10037, 246}}, logistic, 0.5, 2.5), -3.074126, 1e-6);
  EXPECT_NEAR(pairs({{871, 26175, 55983, 26678, 821}}, logistic, 0, 2), -4.978673, 1e-6);
}

// Values that the tests of fishtest print, and of programs that follow it.
TEST(LikelihoodRatio, PublishedPairsInFullPrecision) {
  const PairCounts counts{{10789, 19328, 33806, 19402, 10543}};
  EXPECT_NEAR(pairs(counts, Model::logistic, -3, 1), 2.1310678117942, 1e-9);
  EXPECT_NEAR(pairs(counts, Model::normalized, 0, 5), -26.838448639795, 1e-6);
  EXPECT_NEAR(pairs(counts, Model::normalized, -5, 0), 12.039751536817, 1e-6);
  EXPECT_NEAR(pairs({{39, 2226, 31451, 2412, 40}}, Model::logistic, 0.2, 0.9), 2.1625425800483, 1e-9);
}

TEST(LikelihoodRatio, ImpossibleEffectsFallBackToTheClosedForm) {
  for (const auto& [counts, value] :
       {std::pair{PairCounts{{20, 0, 0, 0, 0}}, -3.42}, std::pair{PairCounts{{144, 3, 1, 0, 0}}, -228.67}}) {
    const LogLikelihoodRatio ratio = log_likelihood_ratio(score_law(counts), Model::normalized, {-1500, -500});
    EXPECT_EQ(ratio.method, Method::closed_form);
    EXPECT_NEAR(ratio.value, value, 0.005);
  }
}

// Of laws whose effect is t, that of even pairs and a share p of won ones makes even pairs alone most probable:
// t = sqrt(p / (1 - p)), so each takes -ln(1 - p) = ln(1 + t^2) off, t = sqrt(2) nElo / 347.44. Two uneven pairs more,
// one for each team, change that by less than one nat.
TEST(LikelihoodRatio, EvenPairsSpeakForEqualStrength) {
  const auto of_even = [](Count pairs, Count uneven, Model model, Hypotheses hypotheses) {
    return log_likelihood_ratio(score_law(PairCounts{{0, uneven, pairs, uneven, 0}}), model, hypotheses);
  };
  for (const Count pairs : {30, 776, 5000}) {
    const double n1 = 50 / normalized_elo_scale, by_hand = -static_cast<double>(pairs) * std::log(1 + 2 * n1 * n1);
    const LogLikelihoodRatio alone = of_even(pairs, 0, Model::normalized, {0, 50});
    EXPECT_EQ(alone.method, Method::exact);
    EXPECT_NEAR(alone.value, by_hand, 0.01 * -by_hand);
    EXPECT_NEAR(of_even(pairs, 1, Model::normalized, {0, 50}).value, alone.value, 1.0);
    for (const Model model : {Model::logistic, Model::normalized}) {
      EXPECT_LT(of_even(pairs, 0, model, {0, 10}).value, 0.0);
      EXPECT_GT(of_even(pairs, 0, model, {-10, -5}).value, 0.0);
      EXPECT_NEAR(of_even(pairs, 0, model, {-5, 5}).value, 0.0, 1e-9);
    }
  }
}

TEST(LikelihoodRatio, ManyUnitsAndSmallEffectsComeToTheClosedForms) {
  const PairCounts counts{{365, 16618, 36229, 16974, 390}};
  const ScoreLaw law = score_law(counts);
  EXPECT_NEAR(normalized_closed_form(law, {0, 2}), pairs(counts, Model::normalized, 0, 2), 1e-4);
  const ScoreLaw single = score_law(GameCounts{{36027, 68692, 36433}});
  EXPECT_NEAR(normalized_closed_form(single, {0, 2}), games(36027, 68692, 36433, Model::normalized, 0, 2), 1e-4);
  // Of a mean, by the normal law.
  const double s0 = score_of_elo(0.5), s1 = score_of_elo(2.5);
  const PairCounts other{{223, 9863, 21279, 10037, 246}};
  const ScoreLaw of_mean = score_law(other);
  EXPECT_NEAR(of_mean.units * (s1 - s0) * (2 * of_mean.mean - s0 - s1) / (2 * of_mean.variance),
              pairs(other, Model::logistic, 0.5, 2.5), 0.01);
}

TEST(LikelihoodRatio, SwappingTheTeamsAndTheHypothesesNegates) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 300; ++round) {
    PairCounts counts;
    for (Count& each : counts.seen) each = static_cast<Count>(random() % 300);
    counts.seen[0] += 1;
    const double elo0 = -20.0 + static_cast<double>(random() % 30),
                 elo1 = elo0 + 1.0 + static_cast<double>(random() % 9);
    for (const Model model : {Model::logistic, Model::normalized}) {
      const auto one = log_likelihood_ratio(score_law(counts), model, {elo0, elo1});
      const auto other = log_likelihood_ratio(score_law(swapped(counts)), model, {-elo1, -elo0});
      EXPECT_NEAR(one.value, -other.value, 1e-7 * (1.0 + std::abs(one.value)));
      EXPECT_EQ(one.method, other.method);
    }
  }
}

// Whatever the counts and the bounds: a finite number, soon.
TEST(LikelihoodRatio, SurvivesEverything) {
  std::mt19937_64 random(2);
  const auto count = [&] {
    const int size = static_cast<int>(random() % 11);
    return size < 4 ? Count{0} : static_cast<Count>(random() % static_cast<std::uint64_t>(std::pow(10, size - 1)));
  };
  for (int round = 0; round < 20000; ++round) {
    PairCounts counts;
    for (Count& each : counts.seen) each = count();
    if (total(counts) == 0) continue;
    const double size = std::pow(10.0, static_cast<double>(random() % 4));
    const double elo0 = size * (static_cast<double>(random() % 7) - 4.0);
    const Hypotheses hypotheses{elo0, elo0 + size * 0.25 * static_cast<double>(1 + random() % 4)};
    for (const Model model : {Model::logistic, Model::normalized}) {
      EXPECT_TRUE(std::isfinite(log_likelihood_ratio(score_law(counts), model, hypotheses).value));
      const GameCounts single{{counts.seen[0], counts.seen[1], counts.seen[2] + 1}};
      EXPECT_TRUE(std::isfinite(log_likelihood_ratio(score_law(single), model, hypotheses).value));
    }
  }
}

double log_likelihood(const ScoreLaw& law, const Probabilities& q) {
  double sum = 0.0;
  for (std::size_t i = 0; i < law.outcomes; ++i) sum += law.probabilities[i] * std::log(q[i]);
  return sum;
}

double mean_of(const ScoreLaw& law, const Probabilities& q) {
  double mean = 0.0;
  for (std::size_t i = 0; i < law.outcomes; ++i) mean += q[i] * law.scores[i];
  return mean;
}

double effect_of(const ScoreLaw& law, const Probabilities& q) {
  const double mean = mean_of(law, q);
  double variance = 0.0;
  for (std::size_t i = 0; i < law.outcomes; ++i) variance += q[i] * (law.scores[i] - mean) * (law.scores[i] - mean);
  return (mean - 0.5) / std::sqrt(variance);
}

// Laws of three outcomes under one constraint have one free number, the share of draws: try all on a grid.
TEST(ConstrainedLaw, GamesAgainstAGrid) {
  const ScoreLaw law = score_law(GameCounts{{30, 50, 40}});
  for (const double mean : {0.3, 0.48, 0.55, 0.8}) {
    const Probabilities found = *most_likely_with_mean(law, mean);
    EXPECT_NEAR(found[0] + found[1] + found[2], 1.0, 1e-12);
    EXPECT_NEAR(mean_of(law, found), mean, 1e-12);
    double best = -HUGE_VAL;
    for (double draws = 1e-4; draws < 1.0; draws += 1e-4) {
      const Probabilities q{1.0 - mean - draws / 2.0, draws, mean - draws / 2.0};
      if (q[0] > 0.0 && q[2] > 0.0) best = std::max(best, log_likelihood(law, q));
    }
    EXPECT_NEAR(log_likelihood(law, found), best, 1e-7);
    EXPECT_GE(log_likelihood(law, found), best);
  }
  for (const double effect : {-0.4, 0.0, 0.1, 0.6}) {
    const Probabilities found = *most_likely_with_effect(law, effect);
    EXPECT_NEAR(found[0] + found[1] + found[2], 1.0, 1e-9);
    EXPECT_NEAR(effect_of(law, found), effect, 1e-8);
    double best = -HUGE_VAL;
    for (double draws = 1e-4; draws < 1.0; draws += 1e-4) {
      // wins - losses = d: mean - 1/2 = d/2, variance = ((1 - draws) - d^2) / 4
      const double d = std::copysign(std::sqrt(effect * effect * (1.0 - draws) / (1.0 + effect * effect)), effect);
      const Probabilities q{(1.0 - draws - d) / 2.0, draws, (1.0 - draws + d) / 2.0};
      if (q[0] > 0.0 && q[2] > 0.0) best = std::max(best, log_likelihood(law, q));
    }
    EXPECT_NEAR(log_likelihood(law, found), best, 1e-7);
    EXPECT_GE(log_likelihood(law, found), best - 1e-9);
  }
}

// Of pairs: no law near or far that satisfies the constraint makes the counts more probable.
TEST(ConstrainedLaw, PairsAgainstRandomLaws) {
  const ScoreLaw law = score_law(PairCounts{{12, 40, 70, 45, 20}});
  std::mt19937_64 random(3);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (const double target : {-0.3, 0.05, 0.4}) {
    for (const bool of_mean : {true, false}) {
      const auto measure = [&](const Probabilities& q) { return of_mean ? mean_of(law, q) - 0.5 : effect_of(law, q); };
      const double wanted = of_mean ? target / 2.0 : target;
      const Probabilities found =
          of_mean ? *most_likely_with_mean(law, 0.5 + wanted) : *most_likely_with_effect(law, wanted);
      EXPECT_NEAR(measure(found), wanted, 1e-8);
      const double most = log_likelihood(law, found);
      double nearest = -HUGE_VAL;
      for (int trial = 0; trial < 3000; ++trial) {
        Probabilities start{};
        double sum = 0.0;
        const double distance = std::pow(10.0, -3.0 * uniform());
        for (std::size_t i = 0; i < 5; ++i) sum += start[i] = found[i] * std::exp(distance * (2.0 * uniform() - 1.0));
        for (double& each : start) each /= sum;
        // Towards all pairs won or all lost, until the constraint holds.
        const std::size_t end = measure(start) < wanted ? 4 : 0;
        double low = 0.0, high = 1.0;
        Probabilities q = start;
        for (int step = 0; step < 60; ++step) {
          const double share = (low + high) / 2.0;
          for (std::size_t i = 0; i < 5; ++i) q[i] = (1.0 - share) * start[i] + (i == end ? share : 0.0);
          ((measure(q) < wanted) == (end == 4) ? low : high) = share;
        }
        nearest = std::max(nearest, log_likelihood(law, q));
      }
      EXPECT_LE(nearest, most + 1e-9);
      EXPECT_GT(nearest, most - 1e-4);
    }
  }
}

}  // namespace
}  // namespace regista::statistics
