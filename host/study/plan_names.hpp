// SPDX-License-Identifier: MIT
// What plans call the studies they are of: {"study": NAME, ...}.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace regista::study {

inline constexpr const char* tournament_study = "tournament";
inline constexpr const char* experiment_study = "experiment";
inline constexpr const char* tuning_study = "tuning";
inline constexpr const char* search_comparison_study = "search_comparison";

// The study that a plan is of; empty where it does not say.
std::string study_of(const std::string& plan);

// Whether it is a comparison of search algorithms as these were written before they were a study of their own: as a
// tuning with a list of algorithms. Such plans are of the study "search_comparison", too.
bool holds_comparison_of_before(const nlohmann::ordered_json& plan);

}  // namespace regista::study
