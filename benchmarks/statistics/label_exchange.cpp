// SPDX-License-Identifier: MIT
// How often tests of real matches err. Pairs of two different teams are cut into tournaments of equal length; in each
// pair a coin decides which team is called the first. Then neither is better, whatever the teams are, and every
// rejection is an error: at a level of 5 % at most 5 % of the tournaments may end with one.
//
//   regista report PAIRS.db --csv | label_exchange PAIRS_PER_TOURNAMENT MOST_GOALS [SEED]
//
// MOST_GOALS: the largest goal difference of a match, as the tournament bet with it (docs/statistics.md).
// Two teams are needed that do not play the same: a tournament of a team against itself has only even pairs.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "statistics/betting_grid.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/sequential_test.hpp"
#include "statistics/sign_flip.hpp"

namespace {

using namespace regista::statistics;

constexpr double alpha = 0.05;

// Goal differences of the two matches of a pair, for the team that is at home in the first.
struct Pair {
  int first, second;
};

GameOutcome outcome(int goals) {
  return goals > 0 ? GameOutcome::win : goals < 0 ? GameOutcome::loss : GameOutcome::draw;
}

// Of the CSV of `regista report`: row,pair,seed,opening,home,away,home_goals,away_goals,...
std::vector<Pair> read_pairs(std::istream& in) {
  std::vector<int> differences;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::array<std::string, 8> field;
    for (std::string& each : field) std::getline(fields, each, ',');
    differences.push_back(std::atoi(field[6].c_str()) - std::atoi(field[7].c_str()));
  }
  std::vector<Pair> out;
  // The sides are swapped in the second.
  for (std::size_t i = 0; i + 1 < differences.size(); i += 2) out.push_back({differences[i], -differences[i + 1]});
  return out;
}

struct Errors {
  int t = 0, score = 0, betting = 0, sequential = 0;
};

// One tournament: adds 1 to each test that found a difference.
void judge(const std::vector<Pair>& pairs, std::size_t begin, std::size_t end, double most_goals, std::mt19937_64& coin,
           Errors& errors) {
  Moments goals;
  PairCounts counts;
  BettingGrid betting({-most_goals, most_goals, alpha, 1.0}, 4000);
  SequentialTest<PairCounts> sequential({Model::normalized, {0.0, 50.0}, {alpha, alpha}, true});
  for (std::size_t i = begin; i < end; ++i) {
    const int sign = (coin() >> 63) == 0 ? 1 : -1;
    const int first = sign * pairs[i].first, second = sign * pairs[i].second;
    goals.add((first + second) / 2.0);
    betting.add((first + second) / 2.0);
    const PairOutcome pair = pair_outcome(outcome(first), outcome(second));
    counts.add(pair);
    sequential.add(pair);
  }
  const auto t = paired_t(goals);
  errors.t += t && t->p <= alpha ? 1 : 0;
  errors.score += sign_flip_p(counts) <= alpha ? 1 : 0;
  errors.betting += betting.finding(0.0) != BettingTest::Finding::none ? 1 : 0;
  errors.sequential += sequential.verdict() == Verdict::accept_h1 ? 1 : 0;
}

void print(const char* test, int errors, int tournaments) {
  const double rate = static_cast<double>(errors) / tournaments;
  std::printf("%-34s %4d of %d  %.3f +- %.3f\n", test, errors, tournaments, rate,
              1.96 * std::sqrt(rate * (1.0 - rate) / tournaments));
}

}  // namespace

int main(int argc, char** argv) {
  const int length = argc > 1 ? std::atoi(argv[1]) : 0, most_goals = argc > 2 ? std::atoi(argv[2]) : 0;
  if (length < 2 || most_goals < 1) {
    std::fprintf(stderr, "regista report PAIRS.db --csv | label_exchange PAIRS_PER_TOURNAMENT MOST_GOALS [SEED]\n");
    return 2;
  }
  std::mt19937_64 coin(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  const std::vector<Pair> pairs = read_pairs(std::cin);
  const auto size = static_cast<std::size_t>(length);
  const int tournaments = static_cast<int>(pairs.size() / size);
  if (tournaments == 0) {
    std::fprintf(stderr, "label_exchange: %zu pairs are not enough for one tournament\n", pairs.size());
    return 2;
  }
  Errors errors;
  for (int each = 0; each < tournaments; ++each) {
    const std::size_t begin = static_cast<std::size_t>(each) * size;
    judge(pairs, begin, begin + size, most_goals, coin, errors);
  }
  std::printf("%zu pairs, %d tournaments of %d pairs\n", pairs.size(), tournaments, length);
  print("paired t of goals", errors.t, tournaments);
  print("signs of pairs", errors.score, tournaments);
  print("betting on goals, at any time", errors.betting, tournaments);
  print("sequential test [0, 50] nElo: H1", errors.sequential, tournaments);
}
