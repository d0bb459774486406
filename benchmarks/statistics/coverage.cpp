// SPDX-License-Identifier: MIT
// How often intervals of 95 % hold the truth and tests at 5 % err, by simulation: scores (and so Elo), LOS, goal
// differences with Student's t and sign flips, normalised Elo, Bradley-Terry, for laws of pairs whose truth is known
// (tests/unit/statistics/pair_laws.hpp). Tables in Markdown, as docs/statistics.md shows them. A cell: the share of the
// intervals given that hold the truth; in brackets the share of draws in which an interval was given, where that is not
// all.
//
//   coverage [DRAWS [SEED]]     default: 10000 draws for each cell, seed 1; of Bradley-Terry less than half
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pair_laws.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
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

constexpr double central_normal = 1.959963984540054;  // the z of a central interval of 95 % of a normal law

// As it was before the spread was taken as uncertain: +- 347.44 z / sqrt(games).
Interval with_known_spread(const ScoreLaw& law) {
  const double value = normalized_elo(law).value;
  const double margin = normalized_elo_scale * central_normal / std::sqrt(2.0 * law.units);
  return {value - margin, value + margin};
}

void of_pairs(Run& run) {
  constexpr std::array normalized{0.0, 100.0, 300.0, 600.0};
  std::printf(
      "| law | pairs | interval of | 0 nElo | 100 nElo | 300 nElo | 600 nElo |\n|---|---|---|---|---|---|---|\n");
  for (const Family family : all_families) {
    for (const int pairs : {20, 100, 1000}) {
      std::array<Coverage, 4> of_normalized, known;
      for (std::size_t i = 0; i < normalized.size(); ++i) {
        const PairLaw law = pair_law_of_normalized_elo(family, normalized[i]);
        LawDraws draws(run.seed, run.cell++);
        for (int draw = 0; draw < run.draws; ++draw) {
          const ScoreLaw seen = score_law(draws.pairs(law, pairs));
          of_normalized[i].add(normalized_elo(seen).interval, normalized[i]);
          known[i].add(with_known_spread(seen), normalized[i]);
        }
      }
      const auto row = [&](const char* what, const std::array<Coverage, 4>& cells) {
        std::printf("| %s | %d | %s |", name(family), pairs, what);
        for (const Coverage& each : cells) std::printf(" %s |", written(each).c_str());
        std::printf("\n");
      };
      row("nElo", of_normalized);
      row("nElo, spread as known", known);
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
          binomial += central_normal * binomial_deviations(elo, points_won(field.teams, encounters))[field.teams / 2];
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

constexpr std::array sizes{4, 6, 10, 20, 100, 1000};  // pairs

// Fewer draws of many pairs, so that a table takes seconds.
int draws_of(const Run& run, int pairs) { return pairs > 100 ? std::max(1, run.draws / 4) : run.draws; }

void of_scores(Run& run) {
  std::printf(
      "| law | even pairs | pairs | score 0.5 | 0.6 | 0.7 | LOS above 95 %% for equal teams |\n"
      "|---|---|---|---|---|---|---|\n");
  std::vector<Family> families(all_families.begin(), all_families.end());
  families.push_back(Family::even);
  for (const Family family : families) {
    for (const int pairs : sizes) {
      std::array<Coverage, 3> cells;
      int superior = 0;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const double score = 0.5 + 0.1 * static_cast<double>(i);
        const PairLaw law = pair_law_of_score(family, score);
        LawDraws draws(run.seed, run.cell++);
        for (int draw = 0; draw < draws_of(run, pairs); ++draw) {
          const ScoreLaw seen = score_law(draws.pairs(law, pairs));
          // As Elo, in which what is not known is infinite.
          cells[i].add(elo(seen).interval, elo_of_score(mean_score(law)));
          if (i == 0 && likelihood_of_superiority(seen).value_or(0.5) >= 0.95) ++superior;
        }
      }
      std::printf("| %s | %.0f %% | %d |", name(family), 100.0 * pair_law_of_score(family, 0.5)[2], pairs);
      for (const Coverage& each : cells) std::printf(" %s |", written(each).c_str());
      std::printf(" %.1f %% |\n", 100.0 * superior / draws_of(run, pairs));
      std::fflush(stdout);
    }
  }
}

// Goals of a match, first and second team, by laws that differ in how many there are and in how they scatter.
struct GoalLaw {
  const char* name;
  double goals;      // of each side, mean
  double unequal;    // scenes: one side has e^this times the goals, in the second match the other
  double scattered;  // variance of the strength of a day, which both matches share
  double forfeits;   // probability that either team forfeits a match 0:10
};
constexpr std::array goal_laws{GoalLaw{"football", 1.3, 0.0, 0.0, 0.0}, GoalLaw{"many goals", 4.0, 0.0, 0.0, 0.0},
                               GoalLaw{"scenes", 0.25, 0.8, 0.0, 0.0}, GoalLaw{"scattered", 1.3, 0.0, 0.5, 0.0},
                               GoalLaw{"forfeits", 1.3, 0.0, 0.0, 0.02}};

// Of both matches of a pair together. The day makes either team the stronger one as often.
int goals_of_pair(const GoalLaw& law, double better, LawDraws& draws) {
  const double day = law.scattered > 0.0 ? (draws.uniform() < 0.5 ? -1.0 : 1.0) * std::sqrt(law.scattered) : 0.0;
  int out = 0;
  for (const double side : {1.0, -1.0}) {
    const double more = std::exp(side * law.unequal + day);
    int difference = draws.poisson(law.goals * more + better) - draws.poisson(law.goals / more);
    if (law.forfeits > 0.0) {
      const double chance = draws.uniform();
      if (chance < 2.0 * law.forfeits) difference = chance < law.forfeits ? 10 : -10;
    }
    out += std::clamp(difference, -10, 10);
  }
  return out;
}

void of_goals(Run& run) {
  std::printf(
      "| law of goals | pairs | Student's t, equal | better team | sign flips reject equal teams |\n"
      "|---|---|---|---|---|\n");
  constexpr int for_truth = 2'000'000;
  constexpr double better = 0.5;  // goals a match
  for (const GoalLaw& law : goal_laws) {
    double truth = 0.0;  // clamping takes a little off
    LawDraws many(run.seed, run.cell++);
    for (int draw = 0; draw < for_truth; ++draw) truth += goals_of_pair(law, better, many) / 2.0 / for_truth;
    for (const int pairs : sizes) {
      Coverage equal, stronger;
      int rejected = 0;
      LawDraws draws(run.seed, run.cell++);
      for (int draw = 0; draw < draws_of(run, pairs); ++draw) {
        for (const bool even : {true, false}) {
          Moments moments;
          WholeCounts counts;
          for (int pair = 0; pair < pairs; ++pair) {
            const int goals = goals_of_pair(law, even ? 0.0 : better, draws);
            ++counts[goals];
            moments.add(goals / 2.0);
          }
          const auto found = pairs < 6 ? std::nullopt : paired_t(moments);
          (even ? equal : stronger).add(found ? found->interval : Interval{-infinite, infinite}, even ? 0.0 : truth);
          if (even && sign_flip_p(counts) <= 0.05) ++rejected;
        }
      }
      std::printf("| %s | %d | %s | %s | %.1f %% |\n", law.name, pairs, written(equal).c_str(),
                  written(stronger).c_str(), 100.0 * rejected / draws_of(run, pairs));
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Run run{argc > 1 ? std::atoi(argv[1]) : 10000, argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1};
  if (run.draws < 1) {
    std::fprintf(stderr, "coverage [DRAWS [SEED]]: expected a number of draws above 0\n");
    return 2;
  }
  std::printf("Scores of pairs, and so Elo\n\n");
  of_scores(run);
  std::printf("\nGoal differences\n\n");
  of_goals(run);
  std::printf("\nNormalised Elo of pairs\n\n");
  of_pairs(run);
  std::printf("\nBradley-Terry\n\n");
  of_rankings(run);
}
