// SPDX-License-Identifier: MIT
// How reports show what teams spent in games shorter than a match: beside the share of the budget that their length
// has, with a mark where it was more.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "study/packets_spent.hpp"

namespace regista::report {

// "spent 45 packets per match; the share of the budget for this length is 30: OVERSPENT"; empty where there is nothing
// to show.
std::string packets_clause(const study::PacketsSpent& packets);

// {"per_match", "share", "overspent"}; null where there is nothing to show.
nlohmann::ordered_json packets_json(const study::PacketsSpent& packets);

}  // namespace regista::report
