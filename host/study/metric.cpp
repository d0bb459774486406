// SPDX-License-Identifier: MIT
#include "study/metric.hpp"

#include "match/side.hpp"

namespace regista::study {

std::vector<NamedValue> metric_values(const match::MetricNumbers& metrics, int side) {
  std::vector<NamedValue> out;
  if (metrics.empty()) return out;
  for (const std::size_t place : metrics.names().of(static_cast<match::Side>(side))) {
    if (const auto value = metrics.at(place)) out.push_back({metrics.names().path(place), *value});
  }
  return out;
}

std::vector<NamedValue> all_metric_values(const match::MetricNumbers& metrics, int side) {
  std::vector<NamedValue> out = metric_values(metrics, side);
  if (metrics.empty()) return out;
  for (const match::MetricNames::Sum& sum : metrics.names().sums(static_cast<match::Side>(side))) {
    if (const auto value = metrics.sum(sum)) out.push_back({sum.name, *value});
  }
  return out;
}

}  // namespace regista::study
