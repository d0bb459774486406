// SPDX-License-Identifier: MIT
#include "mind/extensions/metric_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace regista::mind {
void MetricReports::report(const plugin::Found& plugin, std::span<const int> of_team, int place, std::uint32_t metric,
                           double value) {
  if (violation_) return;
  if (metric >= of_team.size()) {
    violation_ = {&plugin,
                  fmt::format("reported metric number {}; it declares {}, counted from 0", metric, of_team.size())};
    return;
  }
  const int index = of_team[metric];
  if (!(std::abs(value) <= largest_report)) {
    violation_ = {&plugin, fmt::format("reported {} as metric \"{}\"", value, plugin::metrics(plugin)[metric].name)};
    return;
  }
  const auto key = [](const MetricReport& each) { return std::pair(each.metric, each.place); };
  const std::pair own(index, place);
  const auto known = std::ranges::lower_bound(reports_, own, {}, key);
  if (known == reports_.end() || key(*known) != own) {
    reports_.insert(known, {index, place, 1, value, value, value, value});
    return;
  }
  ++known->count;
  known->sum += value;
  known->least = std::min(known->least, value);
  known->greatest = std::max(known->greatest, value);
  known->last = value;
}

void MetricReports::take(std::vector<MetricReport>& out) {
  out.assign(reports_.begin(), reports_.end());
  reports_.clear();
}

}  // namespace regista::mind
