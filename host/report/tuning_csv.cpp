// SPDX-License-Identifier: MIT
// A tuning as a table: a line for each point of its search. Numbers are as short as they read back exactly; what is not
// known is an empty field.
#include <fmt/format.h>

#include <cmath>

#include "report/csv_text.hpp"
#include "report/tuning_numbers.hpp"

namespace regista::report {

std::string tuning_csv(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::string out = "evaluation,pairs_from,repeated,failed,";
  for (const study::Parameter& each : plan.parameters) out += csv_field(each.path) + ',';
  out += "value,standard_error,pairs,best,matches\n";
  for (const study::SearchStep& each : view.record.trace) {
    const study::MeanEstimate& score = each.played.score;
    out += fmt::format("{},{},{},{},", each.evaluation, each.pairs_from, each.repeated ? 1 : 0,
                       each.played.failed ? 1 : 0);
    for (std::size_t i = 0; i < plan.parameters.size(); ++i) out += text_of(plan.parameters[i], each.values[i]) + ',';
    out += fmt::format("{},", of_objective(plan.objective, each.played.counted));
    if (score.pairs >= 2)
      out += fmt::format("{}", score.standard_deviation / std::sqrt(static_cast<double>(score.pairs)));
    out += fmt::format(",{},{},{}\n", score.pairs, of_objective(plan.objective, each.best), each.matches);
  }
  return out;
}

}  // namespace regista::report
