// SPDX-License-Identifier: MIT
// Plans of tunings, made by hand, and somebody who plays their matches without playing: a goal difference that is a
// known function of the parameters' values, with noise that is a function of the match.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_encoding.hpp"
#include "plugin/shared_object.hpp"
#include "study/tuning/tuning_study.hpp"

namespace regista::study {

// Parameters "p0", "p1", ... of [0, 1], at 0.5; opponents "opponent 0", ... of equal weight.
inline TuningPlan tuning_of(std::size_t parameters, std::size_t opponents,
                            Algorithm algorithm = Algorithm::random_search) {
  TuningPlan plan;
  plan.asked.name = "trial";
  plan.asked.team = "base.yaml";
  plan.document = "team: base\n";
  plan.asked.slices.points = 0;
  for (std::size_t i = 0; i < parameters; ++i) {
    plan.asked.parameters.push_back({fmt::format("p{}", i), std::nullopt, {}, {}});
    plan.parameters.push_back({fmt::format("p{}", i), 0.5, 0.0, 1.0, false, false, "1", "what it does"});
    plan.document += fmt::format("p{}: 0.5\n", i);
  }
  const auto against = [&](const std::string& label, double weight) {
    TuningOpponent out;
    out.label = label;
    out.file = label + ".yaml";
    out.weight = weight;
    for (const std::size_t side : {0u, 1u}) {
      campaign::Job& job = out.jobs[side];
      job.teams[side] = plan.asked.team;
      job.teams[1 - side] = out.file;
      std::vector<campaign::Input>&own = side == 0 ? job.home_inputs : job.away_inputs,
      &other = side == 0 ? job.away_inputs : job.home_inputs;
      own.push_back({"team base", plugin::content_hash(plan.document)});
      own.push_back({"plugin x", "x"});
      other.push_back({"team " + label, "hash of " + label});
      job.common_inputs = {{"rules", "rules 1"}};
    }
    return out;
  };
  for (std::size_t i = 0; i < opponents; ++i) {
    plan.opponents.push_back(against(fmt::format("opponent {}", i), 1.0 / static_cast<double>(opponents)));
    plan.asked.opponents.push_back({plan.opponents.back().file, 1.0, {}});
  }
  plan.base = against("the base team", 1.0);
  plan.objective.terms = {{"goal_difference", 1.0}};
  plan.most_goals = 10;
  plan.asked.seed = 7;
  plan.asked.settings.seeds = config::Seeds::consecutive;
  plan.asked.search.algorithm = name(algorithm);
  plan.search_pairs = 40;
  plan.asked.selection.finalists = 3;
  plan.selection_pairs = 4;
  plan.asked.verification.candidates = 1;
  plan.verification_pairs = 30;
  return plan;
}

// The values of the parameters that a match says for one side; those it does not say are at 0.5.
inline ParameterValues said_values(const campaign::Job& job, std::size_t side, std::size_t parameters) {
  ParameterValues out(parameters, 0.5);
  const std::string own = side == 0 ? "home.p" : "away.p";
  for (const std::string& each : job.overrides) {
    if (!each.starts_with(own)) continue;
    const std::size_t equals = each.find('=');
    out.at(std::stoul(each.substr(own.size(), equals - own.size()))) = std::stod(each.substr(equals + 1));
  }
  return out;
}

// A number of [0, 1) that is a function of what it is asked for.
inline double chance(std::uint64_t seed, std::uint64_t which) {
  std::uint64_t x = seed * 0x9e3779b97f4a7c15ull + which * 0xd1b54a32d192ed03ull + 0x2545f4914f6cdd1dull;
  for (int i = 0; i < 3; ++i) {
    x ^= x >> 31;
    x *= 0xbf58476d1ce4e5b9ull;
  }
  return static_cast<double>((x ^ (x >> 29)) >> 11) * 0x1p-53;
}

// Goals of a match whose home team is stronger by so much: their difference is on average that, and varies by `noise`.
inline campaign::MatchResult goals(double stronger, double noise, std::uint64_t seed, std::uint64_t which) {
  double sum = -6.0;  // a normal law, nearly
  for (std::uint64_t i = 0; i < 12; ++i) sum += chance(seed, 100 * which + i);
  const double wanted = stronger + noise * sum;
  // Rounded up or down at random, so that the mean stays.
  const double below = std::floor(wanted);
  int difference = static_cast<int>(below) + (chance(seed, 100 * which + 50) < wanted - below ? 1 : 0);
  difference = std::clamp(difference, -10, 10);
  campaign::MatchResult out;
  out.score = {std::max(difference, 0), std::max(-difference, 0)};
  out.ended = "full_time";
  out.hash = "h";
  out.metrics = campaign::metrics_from_json(
      fmt::format(R"({{"playing_seconds": 600, "packets": [{}, {}]}})", 100 + difference, 100 - difference));
  return out;
}

// Who plays: `strength` of a team's values; counts what is played.
class FakeMatches {
 public:
  using Strength = std::function<double(const ParameterValues&)>;
  using Judge = std::function<void(const campaign::Job&, campaign::MatchResult&)>;

  FakeMatches(const TuningPlan& plan, Strength strength, double noise)
      : parameters_(plan.parameters.size()), strength_(std::move(strength)), noise_(noise) {}

  campaign::MatchResult play(const campaign::Job& job) const {
    const double home = strength_(said_values(job, 0, parameters_)), away = strength_(said_values(job, 1, parameters_));
    // The fixture counts too: different teams on one seed do not have the same luck.
    const std::uint64_t which = std::stoull(
        plugin::content_hash(job.teams[0] + job.teams[1] + fmt::format("{}{}", home, away)).substr(0, 6), nullptr, 16);
    campaign::MatchResult out = goals(home - away, noise_, job.seed, which);
    if (judge) judge(job, out);
    return out;
  }

  // As a study's course wants it. Before each match `before` is asked, which may throw.
  PlayRound hook() {
    return [this](const Round& round) {
      for (std::uint64_t i = 0; i < round.matches; ++i) {
        const campaign::Job job = round.job(i);
        const auto key = std::pair(round.fixtures[round.at(i)->fixture].key, job.seed);
        if (!store.contains(key)) {
          if (before) before(played);
          ++played;
          store.emplace(key, play(job));
        }
        rows.push_back(round.first_row + i);
        ++taken;
        if (!round.take(i, &store.at(key))) return;
      }
    };
  }

  std::map<std::pair<std::string, std::uint64_t>, campaign::MatchResult> store;  // by fixture and seed
  std::function<void(std::uint64_t)> before;
  Judge judge;
  std::vector<std::uint64_t> rows;
  std::uint64_t played = 0, taken = 0;

 private:
  std::size_t parameters_;
  Strength strength_;
  double noise_;
};

inline std::string words(const ParameterValues& values) {
  std::string out;
  for (const double each : values) out += fmt::format("{} ", each);
  return out;
}

inline std::string told(const MatchTally& tally) {
  std::string out;
  for (const Forfeits& each : tally.forfeits.listed())
    out += fmt::format("forfeit {} {} {}\n", each.team, each.first_match, each.count);
  return out;
}

// Everything a record says, in words: equal for equal courses.
inline std::string told(const TuningRecord& record) {
  std::string out = fmt::format("{} {}\n", record.ended, record.tally.matches);
  const auto played = [](const PlayedScore& each) {
    return fmt::format("{} {} {} {} {}", each.score.pairs, each.score.mean, each.score.standard_deviation, each.failed,
                       each.counted);
  };
  for (const SearchStep& each : record.trace) {
    out += fmt::format("{} {} {}{} {} {} {}\n", each.evaluation, each.pairs_from, words(each.values),
                       played(each.played), each.repeated, each.best, each.matches);
  }
  for (const Finalist& each : record.finalists) {
    out += fmt::format("finalist {}{} {}\n", words(each.values), played(each.selected),
                       each.seen ? played(*each.seen) : "");
  }
  for (const ScoreDifference& each : record.verification.of()) {
    out += fmt::format("verified {} {} {} {}\n", record.verification.pairs(), each.p(), each.difference().mean(),
                       each.estimate().interval.low);
  }
  for (const VerifiedAs each : record.verification.findings())
    out += fmt::format("finding {}\n", static_cast<int>(each));
  for (const Slice& each : record.slices) {
    out += fmt::format("slice {} {} {}\n", each.parameter, each.importance, each.p.value_or(-1.0));
    for (const SlicePoint& point : each.points)
      out += fmt::format("  {} {} {}\n", point.value, point.score.mean, point.difference.mean);
  }
  return out + told(record.tally);
}

}  // namespace regista::study
