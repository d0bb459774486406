// SPDX-License-Identifier: MIT
#include "campaign/match_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "match/names.hpp"

namespace regista::campaign {
namespace {

using Json = nlohmann::ordered_json;

// To the sixth decimal: sums and shares have no more to say, and a campaign keeps them for every match.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json number(const std::optional<double>& value) { return value ? Json(rounded(*value)) : Json(nullptr); }

Json roles(const match::TeamMetrics& team, const std::vector<std::string>& names) {
  Json out = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const match::RoleMetrics& role = team.coordination.roles[i];
    const match::RoleMetrics::Counts &all = role.all, &before = role.before_silence, &after = role.after_silence;
    out[names[i]] = {{"overlap_seconds", all.overlap_seconds},
                     {"uncovered_seconds", all.uncovered_seconds},
                     {"switches", all.switches},
                     {"unplayed_seconds", all.unplayed_seconds},
                     {"overlap_before_silence_seconds", before.overlap_seconds},
                     {"overlap_after_silence_seconds", after.overlap_seconds},
                     {"uncovered_before_silence_seconds", before.uncovered_seconds},
                     {"uncovered_after_silence_seconds", after.uncovered_seconds},
                     {"switches_before_silence", before.switches},
                     {"switches_after_silence", after.switches},
                     {"robot_seconds", role.robot_seconds}};
  }
  return out;
}

// Of all roles together, by the minute of play: spans of different length beside each other.
Json rates(const match::CoordinationMetrics& coordination, double playing_seconds) {
  Json out = Json::object();
  const auto add = [&](const std::string& span, match::RoleMetrics::Counts match::RoleMetrics::*counts,
                       double seconds) {
    match::RoleMetrics::Counts sum;
    for (const match::RoleMetrics& role : coordination.roles) {
      sum.overlap_seconds += (role.*counts).overlap_seconds;
      sum.uncovered_seconds += (role.*counts).uncovered_seconds;
      sum.switches += (role.*counts).switches;
    }
    const auto rate = [seconds](double value) {
      return number(seconds > 0.0 ? std::optional(60.0 * value / seconds) : std::nullopt);
    };
    out["overlap_seconds_per_minute" + span] = rate(sum.overlap_seconds);
    out["uncovered_seconds_per_minute" + span] = rate(sum.uncovered_seconds);
    out["switches_per_minute" + span] = rate(sum.switches);
  };
  add("", &match::RoleMetrics::all, playing_seconds);
  add("_before_silence", &match::RoleMetrics::before_silence, playing_seconds - coordination.silent_seconds);
  add("_after_silence", &match::RoleMetrics::after_silence, coordination.silent_seconds);
  return out;
}

Json estimate(const match::EstimateMetrics& of) {
  return {{"known_share", number(of.known_share)},
          {"rmse_metres", number(of.rmse_metres)},
          {"nees", number(of.nees)},
          {"coverage_95", number(of.coverage_95)}};
}

Json world_model(const match::TeamMetrics& team) {
  const match::WorldModelMetrics& model = team.world_model;
  return {{"ball", estimate(model.ball)},
          {"self", estimate(model.self)},
          {"teammates", estimate(model.teammates)},
          {"opponents",
           {{"ospa_metres", number(model.ospa_metres)},
            {"ospa_location_metres", number(model.ospa_location_metres)},
            {"ospa_cardinality_metres", number(model.ospa_cardinality_metres)}}}};
}

Json robot_distances(const match::TeamMetrics& team) {
  Json out = Json::array();
  for (const double metres : team.play.robot_distance_metres) out.push_back(std::round(metres * 1e3) / 1e3);
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

std::optional<double> packets_share_of(const match::Setup& setup) {
  if (setup.rules.messages.short_games == config::ShortGames::share) return std::nullopt;  // it is the budget then
  const config::Durations& durations = setup.rules.durations;
  const double whole = durations.half * durations.halves;
  const std::optional<double> length = match::limit_of(setup);
  if (!length || !(*length < whole)) return std::nullopt;
  return setup.rules.messages.budget * *length / whole;
}

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
  if (match.packets_share) {
    const double share = rounded(*match.packets_share);
    out["packets_share"] = {share, share};
    out["packets_over_share"] = {rounded(result.packets[0] - share), rounded(result.packets[1] - share)};
  }
  using match::TeamMetrics;
  out["budget_curve"] = both([](const TeamMetrics& team) { return team.budget_curve; });
  out["silent_seconds"] = both([](const TeamMetrics& team) { return team.coordination.silent_seconds; });
  out["agreement"] = both([](const TeamMetrics& team) { return number(team.coordination.agreement); });
  out["agreement_before_silence"] =
      both([](const TeamMetrics& team) { return number(team.coordination.agreement_before_silence); });
  out["agreement_after_silence"] =
      both([](const TeamMetrics& team) { return number(team.coordination.agreement_after_silence); });
  out["rates"] =
      both([&](const TeamMetrics& team) { return rates(team.coordination, result.metrics.playing_seconds); });
  out["falls"] = both([](const TeamMetrics& team) { return team.falls; });
  out["penalties"] = both([](const TeamMetrics& team) { return team.penalties; });
  out["kicks"] = both([](const TeamMetrics& team) { return team.kicks; });
  out["touches"] = both([](const TeamMetrics& team) { return team.touches; });
  out["shots"] = both([](const TeamMetrics& team) { return team.play.shots; });
  out["shots_scored"] = both([](const TeamMetrics& team) { return team.play.shots_scored; });
  out["shots_saved"] = both([](const TeamMetrics& team) { return team.play.shots_saved; });
  out["passes"] = both([](const TeamMetrics& team) { return team.play.passes; });
  out["interceptions"] = both([](const TeamMetrics& team) { return team.play.interceptions; });
  out["possession_seconds"] = both([](const TeamMetrics& team) { return team.play.possession_seconds; });
  out["possession_share"] = both([](const TeamMetrics& team) { return number(team.play.possession_share); });
  out["territory"] = both([](const TeamMetrics& team) {
    return Json{{"ball_x_metres", number(team.play.ball_x_metres)},
                {"opponent_half_share", number(team.play.opponent_half_share)}};
  });
  out["distance_walked_metres"] =
      both([](const TeamMetrics& team) { return rounded(team.play.distance_walked_metres); });
  out["robot_distance_metres"] = both(robot_distances);
  out["ball_seen_share"] = both([](const TeamMetrics& team) { return number(team.world_model.ball_seen_share); });
  out["world_model"] = both(world_model);
  if (!match.opening.empty()) out["opening"] = match.opening;
  return out.dump() + '\n';
}

}  // namespace regista::campaign
