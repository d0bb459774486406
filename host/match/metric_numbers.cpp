// SPDX-License-Identifier: MIT
#include "match/metric_numbers.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace regista::match {
namespace {

// Returns the key by which numbers are sorted: first the whole match, then home, then away; within each, by path.
std::pair<int, std::string_view> key(std::optional<Side> side, std::string_view path) {
  return {side ? static_cast<int>(*side) : -1, path};
}

}  // namespace

std::string MetricName::path() const {
  std::string out = role.empty() ? name : role + '.' + name;
  return place == 0 ? out : out + '.' + std::to_string(place);
}

MetricNames::MetricNames(std::vector<MetricName> names) : names_(std::move(names)), sorted_(names_.size()) {
  for (const MetricName& each : names_) paths_.push_back(each.path());
  const auto key_at = [this](std::size_t i) { return key(names_[i].side, paths_[i]); };
  std::iota(sorted_.begin(), sorted_.end(), 0);
  std::ranges::sort(sorted_, {}, key_at);
  if (const auto twice = std::ranges::adjacent_find(sorted_, {}, key_at); twice != sorted_.end()) {
    throw std::invalid_argument("two numbers are called " + paths_[*twice]);
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const MetricName& each = names_[i];
    if (each.place != 0) continue;
    if (!each.side) {
      of_match_.push_back(i);
      continue;
    }
    OfSide& side = sides_[index(*each.side)];
    side.numbers.push_back(i);
    if (each.role.empty()) continue;
    auto sum = std::ranges::find(side.sums, each.name, &Sum::name);
    if (sum == side.sums.end()) sum = side.sums.insert(sum, {each.name, {}});
    sum->places.push_back(i);
  }
  // If a team has a number of its own with the name of a sum over roles, the sum is removed.
  for (const Side side : both_sides) {
    std::erase_if(sides_[index(side)].sums, [&](const Sum& sum) { return find(side, sum.name).has_value(); });
  }
}

std::optional<std::size_t> MetricNames::find(std::optional<Side> side, std::string_view path) const {
  const auto found = std::ranges::lower_bound(sorted_, key(side, path), {},
                                              [this](std::size_t i) { return key(names_[i].side, paths_[i]); });
  if (found == sorted_.end() || names_[*found].side != side || paths_[*found] != path) return std::nullopt;
  return names_[*found].place == 0 ? std::optional(*found) : std::nullopt;
}

MetricNumbers::MetricNumbers(std::shared_ptr<const MetricNames> names, std::vector<double> values)
    : names_(std::move(names)), values_(std::move(values)) {
  assert(names_ && values_.size() == names_->size());
}

std::optional<double> MetricNumbers::at(std::size_t place) const {
  return std::isnan(values_[place]) ? std::nullopt : std::optional(values_[place]);
}

std::optional<double> MetricNumbers::of_match(std::string_view name) const {
  if (empty()) return std::nullopt;
  const auto place = names_->find(std::nullopt, name);
  return place ? at(*place) : std::nullopt;
}

std::optional<double> MetricNumbers::of_side(Side side, std::string_view path) const {
  if (empty()) return std::nullopt;
  path = without_roles(path);
  if (const auto place = names_->find(side, path)) return at(*place);
  const auto found = std::ranges::find(names_->sums(side), path, &MetricNames::Sum::name);
  return found == names_->sums(side).end() ? std::nullopt : sum(*found);
}

std::optional<double> MetricNumbers::sum(const MetricNames::Sum& sum) const {
  std::optional<double> out;
  for (const std::size_t place : sum.places) {
    if (const auto value = at(place)) out = out.value_or(0.0) + *value;
  }
  return out;
}

bool operator==(const MetricNumbers& a, const MetricNumbers& b) {
  if (a.empty() || b.empty()) return a.empty() && b.empty();
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return (a.names_ == b.names_ || *a.names_ == *b.names_) && std::ranges::equal(a.values_, b.values_, {}, bits, bits);
}

std::string_view without_roles(std::string_view path) {
  const std::string_view prefix = "roles.";
  return path.starts_with(prefix) ? path.substr(prefix.size()) : path;
}

constexpr std::size_t most_known = 256;  // largest number of stored MetricNames; one file usually has few

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
  std::ranges::fill(values_, std::nullopt);
  if (numbers.empty()) return values_;
  const Places& places = places_in(numbers.shared_names());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) values_[i] = numbers.at(*places[i]);
  }
  return values_;
}

}  // namespace regista::match
