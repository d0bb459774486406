// SPDX-License-Identifier: MIT
#include "report/experiment_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "texts/visible.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_figures = 40;

double row_of(std::size_t row, std::size_t arm, std::size_t arms) {
  return static_cast<double>(row) + 0.8 * ((static_cast<double>(arm) + 0.5) / static_cast<double>(arms) - 0.5);
}

// --- Of one measure --------------------------------------------------------------------------------------------------

std::string description(const study::ExperimentPlan& plan, const std::string& measure, const char* interval) {
  return fmt::format("{}, with {} of {:.4g} %.",
                     study::is_time(measure) ? "Minutes in 60 minutes of play" : "Mean of a match", interval,
                     100.0 * plan.asked.confidence);
}

std::string measure_title(const std::string& measure) { return in_title(measure) + ", " + study::unit_of(measure); }

std::string names_of_arms(const study::ExperimentPlan& plan) {
  std::string out;
  for (const config::Experiment::Arm& arm : plan.asked.arms) {
    for (const char* end : {"", " low", " high"}) out += ',' + figure_field(arm.name + end);
  }
  return out;
}

std::optional<double> number_of(const std::string& text) {
  try {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    if (end == text.size() && std::isfinite(value)) return value;
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

// Of the values of a sweep; by powers of ten where these are far apart.
Axis value_axis(const study::ExperimentPlan& plan) {
  Range values;
  for (const std::string& each : plan.value_texts()) values.take(*number_of(each));
  return {.title = in_title(plan.sweep()), .logarithmic = values.low > 0.0 && values.high / values.low >= 50.0};
}

// Without a sweep: a row for each arm, its mean and interval.
std::optional<Figure> arms_figure(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string& path = plan.measures[measure];
  Figure out{.name = fmt::format("measure_{}", measure + 1),
             .title = texts::visible(path),
             .description = description(plan, path, "intervals")};
  out.csv = "arm,mean,low,high\n";
  Panel panel{.x = {.title = measure_title(path)}};
  bool any = false;
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    const study::MeanEstimate mean = view.course.mean(arm, measure);
    any = any || mean.pairs > 0;
    out.csv += figure_field(plan.asked.arms[arm].name) + ',' + mean_fields(mean) + '\n';
    out.chart.rows.push_back(plan.asked.arms[arm].name);
    panel.series.push_back({.colour = arm,
                            .points = {mean_in_row(static_cast<double>(arm), mean)},
                            .shape = Shape::circle,
                            .interval = Interval::whiskers});
  }
  if (!any) return std::nullopt;
  out.chart.panels = {panel};
  out.chart.width = page_width;
  out.chart.height = 30.0 * static_cast<double>(plan.asked.arms.size());
  return out;
}

// Over a sweep: a curve for each arm with its interval as a band, if the values are numbers; else a row for each value,
// in it the arms from above.
std::optional<Figure> sweep_figure(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string& path = plan.measures[measure];
  const std::size_t arms = plan.asked.arms.size();
  const bool numbers =
      std::ranges::all_of(plan.value_texts(), [](const auto& each) { return number_of(each).has_value(); });
  bool any = false;
  Figure out{.name = fmt::format("sweep_{}", measure + 1),
             .title = fmt::format("{} over {}", texts::visible(path), texts::visible(plan.sweep())),
             .description = description(plan, path, numbers ? "bands" : "intervals")};
  out.csv = "x," + figure_field(plan.sweep()) + names_of_arms(plan) + '\n';
  Panel panel;
  for (std::size_t arm = 0; arm < arms; ++arm) {
    panel.series.push_back({.name = plan.asked.arms[arm].name,
                            .colour = arm,
                            .join = numbers ? Join::line : Join::nothing,
                            .shape = shape_of(arm),
                            .interval = numbers ? Interval::band : Interval::whiskers});
  }
  for (std::size_t value = 0; value < plan.values(); ++value) {
    const double x = numbers ? *number_of(plan.value(value)) : static_cast<double>(value);
    out.csv += fmt::format("{},{}", x, figure_field(plan.value(value)));
    for (std::size_t arm = 0; arm < arms; ++arm) {
      const study::MeanEstimate mean = view.course.mean(plan.condition(arm, value), measure);
      any = any || mean.pairs > 0;
      out.csv += ',' + mean_fields(mean);
      panel.series[arm].points.push_back(numbers ? mean_over(x, mean) : mean_in_row(row_of(value, arm, arms), mean));
    }
    out.csv += '\n';
  }
  if (!any) return std::nullopt;
  if (numbers) {
    out.chart.y.title = study::unit_of(path);
    panel.x = value_axis(plan);
  } else {
    out.chart.rows = plan.value_texts();
    panel.x.title = measure_title(path);
  }
  out.chart.panels = {panel};
  out.chart.width = page_width;
  out.chart.height = numbers ? 250.0 : (18.0 + 12.0 * static_cast<double>(arms)) * static_cast<double>(plan.values());
  return out;
}

// --- Of roles --------------------------------------------------------------------------------------------------------

struct RoleMeasure {
  std::string_view end;  // of the measure's path
  const char* title;     // with its unit
  const char* name;
  const char* meaning;

  bool is(std::string_view path) const { return path.ends_with(end); }
};
constexpr std::array measures_by_role{
    RoleMeasure{".overlap_seconds", "overlap, min per 60 min", "overlap",
                "minutes in 60 minutes of play in which two robots or more held the role"},
    RoleMeasure{".uncovered_seconds", "uncovered, min per 60 min", "uncovered time",
                "minutes in 60 minutes of play in which no robot held it although it was wanted"},
    RoleMeasure{".switches", "switches per match", "switches", "how often a robot took it, in a match"}};

bool is_in_role_figure(std::string_view path) {
  return std::ranges::any_of(measures_by_role, [&](const RoleMeasure& each) { return each.is(path); });
}

std::string capital(std::string words) {
  words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

// "Overlap, uncovered time and switches by role"
std::string title_of(const std::vector<RoleMeasure>& shown) {
  std::string out;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    out += i == 0 ? "" : i + 1 == shown.size() ? " and " : ", ";
    out += shown[i].name;
  }
  return capital(out) + " by role";
}

std::optional<std::size_t> measure_index(const study::ExperimentPlan& plan, const std::string& path) {
  const auto found = std::ranges::find(plan.measures, path);
  if (found == plan.measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plan.measures.begin());
}

// Of the roles that the measures name, in their order.
std::vector<std::string> roles_of(const study::ExperimentPlan& plan) {
  std::vector<std::string> out;
  for (const std::string& measure : plan.measures) {
    if (!is_in_role_figure(measure)) continue;
    const std::string role = measure.substr(0, measure.rfind('.'));
    if (std::ranges::find(out, role) == out.end()) out.push_back(role);
  }
  return out;
}

// "goalkeeper" of "playing.goalkeeper": other lists may have a role of this name, but in a picture it is enough.
std::string short_name(const std::string& role) {
  std::string out = role.substr(role.rfind('.') + 1);
  std::ranges::replace(out, '_', ' ');
  return out;
}

// The bar chart of Affinita et al. 2023, section 4: overlap, uncovered time and switches by role, a colour for each
// arm, the first one's bars on top.
std::optional<Figure> role_figure(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::size_t arms = plan.asked.arms.size();
  const std::vector<std::string> names = roles_of(plan);
  if (names.empty() || view.course.taken() == 0) return std::nullopt;
  std::vector<RoleMeasure> shown;
  std::ranges::copy_if(measures_by_role, std::back_inserter(shown), [&](const RoleMeasure& each) {
    return std::ranges::any_of(plan.measures, [&](const std::string& measure) { return each.is(measure); });
  });
  Figure out{.name = "roles", .title = title_of(shown)};
  out.csv = "role";
  for (const RoleMeasure& each : shown) {
    out.description += fmt::format("{}{}: {}", out.description.empty() ? "" : "; ", each.name, each.meaning);
    Panel& panel = out.chart.panels.emplace_back(Panel{.x = {.title = each.title, .from_zero = true}});
    for (std::size_t arm = 0; arm < arms; ++arm) {
      const std::string& name = plan.asked.arms[arm].name;
      for (const char* end : {"", " low", " high"})
        out.csv += ',' + figure_field(fmt::format("{} {}{}", name, each.end.substr(1), end));
      panel.series.push_back({.name = name, .colour = arm, .bar = 0.74 / static_cast<double>(arms)});
    }
    panel.series.push_back({.colour = grey, .interval = Interval::whiskers});
  }
  out.csv += '\n';
  out.description =
      capital(out.description) + fmt::format(". Whiskers: intervals of {:.4g} %.", 100.0 * plan.asked.confidence);
  for (std::size_t row = 0; row < names.size(); ++row) {
    out.csv += figure_field(names[row]);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      std::vector<Series>& series = out.chart.panels[i].series;
      const auto measure = measure_index(plan, names[row] + std::string(shown[i].end));
      for (std::size_t arm = 0; arm < arms; ++arm) {
        const study::MeanEstimate mean = measure ? view.course.mean(arm, *measure) : study::MeanEstimate{};
        out.csv += ',' + mean_fields(mean);
        const Point point = mean_in_row(row_of(row, arm, arms), mean);
        series[arm].points.push_back({point.x, point.y});
        if (mean.interval) series[arms].points.push_back(point);
      }
    }
    out.csv += '\n';
    out.chart.rows.push_back(short_name(names[row]));
  }
  out.chart.width = page_width;
  out.chart.height = static_cast<double>(names.size()) * std::max(24.0, 10.0 * static_cast<double>(arms));
  return out;
}

}  // namespace

bool is_experiment_figure(std::string_view name) {
  return name == "roles" || is_numbered(name, "sweep_") || is_numbered(name, "measure_");
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
