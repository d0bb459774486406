// SPDX-License-Identifier: MIT
#include "mind/extensions/metric_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace regista::mind {
namespace {

constexpr double largest = 1e9;  // so that no sum of a match is infinite

}  // namespace

void MetricReports::report(const plugin::Found& plugin, std::span<const int> of_team, std::uint32_t metric,
                           double value) {
  if (violation_) return;
  if (metric >= of_team.size()) {
    violation_ = {&plugin, fmt::format("reported metric {}; it declares {}", metric, of_team.size())};
    return;
  }
  const int index = of_team[metric];
  if (!(std::abs(value) <= largest)) {
    violation_ = {&plugin, fmt::format("reported {} as metric \"{}\"", value, plugin::metrics(plugin)[metric].name)};
    return;
  }
  const auto place = std::ranges::lower_bound(reports_, index, {}, &MetricReport::metric);
  if (place == reports_.end() || place->metric != index) {
    reports_.insert(place, {index, 1, value, value, value, value});
    return;
  }
  ++place->count;
  place->sum += value;
  place->least = std::min(place->least, value);
  place->greatest = std::max(place->greatest, value);
  place->last = value;
}

void MetricReports::take(std::vector<MetricReport>& out) {
  out.assign(reports_.begin(), reports_.end());
  reports_.clear();
}

}  // namespace regista::mind
