// SPDX-License-Identifier: MIT
// The page about a tuning: one HTML file.
#pragma once

#include <string>
#include <vector>

#include "report/page_parts.hpp"
#include "report/tuning.hpp"
#include "report/tuning_page_parts.hpp"

namespace regista::report {

struct TuningPage {
  TuningView view;
  std::vector<Figure> figures;
  PlayedResults results;
};

std::string tuning_page(const TuningPage& page);

}  // namespace regista::report
