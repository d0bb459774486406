// SPDX-License-Identifier: MIT
#include "report/curve_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "report/elo_interval.hpp"
#include "report/standing.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

// A field without a number says that there is none.
std::string field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : std::string(); }

struct Range {
  double low = 0.0, high = 0.0;
  void take(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Of an axis: a little more on both sides. What rounding leaves of values that are equal is no range.
  double room() const { return high - low > 1e-6 ? 0.06 * (high - low) : 1.0; }
  std::string bottom() const { return fmt::format("{:.6g}", low - room()); }
  std::string top() const { return fmt::format("{:.6g}", high + room()); }
  std::string axis() const { return fmt::format("[{}:{}]", bottom(), top()); }
};

struct Banded {
  std::uint64_t pair;
  statistics::Estimate estimate;
};

std::string banded_csv(std::span<const Banded> points, const char* value) {
  std::string out = fmt::format("pair,{},low,high\n", value);
  for (const auto& [pair, estimate] : points) {
    out += fmt::format("{},{},{},{}\n", pair, field(estimate.value), field(estimate.interval.low),
                       field(estimate.interval.high));
  }
  return out;
}

// The first pairs of many say next to nothing, and would make the rest too small to be seen: the axis is that of the
// others.
Range range_of(std::span<const Banded> points) {
  constexpr std::uint64_t few = 8;
  Range out;
  const std::uint64_t last = points.back().pair, from = last <= few ? 0 : std::max(last / 10, few);
  for (const auto& [pair, estimate] : points) {
    if (pair < from) continue;
    for (const double value : {estimate.value, estimate.interval.low, estimate.interval.high}) out.take(value);
  }
  return out;
}

std::string pairs_axis(std::uint64_t last) {
  const std::uint64_t end = std::max<std::uint64_t>(last, 2);
  return fmt::format("set xlabel 'pairs'\nset xrange [0:{}]\nset xtics {}\n", end,
                     whole_tic_step(static_cast<double>(end), 8));
}

// An interval with one end reaches to the edge of the picture on the other side, one without any is left out.
std::string banded_commands(const std::string& file, std::span<const Banded> points, const char* axis) {
  const Range range = range_of(points);
  return fmt::format(
      "{1}set yrange {2}\nset ylabel '{3}'\nset xzeroaxis lt 1 lc rgb '{4}' lw 1\nunset key\n"
      "end(own, other, edge) = strlen(strcol(own)) ? column(own) : strlen(strcol(other)) ? edge : NaN\n"
      "plot '{0}.csv' using 1:(end(3, 4, {7})):(end(4, 3, {8})) with filledcurves lc rgb '{5}' "
      "fs transparent solid 0.2 noborder, \\\n"
      "  '' using 1:2 with linespoints pt 7 ps {6} lw 2 lc rgb '{5}'\n",
      file, pairs_axis(points.back().pair), range.axis(), axis, colours[7], colours[0], points.size() > 60 ? 0.0 : 0.4,
      range.bottom(), range.top());
}

bool has_points(std::span<const Banded> points) {
  return std::ranges::any_of(points, [](const Banded& each) { return std::isfinite(each.estimate.value); });
}

}  // namespace

std::optional<Figure> elo_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  std::vector<Banded> points;
  for (const PairPoint& each : curve) {
    if (!each.elo) continue;
    points.push_back({each.pair, *each.elo});
    if (!each.enough) points.back().estimate.interval = {-HUGE_VAL, HUGE_VAL};
  }
  if (!has_points(points)) return std::nullopt;
  const bool any = std::ranges::any_of(points, [](const Banded& each) {
    return std::isfinite(each.estimate.interval.low) || std::isfinite(each.estimate.interval.high);
  });
  Figure out;
  out.name = "elo";
  out.title = "Elo over pairs";
  out.description = fmt::format("Strength of {} above {}, as it was after each pair{}", view.label(0), view.label(1),
                                any ? fmt::format(". From the {}th uneven pair on with its 95 % interval, which holds "
                                                  "for a number of pairs fixed beforehand.",
                                                  fewest_uneven_pairs)
                                    : std::string(". Too few pairs for an interval."));
  out.csv = banded_csv(points, "elo");
  out.commands = banded_commands(out.name, points, "Elo");
  return out;
}

std::optional<Figure> value_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  std::vector<Banded> points;
  for (const PairPoint& each : curve) {
    if (each.pair > 0) points.push_back({each.pair, each.value});
  }
  if (!has_points(points)) return std::nullopt;
  const study::Objective objective = view.plan.objective();
  const auto* const test = std::get_if<study::ValueTest>(&objective);
  const bool goals = test == nullptr || test->value == study::goals_value;
  Figure out;
  out.name = "value";
  out.title =
      goals ? "Goal difference over pairs" : fmt::format("Difference of {} over pairs", texts::visible(test->value));
  out.description =
      fmt::format("{} less {}, mean of a match, with the anytime-valid interval{}.", view.label(0), view.label(1),
                  test == nullptr ? std::string(" (95 %)") : fmt::format(" ({:.4g} %)", 100.0 * (1.0 - test->alpha)));
  out.csv = banded_csv(points, "difference");
  out.commands = banded_commands(out.name, points, goals ? "goals per match" : "difference per match");
  return out;
}

std::optional<Figure> ratio_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  Figure out;
  out.name = "llr";
  out.title = "Log-likelihood ratio over pairs";
  Range range;
  out.csv = "pair,llr,lower,upper\n";
  std::uint64_t last = 0;
  for (const PairPoint& each : curve) {
    if (!each.ratio) continue;
    out.csv += fmt::format("{},{},{},{}\n", each.pair, field(*each.ratio), field(each.lower), field(each.upper));
    for (const double value : {*each.ratio, each.lower, each.upper}) range.take(value);
    last = each.pair;
  }
  if (last == 0) return std::nullopt;
  const auto hypotheses = std::get<study::ScoreTest>(view.plan.objective()).design.hypotheses;
  out.description =
      fmt::format("The test stops at the upper line, for H1 ({} is {} stronger), or at the lower one, for H0 ({}).",
                  view.label(0), hypotheses.elo1, hypotheses.elo0);
  out.commands = fmt::format(
      "{0}set yrange {1}\nset ylabel 'LLR'\nset xzeroaxis lt 1 lc rgb '{2}' lw 1\nset key outside top center "
      "horizontal\n"
      "plot 'llr.csv' using 1:4 with lines dt 2 lw 1.5 lc rgb '{3}' title 'H1', \\\n"
      "  '' using 1:2 with linespoints pt 7 ps {6} lw 2 lc rgb '{4}' title 'LLR', \\\n"
      "  '' using 1:3 with lines dt 4 lw 1.5 lc rgb '{5}' title 'H0'\n",
      pairs_axis(last), range.axis(), colours[7], colours[2], colours[0], colours[1], curve.size() > 60 ? 0.0 : 0.4);
  return out;
}

std::optional<Figure> ranking_figure(const TournamentView& view) {
  constexpr std::size_t most = 40;
  std::vector<Ranked> ranks = ranking(view.plan, view.course);
  std::erase_if(ranks, [](const Ranked& each) { return !each.elo || !std::isfinite(each.elo->value); });
  if (ranks.empty()) return std::nullopt;
  if (ranks.size() > most) ranks.resize(most);
  Figure out;
  out.name = "ranking";
  out.title = "Strength of the teams";
  out.description = "Bradley-Terry Elo, sum 0, with 95 % intervals by the spread of pairs.";
  out.csv = "team,elo,low,high\n";
  std::string tics;
  Range range;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const statistics::Estimate& elo = *ranks[i].elo;
    // An interval without an end has none to be drawn.
    const bool bounded = elo.interval.bounded();
    const double low = bounded ? elo.interval.low : elo.value, high = bounded ? elo.interval.high : elo.value;
    out.csv += fmt::format("{},{},{},{}\n", figure_field(view.label(ranks[i].team)), elo.value, low, high);
    range.take(low);
    range.take(high);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_mark(view.label(ranks[i].team)), -static_cast<int>(i));
  }
  out.height = 80 + 24 * static_cast<int>(ranks.size());
  out.commands = fmt::format(
      "set ytics ({0})\nset grid noytics\nset grid xtics lt 1 lc rgb '{1}' lw 0.7\nset yrange [{2}:0.6]\n"
      "set xrange {3}\nset xlabel 'Elo'\nset yzeroaxis lt 1 lc rgb '{4}' lw 1\nunset key\n"
      "plot 'ranking.csv' using 2:(-$0):3:4 with xerrorbars pt 7 ps 0.9 lw 2 lc rgb '{5}'\n",
      tics, grid_colour, -static_cast<double>(ranks.size()) + 0.4, range.axis(), colours[7], colours[0]);
  return out;
}

std::optional<Figure> ranking_over_pairs(const TournamentView& view, std::span<const RankingPoint> curve) {
  std::vector<std::size_t> teams;
  for (const Ranked& each : ranking(view.plan, view.course)) teams.push_back(each.team);
  if (teams.size() > colours.size()) teams.resize(colours.size());
  Figure out;
  out.name = "elo";
  out.title = "Elo over pairs";
  out.description = fmt::format("Bradley-Terry Elo of {} after each number of pairs.",
                                teams.size() == view.plan.teams.size()
                                    ? std::string("all teams")
                                    : fmt::format("the first {} teams of the ranking", teams.size()));
  out.csv = "pair";
  for (const std::size_t team : teams) out.csv += ',' + figure_field(view.label(team));
  out.csv += '\n';
  Range range;
  std::uint64_t last = 0;
  for (const RankingPoint& each : curve) {
    if (each.elo.empty()) continue;
    out.csv += fmt::format("{}", each.pair);
    for (const std::size_t team : teams) {
      out.csv += ',' + field(each.elo[team]);
      if (each.pair >= curve.back().pair / 10) range.take(each.elo[team]);
    }
    out.csv += '\n';
    last = each.pair;
  }
  if (last == 0) return std::nullopt;
  out.height = 340;
  out.commands = fmt::format(
      "{}set yrange {}\nset ylabel 'Elo'\nset xzeroaxis lt 1 lc rgb '{}' lw 1\n"
      "set key outside right top vertical Left reverse\nplot",
      pairs_axis(last), range.axis(), colours[7]);
  for (std::size_t i = 0; i < teams.size(); ++i) {
    out.commands +=
        fmt::format("{} '{}' using 1:{} with linespoints pt {} ps 0.7 pointinterval {} lw 2 lc rgb '{}' title {}",
                    i == 0 ? "" : ", \\\n ", i == 0 ? "elo.csv" : "", i + 2, 4 + i,
                    std::max<std::size_t>(1, curve.size() / 8), colours[i], gnuplot_text(view.label(teams[i])));
  }
  out.commands += '\n';
  return out;
}

}  // namespace regista::report
