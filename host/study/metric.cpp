// SPDX-License-Identifier: MIT
#include "study/metric.hpp"

#include "match/side.hpp"

namespace regista::study {

namespace {

std::vector<NamedValue> values_at(const match::MetricNumbers& metrics, const std::vector<std::size_t>& places) {
  std::vector<NamedValue> out;
  for (const std::size_t place : places) {
    if (const auto value = metrics.at(place)) out.push_back({metrics.names().path(place), *value});
  }
  return out;
}

}  // namespace

std::vector<NamedValue> metric_values(const match::MetricNumbers& metrics, int side) {
  if (metrics.empty()) return {};
  return values_at(metrics, metrics.names().of(static_cast<match::Side>(side)));
}

std::vector<NamedValue> metric_values_of_match(const match::MetricNumbers& metrics) {
  if (metrics.empty()) return {};
  return values_at(metrics, metrics.names().of_match());
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
