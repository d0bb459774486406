// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "cli/match_report.hpp"
#include "match/names.hpp"

namespace regista::cli {
namespace {

std::string in_words(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

const char* in_words(match::Ended ended) {
  switch (ended) {
    case match::Ended::mercy:
      return "by the mercy rule";
    case match::Ended::limit:
      return "at the time limit";
    default:
      return "at full time";
  }
}

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

std::string packets(const match::TeamMetrics& team, int charged, int budget) {
  std::string out = fmt::format("  packets {} of {}", charged, budget);
  std::vector<std::size_t> order;
  for (std::size_t reason = 0; reason < team.packets_by_reason.size(); ++reason) {
    if (team.packets_by_reason[reason] > 0) order.push_back(reason);
  }
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t r) { return team.packets_by_reason[r]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    out += fmt::format("{} {} {}", i == 0 ? ":" : ",", team.packets_by_reason[order[i]],
                       in_words(match::reason_name(static_cast<int>(order[i]))));
  }
  return out + '\n';
}

std::string table(const match::TeamMetrics& team, const std::vector<std::string>& names) {
  std::size_t width = 4;
  for (const std::string& role : names) width = std::max(width, role.size());
  std::string out =
      fmt::format("  {:<{}}  {:>9}  {:>11}  {:>8}\n", "role", width, "overlap s", "uncovered s", "switches");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const match::RoleMetrics& role = team.roles[i];
    out += fmt::format("  {:<{}}  {:>9.1f}  {:>11.1f}  {:>8}\n", names[i], width, role.overlap_seconds,
                       role.uncovered_seconds, role.switches);
  }
  return out;
}

}  // namespace

std::string summary_text(const PlayedMatch& match) {
  const match::Result& result = match.result;
  std::string out = fmt::format("{} {} : {} {}\n\n", match.teams[0], result.score[0], result.score[1], match.teams[1]);
  out += fmt::format("ended       {}, after {:.1f} s\n", in_words(result.ended), result.simulated_seconds);
  out += fmt::format("seed        {}\n", match.seed);
  if (!match.opening.empty()) out += fmt::format("opening     {}\n", match.opening);
  out += fmt::format("state hash  {}\n", match::hash_text(result.hash));
  out += fmt::format("wall time   {:.2f} s, {:.0f} times faster than the game\n", match.wall_seconds,
                     share(result.simulated_seconds, match.wall_seconds));
  const double possessed = result.metrics.teams[0].possession_seconds + result.metrics.teams[1].possession_seconds;
  for (const match::Side side : match::both_sides) {
    const std::size_t i = match::index(side);
    const match::TeamMetrics& team = result.metrics.teams[i];
    out += fmt::format("\n{} ({})\n", match.teams[i], match::name(side));
    out += table(team, match.role_names[i]);
    out += packets(team, result.packets[i], match.budget);
    out += fmt::format("  possession {:.0f} %, agreement {:.1f} %, falls {}, penalties {}, kicks {}\n",
                       100.0 * share(team.possession_seconds, possessed), 100.0 * team.agreement, team.falls,
                       team.penalties, team.kicks);
  }
  return out;
}

}  // namespace regista::cli
