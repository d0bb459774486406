// SPDX-License-Identifier: MIT
#include "report/number_json.hpp"

#include <cmath>

#include "texts/json.hpp"

namespace regista::report {

using Json = nlohmann::ordered_json;

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json_or_null(const std::optional<double>& value) { return value ? json_number(*value) : Json(nullptr); }

Json json_of(const statistics::Interval& interval) {
  return Json::array({json_number(interval.low), json_number(interval.high)});
}

Json json_of(const study::MeanEstimate& estimate) {
  const bool any = estimate.pairs > 0;
  return {{"pairs", estimate.pairs},
          {"mean", any ? Json(estimate.mean) : Json(nullptr)},
          {"standard_deviation", estimate.pairs > 1 ? Json(estimate.standard_deviation) : Json(nullptr)},
          {"interval", estimate.interval ? json_of(*estimate.interval) : Json(nullptr)}};
}

}  // namespace regista::report
