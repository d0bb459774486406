// SPDX-License-Identifier: MIT
// How often tests of real matches err. Pairs of two different teams are cut into tournaments of equal length; in each
// pair a coin decides which team is called the first. Then neither is better, whatever the teams are, and every
// rejection is an error: at a level of 5 % at most 5 % of the tournaments may end with one. Each test is that of the
// program itself: of tournaments, of experiments, and of the verification of a tuning.
//
//   regista report PAIRS.db --csv | label_exchange PAIRS_PER_TOURNAMENT MOST_GOALS [SEED]
//
// MOST_GOALS: the largest goal difference of a match, as the tournament bet with it (docs/statistics.md).
// Tests of a number other than goals need two more columns, home_metric and away_metric (scripts/prove labels).
// Two teams are needed that do not play the same: a tournament of a team against itself has only even pairs.
// Status 1: a test rejected more often than one of level 5 % does with a probability of 1 %.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "statistics/anytime_valid_tests.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/sequential_test.hpp"
#include "study/paired_estimates.hpp"
#include "study/tournament_course.hpp"
#include "study/tuning/tuning_study.hpp"

namespace {

using namespace regista::statistics;
namespace study = regista::study;

constexpr double alpha = 0.05;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Of the two matches of a pair, for the team that is at home in the first, and for the other: goal differences of the
// first team, mean values of the metric.
struct Pair {
  int first, second;
  std::array<double, 2> metric;
};

GameOutcome outcome(int goals) {
  return goals > 0 ? GameOutcome::win : goals < 0 ? GameOutcome::loss : GameOutcome::draw;
}

// Columns by name, a row each. Fields with quotes stand behind the ones that are read.
class Table {
 public:
  explicit Table(std::istream& in) {
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = fields_of(line);
    for (std::size_t i = 0; i < names.size(); ++i) columns_.emplace(names[i], i);
    while (std::getline(in, line)) rows_.push_back(fields_of(line));
  }
  std::size_t rows() const { return rows_.size(); }
  bool has(const std::string& column) const { return columns_.contains(column); }
  double at(std::size_t row, const std::string& column) const {
    const std::string& text = rows_.at(row).at(columns_.at(column));
    return text.empty() ? missing : std::atof(text.c_str());
  }

 private:
  static std::vector<std::string> fields_of(const std::string& line) {
    std::istringstream fields(line);
    std::vector<std::string> out;
    for (std::string each; std::getline(fields, each, ',');) out.push_back(each);
    return out;
  }
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> rows_;
};

std::vector<Pair> pairs_of(const Table& table) {
  const bool with_metric = table.has("home_metric") && table.has("away_metric");
  const auto goals = [&](std::size_t row) {
    return static_cast<int>(table.at(row, "home_goals") - table.at(row, "away_goals"));
  };
  const auto metric = [&](std::size_t row, const char* column) {
    return with_metric ? table.at(row, column) : missing;
  };
  std::vector<Pair> out;
  // The sides are swapped in the second.
  for (std::size_t i = 0; i + 1 < table.rows(); i += 2) {
    out.push_back({goals(i),
                   -goals(i + 1),
                   {(metric(i, "home_metric") + metric(i + 1, "away_metric")) / 2.0,
                    (metric(i, "away_metric") + metric(i + 1, "home_metric")) / 2.0}});
  }
  return out;
}

// What the coin left of a tournament: values of the pairs for either label.
struct Labelled {
  std::vector<double> goals, nothing, first, second;
  std::vector<std::array<int, 2>> matches;  // goal differences
};

Labelled labelled(std::span<const Pair> pairs, std::mt19937_64& coin) {
  Labelled out;
  for (const Pair& pair : pairs) {
    const bool as_it_was = (coin() >> 63) == 0;
    const int sign = as_it_was ? 1 : -1;
    out.matches.push_back({sign * pair.first, sign * pair.second});
    out.goals.push_back(sign * (pair.first + pair.second) / 2.0);
    out.nothing.push_back(0.0);
    out.first.push_back(pair.metric[as_it_was ? 0 : 1]);
    out.second.push_back(pair.metric[as_it_was ? 1 : 0]);
  }
  return out;
}

double deviation_of(std::span<const double> first, std::span<const double> second) {
  Moments out;
  for (std::size_t i = 0; i < first.size(); ++i) out.add(first[i] - second[i]);
  return out.variance() > 0.0 ? out.standard_deviation() : 1.0;
}

bool sequential(const Labelled& told, Model model) {
  SequentialTest test({model, {0.0, 50.0}, {alpha, alpha}, true});
  for (const auto& [first, second] : told.matches) test.add(pair_outcome(outcome(first), outcome(second)));
  return test.verdict() == Verdict::accept_h1;
}

bool signs_of_pairs(const Labelled& told) {
  WholeCounts goals;
  for (const auto& [first, second] : told.matches) ++goals[first + second];
  return sign_flip_p(goals) <= alpha;
}

bool betting(const Labelled& told, double most_goals) {
  BettingGrid test({-most_goals, most_goals, alpha, 1.0}, 4000);
  for (const double goals : told.goals) test.add(goals);
  return test.finding(0.0) != BettingTest::Finding::none;
}

bool metric_signs(const Labelled& told) {
  study::MetricDifference test(alpha);
  for (std::size_t i = 0; i < told.first.size(); ++i) test.add(told.first[i], told.second[i]);
  return test.test().finding() != BettingTest::Finding::none;
}

bool experiment(std::span<const double> first, std::span<const double> second, study::PairTest test) {
  const auto found = study::p_of_values(study::paired_differences(first, second), test);
  return found && found->p <= alpha;
}

// deviation: from other matches.
bool verification(std::span<const double> first, std::span<const double> second, double deviation,
                  std::optional<double> widest) {
  study::Verification test(1, 1.0 - alpha, deviation, widest);
  for (std::size_t i = 0; i < first.size() && !test.decided(); ++i) test.add(second[i], {&first[i], 1});
  return test.findings().front() != study::VerifiedAs::undecided;
}

// Rejections by name of the test, in the order in which they were first told.
class Rejections {
 public:
  void add(const char* test, bool rejected) {
    for (auto& [name, rejections] : counts_) {
      if (name == test) {
        rejections += rejected ? 1 : 0;
        return;
      }
    }
    counts_.emplace_back(test, rejected ? 1 : 0);
  }
  const std::vector<std::pair<std::string, int>>& all() const { return counts_; }

 private:
  std::vector<std::pair<std::string, int>> counts_;
};

// The most rejections that a test of this level shows in so many tries, but for 1 % of the time.
int most_rejections(int tries) {
  double chance = std::pow(1.0 - alpha, tries), sum = chance;
  int out = 0;
  for (; sum < 0.99; ++out) {
    chance *= (tries - out) / (out + 1.0) * alpha / (1.0 - alpha);
    sum += chance;
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int length = argc > 1 ? std::atoi(argv[1]) : 0, most_goals = argc > 2 ? std::atoi(argv[2]) : 0;
  if (length < 2 || most_goals < 1) {
    std::fprintf(stderr, "regista report PAIRS.db --csv | label_exchange PAIRS_PER_TOURNAMENT MOST_GOALS [SEED]\n");
    return 2;
  }
  std::mt19937_64 coin(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  const std::vector<Pair> pairs = pairs_of(Table(std::cin));
  const auto size = static_cast<std::size_t>(length);
  const std::size_t tournaments = pairs.size() / size;
  if (tournaments < 2) {
    std::fprintf(stderr, "label_exchange: %zu pairs are not enough for two tournaments\n", pairs.size());
    return 2;
  }
  std::vector<Labelled> all;
  for (std::size_t i = 0; i < tournaments; ++i) all.push_back(labelled(std::span(pairs).subspan(i * size, size), coin));
  const double most = most_goals;
  Rejections errors;
  for (std::size_t i = 0; i < tournaments; ++i) {
    using enum regista::config::PairedTest;
    const Labelled& told = all[i];
    const Labelled& before = all[i == 0 ? tournaments - 1 : i - 1];  // what is expected comes from other matches
    const double deviation = deviation_of(before.goals, before.nothing);
    errors.add("tournament: sequential, normalized", sequential(told, Model::normalized));
    errors.add("tournament: sequential, logistic", sequential(told, Model::logistic));
    errors.add("tournament: signs of pairs", signs_of_pairs(told));
    errors.add("tournament: betting on goals", betting(told, most));
    errors.add("experiment: paired t of goals", experiment(told.goals, told.nothing, paired_t));
    errors.add("experiment: sign flips of goals", experiment(told.goals, told.nothing, sign_flip));
    errors.add("verification: goals, betting", verification(told.goals, told.nothing, deviation, most));
    errors.add("verification: goals, symmetry", verification(told.goals, told.nothing, deviation, {}));
    if (std::isnan(told.first.front())) continue;
    errors.add("tournament: signs of a metric", metric_signs(told));
    errors.add("experiment: paired t of a metric", experiment(told.first, told.second, paired_t));
    errors.add("experiment: sign flips of a metric", experiment(told.first, told.second, sign_flip));
    errors.add("verification: a metric, symmetry",
               verification(told.first, told.second, deviation_of(before.first, before.second), {}));
  }
  const int tries = static_cast<int>(tournaments), limit = most_rejections(tries);
  std::printf(
      "%zu pairs, %d tournaments of %d pairs; at a level of 5 %% at most %d rejections are expected, and %d are "
      "seen or fewer but for 1 %% of the time\n",
      pairs.size(), tries, length, tries / 20, limit);
  bool sound = true;
  for (const auto& [test, rejections] : errors.all()) {
    std::printf("  %-36s %4d of %d  %4.1f %%%s\n", test.c_str(), rejections, tries, 100.0 * rejections / tries,
                rejections > limit ? "  TOO MANY" : "");
    sound = sound && rejections <= limit;
  }
  return sound ? 0 : 1;
}
