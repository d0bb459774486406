// SPDX-License-Identifier: MIT
// The numbers that a plugin declares about a match: <regista/extensions/metric.h>.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <regista/abi.h>
#include <regista/extensions/metric.h>

namespace regista::plugin {

struct DeclaredMetric {
  std::string name, unit, doc;
  std::int32_t combine = REGISTA_METRIC_SUM;
};

// "sum", "mean", "least", "greatest", "mean over time"
std::string_view combine_name(std::int32_t combine);

// Why the metrics of a descriptor cannot be used, in one line; empty when they can, or it has none.
// `wrong_with_name`, `wrong_with_text`: of the words of a descriptor; empty when nothing is.
std::string wrong_with_metrics(const regista_descriptor& descriptor, std::string (*wrong_with_name)(std::string_view),
                               std::string (*wrong_with_text)(std::string_view));

// Of a descriptor whose metrics were checked.
std::vector<DeclaredMetric> declared_metrics(const regista_descriptor& descriptor);

template <class Archive>
void visit(Archive& archive, DeclaredMetric& metric) {
  archive(metric.name, metric.unit, metric.doc, metric.combine);
}

}  // namespace regista::plugin
