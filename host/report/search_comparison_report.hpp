// SPDX-License-Identifier: MIT
// The report of a comparison of search algorithms.
#pragma once

#include <memory>

#include "report/study_report.hpp"
#include "study/tuning/search_comparison_plan.hpp"

namespace regista::report {

std::unique_ptr<StudyReport> search_comparison_report(study::SearchComparisonPlan plan);

}  // namespace regista::report
