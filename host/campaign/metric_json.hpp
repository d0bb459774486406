// SPDX-License-Identifier: MIT
// The numbers of a match as JSON: {"playing_seconds": 612.4, "packets": [90, 87], "territory": [{"ball_x_metres": 0.3},
// {"ball_x_metres": -0.3}], "roles": [{"striker": {"switches": 4}}, {"striker": {"switches": 6}}]}. Numbers of the
// match as a whole stand alone, all others in arrays of two, home and away. null: there is no such number in this
// match.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "match/metric_numbers.hpp"

namespace regista::campaign {

void add_metrics(nlohmann::ordered_json& object, const match::MetricNumbers& numbers);

// Throws std::invalid_argument for anything else.
match::MetricNumbers metrics_from_json(const nlohmann::ordered_json& object);
match::MetricNumbers metrics_from_json(const std::string& text);

}  // namespace regista::campaign
