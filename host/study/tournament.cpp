// SPDX-License-Identifier: MIT
#include "study/tournament.hpp"

#include <algorithm>
#include <cassert>

#include "study/metric.hpp"

namespace regista::study {
namespace {

constexpr double usual_alpha = 0.05;
// Of the grid of mean goal differences: 0.005 goals apart where a match can end with a difference of ten.
constexpr int goal_steps = 4000;
// Standard deviation of the mean goal difference of a pair of matches that is expected before the first.
constexpr double usual_goals = 1.0;

int goals_of(const campaign::Decided& decided, bool first_at_home) {
  const int difference = decided.score[0] - decided.score[1];
  return first_at_home ? difference : -difference;
}

statistics::GameOutcome outcome(int goals) {
  return goals > 0   ? statistics::GameOutcome::win
         : goals < 0 ? statistics::GameOutcome::loss
                     : statistics::GameOutcome::draw;
}

double alpha_of(const Objective& objective) {
  const auto* const value = std::get_if<ValueTest>(&objective);
  return value == nullptr ? usual_alpha : value->alpha;
}

// The path of the metric that the tournament tests; null where it tests none.
const std::string* tested_metric(const Objective& objective) {
  const auto* const value = std::get_if<ValueTest>(&objective);
  return value == nullptr || value->value == goals_value ? nullptr : &value->value;
}

}  // namespace

Meeting::Meeting(const TournamentPlan& plan, const Pairing& who)
    : pairing(who),
      goals_sequence({-static_cast<double>(plan.most_goals), static_cast<double>(plan.most_goals),
                      alpha_of(plan.objective), usual_goals},
                     goal_steps) {
  if (const auto* const score = std::get_if<ScoreTest>(&plan.objective)) score_test.emplace(score->design);
  if (tested_metric(plan.objective) != nullptr) metric.emplace(alpha_of(plan.objective));
}

Tournament::Tournament(const TournamentPlan& plan)
    : plan_(plan), calendar_(plan), forfeits_(plan.teams.size()), rows_(plan.teams.size()) {
  for (const Pairing& pairing : calendar_.pairings()) meetings_.emplace_back(plan, pairing);
}

bool Tournament::needs_metrics() const { return tested_metric(plan_.objective) != nullptr; }

std::uint64_t Tournament::matches() const {
  std::uint64_t sum = 0;
  for (const Meeting& meeting : meetings_) sum += meeting.matches();
  return sum;
}

bool Tournament::is_set_aside(std::size_t team) const {
  return std::ranges::find(set_aside_, team, &SetAside::team) != set_aside_.end();
}

bool Tournament::wanted(std::uint64_t index) const {
  if (set_aside_.empty()) return true;
  const Fixture fixture = calendar_.at(index);
  return !is_set_aside(fixture.home) && !is_set_aside(fixture.away);
}

bool Tournament::take(const campaign::Decided* decided) {
  const std::uint64_t index = next_++;
  // It may have been played, or read, before its team was set aside.
  if (decided == nullptr || !wanted(index)) return !over();
  const Fixture fixture = calendar_.at(index);
  add(meetings_[fixture.pairing], fixture, *decided);
  return !over();
}

void Tournament::add(Meeting& meeting, const Fixture& fixture, const campaign::Decided& decided) {
  const bool first_at_home = !fixture.swapped;
  meeting.goals[0] += static_cast<std::uint64_t>(decided.score[first_at_home ? 0 : 1]);
  meeting.goals[1] += static_cast<std::uint64_t>(decided.score[first_at_home ? 1 : 0]);
  const int goals = goals_of(decided, first_at_home);
  meeting.games.add(outcome(goals));
  meeting.goals_of_matches.add(std::clamp(goals, -plan_.most_goals, plan_.most_goals));
  if (decided.failure) {
    forfeits_.add(decided.failure->side == 0 ? fixture.home : fixture.away, *decided.failure, next_ - 1);
  }
  count_row(fixture, decided);
  if (first_at_home) {
    first_of_pair_ = decided;
    return;
  }
  assert(first_of_pair_);
  finish_pair(meeting, decided);
  first_of_pair_.reset();
  // At the end of pairs only, so that none is left half played.
  for (const std::size_t team : {fixture.home, fixture.away}) {
    const Row& row = rows_[team];
    if (plan_.failures_in_a_row == 0 || row.failures < static_cast<std::uint64_t>(plan_.failures_in_a_row)) continue;
    if (!is_set_aside(team)) set_aside_.push_back({team, row.plugin, row.failures, fixture.pair});
  }
}

void Tournament::finish_pair(Meeting& meeting, const campaign::Decided& second) {
  const campaign::Decided& first = *first_of_pair_;
  const int goals_first = goals_of(first, true), goals_second = goals_of(second, false);
  const statistics::PairOutcome pair = statistics::pair_outcome(outcome(goals_first), outcome(goals_second));
  meeting.pairs.add(pair);
  if (meeting.score_test) meeting.score_test->add(pair);
  const int most = plan_.most_goals;
  const double goals = (std::clamp(goals_first, -most, most) + std::clamp(goals_second, -most, most)) / 2.0;
  meeting.goals_of_pairs.add(goals);
  meeting.goals_sequence.add(goals);
  if (!meeting.metric) return;
  const std::string& path = *tested_metric(plan_.objective);
  if (first.failure || second.failure) {
    ++meeting.pairs_without_metric;
    return;
  }
  const auto a1 = metric(first.metrics, 0, path), b1 = metric(first.metrics, 1, path);
  const auto b2 = metric(second.metrics, 0, path), a2 = metric(second.metrics, 1, path);
  if (a1 && b1 && a2 && b2)
    meeting.metric->add((*a1 + *a2) / 2.0, (*b1 + *b2) / 2.0);
  else
    ++meeting.pairs_without_metric;
}

// A team that forfeits against itself has both its matches counted in the same row.
void Tournament::count_row(const Fixture& fixture, const campaign::Decided& decided) {
  for (const int side : {0, 1}) {
    Row& row = rows_[side == 0 ? fixture.home : fixture.away];
    if (!decided.failure) {
      row = {};
    } else if (decided.failure->side == side) {
      row.failures = row.plugin == decided.failure->plugin ? row.failures + 1 : 1;
      row.plugin = decided.failure->plugin;
    }  // else the others forfeited: this team was not put to the test
  }
}

bool Tournament::over() const {
  if (verdict() == Verdict::accept_h0 || verdict() == Verdict::accept_h1) return true;
  // Nobody is left to play against.
  return std::ranges::all_of(calendar_.pairings(), [&](const Pairing& pairing) {
    return is_set_aside(pairing.first) || is_set_aside(pairing.second);
  });
}

Verdict Tournament::verdict() const {
  if (std::holds_alternative<FixedNumber>(plan_.objective)) return Verdict::none;
  const Meeting& meeting = meetings_.front();
  if (meeting.score_test) {
    switch (meeting.score_test->verdict()) {
      case statistics::Verdict::accept_h0:
        return Verdict::accept_h0;
      case statistics::Verdict::accept_h1:
        return Verdict::accept_h1;
      case statistics::Verdict::inconclusive:
        return Verdict::inconclusive;
    }
  }
  const auto finding = meeting.metric ? meeting.metric->test().finding() : meeting.goals_sequence.finding(0.0);
  return finding == statistics::BettingTest::Finding::none ? Verdict::inconclusive : Verdict::accept_h1;
}

bool Tournament::first_has_more() const {
  const Meeting& meeting = meetings_.front();
  const auto finding = meeting.metric ? meeting.metric->test().finding() : meeting.goals_sequence.finding(0.0);
  return finding == statistics::BettingTest::Finding::above;
}

}  // namespace regista::study
