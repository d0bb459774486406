// SPDX-License-Identifier: MIT
// Laws of games and pairs whose strength is known, and draws from them: for tests and benchmarks that count how often
// an interval holds the truth.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "match/chance.hpp"
#include "statistics/counts.hpp"
#include "statistics/rating.hpp"

namespace regista::statistics {

using GameLaw = std::array<double, 3>;  // probability of a loss, a draw, a win
using PairLaw = std::array<double, 5>;  // of LL, LD, WL or DD, WD, WW

inline PairLaw pair_of(const GameLaw& one, const GameLaw& other) {
  PairLaw out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[i + j] += one[i] * other[j];
  }
  return out;
}

inline double mean_score(const PairLaw& law) { return 0.25 * (law[1] + 2.0 * law[2] + 3.0 * law[3] + 4.0 * law[4]); }

inline double true_normalized_elo(const PairLaw& law) {
  const double mean = mean_score(law);
  double variance = 0.0;
  for (std::size_t i = 0; i < law.size(); ++i) {
    const double deviation = 0.25 * static_cast<double>(i) - mean;
    variance += law[i] * deviation * deviation;
  }
  return normalized_elo_scale * (mean - 0.5) / std::sqrt(2.0 * variance);
}

// P. V. Rao and L. L. Kupper, "Ties in Paired-Comparison Experiments", 1967: a game is drawn unless it is won by more
// than a margin on the logistic scale. In Elo.
inline GameLaw logistic_game(double elo, double draw_margin) {
  const double win = score_of_elo(elo - draw_margin), loss = score_of_elo(-elo - draw_margin);
  return {loss, 1.0 - win - loss, win};
}

// Goals by Poisson's law, as football is usually modelled (M. J. Maher, "Modelling Association Football Scores", 1982).
inline GameLaw poisson_game(double goals, double goals_against) {
  GameLaw out{};
  double mine = std::exp(-goals);
  for (int i = 0; i < 60; mine *= goals / ++i) {
    double theirs = std::exp(-goals_against);
    for (int j = 0; j < 60; theirs *= goals_against / ++j) out[i < j ? 0 : i == j ? 1 : 2] += mine * theirs;
  }
  return out;
}

// Two games from one scene that gives the side that begins e^(2 unequal) times the goals; strength multiplies likewise.
inline PairLaw poisson_pair(double strength, double goals, double unequal) {
  const auto game = [&](double more) { return poisson_game(goals * std::exp(more), goals * std::exp(-more)); };
  return pair_of(game(strength + unequal), game(strength - unequal));
}

// The families of laws, by a strength of no unit.
enum class Family {
  tilted,    // 1 : 2 : 4 : 2 : 1, tilted
  logistic,  // two independent games, drawn within 200 Elo: 52 % of games between equals
  football,  // 1.3 goals a side and game, scenes that are a little unequal
  scenes,    // short games: 0.25 goals a side, unequal scenes
  decided,   // 4 : 1 : 2 : 1 : 4, tilted: most pairs are won or lost twice
  even,      // 1 : 12 : 74 : 12 : 1, tilted: most pairs are even; not of all_families
};
inline constexpr std::array all_families{Family::tilted, Family::logistic, Family::football, Family::scenes,
                                         Family::decided};

inline const char* name(Family family) {
  constexpr std::array names{"tilted", "logistic", "football", "scenes", "decided", "even"};
  return names[static_cast<std::size_t>(family)];
}

inline PairLaw tilted(PairLaw law, double strength) {
  double sum = 0.0;
  for (std::size_t i = 0; i < law.size(); ++i) sum += law[i] *= std::exp(strength * static_cast<double>(i));
  for (double& each : law) each /= sum;
  return law;
}

inline PairLaw pair_law(Family family, double strength) {
  switch (family) {
    case Family::tilted:
      return tilted({1.0, 2.0, 4.0, 2.0, 1.0}, strength);
    case Family::decided:
      return tilted({4.0, 1.0, 2.0, 1.0, 4.0}, strength);
    case Family::even:
      return tilted({1.0, 12.0, 74.0, 12.0, 1.0}, strength);
    case Family::logistic: {
      const GameLaw game = logistic_game(400.0 * strength, 200.0);
      return pair_of(game, game);
    }
    case Family::football:
      return poisson_pair(strength, 1.3, 0.3);
    case Family::scenes:
      break;
  }
  return poisson_pair(strength, 0.25, 0.8);
}

// The law of a family of which a number that grows with strength has this value, that of equal teams or above.
inline PairLaw pair_law_with(Family family, double (*number)(const PairLaw&), double wanted) {
  double low = 0.0, high = 4.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2.0;
    (number(pair_law(family, middle)) < wanted ? low : high) = middle;
  }
  return pair_law(family, low);
}
inline PairLaw pair_law_of_score(Family family, double score) { return pair_law_with(family, mean_score, score); }
inline PairLaw pair_law_of_normalized_elo(Family family, double elo) {
  return pair_law_with(family, true_normalized_elo, elo);
}

// Draws of one cell of a table: a stream of its own, named by the seed and the cell.
class LawDraws {
 public:
  LawDraws(std::uint64_t seed, std::uint32_t cell) : words_(seed, {0, 0, cell, 0x636f7665}) {}

  double uniform() { return static_cast<double>(words_.next()) * 0x1p-32; }

  std::size_t outcome(std::span<const double> law) {
    double left = uniform();
    std::size_t out = 0;
    while (out + 1 < law.size() && left >= law[out]) left -= law[out++];
    return out;
  }

  PairCounts pairs(const PairLaw& law, int number) {
    PairCounts out;
    for (int i = 0; i < number; ++i) ++out.seen[outcome(law)];
    return out;
  }

  // Knuth's product of uniform numbers: for a few goals.
  int poisson(double mean) {
    const double least = std::exp(-mean);
    int out = -1;
    for (double product = 1.0; product > least; ++out) product *= uniform();
    return out;
  }

 private:
  match::RandomWords words_;
};

// How often intervals were given, and how often these held the truth.
struct Coverage {
  int drawn = 0, given = 0, held = 0;

  void add(const Interval& interval, double truth) {
    ++drawn;
    if (interval.unbounded()) return;
    ++given;
    held += interval.contains(truth) ? 1 : 0;
  }
  double share_given() const { return static_cast<double>(given) / drawn; }
  double share_held() const { return given == 0 ? 0.0 : static_cast<double>(held) / given; }
};

}  // namespace regista::statistics
