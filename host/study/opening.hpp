// SPDX-License-Identifier: MIT
// A scene that matches of a study start from.
#pragma once

#include <string>

#include "campaign/input.hpp"
#include "campaign/job.hpp"

namespace regista::study {

struct Opening {
  std::string file;
  campaign::Input input;
};

// The match starts from this scene.
inline void start_from(const Opening& opening, campaign::Job& job) {
  job.opening = opening.file;
  job.common_inputs.push_back(opening.input);
}

}  // namespace regista::study
