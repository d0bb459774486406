// SPDX-License-Identifier: MIT
// What plans call the studies they are of: {"study": NAME, ...}.
#pragma once

#include <string>

namespace regista::study {

inline constexpr const char* tournament_study = "tournament";
inline constexpr const char* experiment_study = "experiment";
inline constexpr const char* tuning_study = "tuning";

// The study that a plan is of; empty where it does not say.
std::string study_of(const std::string& plan);

}  // namespace regista::study
