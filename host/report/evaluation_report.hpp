// SPDX-License-Identifier: MIT
// The reports of `regista evaluate-predictor`: as text for people and as JSON for programs.
#pragma once

#include <string>

#include "config/predictor_study.hpp"
#include "study/prediction/evaluation.hpp"

namespace regista::report {

// The inputs of an evaluation. The text and the JSON begin with these inputs.
struct Evaluated {
  std::string file;       // document of the study
  std::string data;       // the recording that the predictor is tested with
  std::string predictor;  // file of the plugin
  std::string hash;       // hash of the plugin file
  std::string program;    // version of the program
};

std::string evaluation_text(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation);
std::string evaluation_json(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation);

}  // namespace regista::report
