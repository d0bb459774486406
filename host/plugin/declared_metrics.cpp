// SPDX-License-Identifier: MIT
#include "plugin/declared_metrics.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <set>

#include "texts/message.hpp"

namespace regista::plugin {
namespace {

const regista_metrics* metrics_of(const regista_descriptor& d) {
  if (d.extension == nullptr) return nullptr;
  return static_cast<const regista_metrics*>(d.extension(REGISTA_METRIC_EXTENSION));
}

const regista_metric& metric(const regista_metrics& metrics, std::uint32_t index) {
  const char* const first = reinterpret_cast<const char*>(metrics.metrics);
  return *reinterpret_cast<const regista_metric*>(first + std::size_t{index} * metrics.stride);
}

}  // namespace

std::string_view combine_name(std::int32_t combine) {
  constexpr std::array<std::string_view, 6> names{"", "sum", "mean", "least", "greatest", "mean over time"};
  return names.at(static_cast<std::size_t>(combine));
}

std::string wrong_with_metrics(const regista_descriptor& d, std::string (*wrong_with_name)(std::string_view),
                               std::string (*wrong_with_text)(std::string_view)) {
  const regista_metrics* const metrics = metrics_of(d);
  if (metrics == nullptr) return {};
  if (metrics->size < sizeof *metrics) {
    return fmt::format("table of its metrics is {} bytes; {} needs {}", metrics->size, REGISTA_METRIC_EXTENSION,
                       sizeof *metrics);
  }
  constexpr std::uint32_t most = REGISTA_METRIC_MOST;
  if (metrics->count > most) return fmt::format("declares {} metrics; at most {} are taken", metrics->count, most);
  if (metrics->count == 0) return {};
  if (metrics->metrics == nullptr) return "its metrics are null";
  if (metrics->stride < sizeof(regista_metric) || metrics->stride % alignof(regista_metric) != 0) {
    return fmt::format("metrics are {} bytes apart; {} needs {}", metrics->stride, REGISTA_METRIC_EXTENSION,
                       sizeof(regista_metric));
  }
  std::set<std::string_view> seen;
  for (std::uint32_t i = 0; i < metrics->count; ++i) {
    const regista_metric& each = metric(*metrics, i);
    if (each.size < sizeof each) {
      return fmt::format("metric {} is {} bytes; {} needs {}", i, each.size, REGISTA_METRIC_EXTENSION, sizeof each);
    }
    if (each.name == nullptr) return fmt::format("metric {} has a null name", i);
    if (const std::string wrong = wrong_with_name(each.name); !wrong.empty()) {
      return fmt::format("metric {} {}", texts::in_quotes(each.name), wrong);
    }
    if (!seen.insert(each.name).second) return fmt::format("declares the metric \"{}\" twice", each.name);
    if (each.unit == nullptr) return fmt::format("metric \"{}\": unit is null", each.name);
    if (each.doc == nullptr) return fmt::format("metric \"{}\": doc is null", each.name);
    if (const std::string wrong = wrong_with_text(each.unit); !wrong.empty()) {
      return fmt::format("metric \"{}\": unit {}", each.name, wrong);
    }
    if (const std::string wrong = wrong_with_text(each.doc); !wrong.empty()) {
      return fmt::format("metric \"{}\": doc {}", each.name, wrong);
    }
    if (each.combine < REGISTA_METRIC_SUM || each.combine > REGISTA_METRIC_OVER_TIME) {
      return fmt::format("metric \"{}\": there is no way {} to combine reports", each.name, each.combine);
    }
  }
  return {};
}

std::vector<DeclaredMetric> declared_metrics(const regista_descriptor& d) {
  std::vector<DeclaredMetric> out;
  const regista_metrics* const metrics = metrics_of(d);
  for (std::uint32_t i = 0; metrics != nullptr && i < metrics->count; ++i) {
    const regista_metric& each = metric(*metrics, i);
    out.push_back({each.name, each.unit, each.doc, each.combine});
  }
  return out;
}

}  // namespace regista::plugin
