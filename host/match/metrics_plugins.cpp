// SPDX-License-Identifier: MIT
#include "match/metrics_plugins.hpp"

#include <regista/extensions/metric.h>

#include <algorithm>
#include <utility>

namespace regista::match {

PluginMeasures::PluginMeasures(std::vector<mind::TeamMetric> metrics, int team_size)
    : metrics_(std::move(metrics)), combined_(metrics_.size()), last_told_(metrics_.size()) {
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    if (metrics_[i].combine == REGISTA_METRIC_OVER_TIME) last_told_[i].resize(static_cast<std::size_t>(team_size));
  }
}

void PluginMeasures::add(Combined& to, std::uint64_t count, double sum, double least, double greatest) const {
  to.least = to.count == 0 ? least : std::min(to.least, least);
  to.greatest = to.count == 0 ? greatest : std::max(to.greatest, greatest);
  to.count += count;
  to.sum += sum;
}

void PluginMeasures::decided(int number, std::span<const mind::MetricReport> reports) {
  for (const mind::MetricReport& each : reports) {
    const auto metric = static_cast<std::size_t>(each.metric);
    if (metrics_[metric].combine == REGISTA_METRIC_OVER_TIME) {
      std::vector<Told>& robot = last_told_[metric][static_cast<std::size_t>(number - 1)];
      const auto known = std::ranges::find(robot, each.place, &Told::place);
      if (known == robot.end())
        robot.push_back({each.place, each.last});
      else
        known->value = each.last;
    } else {
      add(combined_[metric], each.count, each.sum, each.least, each.greatest);
    }
  }
}

void PluginMeasures::crashed(int number) {
  for (auto& robots : last_told_) {
    if (!robots.empty()) robots[static_cast<std::size_t>(number - 1)].clear();
  }
}

void PluginMeasures::sample() {
  for (std::size_t i = 0; i < last_told_.size(); ++i) {
    for (const std::vector<Told>& robot : last_told_[i]) {
      for (const Told& each : robot) add(combined_[i], 1, each.value, each.value, each.value);
    }
  }
}

PluginMetrics PluginMeasures::result() const {
  PluginMetrics out;
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    const Combined& all = combined_[i];
    if (metrics_[i].combine == REGISTA_METRIC_SUM) {
      out.total_names.push_back(metrics_[i].name);
      out.totals.push_back(all.sum);
      continue;
    }
    out.value_names.push_back(metrics_[i].name);
    std::optional<double>& value = out.values.emplace_back();
    if (all.count == 0) continue;
    switch (metrics_[i].combine) {
      case REGISTA_METRIC_LEAST:
        value = all.least;
        break;
      case REGISTA_METRIC_GREATEST:
        value = all.greatest;
        break;
      default:
        value = all.sum / static_cast<double>(all.count);
    }
  }
  return out;
}

}  // namespace regista::match
