// SPDX-License-Identifier: MIT
// Numbers of many matches under the same paths, as a table has them: where a path stands is looked up once for all
// matches that have the same names.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "match/metric_numbers.hpp"

namespace regista::match {

class MetricColumns {
 public:
  explicit MetricColumns(MetricPaths paths = {});

  const MetricPaths& paths() const { return paths_; }
  // For each path of teams the number of home and that of away, then those of the match; nothing where this match has
  // none. Valid until the next call.
  std::span<const std::optional<double>> of(const MetricNumbers& numbers);

 private:
  using Places = std::vector<std::optional<std::size_t>>;
  const Places& places_in(const std::shared_ptr<const MetricNames>& names);

  MetricPaths paths_;
  std::map<std::shared_ptr<const MetricNames>, Places> places_;
  std::vector<std::optional<double>> values_;
};

}  // namespace regista::match
