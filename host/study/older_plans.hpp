// SPDX-License-Identifier: MIT
// Plans of results that older versions of the program wrote, which held no document: as today's are.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace regista::study {

// A plan of version 1. All throw nlohmann::json::exception, std::out_of_range and config::Error for what is none.
nlohmann::ordered_json tournament_of_version_1(const nlohmann::ordered_json& plan);
nlohmann::ordered_json experiment_of_version_1(const nlohmann::ordered_json& plan);
nlohmann::ordered_json tuning_of_version_1(const nlohmann::ordered_json& plan);

}  // namespace regista::study
