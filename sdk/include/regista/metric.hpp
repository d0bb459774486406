// SPDX-License-Identifier: MIT
// Numbers of a plugin about a match: see <regista/extensions/metric.h>. The class declares them,
//
//   static constexpr std::array metrics{
//       regista::metric("crossings", "1", "How often two robots' ways to their tasks crossed", REGISTA_METRIC_SUM)};
//   void setup(const regista::Environment&, const regista::Host& host) { reports_ = regista::MetricReports(host); }
//   ...
//   reports_.report(0, crossings);
#pragma once

#include <cstdint>

#include <regista/extensions/metric.h>
#include <regista/host.hpp>

namespace regista {

constexpr regista_metric metric(const char* name, const char* unit, const char* doc, std::int32_t combine) {
  return {sizeof(regista_metric), combine, name, unit, doc};
}

// Without a host that takes numbers nothing happens.
class MetricReports {
 public:
  MetricReports() = default;
  explicit MetricReports(const Host& host) : table_(host.extension<regista_metric_reports>(REGISTA_METRIC_EXTENSION)) {}

  // index: of the declared metrics.
  void report(std::uint32_t index, double value) const {
    if (table_ != nullptr) table_->report(table_->context, index, value);
  }

 private:
  const regista_metric_reports* table_ = nullptr;
};

}  // namespace regista
