// SPDX-License-Identifier: MIT
#include "report/tuning_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "report/estimate_text.hpp"
#include "report/objective_axis.hpp"
#include "report/thinned.hpp"
#include "report/tuning_sentences.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_points = 1000;  // of the search that are drawn
constexpr std::size_t most_slices = 40;
constexpr std::string_view slice_prefix = "slice_";

// The end of a path says most; an axis has room for so much.
std::string short_path(const std::string& path) {
  constexpr std::size_t most = 31;
  if (path.size() <= most) return path;
  const std::size_t dot = path.find('.', path.size() - most);
  return dot == std::string::npos ? path.substr(path.size() - most) : path.substr(dot + 1);
}

std::string field(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

std::string interval_fields(const study::MeanEstimate& estimate) {
  const bool known = estimate.pairs > 0, bounded = estimate.interval.has_value();
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return fmt::format("{},{},{}", field(known ? estimate.mean : nothing),
                     field(bounded ? estimate.interval->low
                           : known ? estimate.mean
                                   : nothing),
                     field(bounded ? estimate.interval->high
                           : known ? estimate.mean
                                   : nothing));
}

// --- Convergence -----------------------------------------------------------------------------------------------------

struct Level {
  study::MeanEstimate value;
  const char* words;
  std::string_view colour;
};

// Of a verified value, over the whole width: its band, behind all else, and its line.
std::string band_commands(const Level& level) {
  if (!level.value.interval) return {};
  return fmt::format(
      "'convergence.csv' using 1:({:.9g}):({:.9g}) with filledcurves lc rgb '{}' fs transparent solid 0.18 noborder "
      "notitle, \\\n  ",
      level.value.interval->low, level.value.interval->high, level.colour);
}
std::string line_commands(const Level& level) {
  return fmt::format(", \\\n  {:.9g} with lines dt 2 lw 2 lc rgb '{}' title '{}'", level.value.mean, level.colour,
                     level.words);
}

std::vector<Level> verified_levels(const TuningView& view) {
  std::vector<Level> out;
  const std::optional<std::size_t> kept = view.record.tuned();
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (!kept || each.finalist != *kept || !each.value) continue;
    out.push_back({*each.value, "tuned, verified", colours[2]});
    out.push_back({*each.base, "base team, verified", colours[1]});
  }
  return out;
}

std::optional<Figure> convergence(const TuningView& view) {
  const std::vector<study::SearchStep>& trace = view.record.trace;
  if (trace.empty()) return std::nullopt;
  const study::TuningObjective& objective = view.plan.objective;
  const std::vector<Level> levels = verified_levels(view);
  Thinned<const study::SearchStep*> kept(most_points);
  AxisRange range;
  for (const study::SearchStep& each : trace) {
    kept.offer([&] { return &each; });
    if (!each.played.failed) range.take(of_objective(objective, each.played.counted));
  }
  for (const Level& each : levels) range.take(each.value);
  std::vector<const study::SearchStep*> steps = kept.with_last([&] { return &trace.back(); });
  if (steps.front() != &trace.front()) steps.insert(steps.begin(), &trace.front());

  Figure out;
  out.name = "convergence";
  out.title = "The search and its verification";
  out.description = fmt::format(
      "Points: value of each evaluation{}, noisy because it has few matches. Line: the best so far, which is "
      "optimistic because it is the best of many noisy values.{}{}",
      kept.stride() > 1 ? fmt::format(" (every {}th)", kept.stride()) : std::string(),
      std::ranges::any_of(trace, [](const auto& each) { return each.played.failed; })
          ? " Crosses at the bottom: forfeited by the tuned team."
          : "",
      levels.empty()
          ? std::string()
          : fmt::format(
                " Dashed, with bands of {:.4g} %: the tuned team and the base team on the pairs of the verification.",
                100.0 * view.plan.confidence()));
  out.csv = "matches,evaluation,value,best,failed\n";
  for (const study::SearchStep* const each : steps) {
    const double value = of_objective(objective, each->played.counted);
    out.csv +=
        fmt::format("{},{},{},{},{}\n", each->matches, each->evaluation,
                    each->played.failed ? std::string() : field(value), field(of_objective(objective, each->best)),
                    each->played.failed ? fmt::format("{:.9g}", range.bottom()) : std::string());
  }
  out.height = 340;
  const std::uint64_t end = std::max<std::uint64_t>(trace.back().matches, 1);
  out.commands = fmt::format(
      "set xlabel 'matches of the search'\nset xrange [0:{}]\nset xtics {}\nset ylabel {}\nset yrange {}\n"
      "set key outside top center horizontal maxrows 2\n"
      "plot ",
      end, whole_tic_step(static_cast<double>(end), 8), value_label(objective, out.height - 70), range.axis());
  for (const Level& each : levels) out.commands += band_commands(each);
  out.commands += fmt::format(
      "'convergence.csv' using 1:3 with points pt 7 ps {} lc rgb '{}' title 'an evaluation', \\\n"
      "  '' using 1:4 with steps lw 2 lc rgb '{}' title 'best so far'",
      steps.size() > 200 ? 0.25 : 0.45, colours[7], colours[0]);
  if (std::ranges::any_of(steps, [](const auto* each) { return each->played.failed; })) {
    out.commands +=
        fmt::format(", \\\n  '' using 1:5 with points pt 2 ps 0.6 lc rgb '{}' title 'forfeited'", colours[6]);
  }
  for (const Level& each : levels) out.commands += line_commands(each);
  out.commands += '\n';
  return out;
}

// --- Importance and slices -------------------------------------------------------------------------------------------

std::optional<Figure> importance(const TuningView& view) {
  std::vector<const study::Slice*> slices;
  for (const study::Slice& each : view.record.slices) {
    if (slices.size() < most_slices) slices.push_back(&each);
  }
  if (slices.empty()) return std::nullopt;
  Figure out;
  out.name = "importance";
  out.title = "Importance of the parameters";
  out.description =
      "Standard deviation of the objective over the range of each parameter, around the point that was found, less the "
      "part that chance explains. Grey: no more than chance.";
  out.csv = "parameter,importance,p,more_than_chance\n";
  double most = 0.0;
  std::size_t widest = 0;
  std::string tics;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const std::string& path = view.plan.parameters[slices[i]->parameter].path;
    out.csv += fmt::format("{},{},{},{}\n", figure_field(path), slices[i]->importance,
                           slices[i]->p ? field(*slices[i]->p) : std::string(), more_than_chance(*slices[i]) ? 1 : 0);
    most = std::max(most, slices[i]->importance);
    const std::string mark = gnuplot_mark(short_path(path));
    widest = std::max(widest, mark.size() - 2);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", mark, -static_cast<int>(i));
  }
  out.height = 80 + 26 * static_cast<int>(slices.size());
  out.commands = fmt::format(
      "set ytics scale 0 ({0})\nset grid noytics\nset grid xtics lt 1 lc rgb '{1}' lw 0.7\nset yrange [{2}:0.6]\n"
      "set xrange [0:{3:.6g}]\nset xtics {4:.6g}\nset xlabel {5}\nset lmargin at screen {6:.4f}\nunset key\n"
      "set style fill solid noborder\n"
      "plot 'importance.csv' using ($4>0?$2:1/0):(-$0):(0):2:(-$0-0.32):(-$0+0.32) with boxxyerror lc rgb '{7}', \\\n"
      "  '' using ($4>0?1/0:$2):(-$0):(0):2:(-$0-0.32):(-$0+0.32) with boxxyerror lc rgb '{8}'\n",
      tics, grid_colour, -static_cast<double>(slices.size()) + 0.4, most > 0.0 ? 1.05 * most : 1.0, tic_step(most, 6),
      value_label(view.plan.objective, out.width / 2),
      std::min(0.5, (8.2 * static_cast<double>(widest) + 16.0) / out.width), colours[0], colours[7]);
  return out;
}

std::string slice_axis(const study::Parameter& parameter) {
  const bool logarithmic = parameter.log_scale && parameter.least > 0.0;
  const double room = 0.03 * (parameter.most - parameter.least);
  return fmt::format("{}set xrange [{:.6g}:{:.6g}]\n", logarithmic ? "set logscale x\n" : "",
                     logarithmic ? parameter.least / 1.08 : parameter.least - room,
                     logarithmic ? parameter.most * 1.08 : parameter.most + room);
}

std::optional<Figure> slice(const TuningView& view, const study::Slice& of, std::size_t number) {
  const std::optional<std::size_t> centre = slice_centre(view.record);
  if (of.points.empty() || !centre) return std::nullopt;
  const study::Parameter& parameter = view.plan.parameters[of.parameter];
  const double tuned = view.record.finalists[*centre].values[of.parameter];
  const study::TuningObjective& objective = view.plan.objective;
  Figure out;
  out.name = fmt::format("{}{}", slice_prefix, number);
  out.title = texts::visible(parameter.path);
  out.description = fmt::format(
      "The objective over this parameter alone, all others as in finalist {}. Whiskers: intervals of {:.4g} %. "
      "Triangle: the point that was found. Dashed: the base team's value. {}{}.",
      *centre + 1, 100.0 * view.plan.confidence(),
      more_than_chance(of) ? fmt::format("Importance {:.3g}, ", of.importance) : std::string("Importance: "),
      importance_text(of));
  AxisRange range;
  out.csv = "value,mean,low,high,tuned\n";
  for (const study::SlicePoint& each : of.points) {
    const study::MeanEstimate score = of_objective(objective, each.score);
    range.take(score);
    out.csv += fmt::format("{},{},{}\n", each.value, interval_fields(score), each.value == tuned ? 1 : 0);
  }
  if (range.empty()) return std::nullopt;
  out.commands = fmt::format(
      "{0}set xlabel {1}{2}\nset ylabel {3}\nset yrange {4}\nunset key\n"
      "set arrow 1 from first {5:.9g}, graph 0 to first {5:.9g}, graph 1 nohead dt 2 lw 1.5 lc rgb '{6}'\n"
      "plot '{7}.csv' using 1:2 with lines lw 1.5 lc rgb '{8}', \\\n"
      "  '' using ($5>0?1/0:$1):2:3:4 with yerrorbars pt 7 ps 0.6 lw 1.5 lc rgb '{8}', \\\n"
      "  '' using ($5>0?$1:1/0):2:3:4 with yerrorbars pt 9 ps 1.1 lw 1.5 lc rgb '{9}'\n",
      slice_axis(parameter), gnuplot_text(short_path(parameter.path)),
      has_unit(parameter) ? fmt::format(".', '.{}", gnuplot_text(parameter.unit)) : std::string(),
      value_label(objective, out.height - 60), range.axis(), parameter.start, colours[1], out.name, colours[0],
      colours[2]);
  return out;
}

}  // namespace

std::vector<Figure> tuning_figures(const TuningView& view) {
  std::vector<Figure> out;
  const auto add = [&out](std::optional<Figure> figure) {
    if (figure) out.push_back(std::move(*figure));
  };
  add(convergence(view));
  add(importance(view));
  for (std::size_t i = 0; i < std::min(view.record.slices.size(), most_slices); ++i) {
    add(slice(view, view.record.slices[i], i + 1));
  }
  return out;
}

bool is_tuning_figure(std::string_view name) {
  if (name == "convergence" || name == "importance") return true;
  if (!name.starts_with(slice_prefix)) return false;
  const std::string_view number = name.substr(slice_prefix.size());
  return !number.empty() && number.size() <= 3 && number.find_first_not_of("0123456789") == number.npos;
}

}  // namespace regista::report
