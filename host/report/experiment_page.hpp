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
  std::vector<PageFigure> figures;
  std::string program;      // version that began the experiment
  std::string fingerprint;  // of all matches
  std::string command;      // that plays it again
};

std::string experiment_page(const ExperimentPageSource& source);

// The words of `regista experiment` that play it again, after the name of the program. Paths are relative to
// plan.folder.
std::vector<std::string> experiment_arguments(const study::ExperimentPlan& plan);

}  // namespace regista::report
