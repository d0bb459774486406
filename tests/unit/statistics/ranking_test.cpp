// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "statistics/moments.hpp"
#include "statistics/rating.hpp"

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
  const std::vector<double> ratings = *bradley_terry_elo(table({{0, 7, 9}, {3, 0, 6}, {1, 4, 0}}));
  EXPECT_NEAR(ratings[0], 163.921, 0.0005);
  EXPECT_NEAR(ratings[1], -27.823, 0.0005);
  EXPECT_NEAR(ratings[2], -136.098, 0.0005);
  // As games, or as pairs that gave the same points.
  const std::vector<Encounter> games{{0, 1, {}, {{3, 0, 7}}}, {0, 2, {}, {{1, 0, 9}}}, {2, 1, {}, {{6, 0, 4}}}};
  const std::vector<Encounter> pairs{
      {0, 1, {{0, 1, 0, 3, 1}}, {}}, {2, 0, {{4, 0, 1, 0, 0}}, {}}, {1, 2, {{0, 2, 0, 2, 1}}, {}}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR((*bradley_terry(3, games))[i].value, ratings[i], 1e-9);
    EXPECT_NEAR((*bradley_terry(3, pairs))[i].value, ratings[i], 1e-9);
  }
}

// Of two teams there is a closed form: the logit of the share of points, its variance by the delta method that of a
// unit's score over units (share (1 - share))^2. Of games that are won or lost this is 1/wins + 1/losses.
TEST(BradleyTerry, OfTwoTeams) {
  const double scale = 400.0 / std::log(10.0) / 2;
  const auto of_games = *bradley_terry(2, std::vector<Encounter>{{0, 1, {}, {{10, 0, 30}}}});
  const double difference = 400.0 * std::log10(3.0);
  EXPECT_NEAR(of_games[0].value, difference / 2, 1e-8);
  EXPECT_NEAR(of_games[1].value, -difference / 2, 1e-8);
  const double by_hand = scale * student_t_quantile(0.975, 39) * std::sqrt((1.0 / 30 + 1.0 / 10) * 40 / 39);
  EXPECT_NEAR(of_games[0].margin(), by_hand, 1e-6);
  EXPECT_NEAR(of_games[1].margin(), by_hand, 1e-6);

  const PairCounts pairs{{5, 10, 40, 30, 15}};
  const auto of_pairs = *bradley_terry(2, std::vector<Encounter>{{1, 0, swapped(pairs), {}}});
  const ScoreLaw law = score_law(pairs);
  EXPECT_NEAR(of_pairs[0].value, elo_of_score(law.mean) / 2, 1e-8);
  const double error = std::sqrt(law.variance / 99) / (law.mean * (1 - law.mean));
  EXPECT_NEAR(of_pairs[0].margin(), scale * student_t_quantile(0.975, 99) * error, 1e-6);
}

// Each team met its neighbours only: every step of the chain is 3 : 2.
TEST(BradleyTerry, OfALongChain) {
  constexpr std::size_t teams = 300;
  SquareTable points(teams);
  for (std::size_t i = 0; i + 1 < teams; ++i) {
    points.at(i, i + 1) = 6.0;
    points.at(i + 1, i) = 4.0;
  }
  const std::vector<double> elo = *bradley_terry_elo(points);
  const double step = 400.0 * std::log10(1.5);
  for (std::size_t i = 0; i < teams; ++i) {
    EXPECT_NEAR(elo[i], step * (static_cast<double>(teams - 1) / 2.0 - static_cast<double>(i)), 1e-6);
  }
}

// The same results in any order and from either side.
TEST(BradleyTerry, EncountersAddUp) {
  const std::vector<Encounter> one{
      {0, 1, {{3, 4, 9, 6, 5}}, {{1, 0, 0}}}, {1, 2, {{1, 4, 7, 6, 2}}, {}}, {0, 2, {{2, 2, 9, 9, 1}}, {}}};
  std::vector<Encounter> other{
      {2, 0, swapped(one[2].pairs), {}}, {0, 1, one[0].pairs, one[0].games}, {2, 1, swapped(one[1].pairs), {}}};
  const auto x = *bradley_terry(3, one), y = *bradley_terry(3, other);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(x[i].value, y[i].value, 1e-9);
    EXPECT_TRUE(x[i].interval.bounded());
    EXPECT_NEAR(x[i].margin(), y[i].margin(), 1e-9);
  }
}

TEST(BradleyTerry, NoIntervalOfTeamsWhoseSpreadIsNotKnown) {
  // The third team wins every pair, once with a draw.
  const auto strongest = *bradley_terry(
      3, std::vector<Encounter>{
             {0, 1, {{6, 2, 3, 2, 6}}, {}}, {2, 0, {{0, 0, 0, 1, 15}}, {}}, {2, 1, {{0, 0, 0, 0, 16}}, {}}});
  EXPECT_TRUE(strongest[0].interval.bounded());
  EXPECT_TRUE(strongest[1].interval.bounded());
  EXPECT_TRUE(strongest[2].interval.unbounded());
  // Nearly all pairs were even.
  const auto even = *bradley_terry(2, std::vector<Encounter>{{0, 1, {{2, 2, 90, 3, 2}}, {}}});
  EXPECT_TRUE(even[0].interval.unbounded());
}

// At the maximum, each team's points are those that its strength lets expect.
TEST(BradleyTerry, ExpectedPointsAreThePointsWon) {
  std::mt19937_64 random(9);
  SquareTable points(8);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) points.at(i, j) = i == j ? 99.0 : static_cast<double>(1 + random() % 20) / 2.0;
  }
  const std::vector<double> ratings = *bradley_terry_elo(points);
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    double won = 0.0, expected = 0.0;
    for (std::size_t j = 0; j < 8; ++j) {
      if (i == j) continue;
      won += points.at(i, j);
      expected += (points.at(i, j) + points.at(j, i)) / (1 + std::pow(10, (ratings[j] - ratings[i]) / 400));
    }
    EXPECT_NEAR(expected, won, 1e-8);
    sum += ratings[i];
  }
  EXPECT_NEAR(sum, 0.0, 1e-8);
}

TEST(BradleyTerry, IntervalsHoldWhatTheySay) {
  const std::vector<double> truth{150, 20, -30, -140};
  std::mt19937_64 random(10);
  int inside = 0, all = 0;
  for (int tournament = 0; tournament < 500; ++tournament) {
    std::vector<Encounter> encounters;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        encounters.push_back({i, j, {}, {}});
        for (int game = 0; game < 50; ++game) {
          const double u = static_cast<double>(random() >> 11) * 0x1p-53;
          const bool won = u < 1 / (1 + std::pow(10, (truth[j] - truth[i]) / 400));
          encounters.back().games.add(won ? GameOutcome::win : GameOutcome::loss);
        }
      }
    }
    const auto ratings = *bradley_terry(4, encounters);
    for (std::size_t i = 0; i < 4; ++i) {
      inside += ratings[i].interval.contains(truth[i]) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.02);
}

// Against the closure of "played each other", by brute force.
TEST(GroupsThatMet, AreThoseThatResultsConnect) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const std::size_t teams = 1 + random() % 9;
    std::vector<std::vector<bool>> met(teams, std::vector<bool>(teams));
    std::vector<Encounter> encounters;
    for (std::size_t i = 0; i < teams; ++i) met[i][i] = true;
    for (auto games = random() % (teams + 2); games > 0 && teams > 1; --games) {
      const std::size_t one = random() % teams, other = (one + 1 + random() % (teams - 1)) % teams;
      const Count draws = random() % 4 == 0 ? 0 : 1;  // an encounter without a game connects nobody
      encounters.push_back({one, other, {}, {{0, draws, 0}}});
      if (draws > 0) met[one][other] = met[other][one] = true;
    }
    for (std::size_t by = 0; by < teams; ++by) {
      for (std::size_t i = 0; i < teams; ++i) {
        for (std::size_t j = 0; j < teams; ++j) met[i][j] = met[i][j] || (met[i][by] && met[by][j]);
      }
    }
    const std::vector<std::size_t> groups = groups_that_met(teams, encounters);
    for (std::size_t i = 0; i < teams; ++i) {
      const auto first = std::find(met[i].begin(), met[i].end(), true) - met[i].begin();
      EXPECT_EQ(groups[i], static_cast<std::size_t>(first));
    }
  }
}

TEST(BradleyTerry, NoInformation) {
  EXPECT_FALSE(bradley_terry_elo(table({{0, 5}, {0, 0}})).has_value());                   // never lost
  EXPECT_FALSE(bradley_terry_elo(table({{0, 0}, {0, 0}})).has_value());                   // never met
  EXPECT_FALSE(bradley_terry_elo(table({{0, 1, 2}, {1, 0, 2}, {0, 0, 0}})).has_value());  // one took nothing
  EXPECT_FALSE(bradley_terry(2, std::vector<Encounter>{{0, 1, {{0, 0, 0, 0, 30}}, {}}}).has_value());
  EXPECT_TRUE(bradley_terry_elo(SquareTable(0))->empty());
  EXPECT_TRUE(bradley_terry(0, {})->empty());
  EXPECT_EQ(bradley_terry(1, {})->front().value, 0.0);
  EXPECT_TRUE(bradley_terry(1, {})->front().interval.unbounded());
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
