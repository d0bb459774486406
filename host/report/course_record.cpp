// SPDX-License-Identifier: MIT
#include "report/course_record.hpp"

#include <algorithm>
#include <utility>

#include "match/side.hpp"
#include "report/elo_interval.hpp"
#include "report/standing.hpp"
#include "statistics/bradley_terry.hpp"
#include "statistics/rating.hpp"

namespace regista::report {
namespace {

constexpr std::size_t most_points = 600;  // of a curve: finer than a figure can show
constexpr std::size_t most_rankings = 120;

void count(GoalDifferences& counts, int difference, bool forfeited) {
  const int within = std::clamp(difference, -GoalDifferences::largest, GoalDifferences::largest);
  ++(forfeited ? counts.forfeited : counts.played)[static_cast<std::size_t>(within + GoalDifferences::largest)];
}

std::optional<double> packets_of(const campaign::Decided& decided) {
  const auto home = decided.metrics.of_side(match::Side::home, "packets"),
             away = decided.metrics.of_side(match::Side::away, "packets");
  return home && away ? std::optional(*home + *away) : std::nullopt;
}

}  // namespace

CourseRecord::CourseRecord(const study::TournamentPlan& plan, const study::Tournament& course,
                           std::vector<std::uint64_t> recorded)
    : plan_(plan),
      course_(course),
      pair_points_(most_points),
      ranking_points_(most_rankings),
      goals_(plan.teams.size()),
      numbers_(plan),
      wanted_(std::move(recorded)) {}

void CourseRecord::take(const campaign::Decided* decided) {
  const std::uint64_t index = course_.taken() - 1;
  const std::uint64_t before = std::exchange(matches_, course_.matches());
  const bool unplayed = course_.unplayed_pairs() != std::exchange(unplayed_pairs_, course_.unplayed_pairs());
  if (decided != nullptr && index % 2 == 0) {
    // The course leaves out what it was given of a team that was set aside.
    if (matches_ != before || decided->set_aside()) first_of_pair_ = {index, *decided};
  } else {
    const bool taken = unplayed || matches_ == before + 1;
    if (decided != nullptr && first_of_pair_ && taken) {
      const Pair pair = unplayed ? Pair::could_not_be_played : Pair::counted;
      record(*first_of_pair_, pair);
      record({index, *decided}, pair);
    }
    first_of_pair_.reset();
  }
  if (course_.taken() % (2 * course_.calendar().pairings().size()) != 0) return;
  if (plan_.teams.size() == 2) {
    pair_points_.offer([this] { return pair_point(); });
  } else if (plan_.teams.size() <= most_ranked) {
    ranking_points_.offer([this] { return ranking_point(); });
  }
}

void CourseRecord::end() {
  if (first_of_pair_ && !first_of_pair_->decided.set_aside()) record(*first_of_pair_, Pair::counted);
  first_of_pair_.reset();
}

void CourseRecord::record(const Match& match, Pair pair) {
  const auto& [index, decided] = match;
  const study::Fixture fixture = course_.calendar().at(index);
  fingerprint_.take(index, decided);
  if (pair == Pair::counted) {
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

PairPoint CourseRecord::pair_point() const {
  const study::Meeting& meeting = course_.meetings().front();
  PairPoint out;
  out.pair = static_cast<std::uint64_t>(total(meeting.pairs));
  if (out.pair > 0) out.elo = statistics::elo(score_law(meeting.pairs));
  out.enough = enough_for_interval(meeting.pairs);
  if (meeting.score_test) {
    out.ratio = meeting.score_test->ratio().value;
    out.lower = meeting.score_test->stopping().lower;
    out.upper = meeting.score_test->stopping().upper;
  }
  out.value = meeting.metric ? meeting.metric->estimate()
                             : statistics::Estimate{meeting.goals_of_pairs.mean(), meeting.goals_sequence.interval()};
  return out;
}

RankingPoint CourseRecord::ranking_point() const {
  RankingPoint out{course_.taken() / 2 / course_.calendar().pairings().size(), {}};
  if (auto elo = statistics::bradley_terry_elo(points_won(plan_, course_))) out.elo = std::move(*elo);
  return out;
}

std::vector<PairPoint> CourseRecord::pair_curve() const {
  return pair_points_.with_last([this] { return pair_point(); });
}

std::vector<RankingPoint> CourseRecord::ranking_curve() const {
  return ranking_points_.with_last([this] { return ranking_point(); });
}

}  // namespace regista::report
