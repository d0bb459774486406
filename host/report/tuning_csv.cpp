// SPDX-License-Identifier: MIT
// A tuning as a table: a line for each point of its search.
#include <fmt/format.h>

#include "report/tuning_csv_fields.hpp"
#include "report/tuning_numbers.hpp"

namespace regista::report {

std::string tuning_csv(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::string out =
      "evaluation,pairs_from,repeated,failed," + parameter_columns(plan) + "value,standard_error,pairs,best,matches\n";
  for (const study::SearchStep& each : view.record.trace) {
    out += fmt::format("{},{},{},{},{}{},{},{},{},{}\n", each.evaluation, each.pairs_from, each.repeated ? 1 : 0,
                       each.played.failed ? 1 : 0, value_fields(plan, each.values),
                       of_objective(plan.objective, each.played.counted), standard_error_field(each.played.score),
                       each.played.score.pairs, of_objective(plan.objective, each.best), each.matches);
  }
  return out;
}

}  // namespace regista::report
