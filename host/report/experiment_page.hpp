// SPDX-License-Identifier: MIT
// An experiment as one page of HTML that needs nothing else: a function of plan, results in order and the pictures that
// were drawn; no time of day and no running time stands in it.
#pragma once

#include <string>
#include <vector>

#include "report/experiment.hpp"
#include "report/page_parts.hpp"

namespace regista::report {

struct ExperimentPageSource {
  ExperimentView view;
  std::vector<Figure> figures;
  PlayedResults results;
};

std::string experiment_page(const ExperimentPageSource& source);

}  // namespace regista::report
