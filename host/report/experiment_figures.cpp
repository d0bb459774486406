// SPDX-License-Identifier: MIT
#include "report/experiment_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "report/experiment_figure_parts.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_figures = 40;
constexpr std::array<std::string_view, 2> numbered{"sweep_", "measure_"};

std::string field(bool known, double value) {
  return known && std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

}  // namespace

std::string mean_fields(const study::MeanEstimate& mean) {
  const bool known = mean.pairs > 0, bounded = mean.interval.has_value();
  return fmt::format("{},{},{}", field(known, mean.mean), field(known, bounded ? mean.interval->low : mean.mean),
                     field(known, bounded ? mean.interval->high : mean.mean));
}

std::string arm_colour(std::size_t arm) { return std::string(colours[arm % colours.size()]); }

int key_columns(const study::ExperimentPlan& plan) {
  std::size_t widest = 0;
  for (const config::Experiment::Arm& arm : plan.asked.arms)
    widest = std::max(widest, gnuplot_text(arm.name).size() - 2);
  return std::clamp(static_cast<int>(1000.0 / (8.2 * static_cast<double>(widest) + 50.0)), 1,
                    static_cast<int>(plan.asked.arms.size()));
}

int key_rows(const study::ExperimentPlan& plan) {
  const int columns = key_columns(plan);
  return (static_cast<int>(plan.asked.arms.size()) + columns - 1) / columns;
}

bool is_experiment_figure(std::string_view name) {
  if (name == "roles") return true;
  return std::ranges::any_of(numbered, [name](std::string_view prefix) {
    if (!name.starts_with(prefix)) return false;
    const std::string_view number = name.substr(prefix.size());
    return !number.empty() && number.size() <= 3 && number.find_first_not_of("0123456789") == number.npos;
  });
}

std::vector<Figure> experiment_figures(const ExperimentView& view) {
  std::vector<Figure> out;
  const auto add = [&out](std::optional<Figure> figure) {
    if (figure) out.push_back(std::move(*figure));
  };
  const study::ExperimentPlan& plan = view.plan;
  const auto of_measure = [&](std::size_t measure) {
    if (plan.swept())
      add(sweep_figure(view, measure));
    else if (!is_in_role_figure(plan.measures[measure]))
      add(arms_figure(view, measure));
  };
  const std::optional<std::size_t> primary = study::primary_measure(plan);
  if (primary) of_measure(*primary);
  if (!plan.swept()) add(role_figure(view));
  for (std::size_t measure = 0; measure < plan.measures.size() && out.size() < most_figures; ++measure) {
    if (measure != primary) of_measure(measure);
  }
  return out;
}

}  // namespace regista::report
