// SPDX-License-Identifier: MIT
#include "report/tournament_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "report/metric_reference.hpp"
#include "report/standing.hpp"
#include "statistics/rating.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr std::size_t many_points = 60;  // a curve with more points is drawn without circles

constexpr Range with_zero{0.0, 0.0};  // range that contains zero, for axes of strength and of differences

struct Banded {
  std::uint64_t pair;
  statistics::Estimate estimate;
};

// Returns the first pair that a curve shows. A long curve leaves out its first values, because they vary much.
std::uint64_t first_drawn(std::uint64_t last) {
  constexpr std::uint64_t few = 8;
  return last <= few ? 0 : std::max(last / 10, few);
}

// Returns " Drawn from pair 8 on."; empty if the curve shows all pairs.
std::string drawn_from(std::uint64_t last) {
  const std::uint64_t first = first_drawn(last);
  return first > 1 ? fmt::format(" Drawn from pair {} on.", first) : std::string();
}

Axis pairs_axis(std::uint64_t last) {
  return {.title = "pairs", .range = Range{0.0, static_cast<double>(std::max<std::uint64_t>(last, 2))}, .whole = true};
}

// Adds the table and the chart of a curve with its interval to the figure. value: name of the column in the table.
void draw_banded(Figure& figure, std::span<const Banded> points, const char* value, const char* axis) {
  Series curve{.join = Join::line,
               .shape = points.size() > many_points ? Shape::nothing : Shape::circle,
               .size = 2.5,
               .interval = Interval::band};
  figure.csv = fmt::format("pair,{},low,high\n", value);
  const std::uint64_t last = points.back().pair;
  Range range = with_zero;
  for (const auto& [pair, estimate] : points) {
    const auto& [low, high] = estimate.interval;
    figure.csv +=
        fmt::format("{},{},{},{}\n", pair, figure_field(estimate.value), figure_field(low), figure_field(high));
    if (pair < first_drawn(last)) continue;
    curve.points.push_back({static_cast<double>(pair), estimate.value, low, high});
    for (const double each : {estimate.value, low, high}) range.take(each);
  }
  figure.description += drawn_from(last);
  figure.chart = {.y = {.title = axis, .range = range.with_room()}, .panels = {{pairs_axis(last), {std::move(curve)}}}};
}

bool has_points(std::span<const Banded> points) {
  return std::ranges::any_of(points, [](const Banded& each) { return std::isfinite(each.estimate.value); });
}

bool any_interval(std::span<const Banded> points) {
  return std::ranges::any_of(points, [](const Banded& each) {
    return std::isfinite(each.estimate.interval.low) || std::isfinite(each.estimate.interval.high);
  });
}

std::optional<Figure> elo_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  std::vector<Banded> points;
  for (const PairPoint& each : curve) {
    if (each.elo) points.push_back({each.pair, *each.elo});
  }
  if (!has_points(points)) return std::nullopt;
  const bool any = any_interval(points);
  Figure out{
      .name = "elo",
      .title = "Elo over pairs",
      .description = fmt::format("Strength of {} above {}, as it was after each pair{}", view.shown(0), view.shown(1),
                                 any ? fmt::format(". From the {}th uneven pair on with its 95 % interval, which holds "
                                                   "for a number of pairs fixed beforehand.",
                                                   statistics::fewest_uneven)
                                     : std::string(". Too few pairs for an interval."))};
  draw_banded(out, points, "elo", "Elo");
  return out;
}

std::optional<Figure> value_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  std::vector<Banded> points;
  for (const PairPoint& each : curve) {
    if (each.pair > 0) points.push_back({each.pair, each.value});
  }
  if (!has_points(points)) return std::nullopt;
  const bool any = any_interval(points);
  const study::Objective objective = view.plan.objective();
  const auto* const test = std::get_if<study::ValueTest>(&objective);
  const bool goals = test == nullptr || test->value == study::goals_value;
  Figure out{.name = "value",
             .title = goals ? "Goal difference over pairs"
                            : fmt::format("Difference of {} over pairs", texts::visible(test->value)),
             .description = fmt::format("{} less {}, mean of a match{}.", view.shown(0), view.shown(1),
                                        any ? fmt::format(", with the anytime-valid interval ({:.4g} %)",
                                                          test == nullptr ? 95.0 : 100.0 * (1.0 - test->alpha))
                                            : std::string())};
  draw_banded(out, points, "difference", goals ? "goals per match" : "difference per match");
  return out;
}

std::optional<Figure> ratio_over_pairs(const TournamentView& view, std::span<const PairPoint> curve) {
  Figure out{.name = "llr", .title = "Log-likelihood ratio over pairs"};
  std::vector<Series> series{{.name = "H1", .colour = 2, .join = Join::dashes},
                             {.name = "LLR",
                              .join = Join::line,
                              .shape = curve.size() > many_points ? Shape::nothing : Shape::circle,
                              .size = 2.5},
                             {.name = "H0", .colour = 1, .join = Join::dashes}};
  Range range = with_zero;
  out.csv = "pair,llr,lower,upper\n";
  std::uint64_t last = 0;
  for (const PairPoint& each : curve) {
    if (!each.ratio) continue;
    out.csv += fmt::format("{},{},{},{}\n", each.pair, figure_field(*each.ratio), figure_field(each.lower),
                           figure_field(each.upper));
    const std::array<double, 3> values{each.upper, *each.ratio, each.lower};
    for (std::size_t i = 0; i < values.size(); ++i) {
      series[i].points.push_back({static_cast<double>(each.pair), values[i]});
      range.take(values[i]);
    }
    last = each.pair;
  }
  if (last == 0) return std::nullopt;
  const auto hypotheses = std::get<study::ScoreTest>(view.plan.objective()).design.hypotheses;
  out.description =
      fmt::format("The test stops at the upper line, for H1 ({} is {} stronger), or at the lower one, for H0 ({}).",
                  view.shown(0), hypotheses.elo1, hypotheses.elo0);
  out.chart = {.y = {.title = "LLR", .range = range.with_room()}, .panels = {{pairs_axis(last), series}}};
  return out;
}

std::optional<Figure> ranking_figure(const TournamentView& view) {
  constexpr std::size_t most = 40;
  std::vector<Ranked> ranks = ranking(view.plan, view.course);
  std::erase_if(ranks, [](const Ranked& each) { return !each.elo || !std::isfinite(each.elo->value); });
  if (ranks.empty()) return std::nullopt;
  if (ranks.size() > most) ranks.resize(most);
  Figure out{.name = "ranking", .title = "Strength of the teams", .description = "Bradley-Terry Elo, sum 0."};
  if (std::ranges::any_of(ranks, [](const Ranked& each) { return each.elo->interval.bounded(); }))
    out.description = "Bradley-Terry Elo, sum 0, with 95 % intervals by the spread of pairs.";
  out.csv = "team,elo,low,high\n";
  Series teams{.shape = Shape::circle, .interval = Interval::whiskers};
  Range range = with_zero;
  for (const Ranked& each : ranks) {
    const statistics::Estimate& elo = *each.elo;
    const bool bounded = elo.interval.bounded();
    const double low = bounded ? elo.interval.low : elo.value, high = bounded ? elo.interval.high : elo.value;
    out.csv += fmt::format("{},{},{},{}\n", figure_field(view.label(each.team)), elo.value, low, high);
    range.take(low);
    range.take(high);
    teams.points.push_back({elo.value, static_cast<double>(out.chart.rows.size()), low, high});
    out.chart.rows.push_back(view.shown(each.team));
  }
  out.chart.height = 24.0 * static_cast<double>(ranks.size());
  out.chart.panels = {{{.title = "Elo", .range = range.with_room()}, {teams}}};
  return out;
}

std::optional<Figure> ranking_over_pairs(const TournamentView& view, std::span<const RankingPoint> curve) {
  std::vector<std::size_t> teams;
  for (const Ranked& each : ranking(view.plan, view.course)) teams.push_back(each.team);
  if (teams.size() > colours.size()) teams.resize(colours.size());
  Figure out{.name = "elo",
             .title = "Elo over pairs",
             .description = fmt::format("Bradley-Terry Elo of {} after each number of pairs.",
                                        teams.size() == view.plan.teams.size()
                                            ? std::string("all teams")
                                            : fmt::format("the first {} teams of the ranking", teams.size()))};
  out.csv = "pair";
  std::vector<Series> series;
  for (const std::size_t team : teams) {
    out.csv += ',' + figure_field(view.label(team));
    series.push_back({.name = view.shown(team),
                      .colour = series.size(),
                      .join = Join::line,
                      .shape = shape_of(series.size()),
                      .every = std::max<std::size_t>(1, curve.size() / 8)});
  }
  out.csv += '\n';
  Range range = with_zero;
  std::uint64_t last = 0;
  for (const RankingPoint& each : curve) {
    if (each.elo.empty()) continue;
    out.csv += fmt::format("{}", each.pair);
    for (std::size_t i = 0; i < teams.size(); ++i) {
      const double elo = each.elo[teams[i]];
      out.csv += ',' + figure_field(elo);
      if (each.pair < first_drawn(curve.back().pair)) continue;
      series[i].points.push_back({static_cast<double>(each.pair), elo});
      range.take(elo);
    }
    out.csv += '\n';
    last = each.pair;
  }
  if (last == 0) return std::nullopt;
  out.description += drawn_from(curve.back().pair);
  out.chart = {
      .y = {.title = "Elo", .range = range.with_room()}, .panels = {{pairs_axis(last), series}}, .height = 270.0};
  return out;
}

double mean_of(const statistics::Moments* moments) {
  return moments == nullptr || moments->count() == 0 ? unknown : moments->mean();
}

std::optional<Figure> goal_differences(const TournamentView& view, const TournamentHistory& record) {
  if (view.course.matches() == 0) return std::nullopt;
  const GoalDifferences& counts = record.goals_of(0);
  Figure out{.name = "goal_differences",
             .title = "Goal differences of matches",
             .description = fmt::format("Matches by goals of {} less goals of {}.", view.shown(0), view.shown(1))};
  out.csv = "goal_difference,played,forfeited\n";
  Series won{.name = name_with(view.shown(0), " wins"), .bar = 0.8}, drawn{.name = "draws", .colour = grey, .bar = 0.8},
      lost{.name = name_with(view.shown(1), " wins"), .colour = 1, .bar = 0.8},
      forfeited{.name = "forfeits", .colour = black, .bar = 0.8};
  int widest = 2;
  for (int difference = -GoalDifferences::largest; difference <= GoalDifferences::largest; ++difference) {
    const auto at = static_cast<std::size_t>(difference + GoalDifferences::largest);
    const auto played = static_cast<double>(counts.played[at]), forfeits = static_cast<double>(counts.forfeited[at]);
    out.csv += fmt::format("{},{},{}\n", difference, counts.played[at], counts.forfeited[at]);
    (difference > 0 ? won : difference < 0 ? lost : drawn).points.push_back({1.0 * difference, played});
    if (forfeits > 0.0) forfeited.points.push_back({1.0 * difference, played + forfeits, played});
    if (played + forfeits > 0.0) widest = std::max(widest, std::abs(difference));
  }
  std::vector<Series> series{won, drawn, lost};
  if (!forfeited.points.empty()) {
    out.description += " Black: forfeits.";
    series.push_back(forfeited);
  }
  if (widest == GoalDifferences::largest) out.description += fmt::format(" {} or more count as {}.", widest, widest);
  const Axis goals{
      .title = fmt::format("goals of {} less goals of {}", in_title(view.shown(0)), in_title(view.shown(1))),
      .range = Range{-widest - 0.6, widest + 0.6},
      .whole = true};
  out.chart = {.y = {.title = "matches", .whole = true}, .panels = {{goals, series}}};
  return out;
}

std::optional<Figure> roles(const TournamentView& view, const TournamentHistory& record) {
  const MatchNumbers& numbers = record.numbers();
  std::vector<std::string> names = role_names(numbers, 2);
  std::erase_if(names, [&](const std::string& role) {
    return std::ranges::all_of(role_measures,
                               [&](const char* each) { return all_zero(numbers, 2, role + '.' + each); });
  });
  if (names.empty()) return std::nullopt;
  Figure out{.name = "roles",
             .title = "Overlap, uncovered time and switches by role",
             .description = fmt::format(
                 "Means of a match. Circles: {}. Triangles: {}. Less overlap and uncovered time is better coordinated.",
                 view.shown(0), view.shown(1))};
  out.csv = "role";
  constexpr std::array<const char*, role_measures.size()> titles{"overlap, s", "uncovered, s", "switches"};
  std::vector<Panel>& panels = out.chart.panels;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    for (const std::size_t team : {0u, 1u})
      out.csv += ',' + figure_field(fmt::format("{} {}", view.label(team), role_measures[i]));
    panels.push_back({{.title = titles[i], .from_zero = true},
                      {{.colour = grey, .join = Join::line},
                       {.name = view.shown(0), .shape = Shape::circle},
                       {.name = view.shown(1), .colour = 1, .shape = Shape::triangle}}});
  }
  out.csv += '\n';
  for (const std::string& role : names) {
    const auto row = static_cast<double>(out.chart.rows.size());
    out.chart.rows.push_back(role);
    out.csv += figure_field(role);
    for (std::size_t i = 0; i < titles.size(); ++i) {
      Series& both = panels[i].series[0];
      for (const std::size_t team : {0u, 1u}) {
        const Point mean{mean_of(numbers.find(team, role + '.' + role_measures[i])), row};
        out.csv += ',' + figure_field(mean.x);
        panels[i].series[team + 1].points.push_back(mean);
        both.points.push_back(mean);
      }
      both.points.push_back({unknown, row});  // ends the line that joins the points of both teams in this role
    }
    out.csv += '\n';
  }
  out.chart.width = page_width;
  out.chart.height = 22.0 * static_cast<double>(names.size());
  return out;
}

std::optional<Figure> packets(const TournamentView& view, const TournamentHistory& record) {
  const MatchNumbers& numbers = record.numbers();
  std::vector<std::string> reasons = packet_reasons(numbers, 2);
  std::erase_if(reasons, [&](const std::string& reason) { return all_zero(numbers, 2, packets_prefix + reason); });
  if (reasons.empty()) return std::nullopt;
  Figure out{
      .name = "packets",
      .title = "Packets by the event that caused them",
      .description = fmt::format("Means of a match. Upper bars: {}. Lower bars: {}.", view.shown(0), view.shown(1))};
  out.csv = fmt::format("reason,{},{}\n", figure_field(view.label(0)), figure_field(view.label(1)));
  std::vector<Series> teams{{.name = view.shown(0), .bar = 0.34}, {.name = view.shown(1), .colour = 1, .bar = 0.34}};
  for (const std::string& reason : reasons) {
    const auto row = static_cast<double>(out.chart.rows.size());
    out.csv += figure_field(reason);
    for (const std::size_t team : {0u, 1u}) {
      const double mean = mean_of(numbers.find(team, packets_prefix + reason));
      out.csv += ',' + figure_field(mean);
      teams[team].points.push_back({mean, row + (team == 0 ? -0.19 : 0.19)});
    }
    out.csv += '\n';
    out.chart.rows.push_back(spaced(reason));
  }
  out.chart.height = 28.0 * static_cast<double>(reasons.size());
  out.chart.panels = {{{.title = "packets per match"}, teams}};
  return out;
}

}  // namespace

std::vector<Figure> tournament_figures(const TournamentView& view, const TournamentHistory& record) {
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
