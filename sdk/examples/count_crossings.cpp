// SPDX-License-Identifier: MIT
// Example of the extension metric: a greedy assigner that counts how many ways of two robots to their tasks cross.
//
//   assigner: {plugin: count_crossings}      regista match a.yaml b.yaml --json | jq .plugin_values
#include <array>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/metric.hpp>

namespace {

double side(const double* a, const double* b, const double* c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
bool cross(const double* a, const double* b, const double* c, const double* d) {
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

struct CountCrossings {
  static constexpr auto id = "count_crossings", version = "1.0.0",
                        summary = "Each task to the best free robot; counts ways that cross";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr std::array metrics{
      regista::metric("decisions", "1", "Decisions with an assignment, of all robots", REGISTA_METRIC_SUM),
      regista::metric("crossings", "1", "Pairs of robots whose ways to their tasks cross", REGISTA_METRIC_OVER_TIME)};

  regista::MetricReports reports;

  void setup(const regista::Environment&, const regista::Host& host) { reports = regista::MetricReports(host); }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    for (std::size_t column = 0; column < utilities.columns(); ++column) {
      std::size_t best = out.size();
      for (std::size_t row = 0; row < out.size(); ++row) {
        const bool may = out[row] == out.no_task && utilities(row, column) >= 0.0;
        if (may && (best == out.size() || utilities(row, column) > utilities(best, column))) best = row;
      }
      if (best < out.size()) out[best] = static_cast<std::int32_t>(column);
    }
    const regista::World world = frame.world();
    const auto from = [&](std::size_t row) { return world.robot(world.active()[row]).pose; };
    const auto to = [&](std::size_t row) { return frame.tasks()[static_cast<std::size_t>(out[row])].after; };
    int crossings = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (out[i] >= 0 && out[j] >= 0 && cross(from(i), to(i), from(j), to(j))) ++crossings;
      }
    }
    reports.report(0, 1.0);
    reports.report(1, crossings);
  }
};

}  // namespace

REGISTA_PLUGIN(CountCrossings, regista::assigner)
