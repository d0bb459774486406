// SPDX-License-Identifier: MIT
#include "study/measure.hpp"

#include <algorithm>
#include <limits>

#include "match/metric_table.hpp"

namespace regista::study {

bool is_time(std::string_view measure) {
  const match::MetricRow* const row = match::find_metric(match::metric_table(), measure);
  return row != nullptr && row->unit == "s" && row->total == match::MetricRow::Total::sum;
}

const char* unit_of(std::string_view measure) { return is_time(measure) ? "min per 60 min" : "per match"; }

double pair_in_unit(std::string_view measure, double sum, double playing_seconds) {
  if (!is_time(measure)) return sum / 2.0;
  return playing_seconds > 0.0 ? 60.0 * sum / playing_seconds : std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> measure_of_score(std::string_view measure, const campaign::Decided& decided, int side) {
  const int own = decided.score[static_cast<std::size_t>(side)],
            other = decided.score[static_cast<std::size_t>(1 - side)];
  const double points = own > other ? 1.0 : own == other ? 0.5 : 0.0;
  const std::array<double, measures_of_score.size()> values{static_cast<double>(own), static_cast<double>(other),
                                                            static_cast<double>(own - other), points};
  const auto found = std::ranges::find(measures_of_score, measure);
  if (found == measures_of_score.end()) return std::nullopt;
  return values[static_cast<std::size_t>(found - measures_of_score.begin())];
}

MatchMeasures::MatchMeasures(const campaign::Decided& decided, int side)
    : playing_seconds_(decided.metrics.of_match("playing_seconds").value_or(0.0)) {
  for (const char* const each : measures_of_score) values_.push_back({each, *measure_of_score(each, decided, side)});
  for (NamedValue& each : all_metric_values(decided.metrics, side)) {
    if (std::ranges::find(measures_of_score, each.path) == measures_of_score.end()) values_.push_back(std::move(each));
  }
}

std::optional<double> MatchMeasures::value(const std::string& measure) const {
  const auto found = std::ranges::find(values_, match::without_roles(measure), &NamedValue::path);
  return found == values_.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace regista::study
