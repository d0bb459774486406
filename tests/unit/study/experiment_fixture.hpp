// SPDX-License-Identifier: MIT
// Plans of experiments and results of their matches, made by hand.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "study/experiment_course.hpp"

namespace regista::study {

// Arms "arm 0", "arm 1", ... at values "0", "1", ..., all different; every two arms are compared at each value.
inline ExperimentPlan experiment_of(std::size_t arms, std::size_t values, std::uint64_t pairs) {
  ExperimentPlan plan;
  config::Experiment& asked = plan.asked;
  asked.name = "trial";
  asked.opponent = "opponent.yaml";
  for (std::size_t arm = 0; arm < arms; ++arm) {
    asked.arms.push_back({fmt::format("arm {}", arm), fmt::format("{}.yaml", arm), {}, {}});
  }
  if (values > 1) {
    asked.sweep.emplace().path = "rules.messages.budget";
    for (std::size_t value = 0; value < values; ++value)
      asked.sweep->values.push_back(config::Node::scalar(std::to_string(value), false, {}));
  }
  asked.matches = static_cast<int>(2 * pairs);
  asked.seed = 7;
  asked.settings.seeds = config::Seeds::consecutive;
  asked.primary.emplace().measure = "striker.overlap_seconds";
  asked.primary->test = PairTest::paired_t;
  make_jobs(plan, {});
  for (Condition& condition : plan.conditions) {
    for (const std::size_t side : {0u, 1u}) {
      campaign::Job& job = condition.jobs[side];
      (side == 0 ? job.home_inputs : job.away_inputs) = {{"team", fmt::format("team {}", condition.arm)}};
      (side == 0 ? job.away_inputs : job.home_inputs) = {{"team", "opponent"}};
      job.common_inputs = {{"rules", fmt::format("rules {}", condition.value)}};
    }
  }
  plan.pairs = pairs;
  plan.measures = {"striker.overlap_seconds", "packets", "goals", "points"};
  return plan;
}

// These are compared, of an experiment without a sweep, and no others.
inline void compare(ExperimentPlan& plan, const std::vector<Comparison>& comparisons) {
  const auto name = [&](std::size_t arm) { return config::Node::scalar(plan.asked.arms[arm].name, true, {}); };
  plan.asked.primary->compare.clear();
  for (const Comparison& each : comparisons)
    plan.asked.primary->compare.push_back(config::Node::sequence({name(each.first), name(each.second)}, {}));
}

// The team on `side` has these numbers, the other one others.
inline campaign::MatchResult played(std::size_t side, double overlap, int packets, int own, int other,
                                    double playing_seconds = 600.0) {
  campaign::MatchResult out;
  out.score[side] = own;
  out.score[1 - side] = other;
  out.ended = "full_time";
  out.hash = std::string(1, 'h');  // of "h" g++ 12 warns without a reason
  const auto both = [side](const std::string& mine, const std::string& theirs) {
    return side == 0 ? mine + ", " + theirs : theirs + ", " + mine;
  };
  const auto role = [](double seconds) { return fmt::format(R"({{"striker": {{"overlap_seconds": {}}}}})", seconds); };
  out.metrics = campaign::metrics_from_json(fmt::format(R"({{"playing_seconds": {}, "packets": [{}], "roles": [{}]}})",
                                                        playing_seconds, both(std::to_string(packets), "-5"),
                                                        both(role(overlap), role(999.0))));
  return out;
}

}  // namespace regista::study
