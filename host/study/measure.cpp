// SPDX-License-Identifier: MIT
#include "study/measure.hpp"

#include <algorithm>

namespace regista::study {

MatchMeasures::MatchMeasures(const campaign::Decided& decided, int side)
    : playing_seconds_(match_number(decided.metrics, "playing_seconds").value_or(0.0)) {
  const int own = decided.score[static_cast<std::size_t>(side)],
            other = decided.score[static_cast<std::size_t>(1 - side)];
  const double points = own > other ? 1.0 : own == other ? 0.5 : 0.0;
  const std::array<double, measures_of_score.size()> of_score{static_cast<double>(own), static_cast<double>(other),
                                                              static_cast<double>(own - other), points};
  for (std::size_t i = 0; i < of_score.size(); ++i) values_.push_back({measures_of_score[i], of_score[i]});
  for (NamedValue& each : all_metric_values(decided.metrics, side)) {
    if (std::ranges::find(measures_of_score, each.path) == measures_of_score.end()) values_.push_back(std::move(each));
  }
}

std::optional<double> MatchMeasures::value(const std::string& measure) const {
  const auto found = std::ranges::find(values_, without_roles(measure), &NamedValue::path);
  return found == values_.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace regista::study
