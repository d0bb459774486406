// SPDX-License-Identifier: MIT
// The output of the commands for statistics. `regista sprt`: the sequential probability ratio test on scores, and
// strengths, from counts of games or pairs. `regista rank`: the ranking of teams from a table of results. `regista
// power`: how many pairs find a difference, from the results of a study. All texts and JSON end with a newline.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/rating.hpp"
#include "statistics/sequential_test.hpp"
#include "study/paired_estimates.hpp"
#include "study/table.hpp"

namespace regista::report {

struct SequentialTestOfCounts {
  std::vector<statistics::Count> counts;
  statistics::SequentialDesign design;
  statistics::SequentialBounds bounds;
  statistics::LogLikelihoodRatio ratio;
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  std::optional<double> superiority;
  std::optional<double> pair_ratio;
};

// counts: of the first team, not all zero: of pairs (LL, LD, WL and DD, WD, WW) or of games (L, D, W).
SequentialTestOfCounts test_counts(const std::vector<statistics::Count>& counts,
                                   const statistics::SequentialDesign& design);
std::string counts_text(const SequentialTestOfCounts& test);
std::string counts_json(const SequentialTestOfCounts& test);

// A ranking by Bradley-Terry Elo, of each group of teams that met; the intervals use the spread of pairs.
struct RankedResults {
  struct Team {
    std::string name;
    std::optional<statistics::Estimate> elo;  // missing: not determined by the results; the sum in a group is 0
    double points = 0.0;
    statistics::Count games = 0;
    std::size_t group = 0;
  };
  // A group's teams are together, best first: by Elo or, without Elo, by share of points. Ties keep the file's order.
  std::vector<Team> teams;
  statistics::Count games = 0, pairs = 0;
  std::vector<std::string> remarks;  // sentences
};

RankedResults ranked(const study::ResultsOfTeams& results);
std::string ranking_text(const RankedResults& ranking);
std::string ranking_json(const RankedResults& ranking);

// --- Power for each comparison of two teams or arms: the spread of the differences of pairs, the number of pairs that
// finds `difference`, and the smallest difference that `pairs` pairs find.

struct PowerQuestion {
  statistics::PowerDesign design;
  std::optional<double> difference;
  std::optional<std::int64_t> pairs;
  bool sequential = false;  // true: the study uses a sequential test
  const char* what = "";    // word for a comparison, such as "Pairing"; several: its plural
  const char* several = "";
  std::string origin{};  // sentence: how `difference` follows from another unit
};

bool has_spread(const study::ComparedPairs& pairs);  // whether power can be computed: it needs a spread

// Precondition: at least one comparison has a spread.
std::string power_text(const study::PairDifferences& study, const PowerQuestion& question);
std::string power_json(const study::PairDifferences& study, const PowerQuestion& question);

}  // namespace regista::report
