// SPDX-License-Identifier: MIT
// Tunings whose matches are decided by a formula, so that it is known what is to be found.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <utility>

#include "campaign/match_encoding.hpp"
#include "report/tuning_report.hpp"
#include "study/tuning/tuning_study.hpp"

namespace regista::report {

// Two weights of a team, of a range of 0 to 10 and, by its logarithm, of 0.1 to 10, against two opponents.
inline study::TuningPlan tuning_plan() {
  study::TuningPlan plan;
  plan.asked.name = "weights";
  plan.asked.question = "Do other weights score more?";
  plan.asked.team = "teams/base.yaml";
  plan.document = "team: base\nweights:\n  distance: 5.0\n  bearing: 1.0\n";
  plan.parameters = {{"weights.distance", 5.0, 0.0, 10.0, false, false, "m", "how much the distance counts"},
                     {"weights.bearing", 1.0, 0.1, 10.0, false, true, "", "how much the bearing counts"}};
  const auto against = [](const std::string& label, double weight) {
    study::TuningOpponent out{label, label + ".yaml", weight, {}};
    for (const std::size_t side : {0u, 1u}) {
      campaign::Job& job = out.jobs[side];
      (side == 0 ? job.home_inputs : job.away_inputs) = {{"team", "base document"}, {"plugin greedy", "greedy 1"}};
      (side == 0 ? job.away_inputs : job.home_inputs) = {{"team", "document of " + label}};
      job.common_inputs = {{"rules", "rules 1"}};
    }
    return out;
  };
  plan.opponents = {against("fixed_rate", 0.75), against("spqr", 0.25)};
  plan.base = against("base", 1.0);
  plan.asked.opponents = {{"fixed_rate.yaml", 0.75, {}}, {"spqr.yaml", 0.25, {}}};
  for (const study::Parameter& each : plan.parameters)
    plan.asked.parameters.push_back({each.path, std::nullopt, {}, {}});
  plan.objective = {{{"goal_difference", 1.0}}, false};
  plan.most_goals = 10;
  plan.asked.seed = 3;
  plan.asked.settings.seeds = config::Seeds::consecutive;
  plan.asked.search.algorithm = "spsa";
  plan.search_pairs = 60;
  plan.asked.selection.finalists = 3;
  plan.selection_pairs = 12;
  plan.asked.verification.candidates = 1;
  plan.verification_pairs = 200;
  plan.asked.slices.points = 5;
  plan.asked.slices.pairs = 10;
  plan.folder = "/somewhere";
  return plan;
}

// How good a team with these values is, in goals of a match.
using Quality = std::function<double(double distance, double bearing)>;
inline double peak(double distance, double bearing) {  // at 2 and 4
  return 2.0 - 0.25 * std::abs(distance - 2.0) - 1.2 * std::abs(std::log(bearing / 4.0));
}

// The value of "home.weights.bearing=4" in a match.
inline double override_of(const campaign::Job& job, const std::string& path) {
  for (const std::string& each : job.overrides) {
    if (const std::size_t at = each.find(path + '='); at != std::string::npos) {
      return std::strtod(each.c_str() + at + path.size() + 1, nullptr);
    }
  }
  return 0.0;
}

// Goals by quality and luck, which is that of the seed and the side; overlap of 5 s less as many seconds in 600 s.
inline campaign::MatchResult decided_by(const study::TuningPlan& plan, const campaign::Job& job,
                                        const Quality& quality) {
  const std::string& own_path = job.overrides.front();
  const std::size_t side = own_path.starts_with("home.") ? 0 : 1;
  const double of = quality(override_of(job, plan.parameters[0].path), override_of(job, plan.parameters[1].path));
  std::mt19937_64 luck(2 * job.seed + side);
  const double shift = static_cast<double>(luck() >> 11) * 0x1p-53 * 4.0 - 2.0;
  const int difference = static_cast<int>(std::lround(of + shift));
  campaign::MatchResult out;
  out.score[side] = std::max(difference, 0);
  out.score[1 - side] = std::max(-difference, 0);
  out.ended = "full_time";
  out.hash = "h";
  const auto role = [&](std::size_t each) {
    return fmt::format(R"({{"striker":{{"overlap_seconds":{}}}}})", each == side ? 60.0 - 5.0 * (of + shift) : 90.0);
  };
  out.metrics =
      campaign::metrics_from_json(fmt::format(R"({{"playing_seconds":600,"roles":[{},{}]}})", role(0), role(1)));
  return out;
}

inline std::string text_of(const TuningView& view) { return outline_text(tuning_outline(view)); }

struct Stopped {};

using Decide = std::function<campaign::MatchResult(const campaign::Job&)>;

// Plays by `decide`, and counts; after so many matches it is stopped as by Ctrl-C.
inline study::PlayRound played_by(const Decide& decide, std::uint64_t& played, std::uint64_t most = ~std::uint64_t{0}) {
  return [&decide, &played, most](const study::Round& round) {
    for (std::uint64_t i = 0; i < round.matches; ++i) {
      if (played == most) throw Stopped{};
      ++played;
      const campaign::MatchResult decided = decide(round.job(i));
      if (!round.take(i, &decided)) return;
    }
  };
}

struct TunedCourse {
  explicit TunedCourse(study::TuningPlan asked, const Quality& quality = peak, std::uint64_t most = ~std::uint64_t{0})
      : plan(std::move(asked)), record(plan) {
    run([&](const campaign::Job& job) { return decided_by(plan, job, quality); }, most);
  }
  TunedCourse(study::TuningPlan asked, const Decide& decide) : plan(std::move(asked)), record(plan) {
    run(decide, ~std::uint64_t{0});
  }
  TunedCourse(const TunedCourse&) = delete;
  TunedCourse& operator=(const TunedCourse&) = delete;

  TuningView view() const { return {plan, record, file}; }

  study::TuningPlan plan;
  study::TuningRecord record;
  std::string file = "tuned.yaml";
  std::uint64_t played = 0;

 private:
  void run(const Decide& decide, std::uint64_t most) {
    try {
      tune(plan, played_by(decide, played, most), {}, record);
    } catch (const Stopped&) {
    }
  }
};

}  // namespace regista::report
