// SPDX-License-Identifier: MIT
#include "study/tuning/pair_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iterator>

#include "config/scalar.hpp"
#include "study/tuning/search.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// The first failure that caused a forfeit: of the tuned team if `of_tuned`, else of any other team; null: no failure.
const campaign::Failure* first_failure(const MatchTally& tally, bool of_tuned) {
  const std::vector<Forfeits>& listed = tally.forfeits.listed();
  const auto first =
      std::ranges::find_if(listed, [of_tuned](const Forfeits& each) { return (each.team == 0) == of_tuned; });
  return first == listed.end() ? nullptr : &first->failure;
}

std::string in_words(const campaign::Failure& failure, const std::string& team) {
  const std::string plugin = failure.plugin.empty() ? "a plugin of " + team : "plugin " + failure.plugin;
  const std::string call = failure.call.empty() ? "" : " in " + failure.call;
  return texts::one_line(plugin + call + ": " + failure.what);
}

std::string why_no_number(const MatchTally& tally) {
  const std::vector<MatchRemark>& unplayed = tally.remarks.unplayed.listed();
  if (!unplayed.empty()) return ": they could not be played: " + texts::one_line(unplayed.front().text);
  const campaign::Failure* const failure = first_failure(tally, false);
  return failure == nullptr ? "" : ": opponents forfeit: " + in_words(*failure, "an opponent");
}

// Answers the questions of a search with the scores of earlier matches, or with new matches.
class PairEvaluation {
 public:
  PairEvaluation(const MatchSource& source, std::uint64_t pairs, std::vector<SearchStep>& steps)
      : source_(source), pairs_(pairs), steps_(steps) {}

  // Returns the number that the search gets for each of `points`, and adds a step for each. Plays matches only for
  // points without a score on this set of pairs. set: Question::pairs, the number of the pairs that all points play.
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
    PairBatch batch(plan, source_.document, fresh, {TuningStage::search, plan.first_seed(), set * pairs_, pairs_});
    play_batch(source_, batch);
    worst = worst_of(batch, fresh.size(), worst);
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      const PlayedScore played = played_score(plan, batch, i, worst);
      if (steps_.empty()) check_base_team(plan, played, source_.tally);
      scores.emplace(std::pair(fresh[i], set), SetScores{batch.scores(i), played});
    }
  }

  void add_step(const ParameterValues& values, std::uint64_t set, const PlayedScore& played, bool repeated) {
    const double best = steps_.empty() ? played.counted : std::max(steps_.back().best, played.counted);
    const std::uint64_t matches = repeated ? 0 : pairs_ * source_.plan.matches_of_pair();
    steps_.push_back({steps_.size() + 1, set * pairs_, values, played, repeated, best,
                      matches + (steps_.empty() ? 0 : steps_.back().matches)});
  }

  const MatchSource& source_;
  std::uint64_t pairs_;
  std::vector<SearchStep>& steps_;
};

SearchSettings search_settings(const TuningPlan& plan, const ParameterValues& start) {
  SearchSettings out;
  out.start = point_of(plan, start);
  out.evaluations = plan.evaluations() - 1 - plan.starts.size();  // base team and given points are evaluated first
  // Points that rounding makes equal cost no matches. So algorithms that do not divide the budget into steps beforehand
  // may ask for more points.
  constexpr std::uint64_t most_repeats = 4;
  const bool plans = plan.algorithm() == Algorithm::spsa || plan.algorithm() == Algorithm::sep_cma_es ||
                     plan.algorithm() == Algorithm::random_search;
  if (!plans) out.evaluations *= most_repeats;
  out.seed = plan.seed();
  out.population = static_cast<std::size_t>(plan.population());
  return out;
}

using Clock = std::chrono::steady_clock;

// Keys in the file of results.
constexpr auto end_of_search = "search ended after";
constexpr auto time_of_search = "time of search";

// The number of points after which the time of the search was up; nullopt if the search did not end in this way.
std::optional<std::uint64_t> stored_end(const campaign::Store& store) {
  const std::string text = store.meta(end_of_search);
  if (text.empty()) return std::nullopt;
  const auto out = config::number_in<std::uint64_t>(text);
  if (!out) throw campaign::StoreError("the end of the search in the results is damaged");
  return out;
}

// The state of the search when it was last stored: number of points, and wall time.
struct SearchTime {
  std::uint64_t evaluations = 0;
  double seconds = 0.0;
};

SearchTime stored_time(const campaign::Store& store) {
  const std::string text = store.meta(time_of_search);
  SearchTime out;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, out.evaluations);
  if (error == std::errc() && rest != end) std::from_chars(rest + 1, end, out.seconds);
  return out;
}

}  // namespace

void check_base_team(const TuningPlan& plan, const PlayedScore& played, const MatchTally& tally) {
  if (played.failed) {
    const campaign::Failure* const failure = first_failure(tally, true);
    throw TuningError("the base team forfeits its first matches" +
                      (failure == nullptr ? std::string() : ": " + in_words(*failure, "the base team")));
  }
  if (played.score.pairs == 0) {
    throw TuningError(fmt::format("the base team's first matches have no number for the objective, {}{}",
                                  in_words(plan.objective), why_no_number(tally)));
  }
}

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
  std::vector<ParameterValues> first{start_values(plan)};
  std::vector<double> values_of_first = evaluation.of(first, 0);
  if (!plan.starts.empty()) {
    first.insert(first.end(), plan.starts.begin(), plan.starts.end());
    std::ranges::copy(evaluation.of(plan.starts, 0), std::back_inserter(values_of_first));
  }
  const auto best = std::ranges::max_element(values_of_first) - values_of_first.begin();
  const ParameterValues& start = first[static_cast<std::size_t>(best)];
  std::string stopped;
  SearchResult found = search(plan.algorithm(), search_settings(plan, start), [&](const Question& question) {
    if (steps.back().matches + matches > plan.evaluations() * matches) {
      stopped = "budget used up";
    } else if (out_of_time && out_of_time(steps.size())) {
      stopped = "its time was up";
    }
    if (!stopped.empty()) return std::vector<double>();
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

OutOfTime search_clock(campaign::Store& store, const TuningPlan& plan, std::optional<campaign::Moment> end_of_time) {
  if (stored_end(store)) return stored_end_of_search(store);
  if (!plan.asked.search.minutes && !end_of_time) return {};
  const double most = plan.asked.search.minutes ? 60.0 * *plan.asked.search.minutes : HUGE_VAL;
  return [&store, most, end_of_time, before = stored_time(store),
          began = std::optional<Clock::time_point>()](std::uint64_t evaluations) mutable {
    // The search repeats an earlier run from stored results, which takes no time, so the time limit does not stop it.
    if (evaluations < before.evaluations) return false;
    if (!began) began = Clock::now();
    const double seconds = before.seconds + std::chrono::duration<double>(Clock::now() - *began).count();
    store.set_meta(time_of_search, std::to_string(evaluations) + ' ' + config::real_text(seconds));
    const bool past = end_of_time && std::chrono::system_clock::now() >= *end_of_time;
    if (seconds < most && !past) return false;
    // Stores the end, so that the search ends at this point whenever the results are read.
    store.set_meta(end_of_search, std::to_string(evaluations));
    return true;
  };
}

OutOfTime stored_end_of_search(const campaign::Store& store) {
  return [ended = stored_end(store)](std::uint64_t evaluations) { return ended && evaluations >= *ended; };
}

}  // namespace regista::study
