// SPDX-License-Identifier: MIT
#include "study/tuning/drawn_seed.hpp"

#include <fmt/format.h>

#include <string>

#include "campaign/inputs.hpp"
#include "plugin/content_hash.hpp"

namespace regista::study {

std::uint64_t drawn_seed(const TuningPlan& plan, const TunedDocument& document,
                         const std::vector<ParameterValues>& chosen) {
  std::string all = fmt::format("{}\n{}\n{}\n", plan.seed(), in_words(plan.objective), plan.objective.minimise);
  for (const TuningOpponent& each : plan.opponents) {
    all += fmt::format("{} {}\n", each.weight,
                       campaign::fixture_key({}, each.jobs[0].away_inputs, each.jobs[0].common_inputs));
  }
  for (const ParameterValues& each : chosen) all += plugin::content_hash(document.with(each)) + '\n';
  return std::stoull(plugin::content_hash(all).substr(0, 8), nullptr, 16) & 0x7fffffffu;
}

}  // namespace regista::study
