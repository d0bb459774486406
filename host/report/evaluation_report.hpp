// SPDX-License-Identifier: MIT
// The result of `regista evaluate-predictor`, for people and for programs.
#pragma once

#include <string>

#include "config/predictor_study.hpp"
#include "study/prediction/evaluation.hpp"

namespace regista::report {

// What was evaluated by what: the beginning of both.
struct Evaluated {
  std::string file;       // of the study
  std::string data;       // the recording
  std::string predictor;  // file of the plugin
  std::string hash;       // of its content
  std::string program;    // version
};

std::string evaluation_text(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation);
std::string evaluation_json(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation);

}  // namespace regista::report
