// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "statistics/bradley_terry.hpp"
#include "statistics/nash.hpp"

namespace regista::statistics {
namespace {

SquareTable table(const std::vector<std::vector<double>>& rows) {
  SquareTable out(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) out.at(i, j) = rows[i][j];
  }
  return out;
}

TEST(BradleyTerry, PublishedTriangle) {
  const auto ratings = *bradley_terry(table({{0, 7, 9}, {3, 0, 6}, {1, 4, 0}}));
  EXPECT_NEAR(ratings[0].value, 163.921, 0.0005);
  EXPECT_NEAR(ratings[1].value, -27.823, 0.0005);
  EXPECT_NEAR(ratings[2].value, -136.098, 0.0005);
}

// Of two teams there is a closed form: the logit of the share of points, its variance 1/wins + 1/losses.
TEST(BradleyTerry, OfTwoTeams) {
  const auto ratings = *bradley_terry(table({{0, 30}, {10, 0}}));
  const double difference = 400.0 * std::log10(3.0);
  EXPECT_NEAR(ratings[0].value, difference / 2, 1e-8);
  EXPECT_NEAR(ratings[1].value, -difference / 2, 1e-8);
  const double margin = 1.959963984540054 * std::sqrt(1.0 / 30 + 1.0 / 10) * 400.0 / std::log(10.0) / 2;
  EXPECT_NEAR(ratings[0].margin(), margin, 1e-6);
}

// At the maximum, each team's points are those that its strength lets expect.
TEST(BradleyTerry, ExpectedPointsAreThePointsWon) {
  std::mt19937_64 random(9);
  SquareTable points(8);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) points.at(i, j) = i == j ? 99.0 : static_cast<double>(1 + random() % 20) / 2.0;
  }
  const auto ratings = *bradley_terry(points);
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    double won = 0.0, expected = 0.0;
    for (std::size_t j = 0; j < 8; ++j) {
      if (i == j) continue;
      won += points.at(i, j);
      expected += (points.at(i, j) + points.at(j, i)) / (1 + std::pow(10, (ratings[j].value - ratings[i].value) / 400));
    }
    EXPECT_NEAR(expected, won, 1e-8);
    sum += ratings[i].value;
  }
  EXPECT_NEAR(sum, 0.0, 1e-8);
}

TEST(BradleyTerry, IntervalsHoldWhatTheySay) {
  const std::vector<double> truth{150, 20, -30, -140};
  std::mt19937_64 random(10);
  int inside = 0, all = 0;
  for (int tournament = 0; tournament < 500; ++tournament) {
    SquareTable points(4);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        for (int game = 0; game < 50; ++game) {
          const double u = static_cast<double>(random() >> 11) * 0x1p-53;
          const bool won = u < 1 / (1 + std::pow(10, (truth[j] - truth[i]) / 400));
          (won ? points.at(i, j) : points.at(j, i)) += 1.0;
        }
      }
    }
    const auto ratings = *bradley_terry(points);
    for (std::size_t i = 0; i < 4; ++i) {
      inside += ratings[i].interval.contains(truth[i]) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.02);
}

TEST(BradleyTerry, NoInformation) {
  EXPECT_FALSE(bradley_terry(table({{0, 5}, {0, 0}})).has_value());                   // never lost
  EXPECT_FALSE(bradley_terry(table({{0, 0}, {0, 0}})).has_value());                   // never met
  EXPECT_FALSE(bradley_terry(table({{0, 1, 2}, {1, 0, 2}, {0, 0, 0}})).has_value());  // one took nothing
  const auto ratings = bradley_terry(table({{0, 5}, {0, 0}}), 0.95, 1.0);
  ASSERT_TRUE(ratings.has_value());
  EXPECT_NEAR((*ratings)[0].value, 200.0 * std::log10(11.0), 1e-8);  // 5.5 to 0.5
  EXPECT_TRUE(bradley_terry(SquareTable(0))->empty());
  EXPECT_FALSE(bradley_terry(SquareTable(1))->front().interval.bounded());
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void expect_equilibrium(const SquareTable& payoff, const NashAverage& average, double tolerance) {
  EXPECT_NEAR(sum(average.share), 1.0, 1e-12);
  for (std::size_t i = 0; i < payoff.teams(); ++i) {
    EXPECT_GE(average.share[i], 0.0);
    EXPECT_LE(average.value[i], tolerance);
    double value = 0.0;
    for (std::size_t j = 0; j < payoff.teams(); ++j) value += payoff.at(i, j) * average.share[j];
    EXPECT_NEAR(average.value[i], value, tolerance);
  }
}

TEST(NashAverage, RockPaperScissors) {
  const SquareTable payoff = table({{0, -1, 1}, {1, 0, -1}, {-1, 1, 0}});
  const NashAverage average = nash_average(payoff);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(average.share[static_cast<std::size_t>(i)], 1.0 / 3.0, 1e-6);
    EXPECT_NEAR(average.value[static_cast<std::size_t>(i)], 0.0, 1e-6);
  }
}

TEST(NashAverage, TransitiveTriple) {
  const SquareTable payoff = table({{0, -1, -1}, {1, 0, -1}, {1, 1, 0}});
  const NashAverage average = nash_average(payoff);
  EXPECT_NEAR(average.share[0], 0.0, 1e-6);
  EXPECT_NEAR(average.share[1], 0.0, 1e-6);
  EXPECT_NEAR(average.share[2], 1.0, 1e-6);
  EXPECT_NEAR(average.value[0], -1.0, 1e-6);
  EXPECT_NEAR(average.value[1], -1.0, 1e-6);
  EXPECT_NEAR(average.value[2], 0.0, 1e-6);
}

// Wins of different size: the share of each is the payoff between the two others.
TEST(NashAverage, UnevenCycle) {
  const double a = 3, b = 2, c = 5;  // 1 beats 2 by a, 2 beats 3 by b, 3 beats 1 by c
  const NashAverage average = nash_average(table({{0, a, -c}, {-a, 0, b}, {c, -b, 0}}));
  EXPECT_NEAR(average.share[0], b / (a + b + c), 1e-6);
  EXPECT_NEAR(average.share[1], c / (a + b + c), 1e-6);
  EXPECT_NEAR(average.share[2], a / (a + b + c), 1e-6);
}

// A second pair of scissors shares with the first and changes nothing else: the entropy is what decides.
TEST(NashAverage, CopiesShare) {
  const NashAverage average = nash_average(table({{0, -1, 1, 1}, {1, 0, -1, -1}, {-1, 1, 0, 0}, {-1, 1, 0, 0}}));
  EXPECT_NEAR(average.share[0], 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(average.share[1], 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(average.share[2], 1.0 / 6.0, 1e-6);
  EXPECT_NEAR(average.share[3], 1.0 / 6.0, 1e-6);
}

// Two that are even and both beat a third; the first beats it by more, which no longer matters.
TEST(NashAverage, EvenBestTeamsShareEqually) {
  const NashAverage average = nash_average(table({{0, 0, 4}, {0, 0, 1}, {-4, -1, 0}}));
  EXPECT_NEAR(average.share[0], 0.5, 1e-6);
  EXPECT_NEAR(average.share[1], 0.5, 1e-6);
  EXPECT_NEAR(average.value[2], -2.5, 1e-5);
}

TEST(NashAverage, RandomGamesAreInEquilibrium) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 60; ++round) {
    const std::size_t teams = 1 + random() % 12;
    SquareTable payoff(teams);
    for (std::size_t i = 0; i < teams; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        payoff.at(i, j) = 200.0 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
        if (round % 2 == 0) payoff.at(i, j) = std::round(payoff.at(i, j) / 60.0);  // many ties
        payoff.at(j, i) = -payoff.at(i, j);
      }
    }
    expect_equilibrium(payoff, nash_average(payoff), 2e-4);
  }
}

TEST(NashAverage, NoInformation) {
  EXPECT_TRUE(nash_average(SquareTable(0)).share.empty());
  EXPECT_EQ(nash_average(SquareTable(1)).share, std::vector<double>{1.0});
  const NashAverage even = nash_average(SquareTable(4));
  for (const double share : even.share) EXPECT_DOUBLE_EQ(share, 0.25);
}

}  // namespace
}  // namespace regista::statistics
