// SPDX-License-Identifier: MIT
#include "report/tournament_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "report/curve_figures.hpp"
#include "report/role_names.hpp"
#include "report/standing.hpp"

namespace regista::report {
namespace {

std::string number_or_nothing(const statistics::Moments* moments) {
  return moments == nullptr || moments->count() == 0 ? std::string() : fmt::format("{}", moments->mean());
}

std::optional<Figure> goal_differences(const TournamentView& view, const CourseRecord& record) {
  if (view.course.matches() == 0) return std::nullopt;
  const GoalDifferences& counts = record.goals_of(0);
  Figure out;
  out.name = "goal_differences";
  out.title = "Goal differences of matches";
  out.description = fmt::format("Matches by goals of {} less goals of {}. Black: forfeits. {} or more count as {}.",
                                view.label(0), view.label(1), GoalDifferences::largest, GoalDifferences::largest);
  out.csv = "goal_difference,played,forfeited\n";
  int widest = 2;
  std::uint64_t highest = 1;
  for (int difference = -GoalDifferences::largest; difference <= GoalDifferences::largest; ++difference) {
    const auto at = static_cast<std::size_t>(difference + GoalDifferences::largest);
    out.csv += fmt::format("{},{},{}\n", difference, counts.played[at], counts.forfeited[at]);
    highest = std::max(highest, counts.played[at] + counts.forfeited[at]);
    if (counts.played[at] + counts.forfeited[at] > 0) widest = std::max(widest, std::abs(difference));
  }
  const bool forfeits = std::ranges::any_of(counts.forfeited, [](std::uint64_t count) { return count > 0; });
  out.commands = fmt::format(
      "set xlabel 'goals of '.{0}.' less goals of '.{1}\n"
      "set ylabel 'matches'\n"
      "set xrange [{2}:{3}]\n"
      "set yrange [0:*]\n"
      "set xtics 1\n"
      "set ytics {9}\n"
      "set boxwidth 0.8\n"
      "set style fill solid noborder\n"
      "set key {8}\n"
      "plot 'goal_differences.csv' using ($1>0?$1:1/0):2 with boxes lc rgb '{4}' title {0}.' wins', \\\n"
      "  '' using ($1==0?$1:1/0):2 with boxes lc rgb '{6}' title 'draws', \\\n"
      "  '' using ($1<0?$1:1/0):2 with boxes lc rgb '{5}' title {1}.' wins'{7}\n",
      gnuplot_text(view.label(0)), gnuplot_text(view.label(1)), -widest - 0.6, widest + 0.6, colours[0], colours[1],
      colours[7],
      forfeits
          ? fmt::format(", \\\n  '' using 1:($2+$3/2.0):(0.4):($3/2.0) with boxxyerror lc rgb '{}' title 'forfeits'",
                        colours[7])
          : std::string(),
      "outside top center horizontal", whole_tic_step(static_cast<double>(highest), 6));
  return out;
}

// Two values per name, for both teams: a point each, joined by a line.
std::string panel(const Figure& figure, const char* title, int column, const std::string& tics, std::size_t rows) {
  return fmt::format(
      "set title '{1}'\n"
      "{5}"
      "plot '{0}.csv' using {2}:(-$0):(${3}-${2}):(0) with vectors nohead lc rgb '{6}' lw 2 notitle, \\\n"
      "  '' using {2}:(-$0) with points pt 7 ps 0.9 lc rgb '{7}' notitle, \\\n"
      "  '' using {3}:(-$0) with points pt 9 ps 1.1 lc rgb '{8}' notitle\n",
      figure.name, title, column, column + 1, rows, tics, grid_colour, colours[0], colours[1]);
}

// The widest of these, in units of the figure.
double width_of(const std::vector<std::string>& names) {
  std::size_t most = 0;
  for (const std::string& each : names) most = std::max(most, gnuplot_text(each).size() - 2);
  return 8.2 * static_cast<double>(most) + 16.0;
}

std::string name_tics(const std::vector<std::string>& names) {
  std::string out = "set ytics scale 0\nset ytics (";
  for (std::size_t i = 0; i < names.size(); ++i) {
    out += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_mark(names[i]), -static_cast<int>(i));
  }
  return out + ")\n";
}

std::optional<Figure> roles(const TournamentView& view, const CourseRecord& record) {
  const std::vector<std::string> names = role_names(record.numbers(), 2);
  if (names.empty()) return std::nullopt;
  Figure out;
  out.name = "roles";
  out.title = "Overlap, uncovered time and switches by role";
  out.description = fmt::format(
      "Means of a match. Circles: {}. Triangles: {}. Less overlap and uncovered time is better coordinated.",
      view.label(0), view.label(1));
  out.csv = "role";
  for (const char* measure : role_measures) {
    for (const std::size_t team : {0u, 1u})
      out.csv += ',' + figure_field(fmt::format("{} {}", view.label(team), measure));
  }
  out.csv += '\n';
  for (const std::string& role : names) {
    out.csv += figure_field(role);
    for (const char* measure : role_measures) {
      for (const std::size_t team : {0u, 1u}) {
        out.csv += ',' + number_or_nothing(record.numbers().find(team, role + '.' + measure));
      }
    }
    out.csv += '\n';
  }
  out.width = 1130;
  out.height = 90 + 22 * static_cast<int>(names.size());
  out.commands = fmt::format(
      "set grid noytics\nset grid xtics ytics lt 1 lc rgb '{}' lw 0.7\n"
      "set yrange [{}:0.7]\nset xrange [0:*]\nset offsets 0, 0, 0, 0\n"
      "set tmargin 2\nset bmargin 2.5\n"
      "set multiplot\n",
      grid_colour, -static_cast<double>(names.size()) + 0.3);
  const std::array<const char*, 3> titles{"overlap, s", "uncovered, s", "switches"};
  const std::vector<std::string> nameless(names.size());
  const double left = width_of(names) / out.width, panel_width = (1.01 - left) / 3.0;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const double begin = left + panel_width * static_cast<double>(i);
    out.commands +=
        fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", begin, begin + panel_width - 0.03);
    double most = 0.0;
    for (const std::string& role : names) {
      for (const std::size_t team : {0u, 1u}) {
        const auto* const found = record.numbers().find(team, role + '.' + role_measures[i]);
        if (found != nullptr) most = std::max(most, found->mean());
      }
    }
    // Where all are nought there is no range to choose.
    out.commands += fmt::format("set xrange [0:{}]\nset xtics {}\n",
                                most > 0.0 ? fmt::format("{:.6g}", 1.06 * most) : "1", tic_step(most, 5));
    out.commands += panel(out, titles[i], static_cast<int>(2 * i + 2), i == 0 ? name_tics(names) : name_tics(nameless),
                          names.size());
  }
  out.commands += "unset multiplot\n";
  return out;
}

std::optional<Figure> packets(const TournamentView& view, const CourseRecord& record) {
  std::vector<std::string> reasons = packet_reasons(record.numbers(), 2);
  std::erase_if(reasons, [&](const std::string& reason) { return sent_none(record.numbers(), 2, reason); });
  if (reasons.empty()) return std::nullopt;
  Figure out;
  out.name = "packets";
  out.title = "Packets by the event that caused them";
  out.description = fmt::format("Means of a match. Upper bars: {}. Lower bars: {}.", view.label(0), view.label(1));
  out.csv = fmt::format("reason,{},{}\n", figure_field(view.label(0)), figure_field(view.label(1)));
  double most = 0.0;
  std::vector<std::string> names;
  for (const std::string& reason : reasons) {
    out.csv += figure_field(reason);
    for (const std::size_t team : {0u, 1u}) {
      const statistics::Moments* const found = record.numbers().find(team, packets_prefix + reason);
      out.csv += ',' + number_or_nothing(found);
      if (found != nullptr) most = std::max(most, found->mean());
    }
    out.csv += '\n';
    names.push_back(reason);
    std::ranges::replace(names.back(), '_', ' ');
  }
  out.height = 90 + 28 * static_cast<int>(reasons.size());
  out.commands = fmt::format(
      "{0}set grid noytics\nset grid xtics lt 1 lc rgb '{1}' lw 0.7\n"
      "set yrange [{2}:0.6]\nset xrange [0:{3}]\n"
      "set xtics {9}\nset xlabel 'packets per match'\nset lmargin at screen {8:.4f}\n"
      "set style fill solid noborder\nset key outside top center horizontal\n"
      "plot 'packets.csv' using 2:(-$0+0.19):(0):2:(-$0+0.02):(-$0+0.36) with boxxyerror lc rgb '{4}' title {6}, \\\n"
      "  '' using 3:(-$0-0.19):(0):3:(-$0-0.36):(-$0-0.02) with boxxyerror lc rgb '{5}' title {7}\n",
      name_tics(names), grid_colour, -static_cast<double>(reasons.size()) + 0.4, most > 0.0 ? 1.05 * most : 1.0,
      colours[0], colours[1], gnuplot_text(view.label(0)), gnuplot_text(view.label(1)), width_of(names) / out.width,
      tic_step(most, 6));
  return out;
}

}  // namespace

std::vector<Figure> tournament_figures(const TournamentView& view, const CourseRecord& record) {
  std::vector<Figure> out;
  const auto add = [&out](std::optional<Figure> figure) {
    if (figure) out.push_back(std::move(*figure));
  };
  if (view.plan.teams.size() == 2) {
    const std::vector<PairPoint> curve = record.pair_curve();
    add(elo_over_pairs(view, curve));
    add(std::holds_alternative<study::ScoreTest>(view.plan.objective()) ? ratio_over_pairs(view, curve)
                                                                        : value_over_pairs(view, curve));
    add(goal_differences(view, record));
    add(roles(view, record));
    add(packets(view, record));
  } else {
    add(ranking_figure(view));
    add(ranking_over_pairs(view, record.ranking_curve()));
  }
  return out;
}

}  // namespace regista::report
