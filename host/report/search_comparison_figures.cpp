// SPDX-License-Identifier: MIT
#include "report/search_comparison_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "report/objective_axis.hpp"
#include "report/objective_numbers.hpp"
#include "report/search_comparison_numbers.hpp"
#include "report/tuning_problem.hpp"

namespace regista::report {
namespace {

constexpr auto figure_name = "algorithms";

std::optional<Figure> algorithms(const SearchComparisonView& view) {
  std::vector<AlgorithmSummary> placed = algorithm_summaries(view);
  std::erase_if(placed, [](const AlgorithmSummary& each) { return !each.difference; });
  if (placed.empty()) return std::nullopt;
  const study::TuningObjective& objective = view.plan.tuning.objective;
  Figure out;
  out.name = figure_name;
  out.title = "Results of the algorithms";
  out.description = fmt::format(
      "Difference in {} from the base team on pairs with held-out seeds; {} is better. Circles: single runs. Box: "
      "lower to upper quartile. Bar: median.",
      objective_text(objective), objective.minimise ? "less" : "more");
  out.csv = "algorithm,row,repeat,difference,lower_quartile,median,upper_quartile\n";
  AxisRange range;
  range.take(0.0);
  std::string tics;
  std::size_t widest = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const std::string mark = gnuplot_mark(name(placed[i].algorithm));
    widest = std::max(widest, mark.size() - 2);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", mark, -static_cast<int>(i));
    bool first = true;
    for (const study::ComparedRun* const run : placed[i].runs) {
      if (run->judged.pairs == 0) continue;
      const double value = of_objective(objective, run->judged.mean);
      range.take(value);
      const statistics::Quartiles& of = *placed[i].difference;
      out.csv += fmt::format("{},{},{},{},{}\n", name(placed[i].algorithm), i, run->repeat + 1, value,
                             first ? fmt::format("{},{},{}", of.lower, of.median, of.upper) : std::string(",,"));
      first = false;
    }
  }
  out.height = 80 + 34 * static_cast<int>(placed.size());
  out.commands = fmt::format(
      "set ytics scale 0 ({0})\nset grid noytics\nset grid xtics lt 1 lc rgb '{1}' lw 0.7\nset yrange [{2}:0.6]\n"
      "set xrange {3}\nset xlabel {4}\nset lmargin at screen {5:.4f}\nset yzeroaxis lt 1 lc rgb '{6}' lw 1\nunset key\n"
      "plot 'algorithms.csv' using 6:(-$2):5:7:(-$2-0.3):(-$2+0.3) with boxxyerror lc rgb '{7}' fs transparent solid "
      "0.25 noborder, \\\n"
      "  '' using 6:(-$2-0.3):(0):(0.6) with vectors nohead lw 2.5 lc rgb '{7}', \\\n"
      "  '' using 4:(-$2) with points pt 6 ps 0.7 lc rgb '{8}'\n",
      tics, grid_colour, -static_cast<double>(placed.size()) + 0.4, range.axis(), value_label(objective, out.width / 2),
      (8.2 * static_cast<double>(widest) + 16.0) / out.width, colours[7], colours[0], colours[1]);
  return out;
}

}  // namespace

std::vector<Figure> search_comparison_figures(const SearchComparisonView& view) {
  std::vector<Figure> out;
  if (auto figure = algorithms(view)) out.push_back(std::move(*figure));
  return out;
}

bool is_search_comparison_figure(std::string_view name) { return name == figure_name; }

}  // namespace regista::report
