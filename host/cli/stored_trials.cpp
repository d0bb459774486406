// SPDX-License-Identifier: MIT
#include "cli/stored_trials.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace regista::cli {

void stored_trials(const campaign::Store& store, const study::ExperimentPlan& plan,
                   const std::function<void(std::uint64_t index, const campaign::Decided& decided)>& take) {
  std::vector<std::string> keys;
  for (campaign::Store::Fixture& each : study::fixtures(plan)) keys.push_back(std::move(each.key));
  const std::vector<std::int64_t> numbers = store.numbers(keys);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial trial = study::trial(plan, index);
    const auto decided = store.find(static_cast<std::int64_t>(index) + 1, {numbers[trial.number], trial.seed},
                                    campaign::Metrics::wanted);
    if (!decided) return;
    take(index, *decided);
  }
}

}  // namespace regista::cli
