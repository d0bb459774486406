// SPDX-License-Identifier: MIT
// A comparison of search algorithms as a table: a line for each run.
#include <fmt/format.h>

#include "report/csv_text.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison.hpp"
#include "report/tuning_csv_fields.hpp"

namespace regista::report {

std::string search_comparison_csv(const SearchComparisonView& view) {
  const study::TuningPlan& plan = view.plan.tuning;
  std::string out =
      "algorithm,repeat,evaluations,matches," + parameter_columns(plan) + "seen,judged,standard_error,pairs,ended\n";
  for (const study::ComparedRun& each : view.record.runs) {
    out += fmt::format(
        "{},{},{},{},{}{},{},{},{},{}\n", name(each.algorithm), each.repeat + 1, each.evaluations, each.matches,
        value_fields(plan, each.values),
        each.seen ? fmt::format("{}", of_objective(plan.objective, *each.seen)) : std::string(),
        each.judged.pairs > 0 ? fmt::format("{}", of_objective(plan.objective, each.judged.mean)) : std::string(),
        standard_error_field(each.judged), each.judged.pairs, csv_field(each.ended));
  }
  return out;
}

}  // namespace regista::report
