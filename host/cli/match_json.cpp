// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "cli/match_report.hpp"
#include "match/names.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

Json roles(const match::TeamMetrics& team, const std::vector<std::string>& names) {
  Json out = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const match::RoleMetrics& role = team.roles[i];
    out[names[i]] = {{"overlap_seconds", role.overlap_seconds},
                     {"uncovered_seconds", role.uncovered_seconds},
                     {"switches", role.switches},
                     {"robot_seconds", role.robot_seconds}};
  }
  return out;
}

Json packets_by_reason(const match::TeamMetrics& team) {
  Json out = Json::object();
  for (std::size_t reason = 0; reason < team.packets_by_reason.size(); ++reason) {
    out[std::string(match::reason_name(static_cast<int>(reason)))] = team.packets_by_reason[reason];
  }
  return out;
}

}  // namespace

std::string summary_json(const PlayedMatch& match) {
  const match::Result& result = match.result;
  const auto& teams = result.metrics.teams;
  const auto both = [&](auto value) { return Json::array({Json(value(teams[0])), Json(value(teams[1]))}); };
  Json out;
  out["teams"] = match.teams;
  out["score"] = result.score;
  out["seed"] = match.seed;
  out["ended"] = match::name(result.ended);
  out["simulated_seconds"] = result.simulated_seconds;
  out["wall_seconds"] = match.wall_seconds;
  out["state_hash"] = match::hash_text(result.hash);
  out["packets"] = result.packets;
  out["roles"] = Json::array({roles(teams[0], match.role_names[0]), roles(teams[1], match.role_names[1])});
  out["failures"] = Json::array();
  out["playing_seconds"] = result.metrics.playing_seconds;
  out["in_play_seconds"] = result.metrics.in_play_seconds;
  out["packets_by_reason"] = both(packets_by_reason);
  out["possession_seconds"] = both([](const match::TeamMetrics& team) { return team.possession_seconds; });
  out["agreement"] = both([](const match::TeamMetrics& team) { return team.agreement; });
  out["falls"] = both([](const match::TeamMetrics& team) { return team.falls; });
  out["penalties"] = both([](const match::TeamMetrics& team) { return team.penalties; });
  out["kicks"] = both([](const match::TeamMetrics& team) { return team.kicks; });
  out["touches"] = both([](const match::TeamMetrics& team) { return team.touches; });
  if (!match.opening.empty()) out["opening"] = match.opening;
  return out.dump() + '\n';
}

}  // namespace regista::cli
