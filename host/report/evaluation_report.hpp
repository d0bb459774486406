// SPDX-License-Identifier: MIT
// The result of `regista evaluate-predictor`, for people and for programs.
#pragma once

#include <string>

#include "config/predictor_study.hpp"
#include "study/prediction/evaluation.hpp"

namespace regista::report {

std::string evaluation_text(const config::PredictorStudy& study, const std::string& data,
                            const study::Evaluation& evaluation);
std::string evaluation_json(const config::PredictorStudy& study, const std::string& data,
                            const study::Evaluation& evaluation);

}  // namespace regista::report
