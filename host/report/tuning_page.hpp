// SPDX-License-Identifier: MIT
// The page about a tuning: one HTML file.
#pragma once

#include <string>
#include <vector>

#include "report/page_parts.hpp"
#include "report/tuning.hpp"

namespace regista::report {

struct TuningPage {
  TuningView view;
  std::vector<PageFigure> figures;
  std::string program;      // version that played
  std::string fingerprint;  // of the results
  std::string command;      // that plays it again
};

std::string tuning_page(const TuningPage& page);

}  // namespace regista::report
