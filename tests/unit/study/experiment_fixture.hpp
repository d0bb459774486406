// SPDX-License-Identifier: MIT
// Plans of experiments and results of their matches, made by hand.
#pragma once

#include <fmt/format.h>

#include <string>

#include "campaign/metric_json.hpp"
#include "study/experiment.hpp"

namespace regista::study {

// Arms "arm 0", "arm 1", ... at values "0", "1", ..., all different; every two arms are compared at each value.
inline ExperimentPlan experiment_of(std::size_t arms, std::size_t values, std::uint64_t pairs) {
  ExperimentPlan plan;
  plan.name = "trial";
  plan.opponent = "opponent.yaml";
  for (std::size_t arm = 0; arm < arms; ++arm) {
    plan.arms.push_back({fmt::format("arm {}", arm), fmt::format("{}.yaml", arm), {}});
  }
  if (values > 1) plan.sweep = "rules.messages.budget";
  for (std::size_t value = 0; value < values; ++value) {
    plan.values.push_back(values > 1 ? std::to_string(value) : "");
    for (std::size_t arm = 0; arm < arms; ++arm) {
      Condition& condition = plan.conditions.emplace_back();
      condition.arm = arm;
      condition.value = value;
      for (const std::size_t side : {0u, 1u}) {
        campaign::Job& job = condition.jobs[side];
        job.teams[side] = plan.arms[arm].file;
        job.teams[1 - side] = plan.opponent;
        (side == 0 ? job.home_inputs : job.away_inputs) = {{"team", fmt::format("team {}", arm)}};
        (side == 0 ? job.away_inputs : job.home_inputs) = {{"team", "opponent"}};
        job.common_inputs = {{"rules", fmt::format("rules {}", value)}};
      }
      for (std::size_t other = 0; other < arm; ++other) {
        plan.comparisons.push_back({plan.condition(other, value), plan.condition(arm, value)});
      }
    }
  }
  plan.pairs = pairs;
  plan.first_seed = 7;
  plan.measures = {"striker.overlap_seconds", "packets", "goals", "points"};
  plan.primary = "striker.overlap_seconds";
  return plan;
}

// The team on `side` has these numbers, the other one others.
inline campaign::Decided played(std::size_t side, double overlap, int packets, int own, int other,
                                double playing_seconds = 600.0) {
  campaign::Decided out;
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
