// SPDX-License-Identifier: MIT
// The numbers that the plugins of one team report about a match: all reports of all its robots, combined as the plugin
// says. See <regista/extensions/metric.h>.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mind/extensions/metric_reports.hpp"

namespace regista::match {

// Names are "<plugin>.<metric>".
struct PluginMetrics {
  std::vector<std::string> total_names, value_names;
  std::vector<double> totals;                 // of those that are summed
  std::vector<std::optional<double>> values;  // of all others; nothing without a report
};

class PluginMeasures {
 public:
  PluginMeasures(std::vector<mind::TeamMetric> metrics, int team_size);

  std::size_t count() const { return metrics_.size(); }
  // Robot `number` has decided. Reports are sound (see unsound()).
  void decided(int number, std::span<const mind::MetricReport> reports);
  // What it reported of a state holds no longer.
  void crashed(int number);
  // Ten times in a second of phase Playing.
  void sample();

  PluginMetrics result() const;

 private:
  struct Combined {
    std::uint64_t count = 0;
    double sum = 0.0, least = 0.0, greatest = 0.0;
  };
  void add(Combined& to, std::uint64_t count, double sum, double least, double greatest) const;

  struct Told {
    std::int32_t place;  // of the instance
    double value;
  };

  std::vector<mind::TeamMetric> metrics_;
  std::vector<Combined> combined_;                         // by metric
  std::vector<std::vector<std::vector<Told>>> last_told_;  // by metric and robot: of those over time
};

}  // namespace regista::match
