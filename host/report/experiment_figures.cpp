// SPDX-License-Identifier: MIT
#include "report/experiment_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "report/metric_reference.hpp"
#include "study/paired_estimates.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_measures = 40;

double row_of(std::size_t row, std::size_t arm, std::size_t arms) {
  return static_cast<double>(row) + 0.8 * ((static_cast<double>(arm) + 0.5) / static_cast<double>(arms) - 0.5);
}

std::string capital(std::string words) {
  if (!words.empty() && words.front() >= 'a' && words.front() <= 'z')
    words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

std::string description(const study::ExperimentPlan& plan, const std::string& measure, const char* interval) {
  return fmt::format("{} ({}), with {} of {:.4g} %.",
                     study::is_time(measure) ? "Minutes in 60 minutes of play" : "Mean of a match",
                     texts::visible(measure), interval, 100.0 * plan.asked.confidence);
}

std::string title_of(const std::string& measure) { return capital(texts::visible(measure_words(measure))); }

// Returns the axis of a sweep. The axis is logarithmic for positive values if largest / smallest is at least 50.
Axis value_axis(const study::ExperimentPlan& plan) {
  Range values;
  for (const double each : study::swept_numbers(plan)) values.take(each);
  return {.title = in_title(plan.sweep()), .logarithmic = values.low > 0.0 && values.high / values.low >= 50.0};
}

Panel panel_of_arms(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  Panel out{.x = {.title = measure_axis(plan.measures[measure])}};
  for (std::size_t arm = 0; arm < plan.arms(); ++arm) {
    out.series.push_back({.colour = arm,
                          .points = {mean_in_row(static_cast<double>(arm), view.course.mean(arm, measure))},
                          .shape = Shape::circle,
                          .interval = Interval::whiskers});
  }
  return out;
}

Figure figure_of_arms(const ExperimentView& view, std::span<const std::size_t> measures, std::string name) {
  const study::ExperimentPlan& plan = view.plan;
  Figure out{.name = std::move(name)};
  out.csv = "arm";
  for (const std::size_t measure : measures) {
    const std::string& path = plan.measures[measure];
    for (const char* end : {"mean", "low", "high"})
      out.csv += ',' + (measures.size() == 1 ? end : figure_field(fmt::format("{} {}", path, end)));
    out.chart.panels.push_back(panel_of_arms(view, measure));
  }
  out.csv += '\n';
  for (std::size_t arm = 0; arm < plan.arms(); ++arm) {
    out.csv += figure_field(plan.asked.arms[arm].name);
    for (const std::size_t measure : measures) out.csv += ',' + mean_fields(view.course.mean(arm, measure));
    out.csv += '\n';
    out.chart.rows.push_back(plan.asked.arms[arm].name);
  }
  out.chart.width = page_width;
  out.chart.height = 30.0 * static_cast<double>(plan.arms());
  return out;
}

Figure arms_figure(const ExperimentView& view, std::size_t measure) {
  Figure out = figure_of_arms(view, {&measure, 1}, fmt::format("measure_{}", measure + 1));
  out.title = title_of(view.plan.measures[measure]);
  out.description = description(view.plan, view.plan.measures[measure], "intervals");
  return out;
}

std::vector<Figure> other_measures(const ExperimentView& view, const std::vector<std::size_t>& measures) {
  constexpr std::size_t most_panels = 3;
  const study::ExperimentPlan& plan = view.plan;
  const std::size_t count = (measures.size() + most_panels - 1) / most_panels;
  std::vector<Figure> out;
  for (std::size_t i = 0, begin = 0; i < count; ++i) {
    const std::size_t end = measures.size() * (i + 1) / count;
    const std::span<const std::size_t> shown(measures.begin() + static_cast<std::ptrdiff_t>(begin), end - begin);
    Figure& each = out.emplace_back(figure_of_arms(view, shown, fmt::format("measures_{}", i + 1)));
    std::vector<std::string> words, paths;
    for (const std::size_t measure : shown) {
      words.push_back(texts::visible(measure_words(plan.measures[measure])));
      paths.push_back(texts::visible(plan.measures[measure]));
    }
    each.title = capital(fmt::format("{}", fmt::join(words, "; ")));
    const bool times = std::ranges::any_of(shown, [&](std::size_t m) { return study::is_time(plan.measures[m]); });
    each.description =
        fmt::format("{}, with intervals of {:.4g} %: {}.",
                    times ? "Times are minutes in 60 minutes of play, all else means of a match" : "Means of a match",
                    100.0 * plan.asked.confidence, fmt::join(paths, ", "));
    begin = end;
  }
  return out;
}

// Returns the figure of a sweep. If the swept values are numbers, each arm has a curve with its interval as a band. For
// other values, each value has a row with the means of the arms.
Figure sweep_figure(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string& path = plan.measures[measure];
  const std::size_t arms = plan.asked.arms.size();
  const std::vector<double> numbers_of_sweep = study::swept_numbers(plan);
  const bool numbers = !numbers_of_sweep.empty();
  Figure out{.name = fmt::format("sweep_{}", measure + 1),
             .title = fmt::format("{} over {}", title_of(path), texts::visible(plan.sweep())),
             .description = description(plan, path, numbers ? "bands" : "intervals")};
  out.csv = "x," + figure_field(plan.sweep());
  Panel panel;
  for (std::size_t arm = 0; arm < arms; ++arm) {
    for (const char* end : {"", " low", " high"}) out.csv += ',' + figure_field(plan.asked.arms[arm].name + end);
    panel.series.push_back({.name = plan.asked.arms[arm].name,
                            .colour = arm,
                            .join = numbers ? Join::line : Join::nothing,
                            .shape = shape_of(arm),
                            .interval = numbers ? Interval::band : Interval::whiskers});
  }
  out.csv += '\n';
  for (std::size_t value = 0; value < plan.values(); ++value) {
    const double x = numbers ? numbers_of_sweep[value] : static_cast<double>(value);
    out.csv += fmt::format("{},{}", x, figure_field(plan.value(value)));
    for (std::size_t arm = 0; arm < arms; ++arm) {
      const study::MeanEstimate mean = view.course.mean(plan.condition(arm, value), measure);
      out.csv += ',' + mean_fields(mean);
      panel.series[arm].points.push_back(numbers ? mean_over(x, mean) : mean_in_row(row_of(value, arm, arms), mean));
    }
    out.csv += '\n';
  }
  if (numbers) {
    out.chart.y.title = measure_axis(path);
    panel.x = value_axis(plan);
  } else {
    out.chart.rows = plan.value_texts();
    panel.x.title = measure_axis(path);
  }
  out.chart.panels = {panel};
  out.chart.width = page_width;
  out.chart.height = numbers ? 250.0 : (18.0 + 12.0 * static_cast<double>(arms)) * static_cast<double>(plan.values());
  return out;
}

struct RoleMeasure {
  std::string_view end;  // last part of the path of a role's measure
  const char* title;     // title with the unit
  const char* name;
  const char* meaning;

  bool is(std::string_view path) const { return path.ends_with(end); }
};
constexpr std::array measures_by_role{
    RoleMeasure{".overlap_seconds", "held twice, minutes of 60", "held twice",
                "minutes in 60 minutes of play in which two robots or more held the role"},
    RoleMeasure{".uncovered_seconds", "held by nobody, minutes of 60", "held by nobody",
                "minutes in 60 minutes of play in which no robot held it although it was wanted"},
    RoleMeasure{".switches", "changes of holder, per match", "changes of holder",
                "how often a robot took it, in a match"}};

bool is_in_role_figure(std::string_view path) {
  return std::ranges::any_of(measures_by_role, [&](const RoleMeasure& each) { return each.is(path); });
}

// Returns the names of the roles in the order of the measures, without roles whose numbers are all 0.
std::vector<std::string> roles_of(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < plan.measures.size(); ++i) {
    const std::string& measure = plan.measures[i];
    if (is_in_role_figure(measure) && !shows_nothing(view, i))
      texts::add_once(out, measure.substr(0, measure.rfind('.')));
  }
  return out;
}

// Returns the bar chart of Affinita et al. 2023, section 4: overlap, uncovered time and switches by role. Each arm has
// a colour. The bars of the first arm are on top.
std::optional<Figure> role_figure(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::size_t arms = plan.asked.arms.size();
  const std::vector<std::string> names = roles_of(view);
  if (names.empty() || view.course.taken() == 0) return std::nullopt;
  std::vector<RoleMeasure> shown;
  std::ranges::copy_if(measures_by_role, std::back_inserter(shown), [&](const RoleMeasure& each) {
    for (std::size_t i = 0; i < plan.measures.size(); ++i) {
      if (each.is(plan.measures[i]) && !shows_nothing(view, i)) return true;
    }
    return false;
  });
  Figure out{.name = "roles", .title = "Roles: " + in_a_row(texts::names_of(shown, &RoleMeasure::name))};
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
      const auto measure = study::measure_index(plan, names[row] + std::string(shown[i].end));
      for (std::size_t arm = 0; arm < arms; ++arm) {
        const study::MeanEstimate mean = measure ? view.course.mean(arm, *measure) : study::MeanEstimate{};
        out.csv += ',' + mean_fields(mean);
        const Point point = mean_in_row(row_of(row, arm, arms), mean);
        series[arm].points.push_back({point.x, point.y});
        if (mean.interval) series[arms].points.push_back(point);
      }
    }
    out.csv += '\n';
    out.chart.rows.push_back(name_of_role(names[row]));
  }
  out.chart.width = page_width;
  out.chart.height = static_cast<double>(names.size()) * std::max(24.0, 10.0 * static_cast<double>(arms));
  return out;
}

}  // namespace

bool is_experiment_figure(std::string_view name) {
  return name == "roles" || is_numbered(name, "sweep_") || is_numbered(name, "measure_") ||
         is_numbered(name, "measures_");
}

std::vector<Figure> experiment_figures(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::optional<std::size_t> primary = study::primary_measure(plan);
  std::vector<Figure> out;
  if (primary && !shows_nothing(view, *primary))
    out.push_back(plan.swept() ? sweep_figure(view, *primary) : arms_figure(view, *primary));
  std::vector<std::size_t> others;
  for (std::size_t measure = 0; measure < plan.measures.size(); ++measure) {
    const bool by_role = !plan.swept() && is_in_role_figure(plan.measures[measure]);
    if (measure != primary && !by_role && !shows_nothing(view, measure)) others.push_back(measure);
  }
  others.resize(std::min(others.size(), most_measures));
  if (plan.swept()) {
    for (const std::size_t measure : others) out.push_back(sweep_figure(view, measure));
    return out;
  }
  if (auto roles = role_figure(view)) out.push_back(std::move(*roles));
  std::ranges::move(other_measures(view, others), std::back_inserter(out));
  return out;
}

bool shows_nothing(const ExperimentView& view, std::size_t measure) {
  for (std::size_t i = 0; i < view.plan.conditions.size(); ++i) {
    const std::span<const double> values = view.course.values(i, measure);
    if (std::ranges::any_of(values, [](double each) { return !std::isnan(each) && each != 0.0; })) return false;
  }
  return true;
}

std::vector<std::string> names_of_experiment_figures(const study::ExperimentPlan& plan) {
  const std::optional<std::size_t> primary = study::primary_measure(plan);
  const char* const one = plan.swept() ? "sweep" : "measure";
  std::vector<std::string> out;
  if (primary) out.push_back(fmt::format("{}_{}", one, *primary + 1));
  out.emplace_back("roles");
  for (std::size_t i = 0; i < plan.measures.size(); ++i) {
    if (!plan.swept() || i != primary) out.push_back(fmt::format("{}_{}", plan.swept() ? one : "measures", i + 1));
  }
  return out;
}

}  // namespace regista::report
