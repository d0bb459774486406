// SPDX-License-Identifier: MIT
#include "study/tuning/pair_search.hpp"

#include <algorithm>

#include "study/tuning/base_team_check.hpp"
#include "study/tuning/search.hpp"

namespace regista::study {
namespace {

// The value of points for one search: what was played, and what is played for the next question.
class PairEvaluation {
 public:
  PairEvaluation(const MatchSource& source, std::uint64_t pairs, std::vector<SearchStep>& steps)
      : source_(source), pairs_(pairs), steps_(steps) {}

  // What the search is told about points that play a set of pairs together.
  std::vector<double> of(const std::vector<ParameterValues>& points, std::uint64_t set) {
    std::vector<ParameterValues> fresh;
    for (const ParameterValues& each : points) {
      if (!scores.contains({each, set}) && std::ranges::find(fresh, each) == fresh.end()) fresh.push_back(each);
    }
    if (!fresh.empty()) play(fresh, set);
    std::vector<double> out;
    for (const ParameterValues& each : points) {
      const PlayedScore& played = scores.at({each, set}).played;
      const auto first = std::ranges::find(fresh, each);
      add_step(each, set, played, first == fresh.end());
      if (first != fresh.end()) fresh.erase(first);
      out.push_back(played.counted);
    }
    return out;
  }

  SearchScores scores;
  double worst = HUGE_VAL;

 private:
  void play(const std::vector<ParameterValues>& fresh, std::uint64_t set) {
    const TuningPlan& plan = source_.plan;
    PairBatch batch(plan, source_.document, fresh, {TuningStage::search, plan.seed(), set * pairs_, pairs_});
    play_batch(source_, batch);
    worst = worst_of(batch, fresh.size(), worst);
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      const PlayedScore played = played_score(plan, batch, i, worst);
      if (steps_.empty()) check_base_team(plan, played, source_.tally);
      scores.emplace(std::pair(fresh[i], set), SetScores{batch.scores(i), played});
    }
  }

  void add_step(const ParameterValues& values, std::uint64_t set, const PlayedScore& played, bool repeated) {
    SearchStep step;
    step.evaluation = steps_.size() + 1;
    step.pairs_from = set * pairs_;
    step.values = values;
    step.played = played;
    step.repeated = repeated;
    step.best = steps_.empty() ? played.counted : std::max(steps_.back().best, played.counted);
    step.matches =
        (steps_.empty() ? 0 : steps_.back().matches) + (repeated ? 0 : pairs_ * source_.plan.matches_of_pair());
    steps_.push_back(std::move(step));
  }

  const MatchSource& source_;
  std::uint64_t pairs_;
  std::vector<SearchStep>& steps_;
};

SearchSettings settings_of(const TuningPlan& plan) {
  SearchSettings out;
  out.start = point_of(plan, start_values(plan));
  out.evaluations = plan.evaluations() - 1;  // the base team is looked at first
  // Points that whole numbers make equal cost no matches; who does not plan by its budget may ask for others instead.
  constexpr std::uint64_t most_repeats = 4;
  const bool plans = plan.algorithm() == Algorithm::spsa || plan.algorithm() == Algorithm::sep_cma_es ||
                     plan.algorithm() == Algorithm::random_search;
  if (!plans) out.evaluations *= most_repeats;
  out.seed = plan.seed();
  out.population = static_cast<std::size_t>(plan.population());
  return out;
}

}  // namespace

std::optional<PlayedScore> seen_in_search(const SearchScores& scores, const ParameterValues& values,
                                          double confidence) {
  std::vector<double> all;
  bool failed = false, any = false;
  for (auto at = scores.lower_bound({values, 0}); at != scores.end() && at->first.first == values; ++at) {
    all.insert(all.end(), at->second.scores.begin(), at->second.scores.end());
    failed = failed || at->second.played.failed;
    any = true;
  }
  if (!any) return std::nullopt;
  PlayedScore out{mean_of(all, confidence), failed, 0.0};
  out.counted = out.score.mean;
  return out;
}

SearchFindings search_over_pairs(const MatchSource& source, const OutOfTime& out_of_time,
                                 std::vector<SearchStep>& steps) {
  const TuningPlan& plan = source.plan;
  const std::uint64_t pairs = plan.pairs_of_evaluation(), matches = pairs * plan.matches_of_pair();
  PairEvaluation evaluation(source, pairs, steps);
  evaluation.of({start_values(plan)}, 0);
  std::string stopped;
  SearchResult found = search(plan.algorithm(), settings_of(plan), [&](const Question& question) {
    if (steps.back().matches + matches > plan.evaluations() * matches) {
      stopped = "budget used up";
      return std::vector<double>();
    }
    if (out_of_time && out_of_time(steps.size())) {
      stopped = "its time was up";
      return std::vector<double>();
    }
    std::vector<ParameterValues> values;
    for (const Point& point : question.points) values.push_back(values_of(plan, point));
    return evaluation.of(values, question.pairs);
  });
  SearchFindings out;
  for (const Point& each : found.recommended) out.recommended.push_back(values_of(plan, each));
  out.ended = stopped.empty() ? std::move(found.ended) : std::move(stopped);
  out.scores = std::move(evaluation.scores);
  out.worst = evaluation.worst;
  return out;
}

}  // namespace regista::study
