// SPDX-License-Identifier: MIT
#include "study/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "match/metric_table.hpp"
#include "match/side.hpp"

namespace regista::study {
namespace {

std::vector<NamedValue> values_at(const match::MetricNumbers& metrics, const std::vector<std::size_t>& places) {
  std::vector<NamedValue> out;
  for (const std::size_t place : places) {
    if (const auto value = metrics.at(place)) out.push_back({metrics.names().path(place), *value});
  }
  return out;
}

}  // namespace

std::vector<NamedValue> metric_values(const match::MetricNumbers& metrics, int side) {
  if (metrics.empty()) return {};
  return values_at(metrics, metrics.names().of(static_cast<match::Side>(side)));
}

std::vector<NamedValue> metric_values_of_match(const match::MetricNumbers& metrics) {
  if (metrics.empty()) return {};
  return values_at(metrics, metrics.names().of_match());
}

std::vector<NamedValue> all_metric_values(const match::MetricNumbers& metrics, int side) {
  std::vector<NamedValue> out = metric_values(metrics, side);
  if (metrics.empty()) return out;
  for (const match::MetricNames::Sum& sum : metrics.names().sums(static_cast<match::Side>(side))) {
    if (const auto value = metrics.sum(sum)) out.push_back({sum.name, *value});
  }
  return out;
}

bool is_time(std::string_view measure) {
  const match::MetricRow* const row = match::find_metric(match::metric_table(), measure);
  return row != nullptr && row->unit == "s" && row->total == match::MetricRow::Total::sum;
}

const char* unit_of(std::string_view measure) { return is_time(measure) ? "min per 60 min" : "per match"; }

double pair_in_unit(std::string_view measure, double sum, double playing_seconds) {
  if (!is_time(measure)) return sum / 2.0;
  return playing_seconds > 0.0 ? 60.0 * sum / playing_seconds : no_value;
}

std::optional<double> measure_of_score(std::string_view measure, const campaign::MatchResult& decided, int side) {
  const int own = decided.score[static_cast<std::size_t>(side)],
            other = decided.score[static_cast<std::size_t>(1 - side)];
  const double points = own > other ? 1.0 : own == other ? 0.5 : 0.0;
  const std::array<double, measures_of_score.size()> values{static_cast<double>(own), static_cast<double>(other),
                                                            static_cast<double>(own - other), points};
  const auto found = std::ranges::find(measures_of_score, measure);
  if (found == measures_of_score.end()) return std::nullopt;
  return values[static_cast<std::size_t>(found - measures_of_score.begin())];
}

MatchMeasures::MatchMeasures(const campaign::MatchResult& decided, int side)
    : playing_seconds_(decided.metrics.of_match("playing_seconds").value_or(0.0)) {
  for (const char* const each : measures_of_score) values_.push_back({each, *measure_of_score(each, decided, side)});
  for (NamedValue& each : all_metric_values(decided.metrics, side)) {
    if (std::ranges::find(measures_of_score, each.path) == measures_of_score.end()) values_.push_back(std::move(each));
  }
}

std::optional<double> MatchMeasures::value(const std::string& measure) const {
  const auto found = std::ranges::find(values_, match::without_roles(measure), &NamedValue::path);
  return found == values_.end() ? std::nullopt : std::optional(found->value);
}

std::string why_missing(std::string_view metric, bool short_games) {
  if (short_games || metric == match::packet_metrics[0]) return {};
  if (std::ranges::find(match::packet_metrics, metric) == match::packet_metrics.end()) return {};
  return fmt::format(
      "{}: whole matches have none; only games that a limit or an opening ends before their time have it", metric);
}

std::optional<std::array<ShortGamePackets, 2>> PacketsOfShortGames::of(const match::MetricNumbers& metrics) {
  const std::span<const std::optional<double>> values = columns_.of(metrics);
  if (!std::ranges::all_of(values, &std::optional<double>::has_value)) return std::nullopt;
  std::array<ShortGamePackets, 2> out;
  for (const std::size_t side : {0u, 1u}) out[side] = {*values[side], *values[2 + side], *values[4 + side]};
  return out;
}

void PacketsSpent::add(const ShortGamePackets& game) {
  spent_.add(game.spent);
  share_.add(game.share);
  over_.add(game.over);
}

void ForfeitList::add(std::size_t team, const campaign::Failure& failure, std::uint64_t match) {
  ++of_team_[team];
  const auto known = std::ranges::find_if(listed_, [&](const Forfeits& each) {
    return each.team == team && each.failure.plugin == failure.plugin && each.failure.call == failure.call &&
           each.failure.what == failure.what;
  });
  if (known != listed_.end()) {
    ++known->count;
  } else if (listed_.size() < RemarkList::most_listed) {
    listed_.push_back({team, failure, match, 1});
  } else {
    ++unlisted_;
  }
}

void RemarkList::add(std::uint64_t match, const std::string& text) {
  ++count_;
  if (listed_.size() < most_listed) listed_.push_back({match, text});
}

std::string why_unplayable(const std::string& who, const std::string& last) {
  return fmt::format("{}: {} matches could not be played, and no team can be blamed: {}", who, most_set_aside, last);
}

void MatchRemarks::take(std::uint64_t match, const campaign::MatchResult& decided) {
  if (decided.set_aside()) unplayed.add(match, decided.why_set_aside);
  if (!decided.irreproducible.empty()) irreproducible.add(match, decided.irreproducible);
  if (!decided.shared.empty()) shared.add(match, decided.shared);
  if (!decided.broken.empty()) broken.add(match, decided.broken);
  if (!decided.kept.empty() && decided.shared.empty() && decided.irreproducible.empty()) kept.add(match, decided.kept);
  if (!decided.unproven.empty()) unproven.add(match, decided.unproven);
  if (decided.output.empty()) return;
  ++written_count;
  if (written.size() < most_written) written.push_back(match);
}

}  // namespace regista::study
