// SPDX-License-Identifier: MIT
// Numbers stand as short as they read back exactly; what is not known is an empty field.
#include <fmt/format.h>

#include <cmath>

#include "report/csv_text.hpp"
#include "report/tuning_numbers.hpp"

namespace regista::report {
namespace {

std::string paths(const study::TuningPlan& plan) {
  std::string out;
  for (const study::Parameter& each : plan.parameters) out += csv_field(each.path) + ',';
  return out;
}

std::string fields(const study::TuningPlan& plan, const study::ParameterValues& values) {
  std::string out;
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) out += text_of(plan.parameters[i], values[i]) + ',';
  return out;
}

std::string standard_error(const study::MeanEstimate& estimate) {
  if (estimate.pairs < 2) return {};
  return fmt::format("{}", estimate.standard_deviation / std::sqrt(static_cast<double>(estimate.pairs)));
}

std::string trace_csv(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::string out =
      "evaluation,pairs_from,repeated,failed," + paths(plan) + "value,standard_error,pairs,best,matches\n";
  for (const study::SearchStep& each : view.record.trace) {
    out += fmt::format("{},{},{},{},{}{},{},{},{},{}\n", each.evaluation, each.pairs_from, each.repeated ? 1 : 0,
                       each.played.failed ? 1 : 0, fields(plan, each.values), told(plan.objective, each.played.counted),
                       standard_error(each.played.score), each.played.score.pairs, told(plan.objective, each.best),
                       each.matches);
  }
  return out;
}

std::string runs_csv(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::string out = "algorithm,repeat,evaluations,matches," + paths(plan) + "seen,judged,standard_error,pairs,ended\n";
  for (const study::ComparedRun& each : view.record.compared) {
    out += fmt::format(
        "{},{},{},{},{}{},{},{},{},{}\n", name(each.algorithm), each.repeat + 1, each.evaluations, each.matches,
        fields(plan, each.values), each.seen ? fmt::format("{}", told(plan.objective, *each.seen)) : std::string(),
        each.judged.pairs > 0 ? fmt::format("{}", told(plan.objective, each.judged.mean)) : std::string(),
        standard_error(each.judged), each.judged.pairs, csv_field(each.ended));
  }
  return out;
}

}  // namespace

std::string tuning_csv(const TuningView& view) { return view.plan.compares() ? runs_csv(view) : trace_csv(view); }

}  // namespace regista::report
