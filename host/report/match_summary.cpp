// SPDX-License-Identifier: MIT
#include "report/match_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "match/game_state.hpp"
#include "report/metric_reference.hpp"
#include "report/number.hpp"
#include "report/outline.hpp"
#include "study/measure.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

const char* in_words(match::Ended ended) {
  return ended == match::Ended::mercy   ? "by the mercy rule"
         : ended == match::Ended::limit ? "at the time limit"
                                        : "at full time";
}

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

std::string packets(const match::TeamMetrics& team, int charged, int budget, const std::optional<double>& of_time) {
  std::string out = fmt::format("  packets {} of {}", charged, budget);
  if (of_time) {
    out += fmt::format(" ({} of this length: {:.4g})",
                       study::is_above_share(charged - *of_time, *of_time) ? "more than the share" : "share", *of_time);
  }
  std::vector<std::size_t> order;
  for (std::size_t reason = 0; reason < team.packets_by_reason.size(); ++reason) {
    if (team.packets_by_reason[reason] > 0) order.push_back(reason);
  }
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t r) { return team.packets_by_reason[r]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    out +=
        fmt::format("{} {} {}", i == 0 ? ":" : ",", team.packets_by_reason[order[i]], spaced(team.reasons[order[i]]));
  }
  return out + '\n';
}

// Returns a line about segments of plugins' messages; empty for a team whose plugins exchange no messages.
std::string segments(const mind::SegmentCounts& counts) {
  if (counts.offered + counts.refused == 0) return "";
  return fmt::format("  segments offered {}, {} of them sent, {} dropped; heard {}; refused {}\n", counts.offered,
                     counts.sent, counts.dropped, counts.heard, counts.refused);
}

// Returns a line for each plugin that has numbers: "  count_crossings: decisions 2100, crossings 0.398".
std::string plugins(const match::PluginMetrics& metrics) {
  std::vector<std::pair<std::string, std::string>> lines;  // by plugin
  const auto add = [&lines](const std::string& name, const std::string& value) {
    const std::size_t point = name.find('.');
    const std::string plugin = name.substr(0, point), number = name.substr(point + 1) + ' ' + value;
    const auto known = std::ranges::find(lines, plugin, [](const auto& each) { return each.first; });
    if (known == lines.end())
      lines.emplace_back(plugin, number);
    else
      known->second += ", " + number;
  };
  for (std::size_t i = 0; i < metrics.totals.size(); ++i) {
    add(metrics.total_names[i], fmt::format("{:.6g}", metrics.totals[i]));
  }
  for (std::size_t i = 0; i < metrics.values.size(); ++i) {
    add(metrics.value_names[i], metrics.values[i] ? fmt::format("{:.4g}", *metrics.values[i]) : "-");
  }
  std::string out;
  for (const auto& [plugin, numbers] : lines) out += fmt::format("  {}: {}\n", plugin, numbers);
  return out;
}

std::string table(const match::TeamMetrics& team, const std::vector<std::string>& names) {
  std::size_t width = 4;
  for (const std::string& role : names) width = std::max(width, role.size());
  std::string out =
      fmt::format("  {:<{}}  {:>9}  {:>11}  {:>8}\n", "role", width, "overlap s", "uncovered s", "switches");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const match::RoleMetrics::Counts& role = team.coordination.roles[i].all;
    out += fmt::format("  {:<{}}  {:>9.1f}  {:>11.1f}  {:>8}\n", names[i], width, role.overlap_seconds,
                       role.uncovered_seconds, role.switches);
  }
  return out;
}

// Returns the errors of the robots' world models; empty for robots without a world model.
std::string world_model(const match::WorldModelMetrics& model) {
  if (!model.self.rmse_metres) return "";
  const auto metres = [](const std::optional<double>& error) { return error ? fmt::format("{:.2f} m", *error) : "–"; };
  return fmt::format("  errors: ball {}, teammates {}, self {}, opponents {} (OSPA); ball seen {:.0f} % of the time\n",
                     metres(model.ball.rmse_metres), metres(model.teammates.rmse_metres),
                     metres(model.self.rmse_metres), metres(model.ospa_metres),
                     100.0 * model.ball_seen_share.value_or(0.0));
}

}  // namespace

std::string summary_text(const campaign::PlayedMatch& match, const WhatWasPlayed& played) {
  const match::Result& result = match.result;
  const Section before = played_section(played);
  std::string out = before.title + '\n' + section_text(before) + '\n';
  out += fmt::format("{} {} : {} {}\n\n", match.titles[0], result.score[0], result.score[1], match.titles[1]);
  out += fmt::format("ended       {}, after {:.1f} s{}\n", in_words(result.ended), result.simulated_seconds,
                     result.metrics.playing_seconds > 0.0 ? "" : ", before the first kick-off");
  out += fmt::format("seed        {}\n", match.seed);
  if (!match.opening.empty()) out += fmt::format("opening     {}\n", match.opening);
  out += fmt::format("state hash  {}\n", match::hash_text(result.hash));
  out += fmt::format("wall time   {:.2f} s, {:.0f} times faster than the game\n", match.wall_seconds,
                     share(result.simulated_seconds, match.wall_seconds));
  for (const match::Side side : match::both_sides) {
    const std::size_t i = match::index(side);
    const match::TeamMetrics& team = result.metrics.teams[i];
    out += fmt::format("\n{} ({})\n", match.titles[i], match::name(side));
    out += table(team, match.role_names[i]);
    out += packets(team, result.packets[i], match.budget, match.packets_share);
    out += segments(team.segments);
    if (const double silent = team.coordination.silent_seconds; silent > 0.0) {
      out += fmt::format("  silent for the last {:.0f} s of play\n", silent);
    }
    const match::PlayMetrics& play = team.play;
    const std::optional<double>& agreement = team.coordination.agreement;
    out += fmt::format("  possession {:.0f} %, agreement {}, falls {}, penalties {}, kicks {}\n",
                       100.0 * play.possession_share.value_or(0.0),
                       agreement ? fmt::format("{:.1f} %", 100.0 * *agreement) : "-", team.falls, team.penalties,
                       team.kicks);
    out += fmt::format("  shots {}, {} of them saved; passes {}, interceptions {}; walked {:.0f} m\n", play.shots,
                       play.shots_saved, play.passes, play.interceptions, play.distance_walked_metres);
    out += world_model(team.world_model);
    out += plugins(team.plugins);
  }
  return out;
}

std::string summary_json(const campaign::PlayedMatch& match, const WhatWasPlayed& played) {
  nlohmann::ordered_json out{{"played", played_json(played)}};
  out.update(campaign::summary_json(match));
  return text_of(out);
}

std::string metrics_csv(const campaign::PlayedMatch& match, std::span<const match::MetricRow> table) {
  std::string out = fmt::format("{},seed,{}\n", metrics_csv_head, match.seed);
  const match::MetricNumbers numbers = campaign::numbers_of(match, table);
  for (std::size_t i = 0; i < numbers.names().size(); ++i) {
    const auto side = numbers.names()[i].side;
    out += fmt::format("{},{},", side ? match::name(*side) : "", csv_field(numbers.names().path(i)));
    if (const auto value = numbers.at(i)) out += fmt::format("{}", *value);
    out += '\n';
  }
  return out;
}

}  // namespace regista::report
