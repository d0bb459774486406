// SPDX-License-Identifier: MIT
// A tuned team as the lines of YAML that differ from the base team.
#pragma once

#include <string>

#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// name: of the new team. base: its file, as the new file is to name it in `extends`. Lists cannot be changed in part by
// a document that extends another: one in which a value was tuned is written whole. Throws config::Error where the base
// team's settings do not fit it.
std::string tuned_team(const TuningPlan& plan, const ParameterValues& values, const std::string& name,
                       const std::string& base);

}  // namespace regista::study
