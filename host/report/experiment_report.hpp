// SPDX-License-Identifier: MIT
// The report of an experiment.
#pragma once

#include <memory>

#include "report/study_report.hpp"
#include "study/experiment_plan.hpp"

namespace regista::report {

// again: as it is shown to the reader.
std::unique_ptr<StudyReport> experiment_report(study::ExperimentPlan plan, CommandOf again);

}  // namespace regista::report
