// SPDX-License-Identifier: MIT
#include "match/metric_columns.hpp"

#include <utility>

namespace regista::match {
namespace {

constexpr std::size_t most_known = 256;  // lists of names; matches of one file share a few

}  // namespace

MetricColumns::MetricColumns(MetricPaths paths)
    : paths_(std::move(paths)), values_(2 * paths_.of_teams.size() + paths_.of_match.size()) {}

const MetricColumns::Places& MetricColumns::places_in(const std::shared_ptr<const MetricNames>& names) {
  if (const auto known = places_.find(names); known != places_.end()) return known->second;
  if (places_.size() == most_known) places_.clear();
  Places places;
  for (const std::string& path : paths_.of_teams) {
    for (const Side side : both_sides) places.push_back(names->find(side, path));
  }
  for (const std::string& path : paths_.of_match) places.push_back(names->find(std::nullopt, path));
  return places_.emplace(names, std::move(places)).first->second;
}

std::span<const std::optional<double>> MetricColumns::of(const MetricNumbers& numbers) {
  if (numbers.empty()) {
    values_.assign(values_.size(), std::nullopt);
    return values_;
  }
  const Places& places = places_in(numbers.shared_names());
  for (std::size_t i = 0; i < places.size(); ++i) {
    values_[i] = places[i] ? numbers.at(*places[i]) : std::nullopt;
  }
  return values_;
}

}  // namespace regista::match
