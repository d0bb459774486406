// SPDX-License-Identifier: MIT
// How often intervals of 95 % hold the truth, by simulation: of normalised Elo, Elo, Bradley-Terry and the paired t
// test, for laws of pairs whose truth is known (tests/unit/statistics/pair_laws.hpp). Tables in Markdown, as
// docs/statistics.md shows them. A cell: the share of the intervals given that hold the truth; in brackets the share of
// draws in which an interval was given, where that is not all.
//
//   coverage [DRAWS [SEED]]     default: 10000 draws for each cell, seed 1; of Bradley-Terry less than half
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "pair_laws.hpp"
#include "statistics/bradley_terry.hpp"
#include "statistics/distributions.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/rating.hpp"

namespace {

using namespace regista::statistics;

struct Run {
  int draws;
  std::uint64_t seed;
  std::uint32_t cell = 0;  // every cell has a stream of its own
};

std::string written(const Coverage& coverage) {
  char out[64];
  if (coverage.given == 0) return "none given";
  if (coverage.given == coverage.drawn) {
    std::snprintf(out, sizeof out, "%.1f %%", 100.0 * coverage.share_held());
  } else {
    std::snprintf(out, sizeof out, "%.1f %% (%.0f %%)", 100.0 * coverage.share_held(), 100.0 * coverage.share_given());
  }
  return out;
}

// As it was before the spread was taken as uncertain: +- 347.44 z / sqrt(games).
Interval with_known_spread(const ScoreLaw& law) {
  const double value = normalized_elo(law).value;
  const double margin = normalized_elo_scale * central_normal(0.95) / std::sqrt(2.0 * law.units);
  return {value - margin, value + margin};
}

void of_pairs(Run& run) {
  constexpr std::array normalized{0.0, 100.0, 300.0, 600.0};
  std::printf(
      "| law | pairs | interval of | 0 nElo | 100 nElo | 300 nElo | 600 nElo |\n|---|---|---|---|---|---|---|\n");
  for (const Family family : all_families) {
    for (const int pairs : {20, 100, 1000}) {
      std::array<Coverage, 4> of_normalized, known, of_elo;
      for (std::size_t i = 0; i < normalized.size(); ++i) {
        const PairLaw law = pair_law_of_normalized_elo(family, normalized[i]);
        const double true_elo = elo_of_score(mean_score(law));
        LawDraws draws(run.seed, run.cell++);
        for (int draw = 0; draw < run.draws; ++draw) {
          const ScoreLaw seen = score_law(draws.pairs(law, pairs));
          of_normalized[i].add(normalized_elo(seen).interval, normalized[i]);
          known[i].add(with_known_spread(seen), normalized[i]);
          of_elo[i].add(elo(seen).interval, true_elo);
        }
      }
      const auto row = [&](const char* what, const std::array<Coverage, 4>& cells) {
        std::printf("| %s | %d | %s |", name(family), pairs, what);
        for (const Coverage& each : cells) std::printf(" %s |", written(each).c_str());
        std::printf("\n");
      };
      row("nElo", of_normalized);
      row("nElo, spread as known", known);
      row("Elo", of_elo);
      std::fflush(stdout);
    }
  }
}

// As if all games were independent and none drawn: the curvature of the likelihood. Of teams that play equally many
// games it is near enough, for a comparison of widths, to look at that of one team alone.
std::vector<double> binomial_deviations(const std::vector<double>& elo, const SquareTable& points) {
  const auto teams = static_cast<double>(elo.size());
  std::vector<double> out;
  for (std::size_t i = 0; i < elo.size(); ++i) {
    double curvature = 0.0;
    for (std::size_t j = 0; j < elo.size(); ++j) {
      if (i == j) continue;
      const double expected = score_of_elo(elo[i] - elo[j]);
      curvature += (points.at(i, j) + points.at(j, i)) * expected * (1.0 - expected);
    }
    out.push_back(normalized_elo_scale / 2.0 * (teams - 1.0) / teams / std::sqrt(curvature));
  }
  return out;
}

void of_rankings(Run& run) {
  std::printf(
      "| law | teams | largest difference | pairs a pairing | all teams | worst team | half width, Elo | by the "
      "likelihood alone |\n|---|---|---|---|---|---|---|---|\n");
  struct Field {
    std::size_t teams;
    double range;  // of the strengths
  };
  for (const Family family : all_families) {
    for (const Field field : {Field{3, 0.3}, Field{4, 1.0}, Field{8, 0.6}, Field{8, 2.0}}) {
      for (const int pairs : {5, 20, 100, 1000}) {
        if (pairs == 1000 && field.teams == 8) continue;
        std::vector<PairLaw> laws;
        SquareTable expected(field.teams);
        for (std::size_t i = 0; i < field.teams; ++i) {
          for (std::size_t j = i + 1; j < field.teams; ++j) {
            const double apart = field.range * static_cast<double>(j - i) / static_cast<double>(field.teams - 1);
            laws.push_back(pair_law(family, apart));
            expected.at(i, j) = mean_score(laws.back());
            expected.at(j, i) = 1.0 - expected.at(i, j);
          }
        }
        const std::vector<double> truth = *bradley_terry_elo(expected);
        std::vector<Coverage> of_team(field.teams);
        Coverage all;
        double width = 0.0, binomial = 0.0;
        LawDraws draws(run.seed, run.cell++);
        const int rounds = std::max(1, run.draws * 2 / 5);
        for (int draw = 0; draw < rounds; ++draw) {
          std::vector<Encounter> encounters;
          auto law = laws.begin();
          for (std::size_t i = 0; i < field.teams; ++i) {
            for (std::size_t j = i + 1; j < field.teams; ++j)
              encounters.push_back({i, j, draws.pairs(*law++, pairs), {}});
          }
          const auto found = bradley_terry(field.teams, encounters);
          std::vector<double> elo;
          for (std::size_t i = 0; i < field.teams; ++i) {
            constexpr double infinite = std::numeric_limits<double>::infinity();
            const Interval interval = found ? (*found)[i].interval : Interval{-infinite, infinite};
            of_team[i].add(interval, truth[i]);
            all.add(interval, truth[i]);
            if (found) elo.push_back((*found)[i].value);
          }
          if (!found || (*found)[field.teams / 2].interval.unbounded()) continue;
          width += (*found)[field.teams / 2].margin();
          binomial +=
              central_normal(0.95) * binomial_deviations(elo, points_won(field.teams, encounters))[field.teams / 2];
        }
        const auto worst = std::ranges::min_element(of_team, {}, &Coverage::share_held);
        const int given = std::max(1, of_team[field.teams / 2].given);
        std::printf("| %s | %zu | %.0f Elo | %d | %s | %s | %.1f | %.1f |\n", name(family), field.teams,
                    truth.front() - truth.back(), pairs, written(all).c_str(), written(*worst).c_str(), width / given,
                    binomial / given);
        std::fflush(stdout);
      }
    }
  }
}

void of_goals(Run& run) {
  std::printf("| goals a side | 5 pairs | 20 pairs | 100 pairs |\n|---|---|---|---|\n");
  for (const double goals : {0.25, 1.3}) {
    std::printf("| %.2f |", goals);
    for (const int pairs : {5, 20, 100}) {
      const double mine = goals * 1.3, theirs = goals;
      Coverage coverage;
      LawDraws draws(run.seed, run.cell++);
      std::vector<double> values(static_cast<std::size_t>(pairs));
      for (int draw = 0; draw < run.draws; ++draw) {
        for (double& each : values) {
          const int for_first = draws.poisson(2.0 * mine);
          const int for_second = draws.poisson(2.0 * theirs);
          each = 0.5 * (for_first - for_second);
        }
        constexpr double infinite = std::numeric_limits<double>::infinity();
        const auto found = paired_t(values);
        coverage.add(found ? found->interval : Interval{-infinite, infinite}, mine - theirs);
      }
      std::printf(" %s |", written(coverage).c_str());
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  Run run{argc > 1 ? std::atoi(argv[1]) : 10000, argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1};
  if (run.draws < 1) {
    std::fprintf(stderr, "coverage [DRAWS [SEED]]: expected a number of draws above 0\n");
    return 2;
  }
  std::printf("Normalised Elo and Elo of pairs\n\n");
  of_pairs(run);
  std::printf("\nBradley-Terry\n\n");
  of_rankings(run);
  std::printf("\nPaired t of the goal difference\n\n");
  of_goals(run);
}
