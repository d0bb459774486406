// SPDX-License-Identifier: MIT
#include "report/match_numbers.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "study/metric.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_numbers = 600;  // of a team
constexpr double alpha = 0.05;

// Numbers come in the same order match after match: where the last one was found, the next one follows.
template <class Entries>
auto* search(Entries& entries, const std::string& path, std::size_t& hint) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t at = (hint + i) % entries.size();
    if (entries[at].path != path) continue;
    hint = at + 1;
    return &entries[at];
  }
  return static_cast<decltype(&entries[0])>(nullptr);
}

template <class Entries>
auto* search(Entries& entries, const std::string& path) {
  std::size_t hint = 0;
  return search(entries, path, hint);
}

}  // namespace

MatchNumbers::MatchNumbers(const study::TournamentPlan& plan)
    : teams_(plan.teams.size()), paired_(plan.teams.size() == 2) {}

MatchNumbers::Values MatchNumbers::values(const match::MetricNumbers& metrics, int side) {
  Values out;
  std::array<std::optional<double>, role_measures.size()> sums;
  for (study::NamedValue& each : study::metric_values(metrics, side)) {
    for (std::size_t i = 0; i < role_measures.size(); ++i) {
      if (each.path.ends_with(std::string(".") + role_measures[i])) sums[i] = sums[i].value_or(0.0) + each.value;
    }
    out.push_back({std::move(each.path), each.value});
  }
  for (std::size_t i = 0; i < role_measures.size(); ++i) {
    if (sums[i]) out.push_back({role_measures[i], *sums[i]});
  }
  return out;
}

void MatchNumbers::take(const study::Fixture& fixture, const campaign::Decided& decided) {
  if (!fixture.swapped) first_of_pair_.reset();
  if (decided.metrics.empty()) {
    first_of_pair_.reset();
    return;
  }
  std::array<Values, 2> sides{values(decided.metrics, 0), values(decided.metrics, 1)};
  for (const std::size_t side : {0u, 1u}) {
    std::vector<TeamNumber>& known = teams_[side == 0 ? fixture.home : fixture.away];
    std::size_t hint = 0;
    for (const Value& each : sides[side]) {
      TeamNumber* found = search(known, each.path, hint);
      if (found == nullptr && known.size() < most_numbers) found = &known.emplace_back(TeamNumber{each.path, {}});
      if (found != nullptr) found->matches.add(each.number);
    }
  }
  if (!paired_) return;
  if (!fixture.swapped) {
    first_of_pair_ = std::move(sides);
  } else if (first_of_pair_) {
    finish_pair((*first_of_pair_)[0], (*first_of_pair_)[1], sides[1], sides[0]);
    first_of_pair_.reset();
  }
}

void MatchNumbers::finish_pair(const Values& a1, const Values& b1, const Values& a2, const Values& b2) {
  std::size_t in_b1 = 0, in_a2 = 0, in_b2 = 0, in_pairs = 0;
  for (const Value& value : a1) {
    const Value *const first_b = search(b1, value.path, in_b1), *const second_a = search(a2, value.path, in_a2),
                       *const second_b = search(b2, value.path, in_b2);
    if (first_b == nullptr || second_a == nullptr || second_b == nullptr) continue;
    PairedNumber* found = search(pairs_, value.path, in_pairs);
    if (found == nullptr && pairs_.size() < most_numbers) {
      found = &pairs_.emplace_back(PairedNumber{value.path, study::MetricDifference(alpha)});
    }
    if (found != nullptr) {
      found->difference.add((value.number + second_a->number) / 2.0, (first_b->number + second_b->number) / 2.0);
    }
  }
}

const statistics::Moments* MatchNumbers::find(std::size_t team, const std::string& path) const {
  const TeamNumber* const found = search(teams_[team], path);
  return found == nullptr ? nullptr : &found->matches;
}

const study::MetricDifference* MatchNumbers::difference(const std::string& path) const {
  const PairedNumber* const found = search(pairs_, path);
  return found == nullptr ? nullptr : &found->difference;
}

}  // namespace regista::report
