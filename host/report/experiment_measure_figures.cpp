// SPDX-License-Identifier: MIT
// Figures of one measure of an experiment: by arm, or over a sweep.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/experiment_figure_parts.hpp"
#include "report/objective_axis.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

std::string description(const study::ExperimentPlan& plan, const std::string& measure, const char* interval) {
  return fmt::format("{}, with {} of {:.4g} %.",
                     study::is_time(measure) ? "Minutes in 60 minutes of play" : "Mean of a match", interval,
                     100.0 * plan.asked.confidence);
}

// "packets, per match", for gnuplot.
std::string measure_label(const std::string& measure) {
  return fmt::format("{}.', {}'", gnuplot_text(measure), study::unit_of(measure));
}

// Rows from above, called so: their names, and the room that these need on the left.
std::string row_commands(const std::vector<std::string>& names, const Figure& figure) {
  std::string tics;
  std::size_t widest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string mark = gnuplot_mark(names[i]);
    widest = std::max(widest, mark.size() - 2);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", mark, -static_cast<int>(i));
  }
  return fmt::format(
      "set ytics scale 0 ({})\nset yrange [{:.1f}:0.5]\nset lmargin at screen {:.4f}\nset grid noytics\n"
      "set grid xtics lt 1 lc rgb '{}' lw 0.7\n",
      tics, -static_cast<double>(names.size()) + 0.5,
      std::min(0.5, (8.2 * static_cast<double>(widest) + 16.0) / figure.width), grid_colour);
}

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

// From the least value to the largest; by powers of ten where these are far apart.
std::string x_axis(const study::ExperimentPlan& plan) {
  double least = *number_of(plan.value(0)), most = least;
  for (const std::string& each : plan.value_texts()) {
    least = std::min(least, *number_of(each));
    most = std::max(most, *number_of(each));
  }
  if (!(most > least)) return {};
  const bool logarithmic = least > 0.0 && most / least >= 50.0;
  const double room = logarithmic ? 1.0 : 0.02 * (most - least);
  return fmt::format("{}set xrange [{:.6g}:{:.6g}]\n", logarithmic ? "set logscale x\n" : "",
                     logarithmic ? least / 1.1 : least - room, logarithmic ? most * 1.1 : most + room);
}

std::string curve_commands(const study::ExperimentPlan& plan, const std::string& name, const std::string& measure) {
  std::string out = fmt::format("set xlabel {}\nset ylabel '{}'\nset offsets 0, 0, graph 0.05, graph 0.02\n{}plot ",
                                gnuplot_text(plan.sweep()), study::unit_of(measure), x_axis(plan));
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    out += fmt::format(
        "'{0}.csv' using 1:{1}:{2} with filledcurves lc rgb '{3}' fs transparent solid 0.18 noborder notitle, \\\n    "
        " ",
        name, 3 * arm + 4, 3 * arm + 5, arm_colour(arm));
  }
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    out += fmt::format("'' using 1:{} with linespoints lc rgb '{}' lw 2 pt {} ps 0.7 title {}{}", 3 * arm + 3,
                       arm_colour(arm), 5 + 2 * (arm % 5), gnuplot_text(plan.asked.arms[arm].name),
                       arm + 1 < plan.asked.arms.size() ? ", \\\n     " : "\n");
  }
  return out;
}

// A row for each value, in it the arms from above.
std::string value_rows_commands(const ExperimentView& view, const Figure& figure, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  AxisRange range;
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) range.take(view.course.mean(i, measure));
  std::string out =
      fmt::format("{}set xlabel {}\nset xrange {}\nset bars 0.4\nplot ", row_commands(plan.value_texts(), figure),
                  measure_label(plan.measures[measure]), range.axis());
  const double step = 0.8 / static_cast<double>(plan.asked.arms.size());
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    out += fmt::format("{} using {}:(-$1{:+.4f}):{}:{} with xerrorbars lc rgb '{}' lw 2 pt {} ps 0.7 title {}{}",
                       arm == 0 ? '\'' + figure.name + ".csv'" : "''", 3 * arm + 3,
                       0.4 - (static_cast<double>(arm) + 0.5) * step, 3 * arm + 4, 3 * arm + 5, arm_colour(arm),
                       5 + 2 * (arm % 5), gnuplot_text(plan.asked.arms[arm].name),
                       arm + 1 < plan.asked.arms.size() ? ", \\\n     " : "\n");
  }
  return out;
}

}  // namespace

std::optional<Figure> arms_figure(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string& path = plan.measures[measure];
  Figure out;
  out.name = fmt::format("measure_{}", measure + 1);
  out.title = texts::visible(path);
  out.description = description(plan, path, "intervals");
  out.csv = "arm,mean,low,high\n";
  AxisRange range;
  std::vector<std::string> names;
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    const study::MeanEstimate mean = view.course.mean(arm, measure);
    range.take(mean);
    names.push_back(plan.asked.arms[arm].name);
    out.csv += figure_field(plan.asked.arms[arm].name) + ',' + mean_fields(mean) + '\n';
  }
  if (range.empty()) return std::nullopt;
  out.width = page_width;
  out.height = 66 + 30 * static_cast<int>(names.size());
  out.commands =
      fmt::format("{}set xlabel {}\nset xrange {}\nset bars 0.5\nset yzeroaxis lt 1 lc rgb '{}' lw 1\nunset key\nplot ",
                  row_commands(names, out), measure_label(path), range.axis(), colours[7]);
  for (std::size_t arm = 0; arm < names.size(); ++arm) {
    out.commands += fmt::format("{0} using ($0=={1}?$2:1/0):(-$0):3:4 with xerrorbars pt 7 ps 0.9 lw 2 lc rgb '{2}'{3}",
                                arm == 0 ? '\'' + out.name + ".csv'" : "''", arm, arm_colour(arm),
                                arm + 1 < names.size() ? ", \\\n     " : "\n");
  }
  return out;
}

std::optional<Figure> sweep_figure(const ExperimentView& view, std::size_t measure) {
  const study::ExperimentPlan& plan = view.plan;
  const std::string& path = plan.measures[measure];
  const bool numbers =
      std::ranges::all_of(plan.value_texts(), [](const auto& each) { return number_of(each).has_value(); });
  bool any = false;
  Figure out;
  out.name = fmt::format("sweep_{}", measure + 1);
  out.title = fmt::format("{} over {}", texts::visible(path), texts::visible(plan.sweep()));
  out.description = description(plan, path, numbers ? "bands" : "intervals");
  out.csv = "x," + figure_field(plan.sweep()) + names_of_arms(plan) + '\n';
  for (std::size_t value = 0; value < plan.values(); ++value) {
    const double x = numbers ? *number_of(plan.value(value)) : static_cast<double>(value);
    out.csv += fmt::format("{},{}", x, figure_field(plan.value(value)));
    for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
      const study::MeanEstimate mean = view.course.mean(plan.condition(arm, value), measure);
      any = any || mean.pairs > 0;
      out.csv += ',' + mean_fields(mean);
    }
    out.csv += '\n';
  }
  if (!any) return std::nullopt;
  out.width = page_width;
  const int key = 20 * key_rows(plan), row = 18 + 12 * static_cast<int>(plan.asked.arms.size());
  out.height = key + (numbers ? 310 : 66 + row * static_cast<int>(plan.values()));
  out.commands = fmt::format("set key outside top center horizontal Left reverse maxcols {}\n", key_columns(plan)) +
                 (numbers ? curve_commands(plan, out.name, path) : value_rows_commands(view, out, measure));
  return out;
}

}  // namespace regista::report
