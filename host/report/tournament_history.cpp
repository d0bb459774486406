// SPDX-License-Identifier: MIT
#include "report/tournament_history.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "match/side.hpp"
#include "report/standing.hpp"
#include "statistics/rating.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_numbers = 600;  // largest number of a team's numbers
constexpr double alpha = 0.05;

// Finds the number with this path; null if it does not exist. The search begins at `hint`, behind the number that the
// last search found, because the numbers of all matches have the same order.
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

// Returns the parts that `part_of` extracts from the paths of the first `teams` teams, each part once, without "".
template <class PartOf>
std::vector<std::string> parts_of_paths(const MatchNumbers& numbers, std::size_t teams, PartOf part_of) {
  std::vector<std::string> out;
  for (std::size_t team = 0; team < teams; ++team) {
    for (const TeamNumber& each : numbers.of_team(team)) {
      const std::string part(part_of(each.path));
      if (!part.empty()) texts::add_once(out, part);
    }
  }
  return out;
}

bool is_of_plugin(std::string_view path) {
  return path.starts_with("plugin_totals.") || path.starts_with("plugin_values.");
}

constexpr std::size_t most_points = 600;  // largest number of points of a curve; a figure cannot show more points
constexpr std::size_t most_rankings = 120;

void count(GoalDifferences& counts, int difference, bool forfeited) {
  const int within = std::clamp(difference, -GoalDifferences::largest, GoalDifferences::largest);
  ++(forfeited ? counts.forfeited : counts.played)[static_cast<std::size_t>(within + GoalDifferences::largest)];
}

std::optional<double> packets_of(const campaign::MatchResult& decided) {
  const auto home = decided.metrics.of_side(match::Side::home, "packets"),
             away = decided.metrics.of_side(match::Side::away, "packets");
  return home && away ? std::optional(*home + *away) : std::nullopt;
}

}  // namespace

MatchNumbers::MatchNumbers(const study::TournamentPlan& plan)
    : teams_(plan.teams.size()), paired_(plan.teams.size() == 2) {}

MatchNumbers::Values MatchNumbers::values(const match::MetricNumbers& metrics, int side) {
  Values out = study::metric_values(metrics, side);
  std::array<std::optional<double>, role_measures.size()> sums;
  for (const study::NamedValue& each : out) {
    for (std::size_t i = 0; i < role_measures.size(); ++i) {
      if (each.path.ends_with(std::string(".") + role_measures[i])) sums[i] = sums[i].value_or(0.0) + each.value;
    }
  }
  for (std::size_t i = 0; i < role_measures.size(); ++i) {
    if (sums[i]) out.push_back({role_measures[i], *sums[i]});
  }
  return out;
}

void MatchNumbers::take(const study::Fixture& fixture, const campaign::MatchResult& decided) {
  if (!fixture.swapped || decided.metrics.empty()) first_of_pair_.reset();
  if (decided.metrics.empty()) return;
  std::array<Values, 2> sides{values(decided.metrics, 0), values(decided.metrics, 1)};
  for (const std::size_t side : {0u, 1u}) {
    std::vector<TeamNumber>& known = teams_[side == 0 ? fixture.home : fixture.away];
    std::size_t hint = 0;
    for (const study::NamedValue& each : sides[side]) {
      TeamNumber* found = search(known, each.path, hint);
      if (found == nullptr && known.size() < most_numbers) found = &known.emplace_back(TeamNumber{each.path, {}});
      if (found != nullptr) found->matches.add(each.value);
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
  for (const study::NamedValue& value : a1) {
    const study::NamedValue *const first_b = search(b1, value.path, in_b1),
                                   *const second_a = search(a2, value.path, in_a2),
                                   *const second_b = search(b2, value.path, in_b2);
    if (first_b == nullptr || second_a == nullptr || second_b == nullptr) continue;
    PairedNumber* found = search(pairs_, value.path, in_pairs);
    if (found == nullptr && pairs_.size() < most_numbers) {
      found = &pairs_.emplace_back(PairedNumber{value.path, study::MetricDifference(alpha)});
    }
    if (found != nullptr) {
      found->difference.add((value.value + second_a->value) / 2.0, (first_b->value + second_b->value) / 2.0);
    }
  }
}

const statistics::Moments* MatchNumbers::find(std::size_t team, const std::string& path) const {
  const auto found = std::ranges::find(teams_[team], path, &TeamNumber::path);
  return found == teams_[team].end() ? nullptr : &found->matches;
}

const study::MetricDifference* MatchNumbers::difference(const std::string& path) const {
  const auto found = std::ranges::find(pairs_, path, &PairedNumber::path);
  return found == pairs_.end() ? nullptr : &found->difference;
}

std::vector<std::string> role_names(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams, [](std::string_view path) {
    const std::string_view end = ".overlap_seconds";
    return path.ends_with(end) && !is_of_plugin(path) ? path.substr(0, path.size() - end.size()) : "";
  });
}

std::vector<std::string> packet_reasons(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams, [](std::string_view path) {
    const std::string_view begin = packets_prefix;
    return path.starts_with(begin) ? path.substr(begin.size()) : "";
  });
}

std::vector<std::string> plugin_metrics(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams, [](std::string_view path) { return is_of_plugin(path) ? path : ""; });
}

bool all_zero(const MatchNumbers& numbers, std::size_t teams, const std::string& path) {
  for (std::size_t team = 0; team < teams; ++team) {
    const statistics::Moments* const found = numbers.find(team, path);
    if (found != nullptr && found->mean() != 0.0) return false;
  }
  return true;
}

TournamentHistory::TournamentHistory(const study::TournamentPlan& plan, const study::Tournament& course,
                                     std::vector<std::uint64_t> recorded)
    : plan_(plan),
      course_(course),
      pair_points_(most_points),
      ranking_points_(most_rankings),
      goals_(plan.teams.size()),
      numbers_(plan),
      wanted_(std::move(recorded)) {}

void TournamentHistory::take(const campaign::MatchResult* decided) {
  const std::uint64_t index = course_.taken() - 1;
  const std::uint64_t before = std::exchange(matches_, course_.matches());
  const bool unplayed = course_.unplayed_pairs() != std::exchange(unplayed_pairs_, course_.unplayed_pairs());
  if (decided != nullptr && index % 2 == 0) {
    // The course does not count matches of teams that were set aside (excluded after too many failures). The history
    // ignores such a match, too.
    if (matches_ != before || decided->set_aside()) first_of_pair_ = {index, *decided};
  } else {
    const bool taken = unplayed || matches_ == before + 1;
    if (decided != nullptr && first_of_pair_ && taken) {
      record(*first_of_pair_, !unplayed);
      record({index, *decided}, !unplayed);
    }
    first_of_pair_.reset();
  }
  if (!course_.calendar().pairs_after(course_.taken())) return;
  if (plan_.teams.size() == 2) {
    pair_points_.offer([this] { return pair_point(); });
  } else if (plan_.teams.size() <= most_ranked) {
    ranking_points_.offer([this] { return ranking_point(); });
  }
}

void TournamentHistory::end() {
  if (first_of_pair_ && !first_of_pair_->decided.set_aside()) record(*first_of_pair_, true);
  first_of_pair_.reset();
}

void TournamentHistory::record(const Match& match, bool counts) {
  const auto& [index, decided] = match;
  const study::Fixture fixture = course_.calendar().at(index);
  fingerprint_.take(index, decided);
  if (counts) {
    const int difference = decided.score[0] - decided.score[1];
    count(goals_[fixture.home], difference, decided.failure.has_value());
    count(goals_[fixture.away], -difference, decided.failure.has_value());
    numbers_.take(fixture, decided);
  }
  if (decided.set_aside() || !std::ranges::binary_search(wanted_, index)) return;
  ++recorded_count_;
  if (recorded_.size() < most_recorded) {
    recorded_.push_back({index, decided.score, decided.failure.has_value(), packets_of(decided)});
  }
}

PairPoint TournamentHistory::pair_point() const {
  const study::Meeting& meeting = course_.meetings().front();
  PairPoint out;
  out.pair = static_cast<std::uint64_t>(total(meeting.pairs));
  if (out.pair > 0) out.elo = statistics::elo(score_law(meeting.pairs));
  if (meeting.score_test) {
    out.ratio = meeting.score_test->ratio().value;
    out.lower = meeting.score_test->stopping().lower;
    out.upper = meeting.score_test->stopping().upper;
  }
  out.value = meeting.metric ? meeting.metric->estimate()
                             : statistics::Estimate{meeting.goals_of_pairs.mean(), meeting.goals_sequence.interval()};
  return out;
}

RankingPoint TournamentHistory::ranking_point() const {
  RankingPoint out{course_.calendar().pairs_after(course_.taken()).value_or(0), {}};
  if (auto elo = statistics::bradley_terry_elo(points_won(plan_, course_))) out.elo = std::move(*elo);
  return out;
}

std::vector<PairPoint> TournamentHistory::pair_curve() const {
  return pair_points_.with_last([this] { return pair_point(); });
}

std::vector<RankingPoint> TournamentHistory::ranking_curve() const {
  return ranking_points_.with_last([this] { return ranking_point(); });
}

}  // namespace regista::report
