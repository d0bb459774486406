// SPDX-License-Identifier: MIT
#include "campaign/match_json.hpp"

#include "campaign/metric_json.hpp"
#include "match/names.hpp"
#include "texts/json.hpp"

namespace regista::campaign {

std::optional<double> packets_share_of(const match::Setup& setup) {
  if (setup.rules.messages.short_games == config::ShortGames::share) return std::nullopt;  // it is the budget then
  const config::Durations& durations = setup.rules.durations;
  const double whole = durations.half * durations.halves;
  const std::optional<double> length = match::limit_of(setup);
  if (!length || !(*length < whole)) return std::nullopt;
  return setup.rules.messages.budget * *length / whole;
}

match::MetricNumbers numbers_of(const PlayedMatch& match, std::span<const match::MetricRow> table) {
  return match::metric_numbers(table, {match.result, match.packets_share}, match.role_names);
}

nlohmann::ordered_json summary_json(const PlayedMatch& match, std::span<const match::MetricRow> table) {
  const match::Result& result = match.result;
  nlohmann::ordered_json out;
  out["teams"] = match.teams;
  out["score"] = nullptr;  // its place: numbers come later
  out["seed"] = match.seed;
  if (!match.opening.empty()) out["opening"] = match.opening;
  out["ended"] = match::name(result.ended);
  out["simulated_seconds"] = nullptr;
  out["wall_seconds"] = match.wall_seconds;
  out["state_hash"] = match::hash_text(result.hash);
  out["failures"] = nlohmann::ordered_json::array();
  add_metrics(out, numbers_of(match, table));
  // Lists in which nothing stands.
  for (const match::MetricRow& row : table) {
    if (row.is_list() && row.of == match::MetricRow::Of::team && !out.contains(row.name)) {
      out[row.name] = {nlohmann::ordered_json::array(), nlohmann::ordered_json::array()};
    }
  }
  return out;
}

}  // namespace regista::campaign
