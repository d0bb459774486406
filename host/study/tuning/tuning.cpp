// SPDX-License-Identifier: MIT
#include "study/tuning/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "campaign/inputs.hpp"
#include "config/text.hpp"
#include "plugin/content_hash.hpp"

namespace regista::study {
namespace {

class Course {
 public:
  Course(const TuningPlan& plan, const TuningHooks& hooks, TuningRecord& record)
      : plan_(plan), hooks_(hooks), record_(record), document_(plan) {}

  void search_and_verify() {
    const SearchResult found = search(plan_.algorithm, 0, true);
    record_.ended = out_of_time_ ? "its time was up" : found.ended;
    enter(TuningStage::selection);
    select(found.recommended);
    enter(TuningStage::verification);
    verify();
    enter(TuningStage::slices);
    slice();
    record_.stage.reset();
    progress();
  }

  void compare() {
    for (std::uint64_t repeat = 0; repeat < plan_.repeats; ++repeat) {
      for (const Algorithm algorithm : plan_.compared) {
        const std::uint64_t before = record_.matches;
        steps_.clear();
        known_.clear();
        worst_seen_ = HUGE_VAL;
        const SearchResult found = search(algorithm, repeat, false);
        ComparedRun& run = record_.compared.emplace_back();
        run.algorithm = algorithm;
        run.repeat = repeat;
        run.evaluations = steps_.size();
        run.matches = record_.matches - before;
        run.ended = found.ended;
        run.values = values_of(plan_, found.recommended.front());
        if (const auto seen = seen_in_search(run.values)) run.seen = seen->score.mean;
        progress();
      }
    }
    enter(TuningStage::verification);
    judge();
    record_.stage.reset();
    progress();
  }

 private:
  using Key = std::pair<ParameterValues, std::uint64_t>;  // values, set of pairs

  void enter(TuningStage stage) {
    record_.stage = stage;
    progress();
  }
  void progress() const {
    if (hooks_.progress) hooks_.progress();
  }

  // --- Search --------------------------------------------------------------------------------------------------------

  SearchResult search(Algorithm algorithm, std::uint64_t repeat, bool traced) {
    const std::uint64_t pairs = plan_.pairs_of(algorithm);
    traced_ = traced;
    SearchSettings settings;
    const ParameterValues start = start_values(plan_);
    settings.start = point_of(plan_, start);
    const std::uint64_t budget = plan_.evaluations(algorithm);
    settings.evaluations = budget - 1;  // the base team is looked at first
    // Points that whole numbers make equal cost no matches; who does not plan by its budget may ask for others instead.
    constexpr std::uint64_t most_repeats = 4;
    const bool plans =
        algorithm == Algorithm::spsa || algorithm == Algorithm::sep_cma_es || algorithm == Algorithm::random_search;
    if (!plans) settings.evaluations *= most_repeats;
    bool used_up = false;
    settings.seed = plan_.seed + repeat;
    settings.population = static_cast<std::size_t>(plan_.population);
    assess({start}, 0, pairs, repeat);
    SearchResult out = study::search(algorithm, settings, [&](const Question& question) {
      if (steps_.back().matches + pairs * plan_.matches_of_pair() > budget * pairs * plan_.matches_of_pair()) {
        used_up = true;
        return std::vector<double>();
      }
      if (traced && hooks_.out_of_time && hooks_.out_of_time(steps_.size())) {
        out_of_time_ = true;
        return std::vector<double>();
      }
      std::vector<ParameterValues> values;
      for (const Point& point : question.points) values.push_back(values_of(plan_, point));
      return assess(values, question.pairs, pairs, repeat);
    });
    if (used_up) out.ended = "budget used up";
    return out;
  }

  // What the search is told about points that play a set of pairs together.
  std::vector<double> assess(const std::vector<ParameterValues>& points, std::uint64_t set, std::uint64_t pairs,
                             std::uint64_t repeat) {
    std::vector<ParameterValues> fresh;
    for (const ParameterValues& each : points) {
      if (!known_.contains({each, set}) && std::ranges::find(fresh, each) == fresh.end()) fresh.push_back(each);
    }
    const std::size_t new_ones = fresh.size();
    if (new_ones > 0) {
      PairBatch batch(plan_, document_, fresh, {TuningStage::search, repeat, plan_.seed, set * pairs, pairs});
      play(batch);
      for (std::size_t i = 0; i < new_ones; ++i) learn(batch.scores(i));
      for (std::size_t i = 0; i < new_ones; ++i) {
        known_.emplace(Key{fresh[i], set}, Known{batch.scores(i), played(batch, i, steps_.size() + 1)});
      }
    }
    std::vector<double> out;
    for (const ParameterValues& each : points) {
      const Known& known = known_.at({each, set});
      const auto first = std::ranges::find(fresh, each);
      add_step(each, set * pairs, known.played, first == fresh.end(), pairs);
      if (first != fresh.end()) fresh.erase(first);
      out.push_back(known.played.counted);
    }
    progress();
    return out;
  }

  void add_step(const ParameterValues& values, std::uint64_t pairs_from, const PlayedScore& played, bool repeated,
                std::uint64_t pairs) {
    SearchStep step;
    step.evaluation = steps_.size() + 1;
    step.pairs_from = pairs_from;
    step.values = values;
    step.played = played;
    step.repeated = repeated;
    step.best = steps_.empty() ? played.counted : std::max(steps_.back().best, played.counted);
    step.matches = (steps_.empty() ? 0 : steps_.back().matches) + (repeated ? 0 : pairs * plan_.matches_of_pair());
    steps_.push_back(step);
    if (traced_) record_.trace.push_back(std::move(step));
  }

  void learn(const std::vector<double>& scores) {
    for (const double each : scores) {
      if (!std::isnan(each)) worst_seen_ = std::min(worst_seen_, each);
    }
  }

  // Of a batch's candidate. Throws TuningError where a score is wanted that no match has.
  PlayedScore played(const PairBatch& batch, std::size_t candidate, std::uint64_t evaluation) const {
    PlayedScore out{mean_of(batch.scores(candidate), plan_.confidence), batch.failed(candidate), 0.0};
    if (out.failed) {
      if (evaluation == 1)
        throw TuningError("the base team forfeits its first matches: " + why_failed("the base team", true));
      const std::optional<ScoreBounds> bounds = score_bounds(plan_);
      out.counted = bounds ? bounds->low : worst_seen_;
    } else if (out.score.pairs == 0) {
      if (evaluation == 1) {
        throw TuningError(fmt::format("the base team's first matches have no number for the objective, {}{}",
                                      in_words(plan_.objective), why_no_number()));
      }
      // An opponent's crash, or a metric that these matches do not have: known is only that it is not known to be good.
      out.counted = std::isfinite(worst_seen_) ? worst_seen_ : 0.0;
    } else {
      out.counted = out.score.mean;
    }
    return out;
  }

  std::string why_no_number() const {
    const std::vector<MatchRemark>& unplayed = record_.remarks.unplayed().listed();
    if (!unplayed.empty()) return ": they could not be played: " + config::one_line(unplayed.front().text);
    return record_.forfeits.listed().empty() ? "" : ": opponents forfeit: " + why_failed("an opponent", false);
  }

  // Precondition: the tuned team, or else one of the others, has forfeited.
  std::string why_failed(const std::string& team, bool tuned) const {
    const auto first = std::ranges::find_if(record_.forfeits.listed(),
                                            [tuned](const Forfeits& each) { return (each.team == 0) == tuned; });
    const campaign::Failure& failure = first->failure;
    const std::string plugin = failure.plugin.empty() ? "a plugin of " + team : "plugin " + failure.plugin;
    const std::string call = failure.call.empty() ? "" : " in " + failure.call;
    return config::one_line(plugin + call + ": " + failure.what);
  }

  // Over all pairs of the search that these values played.
  std::optional<PlayedScore> seen_in_search(const ParameterValues& values) const {
    std::vector<double> scores;
    bool failed = false, any = false;
    for (auto at = known_.lower_bound({values, 0}); at != known_.end() && at->first.first == values; ++at) {
      scores.insert(scores.end(), at->second.scores.begin(), at->second.scores.end());
      failed = failed || at->second.played.failed;
      any = true;
    }
    if (!any) return std::nullopt;
    PlayedScore out{mean_of(scores, plan_.confidence), failed, 0.0};
    out.counted = out.score.mean;
    return out;
  }

  // --- Selection -----------------------------------------------------------------------------------------------------

  void select(const std::vector<Point>& recommended) {
    std::vector<ParameterValues> chosen;
    for (const Point& point : recommended) {
      const ParameterValues values = values_of(plan_, point);
      if (chosen.size() < plan_.finalists && std::ranges::find(chosen, values) == chosen.end()) {
        chosen.push_back(values);
      }
    }
    PairBatch batch(plan_, document_, chosen, {TuningStage::selection, 0, plan_.seed, 0, plan_.selection_pairs});
    play(batch);
    for (std::size_t i = 0; i < chosen.size(); ++i) learn(batch.scores(i));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      record_.finalists.push_back({chosen[i], seen_in_search(chosen[i]), played(batch, i, steps_.size() + 1)});
    }
    std::ranges::stable_sort(record_.finalists, std::greater(),
                             [](const Finalist& each) { return each.selected.counted; });
    const ParameterValues base = start_values(plan_);
    for (std::size_t i = 0; i < record_.finalists.size() && i < plan_.candidates; ++i) {
      if (record_.finalists[i].values == base) break;  // those behind it are thought worse than it
      record_.candidates.push_back(i);
    }
  }

  // Standard deviation of a finalist's score over the pairs of the selection; 1 where nothing ever varied.
  double deviation_of_finalists() const {
    double variance = 0.0;
    for (const Finalist& each : record_.finalists) {
      const double deviation = each.selected.score.standard_deviation;
      variance += deviation * deviation / static_cast<double>(record_.finalists.size());
    }
    if (variance > 0.0) return std::sqrt(variance);
    // Of one pair nothing varies: then of all pairs of the search.
    statistics::Moments all;
    for (const auto& [key, known] : known_) {
      for (const double each : known.scores) {
        if (!std::isnan(each)) all.add(each);
      }
    }
    return all.variance() > 0.0 ? all.standard_deviation() : 1.0;
  }

  // --- Verification --------------------------------------------------------------------------------------------------

  // Another choice is verified on other seeds.
  std::uint64_t drawn_seed(const std::vector<ParameterValues>& chosen) const {
    std::string all = fmt::format("{}\n{}\n{}\n", plan_.seed, in_words(plan_.objective), plan_.objective.minimise);
    for (const TuningOpponent& each : plan_.opponents) {
      all += fmt::format("{} {}\n", each.weight,
                         campaign::fixture_key({}, each.jobs[0].away_inputs, each.jobs[0].common_inputs));
    }
    for (const ParameterValues& each : chosen) all += plugin::content_hash(document_.with(each)) + '\n';
    return std::stoull(plugin::content_hash(all).substr(0, 8), nullptr, 16) & 0x7fffffffu;
  }

  void verify() {
    std::vector<ParameterValues> chosen;
    for (const std::size_t each : record_.candidates) chosen.push_back(record_.finalists[each].values);
    record_.verification = Verification(chosen.size(), plan_.confidence, deviation_of_finalists(),
                                        widest_difference(plan_), difference_bound(plan_));
    record_.candidate_failed.assign(chosen.size(), false);
    record_.candidate_packets.assign(chosen.size(), {});
    const std::size_t candidates = chosen.size();
    const std::uint64_t pairs = verification_pairs_of(plan_, candidates);
    if (pairs == 0) return;
    const std::uint64_t first_seed = drawn_seed(chosen);
    if (!plan_.head_to_head) chosen.push_back(start_values(plan_));
    PairBatch batch(plan_, document_, chosen, {TuningStage::verification, 0, first_seed, 0, pairs}, plan_.head_to_head);
    play(batch, [&] {
      std::vector<double> scores;
      std::vector<bool> unplayed;
      for (std::size_t i = 0; i < candidates; ++i) {
        scores.push_back(batch.scores(i).back());
        unplayed.push_back(batch.unplayed(i).back() || (!plan_.head_to_head && batch.unplayed(candidates).back()));
        record_.candidate_failed[i] = batch.failed(i);
        record_.candidate_packets[i] = batch.packets(i);
      }
      record_.verification.add(plan_.head_to_head ? 0.0 : batch.scores(candidates).back(), scores, unplayed);
      progress();
      return !record_.verification.decided();
    });
  }

  // --- Slices --------------------------------------------------------------------------------------------------------

  void slice() {
    if (plan_.slice_points == 0 || plan_.slice_pairs == 0) return;
    const ParameterValues& tuned = record_.finalists[record_.tuned().value_or(0)].values;
    std::vector<ParameterValues> points{tuned};
    std::vector<std::vector<double>> values(plan_.parameters.size());
    for (std::size_t parameter = 0; parameter < plan_.parameters.size(); ++parameter) {
      if (plan_.parameters[parameter].fixed()) continue;
      values[parameter] = slice_values(plan_, tuned, parameter);
      for (const double value : values[parameter]) {
        points.push_back(tuned);
        points.back()[parameter] = value;
      }
    }
    PairBatch batch(plan_, document_, points, {TuningStage::slices, 0, plan_.seed, 0, plan_.slice_pairs});
    play(batch);
    std::size_t next = 1;
    for (std::size_t parameter = 0; parameter < plan_.parameters.size(); ++parameter) {
      if (plan_.parameters[parameter].fixed()) continue;
      std::vector<std::vector<double>> scores;
      for (std::size_t i = 0; i < values[parameter].size(); ++i) scores.push_back(batch.scores(next++));
      record_.slices.push_back(
          slice_of(parameter, tuned[parameter], values[parameter], scores, batch.scores(0), plan_.confidence));
    }
    std::ranges::stable_sort(record_.slices, std::greater(), &Slice::importance);
  }

  // --- Comparison of algorithms --------------------------------------------------------------------------------------

  void judge() {
    std::vector<ParameterValues> points;
    for (const ComparedRun& run : record_.compared) points.push_back(run.values);
    const std::uint64_t first_seed = drawn_seed(points);
    points.push_back(start_values(plan_));
    PairBatch batch(plan_, document_, points, {TuningStage::verification, 0, first_seed, 0, plan_.verification_pairs});
    play(batch);
    const std::vector<double>& base = batch.scores(points.size() - 1);
    for (std::size_t i = 0; i < record_.compared.size(); ++i) {
      record_.compared[i].judged = difference_of(batch.scores(i), base, plan_.confidence);
    }
  }

  // Plays a batch; after_pair: whether to go on.
  void play(PairBatch& batch, const std::function<bool()>& after_pair = {}) {
    batch.list().first_row = record_.matches;
    record_.matches += batch.list().matches.size();
    hooks_.play(batch.list(), [&](std::uint64_t, const campaign::Decided& decided) {
      const std::uint64_t unplayed = batch.unplayed_pairs();
      const bool pair = batch.take(decided, record_.forfeits, record_.remarks);
      record_.unplayed_pairs += batch.unplayed_pairs() - unplayed;
      return !pair || !after_pair || after_pair();
    });
  }

  struct Known {
    std::vector<double> scores;
    PlayedScore played;
  };

  const TuningPlan& plan_;
  const TuningHooks& hooks_;
  TuningRecord& record_;
  TunedDocument document_;
  std::map<Key, Known> known_;
  std::vector<SearchStep> steps_;
  bool traced_ = true, out_of_time_ = false;
  double worst_seen_ = HUGE_VAL;
};

}  // namespace

VerifiedAs TuningRecord::finding(std::size_t candidate) const {
  const VerifiedAs found = verification.findings()[candidate];
  return found == VerifiedAs::better && candidate_failed[candidate] ? VerifiedAs::undecided : found;
}

std::optional<std::size_t> TuningRecord::tuned() const {
  for (std::size_t i = 0; i < verification.of().size(); ++i) {
    if (finding(i) == VerifiedAs::better) return candidates[i];
  }
  return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

bool TuningRecord::verified() const {
  for (std::size_t i = 0; i < verification.of().size(); ++i) {
    if (finding(i) == VerifiedAs::better) return true;
  }
  return false;
}

void tune(const TuningPlan& plan, const TuningHooks& hooks, TuningRecord& record) {
  Course course(plan, hooks, record);
  if (plan.compares())
    course.compare();
  else
    course.search_and_verify();
}

}  // namespace regista::study
