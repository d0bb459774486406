// SPDX-License-Identifier: MIT
// How often a sign-flip test finds the difference that host/statistics/paired_tests.hpp says so many pairs find in 80
// of 100 studies, by simulation: of normal differences, of whole matches and of scenes in which most pairs are even. A
// table in Markdown, as docs/statistics.md shows it.
//
//   power [STUDIES [SEED]]     default: 4000 for each cell, seed 1
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"

namespace {

using namespace regista::statistics;
using Chance = std::mt19937_64;

// A pair's mean difference of goals in two matches in which the teams score by Poisson's law, the first one `more`
// goals a match above the usual, the second one below.
double pair_of_goals(Chance& chance, double usual, double more) {
  const double first = usual + more / 2.0, second = std::max(usual - more / 2.0, 1e-9);
  std::poisson_distribution<int> of_first(first), of_second(second);
  double sum = 0.0;
  for (int match = 0; match < 2; ++match) {
    sum += of_first(chance);
    sum -= of_second(chance);
  }
  return sum / 2.0;
}

struct Law {
  const char* name;
  double usual;  // goals a match of each team; 0: the difference is normal, with a deviation of 1
};

// As a large pilot of equal teams shows it.
Spread spread_of(const Law& law) {
  Chance chance(1);
  Moments pilot;
  for (int pair = 0; law.usual > 0.0 && pair < 100000; ++pair) pilot.add(pair_of_goals(chance, law.usual, 0.0));
  return law.usual > 0.0 ? Spread(pilot) : Spread(1.0);
}

double share_found(const Law& law, std::int64_t pairs, const PowerDesign& design, int studies, Chance& chance) {
  const double difference = *difference_found(pairs, spread_of(law), design);
  std::normal_distribution<double> normal(difference, 1.0);
  const double level = design.alpha / static_cast<double>(design.family);
  std::vector<double> values(static_cast<std::size_t>(pairs));
  int found = 0;
  for (int study = 0; study < studies; ++study) {
    for (double& value : values)
      value = law.usual == 0.0 ? normal(chance) : pair_of_goals(chance, law.usual, difference);
    found += sign_flip_p_of_values(values) <= level ? 1 : 0;
  }
  return static_cast<double>(found) / studies;
}

}  // namespace

int main(int count, char** words) {
  const int studies = count > 1 ? std::atoi(words[1]) : 4000;
  Chance chance(count > 2 ? std::strtoull(words[2], nullptr, 10) : 1);
  constexpr std::array laws{Law{"normal", 0.0}, Law{"whole matches, 2.5 goals a side", 2.5},
                            Law{"whole matches, 1 goal a side", 1.0}, Law{"scenes, 0.25 goals a side", 0.25}};
  std::printf("| law | comparisons |");
  constexpr std::array<std::int64_t, 7> sizes{6, 7, 8, 10, 20, 40, 100};
  for (const std::int64_t pairs : sizes) std::printf(" %d pairs |", static_cast<int>(pairs));
  std::printf("\n|---|---|");
  for (std::size_t i = 0; i < sizes.size(); ++i) std::printf("---|");
  std::printf("\n");
  for (const Law& law : laws) {
    for (const std::int64_t family : {1, 3}) {
      const PowerDesign design{0.05, family, 0.8, PairedTest::sign_flip};
      std::printf("| %s | %d |", law.name, static_cast<int>(family));
      for (const std::int64_t pairs : sizes) {
        if (pairs < smallest_pairs(design)) {
          std::printf(" – |");
          continue;
        }
        std::printf(" %.0f %% |", 100.0 * share_found(law, pairs, design, studies, chance));
        std::fflush(stdout);
      }
      std::printf("\n");
    }
  }
  return 0;
}
