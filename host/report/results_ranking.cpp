// SPDX-License-Identifier: MIT
#include "report/results_ranking.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/few_uneven.hpp"
#include "report/number.hpp"
#include "statistics/bradley_terry.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using Team = RankedResults::Team;

double share(const Team& team) { return team.games == 0 ? 0.5 : team.points / static_cast<double>(team.games); }

std::string elo_text(const Team& team) {
  if (!team.elo) return "-";
  const std::string value = fixed(team.elo->value, 1);
  return team.elo->interval.bounded() ? fmt::format("{} +/- {:.1f}", value, team.elo->margin()) : value;
}

std::uint64_t unsigned_count(statistics::Count count) { return static_cast<std::uint64_t>(count); }

// What the margins count.
std::string basis(const RankedResults& ranking) {
  if (ranking.pairs == 0) return "Margins hold with 95 % if all games are independent: the results name no pairs.\n";
  if (2 * ranking.pairs == ranking.games) return "Margins hold with 95 % and count pairs.\n";
  return "Margins hold with 95 % and count pairs, and games without a pair as independent.\n";
}

}  // namespace

RankedResults ranked(const study::ResultsOfTeams& results) {
  RankedResults out;
  for (const std::string& name : results.teams) out.teams.push_back({name, std::nullopt, 0.0, 0});
  for (const statistics::Encounter& each : results.encounters) {
    const statistics::Count games = each.games_played();
    out.teams[each.first].points += each.points();
    out.teams[each.second].points += static_cast<double>(games) - each.points();
    out.teams[each.first].games += games;
    out.teams[each.second].games += games;
    out.games += games;
    out.pairs += total(each.pairs);
  }
  if (const auto elo = statistics::bradley_terry(results.teams.size(), results.encounters)) {
    out.determined = true;
    for (std::size_t i = 0; i < elo->size(); ++i) out.teams[i].elo = (*elo)[i];
  }
  std::ranges::stable_sort(out.teams, [](const Team& x, const Team& y) {
    return x.elo && y.elo && x.elo->value != y.elo->value ? x.elo->value > y.elo->value : share(x) > share(y);
  });
  return out;
}

std::string ranking_text(const RankedResults& ranking) {
  std::size_t widest = 4;
  for (const Team& each : ranking.teams) widest = std::max(widest, texts::one_line(each.name).size());
  std::string out = fmt::format("Ranking of {} by {}", texts::counted(ranking.teams.size(), "team", "teams"),
                                texts::counted(unsigned_count(ranking.games), "game", "games"));
  if (ranking.pairs > 0) out += fmt::format(", {}", texts::counted(unsigned_count(ranking.pairs), "pair", "pairs"));
  out += fmt::format(":\n{:>4}  {:{}}  {:>16}  {:>10}  {:>11}  {:>7}\n", "rank", "team", widest, "Elo", "games",
                     "points", "share");
  int rank = 0;
  bool without = false;
  for (const Team& each : ranking.teams) {
    out += fmt::format("{:>4}  {:{}}  {:>16}  {:>10}  {:>11.1f}  {:>5.1f} %\n", ++rank, texts::one_line(each.name),
                       widest, elo_text(each), each.games, each.points, 100.0 * share(each));
    without = without || (each.elo && !each.elo->interval.bounded());
  }
  if (!ranking.determined) {
    return out +
           "The results do not tell the strengths: some teams never met the others, took no point from them, or "
           "lost none to them.\n";
  }
  out += "Elo: Bradley and Terry, sum 0. " + basis(ranking);
  return without ? out + no_margin_of_team() + '\n' : out;
}

std::string ranking_json(const RankedResults& ranking) {
  nlohmann::ordered_json teams = nlohmann::ordered_json::array();
  for (const Team& each : ranking.teams) {
    nlohmann::ordered_json row;
    row["team"] = each.name;
    if (each.elo) {
      row["elo"] = each.elo->value;
      // An infinite bound becomes null.
      row["elo_interval"] = {each.elo->interval.low, each.elo->interval.high};
    } else {
      row["elo"] = nullptr;
      row["elo_interval"] = nullptr;
    }
    row["games"] = each.games;
    row["points"] = each.points;
    teams.push_back(row);
  }
  nlohmann::ordered_json out;
  out["games"] = ranking.games;
  out["pairs"] = ranking.pairs;
  out["ranking"] = teams;
  return out.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
