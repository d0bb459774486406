// SPDX-License-Identifier: MIT
// Numbers that were estimated, as JSON, the same in every report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "statistics/interval.hpp"
#include "study/paired_estimates.hpp"

namespace regista::report {

// JSON has no infinite numbers: null instead, as for nothing.
nlohmann::ordered_json json_number(double value);
nlohmann::ordered_json json_or_null(const std::optional<double>& value);
nlohmann::ordered_json json_of(const statistics::Interval& interval);
nlohmann::ordered_json json_of(const study::MeanEstimate& estimate);

}  // namespace regista::report
