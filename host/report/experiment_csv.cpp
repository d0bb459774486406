// SPDX-License-Identifier: MIT
// An experiment as a table: a line for each number of each match.
#include <fmt/format.h>

#include <filesystem>

#include "report/csv_text.hpp"
#include "report/experiment.hpp"

namespace regista::report {
namespace {

std::string arm_fields(const study::ExperimentPlan& plan, std::size_t condition) {
  const study::Condition& each = plan.conditions[condition];
  std::string out = csv_field(plan.asked.arms[each.arm].name);
  if (plan.swept()) out += ',' + csv_field(plan.value(each.value));
  return out;
}

std::string head_of_arm(const study::ExperimentPlan& plan) {
  return plan.swept() ? "arm," + csv_field(plan.sweep()) : std::string("arm");
}

std::string scene(const study::ExperimentPlan& plan, const study::Trial& trial) {
  if (plan.openings.empty()) return {};
  return std::filesystem::path(plan.openings[trial.opening].file).stem().string();
}

}  // namespace

std::string experiment_csv_head(const study::ExperimentPlan& plan) {
  return fmt::format("row,{},seed,side,opening,ended,measure,value\n", head_of_arm(plan));
}

std::string experiment_csv_lines(const study::ExperimentPlan& plan, std::uint64_t index,
                                 const campaign::Decided& decided, CsvMeasures measures) {
  const study::Trial trial = study::trial(plan, index);
  const std::string before =
      fmt::format("{},{},{},{},{},{},", index + 1, arm_fields(plan, trial.condition), trial.seed,
                  trial.side == 0 ? "home" : "away", csv_field(scene(plan, trial)), csv_field(decided.ended));
  std::string out;
  const auto line = [&](const std::string& measure, double value) {
    out += fmt::format("{}{},{}\n", before, csv_field(measure), value);
  };
  if (decided.failure || decided.set_aside()) return before + ",\n";  // that it was played, and has no numbers
  const study::MatchMeasures played(decided, static_cast<int>(trial.side));
  const std::string always = "playing_seconds";
  line(always, played.playing_seconds());
  if (measures == CsvMeasures::all) {
    for (const study::NamedValue& each : played.all()) line(each.path, each.value);
    for (const study::NamedValue& each : study::metric_values_of_match(decided.metrics)) {
      if (each.path != always) line(each.path, each.value);
    }
    return out;
  }
  for (const std::string& measure : plan.measures) {
    if (const auto value = played.value(measure)) line(measure, *value);
  }
  return out;
}

std::string experiment_summary_csv(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::string out = fmt::format("measure,unit,{},pairs,mean,low,high,mean_per_match\n", head_of_arm(plan));
  const auto number = [](bool known, double value) { return known ? fmt::format("{}", value) : std::string(); };
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
      const study::MeanEstimate mean = view.course.mean(i, measure);
      const study::MeanEstimate per_match = study::mean_of(view.course.per_match(i, measure), plan.asked.confidence);
      const bool known = mean.interval.has_value();
      out += fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(plan.measures[measure]),
                         study::unit_of(plan.measures[measure]), arm_fields(plan, i), mean.pairs,
                         number(mean.pairs > 0, mean.mean), number(known, known ? mean.interval->low : 0.0),
                         number(known, known ? mean.interval->high : 0.0), number(per_match.pairs > 0, per_match.mean));
    }
  }
  return out;
}

}  // namespace regista::report
