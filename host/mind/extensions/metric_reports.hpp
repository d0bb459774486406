// SPDX-License-Identifier: MIT
// What the plugins of one robot report of a match in numbers: extension regista.metric, <regista/extensions/metric.h>.
// However often a plugin reports in a decision, a mind hands over one summary of each metric and instance.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plugin/found.hpp"

namespace regista::mind {

// The largest size of a report: no sum of a match is infinite.
inline constexpr double largest_report = 1e9;

// A number that a plugin of the team declares.
struct TeamMetric {
  std::string name;          // "voronoi.crossings"
  std::int32_t combine = 0;  // REGISTA_METRIC_*
};

// Of one metric of the team, by one instance, in one decision. `metric`: index into TeamPlan::metrics().
struct MetricReport {
  std::int32_t metric = 0;
  std::int32_t place = 0;  // of the instance in the robot's mind
  std::uint32_t count = 0;
  double sum = 0.0, least = 0.0, greatest = 0.0, last = 0.0;
};

class MetricReports {
 public:
  // A report that breaks a promise.
  struct Violation {
    const plugin::Found* plugin;
    std::string what;
  };

  // of_team: the plugin's metrics as indices of the team's. place: of the instance.
  void report(const plugin::Found& plugin, std::span<const int> of_team, int place, std::uint32_t metric, double value);

  // Those since the last call, by metric and place; and the first violation, if there was one.
  void take(std::vector<MetricReport>& out);
  const std::optional<Violation>& violation() const { return violation_; }

 private:
  std::vector<MetricReport> reports_;
  std::optional<Violation> violation_;
};

}  // namespace regista::mind
