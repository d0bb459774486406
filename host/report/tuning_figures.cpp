// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/figure.hpp"
#include "report/metric_reference.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_drawn_steps = 1000;  // largest number of steps of the search in a figure
constexpr std::size_t most_slices = 40, most_histories = 40;

// Returns a path cut to the room beside an axis. Keeps the end of the path, because the end is the most specific part.
std::string short_path(const std::string& path) {
  constexpr std::size_t most = 31;
  if (path.size() <= most) return path;
  const std::size_t dot = path.find('.', path.size() - most);
  return dot == std::string::npos ? path.substr(path.size() - most) : path.substr(dot + 1);
}

// Returns the title of an axis: "goal difference, per match".
std::string value_title(const study::TuningObjective& objective) {
  if (unit_of(objective).empty()) return "objective";
  return measure_axis(objective.terms.front().measure, longest_name);
}

// The steps of a search that figures draw. The first and the last step are always among these steps.
struct DrawnSteps {
  std::vector<const study::SearchStep*> steps;
  std::string which;  // text about the choice of steps: " (every 2th)"; empty: all steps

  explicit DrawnSteps(const std::vector<study::SearchStep>& trace) {
    Thinned<const study::SearchStep*> kept(most_drawn_steps);
    for (const study::SearchStep& each : trace) kept.offer([&] { return &each; });
    steps = kept.with_last([&] { return &trace.back(); });
    if (steps.front() != &trace.front()) steps.insert(steps.begin(), &trace.front());
    if (kept.stride() > 1) which = fmt::format(" (every {}th)", kept.stride());
  }
};

Axis parameter_axis(const study::Parameter& parameter) {
  const bool logarithmic = parameter.log_scale && parameter.least > 0.0;
  const double room = 0.03 * (parameter.most - parameter.least);
  return {.title = in_title(short_path(parameter.path)) +
                   (has_unit(parameter) ? ", " + in_title(parameter.unit) : std::string()),
          .range = logarithmic ? Range{parameter.least / 1.08, parameter.most * 1.08}
                               : Range{parameter.least - room, parameter.most + room},
          .logarithmic = logarithmic};
}

struct Level {
  study::MeanEstimate value;
  const char* words;
  std::size_t colour;
};

std::vector<Level> verified_levels(const TuningView& view) {
  std::vector<Level> out;
  const std::optional<std::size_t> kept = view.record.tuned();
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (!kept || each.finalist != *kept || !each.value) continue;
    out.push_back({*each.value, "tuned, verified", 2});
    out.push_back({*each.base, "base team, verified", 1});
  }
  return out;
}

std::optional<Figure> convergence(const TuningView& view) {
  const std::vector<study::SearchStep>& trace = view.record.trace;
  if (trace.empty()) return std::nullopt;
  const study::TuningObjective& objective = view.plan.objective;
  const std::vector<Level> levels = verified_levels(view);
  const auto [steps, which] = DrawnSteps(trace);
  Range range;
  for (const study::SearchStep& each : trace) {
    if (!each.played.failed) range.take(of_objective(objective, each.played.counted));
  }
  for (const Level& each : levels) take(range, each.value);
  range = range.with_room();

  Figure out{.name = "convergence", .title = levels.empty() ? "The search" : "The search and its verification"};
  out.description = fmt::format(
      "Points: value of each evaluation{}, noisy because it has few matches. Line: the best so far, which is "
      "optimistic because it is the best of many noisy values.{}{}",
      which,
      std::ranges::any_of(trace, [](const auto& each) { return each.played.failed; })
          ? " Crosses at the bottom: forfeited by the tuned team."
          : "",
      levels.empty()
          ? std::string()
          : fmt::format(
                " Dashed, with bands of {:.4g} %: the tuned team and the base team on the pairs of the verification.",
                100.0 * view.plan.confidence()));
  out.csv = "matches,evaluation,value,best,failed\n";
  Series evaluations{
      .name = "an evaluation", .colour = grey, .shape = Shape::circle, .size = steps.size() > 200 ? 1.5 : 2.5};
  Series best{.name = "best so far", .join = Join::steps};
  Series failed{.name = "forfeited", .colour = black, .shape = Shape::cross};
  for (const study::SearchStep* const each : steps) {
    const double value = of_objective(objective, each->played.counted), so_far = of_objective(objective, each->best);
    const auto matches = static_cast<double>(each->matches);
    out.csv += fmt::format("{},{},{},{},{}\n", each->matches, each->evaluation,
                           each->played.failed ? std::string() : figure_field(value), figure_field(so_far),
                           each->played.failed ? fmt::format("{:.9g}", range.low) : std::string());
    best.points.push_back({matches, so_far});
    (each->played.failed ? failed : evaluations).points.push_back({matches, each->played.failed ? range.low : value});
  }
  const auto end = static_cast<double>(std::max<std::uint64_t>(trace.back().matches, 1));
  std::vector<Series> series{evaluations, best};
  if (!failed.points.empty()) series.push_back(failed);
  for (const Level& each : levels) {
    series.push_back({.name = each.words,
                      .colour = each.colour,
                      .points = {mean_over(0.0, each.value), mean_over(end, each.value)},
                      .join = Join::dashes,
                      .interval = Interval::band});
  }
  out.chart = {.y = {.title = value_title(objective), .range = range},
               .panels = {{{.title = "matches of the search", .range = Range{0.0, end}, .whole = true}, series}},
               .height = 250.0};
  return out;
}

// Returns a figure with the values of one parameter in the search, and its value in the best evaluation so far.
Figure history(const TuningView& view, std::size_t index) {
  const study::Parameter& parameter = view.plan.parameters[index];
  const std::vector<study::SearchStep>& trace = view.record.trace;
  const auto [steps, which] = DrawnSteps(trace);
  Series tried{.name = "tried", .colour = grey, .shape = Shape::circle, .size = steps.size() > 200 ? 1.5 : 2.5},
      best{.name = "best so far", .join = Join::steps}, marks{.shape = Shape::diamond, .size = 4.0},
      base{.name = "base team",
           .colour = 1,
           .points = {{0.0, parameter.start}, {static_cast<double>(trace.back().evaluation), parameter.start}},
           .join = Join::dashes};
  Figure out{.name = fmt::format("history_{}", index + 1), .title = texts::visible(parameter.path)};
  out.description = fmt::format(
      "Values that the search tried, by evaluation{}. Line: that of the best evaluation so far; diamonds: where it "
      "changed. Dashed: the base team's value.",
      which);
  out.csv = "evaluation,value,best\n";
  for (const study::SearchStep* const each : steps)
    tried.points.push_back({static_cast<double>(each->evaluation), each->values[index]});
  std::vector<double> best_values;  // for each evaluation, the parameter's value in the best evaluation so far
  const study::SearchStep* leader = nullptr;
  for (const study::SearchStep& each : trace) {
    if (leader == nullptr || each.played.counted > leader->played.counted) {
      leader = &each;
      marks.points.push_back({static_cast<double>(each.evaluation), each.values[index]});
      best.points.push_back(marks.points.back());
    }
    best_values.push_back(leader->values[index]);
  }
  best.points.push_back({static_cast<double>(trace.back().evaluation), best_values.back()});
  for (const study::SearchStep* const each : steps) {
    const auto at = static_cast<std::size_t>(each - trace.data());
    out.csv += fmt::format("{},{},{}\n", each->evaluation, each->values[index], best_values[at]);
  }
  const double end = std::max(2.0, static_cast<double>(trace.back().evaluation));
  out.chart = {
      .y = parameter_axis(parameter),
      .panels = {{{.title = "evaluation", .range = Range{0.0, end}, .whole = true}, {base, tried, best, marks}}},
      .height = 150.0};
  return out;
}

std::optional<Figure> verified_differences(const TuningView& view) {
  Figure out{.name = "verification", .title = "The verification"};
  Series better{.colour = 2, .shape = Shape::triangle, .interval = Interval::whiskers},
      others{.shape = Shape::circle, .interval = Interval::whiskers};
  Range range{0.0, 0.0};
  out.csv = "finalist,difference,low,high,pairs,better\n";
  bool any_better = false;
  for (const CandidateVerdict& each : candidate_verdicts(view)) {
    if (each.pairs == 0) continue;
    const auto& [low, high] = each.difference.interval;
    const bool is_better = each.finding == study::VerifiedAs::better;
    any_better = any_better || is_better;
    out.csv += fmt::format("{},{},{},{},{},{}\n", each.finalist + 1, figure_field(each.difference.value),
                           figure_field(low), figure_field(high), each.pairs, is_better ? 1 : 0);
    (is_better ? better : others)
        .points.push_back({each.difference.value, static_cast<double>(out.chart.rows.size()), low, high});
    out.chart.rows.push_back(fmt::format("finalist {}", each.finalist + 1));
    for (const double value : {each.difference.value, low, high}) range.take(value);
  }
  if (out.chart.rows.empty()) return std::nullopt;
  out.description = fmt::format(
      "Each candidate less the base team on {} that neither search nor selection played, with intervals of {:.4g} % "
      "that hold at any time. {} of 0 is better than the base team.{}",
      pairs_in_words(view.record.verification.pairs()), 100.0 * view.plan.confidence(),
      view.plan.objective.minimise ? "Left" : "Right", any_better ? " Triangle: found better." : "");
  out.chart.height = 34.0 * static_cast<double>(std::max<std::size_t>(out.chart.rows.size(), 2));
  out.chart.panels = {
      {{.title = "difference to the base team: " + value_title(view.plan.objective), .range = range.with_room()},
       {others, better}}};
  return out;
}

std::optional<Figure> importance(const TuningView& view) {
  std::vector<const study::Slice*> slices;
  for (const study::Slice& each : view.record.slices) {
    if (slices.size() < most_slices) slices.push_back(&each);
  }
  if (slices.empty()) return std::nullopt;
  Figure out{.name = "importance",
             .title = "Importance of the parameters",
             .description =
                 "Standard deviation of the objective over the range of each parameter, around the point that was "
                 "found, less the part that chance explains."};
  out.csv = "parameter,importance,p,more_than_chance\n";
  Series more{.bar = 0.64}, chance{.colour = grey, .bar = 0.64};
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const std::string& path = view.plan.parameters[slices[i]->parameter].path;
    const bool is_more = more_than_chance(*slices[i]);
    out.csv += fmt::format("{},{},{},{}\n", figure_field(path), slices[i]->importance,
                           slices[i]->p ? figure_field(*slices[i]->p) : std::string(), is_more ? 1 : 0);
    (is_more ? more : chance).points.push_back({slices[i]->importance, static_cast<double>(i)});
    out.chart.rows.push_back(short_path(path));
  }
  if (std::ranges::all_of(slices, [](const study::Slice* each) { return each->importance == 0.0; }))
    return std::nullopt;  // all bars would have length 0
  if (!chance.points.empty()) out.description += " Grey: no more than chance.";
  out.chart.height = 26.0 * static_cast<double>(slices.size());
  out.chart.panels = {{{.title = value_title(view.plan.objective)}, {more, chance}}};
  return out;
}

std::optional<Figure> slice(const TuningView& view, const study::Slice& of, std::size_t number) {
  const std::optional<std::size_t> centre = slice_centre(view.record);
  if (of.points.empty() || !centre) return std::nullopt;
  const study::Parameter& parameter = view.plan.parameters[of.parameter];
  const double tuned = view.record.finalists[*centre].values[of.parameter];
  const study::TuningObjective& objective = view.plan.objective;
  Figure out{
      .name = fmt::format("slice_{}", number),
      .title = texts::visible(parameter.path),
      .description = fmt::format(
          "The objective over this parameter alone, all others as in finalist {}. Whiskers: intervals of {:.4g} %. "
          "Triangle: the point that was found. Dashed: the base team's value. {}{}.",
          *centre + 1, 100.0 * view.plan.confidence(),
          more_than_chance(of) ? fmt::format("Importance {:.3g}, ", of.importance) : std::string("Importance: "),
          importance_text(of))};
  Range range;
  out.csv = "value,mean,low,high,tuned\n";
  Series curve{.join = Join::line}, others{.shape = Shape::circle, .size = 3.0, .interval = Interval::whiskers},
      found{.colour = 2, .shape = Shape::triangle, .size = 5.0, .interval = Interval::whiskers};
  for (const study::SlicePoint& each : of.points) {
    const study::MeanEstimate score = of_objective(objective, each.score);
    take(range, score);
    out.csv += fmt::format("{},{},{}\n", each.value, mean_fields(score), each.value == tuned ? 1 : 0);
    curve.points.push_back(mean_over(each.value, score));
    (each.value == tuned ? found : others).points.push_back(curve.points.back());
  }
  if (range.empty()) return std::nullopt;
  range = range.with_room();
  const Series base{
      .colour = 1, .points = {{parameter.start, range.low}, {parameter.start, range.high}}, .join = Join::dashes};
  out.chart = {.y = {.title = value_title(objective), .range = range},
               .panels = {{parameter_axis(parameter), {base, curve, others, found}}}};
  return out;
}

}  // namespace

std::vector<Figure> tuning_figures(const TuningView& view) {
  std::vector<Figure> out;
  const auto add = [&out](std::optional<Figure> figure) {
    if (figure) out.push_back(std::move(*figure));
  };
  add(verified_differences(view));
  add(convergence(view));
  for (std::size_t i = 0; i < view.plan.parameters.size() && out.size() < most_histories; ++i) {
    if (!view.plan.parameters[i].fixed() && !view.record.trace.empty()) out.push_back(history(view, i));
  }
  add(importance(view));
  for (std::size_t i = 0; i < std::min(view.record.slices.size(), most_slices); ++i) {
    add(slice(view, view.record.slices[i], i + 1));
  }
  return out;
}

bool is_tuning_figure(std::string_view name) {
  return name == "convergence" || name == "importance" || name == "verification" || is_numbered(name, "history_") ||
         is_numbered(name, "slice_");
}

}  // namespace regista::report
