// SPDX-License-Identifier: MIT
// A tournament as a table: a line for each match.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "report/csv_text.hpp"
#include "report/tournament.hpp"
#include "study/metric.hpp"
#include "study/packets_spent.hpp"

namespace regista::report {

match::MetricPaths csv_metrics(const study::TournamentPlan& plan) {
  if (!plan.short_games()) return {};
  return {.of_teams = {study::packet_metrics.begin(), study::packet_metrics.end()}, .of_match = {}};
}

std::string csv_head(const match::MetricPaths& metrics) {
  std::string out =
      "row,pair,seed,opening,home,away,home_goals,away_goals,ended,state_hash,forfeited_by,plugin,call,why";
  for (const std::string& each : metrics.of_teams)
    out += fmt::format(",{},{}", csv_field("home." + each), csv_field("away." + each));
  for (const std::string& each : metrics.of_match) out += ',' + csv_field(each);
  return out + '\n';
}

std::string csv_line(const TournamentView& view, std::uint64_t index, const campaign::Decided& decided,
                     const match::MetricPaths& metrics) {
  const study::Fixture fixture = view.course.calendar().at(index);
  const auto& teams = view.plan.teams;
  const std::string opening = view.plan.openings.empty()
                                  ? std::string()
                                  : std::filesystem::path(view.plan.openings[fixture.opening].file).stem().string();
  // A match that could not be played has no score.
  const auto goals = [&decided](std::size_t side) {
    return decided.set_aside() ? std::string() : std::to_string(decided.score[side]);
  };
  std::string out = fmt::format("{},{},{},{},{},{},{},{},{},{},", index + 1, fixture.pair + 1, fixture.seed,
                                csv_field(opening), csv_field(teams[fixture.home].label),
                                csv_field(teams[fixture.away].label), goals(0), goals(1), decided.ended, decided.hash);
  if (decided.failure) {
    const campaign::Failure& failure = *decided.failure;
    out += fmt::format("{},{},{},{}", failure.side == 0 ? "home" : "away", csv_field(failure.plugin),
                       csv_field(failure.call), csv_field(failure.what));
  } else {
    out += ",,," + csv_field(decided.why_set_aside);
  }
  const auto write = [&out](const std::optional<double>& value) {
    out += ',';
    if (value) out += fmt::format("{}", *value);
  };
  if (metrics.empty()) return out + '\n';
  if (metrics == csv_metrics(view.plan)) {
    // Of these a table of a million matches is written in seconds.
    study::PacketMetrics packets;
    if (!decided.metrics.empty()) packets = study::packet_metrics_of(decided.metrics);
    for (const auto& of_sides : packets) std::ranges::for_each(of_sides, write);
  } else {
    std::array<std::vector<study::NamedValue>, 2> values;
    for (const std::size_t side : {0u, 1u}) {
      if (!decided.metrics.empty()) values[side] = study::metric_values(decided.metrics, static_cast<int>(side));
    }
    for (const std::string& each : metrics.of_teams) {
      for (const std::vector<study::NamedValue>& of_side : values) {
        const auto found = std::ranges::find(of_side, each, &study::NamedValue::path);
        write(found == of_side.end() ? std::nullopt : std::optional(found->value));
      }
    }
    for (const std::string& each : metrics.of_match) write(decided.metrics.of_match(each));
  }
  return out + '\n';
}

}  // namespace regista::report
