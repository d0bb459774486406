// SPDX-License-Identifier: MIT
#include "study/tournament_calendar.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <utility>

#include "match/side.hpp"
#include "study/settings.hpp"

namespace regista::study {
namespace {

Pairing by_seed(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// Pairs teams that have not met, with backtracking. The number of attempts is limited, because few teams after many
// rounds may have no such pairing at all.
class Monrad {
 public:
  Monrad(std::span<const std::size_t> order, const std::vector<std::vector<char>>& met)
      : order_(order.begin(), order.end()), met_(met), paired_(order.size(), 0) {}

  std::optional<std::vector<Pairing>> pairs() { return complete() ? std::optional(std::move(out_)) : std::nullopt; }

 private:
  bool complete() {
    const auto first = static_cast<std::size_t>(std::ranges::find(paired_, 0) - paired_.begin());
    if (first == order_.size()) return true;
    paired_[first] = 1;
    for (std::size_t next = first + 1; next < order_.size(); ++next) {
      if (paired_[next] != 0 || met_[order_[first]][order_[next]] != 0) continue;
      if (--attempts_ < 0) break;
      paired_[next] = 1;
      out_.push_back(by_seed(order_[first], order_[next]));
      if (complete()) return true;
      out_.pop_back();
      paired_[next] = 0;
    }
    paired_[first] = 0;
    return false;
  }

  std::vector<std::size_t> order_;
  const std::vector<std::vector<char>>& met_;
  std::vector<char> paired_;
  std::vector<Pairing> out_;
  int attempts_ = 100'000;
};

}  // namespace

std::vector<Pairing> swiss_round(const SwissStanding& standing) {
  std::vector<std::size_t> order(standing.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t team) { return standing.plays[team] == 0; });
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t team) { return standing.points[team]; });
  if (order.size() % 2 == 1) {
    const auto last = std::ranges::find_if(order.rbegin(), order.rend(),
                                           [&](std::size_t team) { return standing.had_bye[team] == 0; });
    const std::size_t bye = last == order.rend() ? order.back() : *last;
    std::erase(order, bye);
  }
  if (auto pairs = Monrad(order, standing.met).pairs()) return std::move(*pairs);
  std::vector<Pairing> out;
  for (std::size_t i = 0; i + 1 < order.size(); i += 2) out.push_back(by_seed(order[i], order[i + 1]));
  return out;
}

std::size_t knock_out_rounds(std::size_t teams) { return static_cast<std::size_t>(std::bit_width(teams - 1)); }

std::vector<Pairing> knock_out_round(std::size_t teams, std::size_t round,
                                     const std::function<std::size_t(const Pairing&)>& winner) {
  // The seeds of a bracket of twice the size are these seeds, each beside the seed with which it sums up to the size.
  std::vector<std::optional<std::size_t>> bracket{0};
  while (bracket.size() < std::bit_ceil(teams)) {
    const std::size_t size = 2 * bracket.size();
    std::vector<std::optional<std::size_t>> larger;
    for (const auto& seed : bracket) larger.insert(larger.end(), {seed, size - 1 - *seed});
    bracket = std::move(larger);
  }
  for (auto& place : bracket) {
    if (*place >= teams) place.reset();
  }
  const auto meeting = [&](std::size_t i) -> std::optional<Pairing> {
    if (!bracket[i] || !bracket[i + 1]) return std::nullopt;
    return by_seed(*bracket[i], *bracket[i + 1]);
  };
  for (std::size_t earlier = 0; earlier < round; ++earlier) {
    std::vector<std::optional<std::size_t>> next;
    for (std::size_t i = 0; i + 1 < bracket.size(); i += 2) {
      const auto pair = meeting(i);
      next.push_back(pair ? winner(*pair) : bracket[i] ? bracket[i] : bracket[i + 1]);
    }
    bracket = std::move(next);
  }
  std::vector<Pairing> out;
  for (std::size_t i = 0; i + 1 < bracket.size(); i += 2) {
    if (const auto pair = meeting(i)) out.push_back(*pair);
  }
  return out;
}

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

std::size_t Calendar::index_of(const Pairing& teams) const {
  const auto found = std::ranges::find(pairings_, teams);
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
