// SPDX-License-Identifier: MIT
// A scene that matches of a study start from.
#pragma once

#include <string>

#include "campaign/input.hpp"

namespace regista::study {

struct Opening {
  std::string file;
  campaign::Input input;
};

}  // namespace regista::study
