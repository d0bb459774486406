// SPDX-License-Identifier: MIT
#include "study/tournament_calendar.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "match/side.hpp"
#include "study/settings.hpp"

namespace regista::study {

Calendar::Calendar(const TournamentPlan& plan)
    : pairings_(plan.pairings()),
      openings_(std::max<std::size_t>(plan.openings.size(), 1)),
      opening_by_chance_(plan.asked.test.has_value()),
      pairs_(plan.pairs()),
      meetings_(plan.meetings()),
      rounds_(plan.rounds()),
      first_seed_(plan.first_seed()) {}

Fixture Calendar::of_number(std::size_t number) const {
  Fixture out;
  out.number = number;
  out.opening = number % openings_;
  out.swapped = number / openings_ % 2 == 1;
  out.pairing = number / openings_ / 2;
  const Pairing& pairing = pairings_[out.pairing];
  out.home = out.swapped ? pairing.second : pairing.first;
  out.away = out.swapped ? pairing.first : pairing.second;
  return out;
}

Fixture Calendar::at(std::uint64_t index) const {
  std::uint64_t pair = 0;
  std::size_t pairing = 0;
  if (rounds_ == 0) {
    pair = index / 2 / pairings_.size();
    pairing = static_cast<std::size_t>(index / 2 % pairings_.size());
  } else {
    assert(index < drawn_matches());
    const auto round =
        static_cast<std::size_t>(std::ranges::upper_bound(first_of_round_, index) - first_of_round_.begin() - 1);
    const std::uint64_t in_round = (index - first_of_round_[round]) / 2;
    pair = round * pairs_ + in_round / drawn_[round].size();
    pairing = drawn_[round][static_cast<std::size_t>(in_round % drawn_[round].size())];
  }
  const std::uint64_t seed = first_seed_ + pair;
  const std::size_t opening =
      opening_by_chance_ ? drawn_opening(seed, openings_) : static_cast<std::size_t>(pair % openings_);
  Fixture out = of_number((2 * pairing + index % 2) * openings_ + opening);
  out.pair = pair;
  out.seed = seed;
  return out;
}

std::optional<std::uint64_t> Calendar::pairs_after(std::uint64_t matches) const {
  if (rounds_ == 0) {
    const std::uint64_t all = 2 * pairings_.size();
    return matches % all == 0 ? std::optional(matches / all) : std::nullopt;
  }
  // A knock-out may have rounds without a match, so the last of equal ends counts.
  const auto end = std::ranges::find(first_of_round_.rbegin(), first_of_round_.rend(), matches);
  if (end == first_of_round_.rend()) return std::nullopt;
  return static_cast<std::uint64_t>(first_of_round_.rend() - end - 1) * pairs_;
}

void Calendar::draw(std::vector<std::size_t> pairings) {
  assert(drawn_.size() < rounds_);
  first_of_round_.push_back(drawn_matches() + 2 * pairs_ * pairings.size());
  drawn_.push_back(std::move(pairings));
}

std::size_t Calendar::index_of(const TeamPair& teams) const {
  const auto found = std::ranges::find_if(
      pairings_, [&](const Pairing& each) { return each.first == teams[0] && each.second == teams[1]; });
  assert(found != pairings_.end());
  return static_cast<std::size_t>(found - pairings_.begin());
}

config::Overrides settings_of(const TournamentPlan& plan, const Fixture& fixture) {
  config::Overrides out;
  for (const config::Node::Entry& each : plan.asked.settings.set.entries()) {
    const std::optional<std::size_t> team = team_meant(plan, each.key);
    if (!team) {
      out.emplace_back(each.key, each.value, each.key_where);
      continue;
    }
    const std::string rest = each.key.substr(1);
    for (const match::Side side : match::both_sides) {
      if (*team != (side == match::Side::home ? fixture.home : fixture.away)) continue;
      out.emplace_back(match::name(side) + rest, each.value, each.key_where);
    }
  }
  return out;
}

campaign::Job job(const TournamentPlan& plan, const Fixture& fixture) {
  campaign::Job out = job_under(plan.asked.settings, plan.plugins);
  out.teams = {plan.asked.teams[fixture.home].team, plan.asked.teams[fixture.away].team};
  out.disturbance = plan.asked.disturbance;
  out.overrides = as_typed(settings_of(plan, fixture));
  out.seed = fixture.seed;
  out.home_inputs = plan.teams[fixture.home].inputs;
  out.away_inputs = plan.teams[fixture.away].inputs;
  out.common_inputs = plan.common_inputs;
  out.home_disturbance = plan.asked.teams[fixture.home].disturbance;
  out.away_disturbance = plan.asked.teams[fixture.away].disturbance;
  for (std::size_t side = 0; side < 2; ++side) {
    const Entrant& team = plan.teams[side == 0 ? fixture.home : fixture.away];
    if (team.disturbances.empty()) continue;
    for (campaign::Input& each : out.common_inputs) {
      if (is_disturbance(each, side)) each = team.disturbances[side];
    }
  }
  if (!plan.openings.empty()) start_from(plan.openings[fixture.opening], out);
  return out;
}

std::vector<campaign::Store::Fixture> fixtures(const TournamentPlan& plan) {
  const Calendar calendar(plan);
  std::vector<campaign::Store::Fixture> out;
  for (std::size_t number = 0; number < calendar.fixtures(); ++number)
    out.push_back(fixture_of(job(plan, calendar.of_number(number))));
  return out;
}

}  // namespace regista::study
