// SPDX-License-Identifier: MIT
#include "study/tournament_course.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "match/side.hpp"

namespace regista::study {
namespace {

constexpr double usual_alpha = 0.05;
// The number of steps of the grid of mean goal differences. If ten goals is the largest difference, a step is 0.005.
constexpr int goal_steps = 4000;
// The expected standard deviation of a pair's mean goal difference, before the first pair.
constexpr double usual_goals = 1.0;

int goals_of(const campaign::MatchResult& decided, bool first_at_home) {
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

// The path of the metric that the tournament tests; null if it tests no metric.
const std::string* tested_metric(const Objective& objective) {
  const auto* const value = std::get_if<ValueTest>(&objective);
  return value == nullptr || value->value == goals_value ? nullptr : &value->value;
}

// The result of a pair of matches, from the first team's point of view.
struct PairResult {
  statistics::PairOutcome outcome = statistics::PairOutcome::even;
  double goals = 0.0;       // mean goal difference of its matches, limited to the bounds of the test
  std::optional<int> sign;  // sign of the metric's difference; nullopt if a match lacks the metric
};

void add(ObjectiveTest& test, const PairResult& pair) {
  if (auto* const scores = std::get_if<statistics::SequentialTest>(&test)) {
    scores->add(pair.outcome);
  } else if (auto* const goals = std::get_if<statistics::BettingGrid>(&test)) {
    goals->add(pair.goals);
  } else if (pair.sign) {
    std::get<statistics::BettingTest>(test).add(*pair.sign);
  }
}

// The finding of a test. 1: H1, or larger values of the first team. -1: H0, or larger values of the second. 0: none.
int found_by(const statistics::SequentialTest& scores) {
  using enum statistics::Verdict;
  return scores.verdict() == accept_h1 ? 1 : scores.verdict() == accept_h0 ? -1 : 0;
}
int found_by(statistics::BettingTest::Finding finding) {
  using enum statistics::BettingTest::Finding;
  return finding == above ? 1 : finding == below ? -1 : 0;
}
int found_by(const statistics::BettingGrid& goals) { return found_by(goals.finding(0.0)); }
int found_by(const statistics::BettingTest& signs) { return found_by(signs.finding()); }
int found_by(const ObjectiveTest& test) {
  return std::visit([](const auto& each) { return found_by(each); }, test);
}

// The finding of the test from the played pairs alone.
int found_without(const Meeting& meeting) {
  if (meeting.score_test) return found_by(*meeting.score_test);
  return meeting.metric ? found_by(meeting.metric->test()) : found_by(meeting.goals_sequence);
}

ObjectiveTest test_of(const Meeting& meeting) {
  if (meeting.score_test) return *meeting.score_test;
  if (meeting.metric) return meeting.metric->test();
  return meeting.goals_sequence;
}

// The verdict for a finding. In a test on a value, a finding for either team means H1.
Verdict verdict_of(const Meeting& meeting, int found) {
  if (found == 0) return Verdict::inconclusive;
  return meeting.score_test && found < 0 ? Verdict::accept_h0 : Verdict::accept_h1;
}

}  // namespace

MetricDifference::MetricDifference(double alpha) : alpha_(alpha), test_({-1.0, 1.0, alpha}, 0.0) {}

void MetricDifference::add(double first, double second) {
  first_.add(first);
  second_.add(second);
  difference_.add(first - second);
  const int sign = first > second ? 1 : first < second ? -1 : 0;
  ++signs_[static_cast<std::size_t>(sign + 1)];
  test_.add(sign);
}

statistics::Estimate MetricDifference::estimate() const {
  const double mean = difference_.mean(), variance = difference_.variance();
  double half = std::numeric_limits<double>::infinity();
  // A mixing variance of 1/16 of the variance finds a mean of 1/4 standard deviation fastest, in about forty pairs.
  if (variance > 0.0) {
    half = statistics::mixture_half_width({difference_.count(), variance, variance / 16.0}, alpha_);
  }
  return {mean, {mean - half, mean + half}};
}

Meeting::Meeting(const TournamentPlan& plan, const Pairing& who)
    : pairing(who),
      goals_sequence({-static_cast<double>(plan.most_goals), static_cast<double>(plan.most_goals),
                      alpha_of(plan.objective()), usual_goals},
                     goal_steps) {
  const Objective objective = plan.objective();
  if (const auto* const score = std::get_if<ScoreTest>(&objective)) score_test.emplace(score->design);
  if (tested_metric(objective) != nullptr) metric.emplace(alpha_of(objective));
}

Tournament::Tournament(const TournamentPlan& plan)
    : plan_(plan),
      objective_(plan.objective()),
      calendar_(plan),
      forfeits_(plan.teams.size()),
      packets_(plan.teams.size()),
      rows_(plan.teams.size()) {
  for (const Pairing& pairing : calendar_.pairings()) meetings_.emplace_back(plan, pairing);
}

campaign::Metrics Tournament::metrics() const {
  if (tested_metric(objective_) != nullptr) return campaign::Metrics::wanted;
  return plan_.short_games() ? campaign::Metrics::packets : campaign::Metrics::left_out;
}

Round Tournament::round(std::uint64_t first, std::uint64_t end) {
  Round out;
  out.first_row = first;
  out.matches = end - first;
  out.fixtures = fixtures(plan_);
  out.at = [this, first](std::uint64_t index) -> std::optional<Round::Place> {
    if (!wanted(first + index)) return std::nullopt;
    const Fixture fixture = calendar_.at(first + index);
    return Round::Place{fixture.number, fixture.seed};
  };
  out.job = [this, first](std::uint64_t index) { return job(plan_, calendar_.at(first + index)); };
  out.take = [this](std::uint64_t, const campaign::MatchResult* decided) { return take(decided); };
  out.may_end_early = !std::holds_alternative<FixedNumber>(objective_) || plan_.ended_after;
  // 0: no time limit (--until, --minutes) may stop a tournament in rounds (Swiss or knock-out). Otherwise some of its
  // teams would have played more matches than others.
  out.matches_of_a_pair = calendar_.rounds() > 0 ? 0 : 2 * calendar_.pairings().size();
  out.first_of_pairing = [this, first](std::uint64_t index) {
    const Fixture fixture = calendar_.at(first + index);
    return fixture.pair % plan_.pairs() == 0 && !fixture.swapped;
  };
  return out;
}

void Tournament::run(const PlayRound& play) {
  if (calendar_.rounds() == 0) play(round(0, calendar_.matches()));
  while (calendar_.drawn().size() < calendar_.rounds()) {
    const std::uint64_t first = calendar_.drawn_matches();
    calendar_.draw(next_round());
    if (calendar_.drawn_matches() > first) play(round(first, calendar_.drawn_matches()));
    if (next_ < calendar_.drawn_matches()) return;  // not played to its end
  }
}

std::vector<std::size_t> Tournament::next_round() const {
  std::vector<Pairing> meetings;
  if (plan_.asked.format == config::Tournament::Format::knock_out) {
    meetings = knock_out_round(plan_.teams.size(), calendar_.drawn().size(),
                               [this](const Pairing& pair) { return winner(meetings_[calendar_.index_of(pair)]); });
  } else {
    meetings = swiss_round(swiss_standing());
  }
  std::vector<std::size_t> out;
  for (const Pairing& each : meetings) out.push_back(calendar_.index_of(each));
  return out;
}

std::size_t Tournament::winner(const Meeting& meeting) const {
  const auto& [first, second] = meeting.pairing;
  if (is_set_aside(first) != is_set_aside(second)) return is_set_aside(first) ? second : first;
  const std::int64_t wins = meeting.games.seen[2], losses = meeting.games.seen[0];
  if (wins != losses) return wins > losses ? first : second;
  return meeting.goals[1] > meeting.goals[0] ? second : first;
}

SwissStanding Tournament::swiss_standing() const {
  const std::size_t teams = plan_.teams.size();
  SwissStanding out{std::vector<double>(teams, 0.0), std::vector<char>(teams, 1), std::vector<char>(teams, 0),
                    std::vector(teams, std::vector<char>(teams, 0))};
  for (std::size_t team = 0; team < teams; ++team) out.plays[team] = is_set_aside(team) ? 0 : 1;
  for (const Meeting& meeting : meetings_) {
    const auto& [first, second] = meeting.pairing;
    const double even = 0.5 * static_cast<double>(meeting.games.seen[1]);
    out.points[first] += static_cast<double>(meeting.games.seen[2]) + even;
    out.points[second] += static_cast<double>(meeting.games.seen[0]) + even;
  }
  for (const std::vector<std::size_t>& round : calendar_.drawn()) {
    std::vector<char> without(teams, 1);
    for (const std::size_t pairing : round) {
      const auto& [first, second] = meetings_[pairing].pairing;
      without[first] = without[second] = 0;
      out.met[first][second] = out.met[second][first] = 1;
    }
    for (std::size_t team = 0; team < teams; ++team) {
      if (without[team] == 0) continue;
      out.had_bye[team] = 1;
      out.points[team] += 2.0 * static_cast<double>(plan_.pairs());  // as if it had won
    }
  }
  return out;
}

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

bool Tournament::take(const campaign::MatchResult* decided) {
  const std::uint64_t index = next_++;
  // The result of an unwanted match may exist, because the match was played or read before its team was set aside.
  if (decided == nullptr || !wanted(index)) return !over();
  remarks_.take(index, *decided);
  const Fixture fixture = calendar_.at(index);
  add(meetings_[fixture.pairing], fixture, *decided);
  return !over();
}

std::uint64_t Tournament::unplayed_pairs() const {
  std::uint64_t sum = 0;
  for (const Meeting& meeting : meetings_) sum += meeting.unplayed_pairs;
  return sum;
}

void Tournament::add(Meeting& meeting, const Fixture& fixture, const campaign::MatchResult& decided) {
  const bool first_at_home = !fixture.swapped;
  if (decided.set_aside() && ++meeting.set_aside == most_set_aside && unplayable_.empty()) {
    const auto label = [this](std::size_t team) { return plan_.teams[team].label; };
    unplayable_ = why_unplayable(label(meeting.pairing.first) + " against " + label(meeting.pairing.second),
                                 decided.why_set_aside);
  }
  if (first_at_home) {
    before_pair_ = {meeting.games,
                    meeting.goals,
                    meeting.goals_of_matches,
                    forfeits_,
                    {packets_[fixture.home], packets_[fixture.away]}};
  }
  count_row(fixture, decided);
  if (first_at_home) {
    if (!decided.set_aside()) count_match(meeting, fixture, decided);
    first_of_pair_ = decided;
    return;
  }
  assert(first_of_pair_);
  if (decided.set_aside() || first_of_pair_->set_aside()) {
    leave_out_pair(meeting, fixture);
  } else {
    count_match(meeting, fixture, decided);
    finish_pair(meeting, decided);
  }
  first_of_pair_.reset();
  // A team is set aside (plays no more matches) only at the end of a pair, so that every pair is complete.
  for (const std::size_t team : {fixture.home, fixture.away}) {
    const Row& row = rows_[team];
    const int most = plan_.asked.failures_in_a_row;
    if (most == 0 || row.failures < static_cast<std::uint64_t>(most)) continue;
    if (!is_set_aside(team)) set_aside_.push_back({team, row.plugin, row.failures, fixture.pair});
  }
}

void Tournament::count_match(Meeting& meeting, const Fixture& fixture, const campaign::MatchResult& decided) {
  const bool first_at_home = !fixture.swapped;
  meeting.goals[0] += static_cast<std::uint64_t>(decided.score[first_at_home ? 0 : 1]);
  meeting.goals[1] += static_cast<std::uint64_t>(decided.score[first_at_home ? 1 : 0]);
  const int goals = goals_of(decided, first_at_home);
  meeting.games.add(outcome(goals));
  meeting.goals_of_matches.add(std::clamp(goals, -plan_.most_goals, plan_.most_goals));
  if (decided.failure) {
    forfeits_.add(decided.failure->side == 0 ? fixture.home : fixture.away, *decided.failure, next_ - 1);
  }
  if (!plan_.short_games() || decided.metrics.empty()) return;
  const auto packets = short_games_.of(decided.metrics);
  if (!packets) return;
  packets_[fixture.home].add((*packets)[0]);
  packets_[fixture.away].add((*packets)[1]);
}

void Tournament::finish_pair(Meeting& meeting, const campaign::MatchResult& second) {
  const campaign::MatchResult& first = *first_of_pair_;
  const int goals_first = goals_of(first, true), goals_second = goals_of(second, false);
  PairResult pair{statistics::pair_outcome(outcome(goals_first), outcome(goals_second)), 0.0, std::nullopt};
  meeting.pairs.add(pair.outcome);
  if (meeting.score_test) meeting.score_test->add(pair.outcome);
  const int most = plan_.most_goals;
  const int goals_of_both = std::clamp(goals_first, -most, most) + std::clamp(goals_second, -most, most);
  ++meeting.goals_by_pair[goals_of_both];
  pair.goals = goals_of_both / 2.0;
  meeting.goals_of_pairs.add(pair.goals);
  meeting.goals_sequence.add(pair.goals);
  if (meeting.metric) {
    const std::string& path = *tested_metric(objective_);
    const bool forfeited = first.failure || second.failure;
    using match::Side;
    const auto value = [&](const campaign::MatchResult& decided, Side side) {
      return forfeited ? std::nullopt : decided.metrics.of_side(side, path);
    };
    const auto a1 = value(first, Side::home), b1 = value(first, Side::away);
    const auto b2 = value(second, Side::home), a2 = value(second, Side::away);
    if (a1 && b1 && a2 && b2) {
      const double of_first = (*a1 + *a2) / 2.0, of_second = (*b1 + *b2) / 2.0;
      meeting.metric->add(of_first, of_second);
      pair.sign = of_first > of_second ? 1 : of_first < of_second ? -1 : 0;
    } else {
      ++meeting.pairs_without_metric;
    }
  }
  if (!meeting.either_way) return;
  for (ObjectiveTest& test : *meeting.either_way) study::add(test, pair);
}

// Counts the current pair as unplayed. If its first match was counted, removes this match from the counts.
void Tournament::leave_out_pair(Meeting& meeting, const Fixture& fixture) {
  meeting.games = before_pair_.games;
  meeting.goals = before_pair_.goals;
  meeting.goals_of_matches = before_pair_.goals_of_matches;
  forfeits_ = before_pair_.forfeits;
  // The away team of this match was at home in the first match of the pair.
  packets_[fixture.away] = before_pair_.packets[0];
  packets_[fixture.home] = before_pair_.packets[1];
  ++meeting.unplayed_pairs;
  if (std::holds_alternative<FixedNumber>(objective_)) return;
  if (!meeting.either_way) meeting.either_way = {test_of(meeting), test_of(meeting)};
  // Counts the pair as the largest loss, then the largest win of the first team. A metric's test uses only signs.
  const double goals = plan_.most_goals;
  study::add((*meeting.either_way)[0], {statistics::PairOutcome::two_losses, -goals, -1});
  study::add((*meeting.either_way)[1], {statistics::PairOutcome::two_wins, goals, 1});
}

// Counts each team's failures in a row by the same plugin. A match without a failure sets both teams' counts to zero. A
// match in which the opponent failed does not change a team's count.
void Tournament::count_row(const Fixture& fixture, const campaign::MatchResult& decided) {
  if (decided.set_aside()) return;  // such a match counts for neither team
  for (const int side : {0, 1}) {
    Row& row = rows_[side == 0 ? fixture.home : fixture.away];
    if (!decided.failure) {
      row = {};
    } else if (decided.failure->side == side) {
      // A failure of an unknown plugin may belong to any plugin.
      const std::string& plugin = decided.failure->plugin;
      const bool same = row.plugin == plugin || row.plugin.empty() || plugin.empty();
      row.plugin = row.failures == 0 || !same || row.plugin == plugin ? plugin : "";
      row.failures = same ? row.failures + 1 : 1;
    }  // the opponent forfeited: the count does not change
  }
}

// Returns whether each pairing has a team that was set aside, so that no match is left.
bool Tournament::nobody_is_left() const {
  return std::ranges::all_of(calendar_.pairings(), [&](const Pairing& pairing) {
    return is_set_aside(pairing.first) || is_set_aside(pairing.second);
  });
}

bool Tournament::over() const {
  const Verdict now = verdict();
  return now == Verdict::accept_h0 || now == Verdict::accept_h1 || now == Verdict::prevented || nobody_is_left() ||
         (plan_.ended_after && at_its_end());
}

Verdict Tournament::verdict() const {
  if (std::holds_alternative<FixedNumber>(objective_)) return Verdict::none;
  const Meeting& meeting = meetings_.front();
  const int found = found_without(meeting);
  if (!meeting.either_way) return verdict_of(meeting, found);
  const int if_lost = found_by((*meeting.either_way)[0]), if_won = found_by((*meeting.either_way)[1]);
  if (found == if_lost && found == if_won) return verdict_of(meeting, found);
  // A test never withdraws its finding. So if two of the tests have opposite findings, the three tests can never agree.
  const bool at_odds = found * if_lost < 0 || found * if_won < 0 || if_lost * if_won < 0;
  return at_odds || at_its_end() ? Verdict::prevented : Verdict::inconclusive;
}

bool Tournament::first_has_more() const { return found_without(meetings_.front()) > 0; }

}  // namespace regista::study
