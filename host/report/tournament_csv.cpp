// SPDX-License-Identifier: MIT
// A tournament as a table: a line for each match.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "report/csv_text.hpp"
#include "report/tournament_outline.hpp"
#include "study/packets_spent.hpp"

namespace regista::report {

match::MetricPaths csv_metrics(const study::TournamentPlan& plan) {
  if (!plan.short_games()) return {};
  return match::packet_paths();
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
                     match::MetricColumns& metrics) {
  const study::Fixture fixture = view.course.calendar().at(index);
  const auto& teams = view.plan.teams;
  const std::string opening = scene_of(view, fixture);
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
    if (value) fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), *value);
  };
  std::ranges::for_each(metrics.of(decided.metrics), write);
  return out + '\n';
}

}  // namespace regista::report
