// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "campaign/match_setup.hpp"
#include "plugin/shared_object.hpp"
#include "statistics/paired_tests.hpp"

namespace regista::study {
namespace {

constexpr int steps = 4000;  // number of steps of the grid of mean differences

std::vector<double> adjusted(const std::vector<ScoreDifference>& of, double (ScoreDifference::*p)() const) {
  std::vector<double> out;
  for (const ScoreDifference& each : of) out.push_back((each.*p)());
  return out.empty() ? out : statistics::holm(out);
}

}  // namespace

ScoreDifference::ScoreDifference(double deviation, double alpha, std::size_t several, std::optional<double> widest,
                                 std::optional<double> bound)
    : counted_{statistics::SymmetricTest(deviation, alpha / static_cast<double>(several)), {}}, bound_(bound) {
  if (!widest) return;
  statistics::BettingDesign design{-*widest, *widest, alpha, std::min(deviation, *widest)};
  const statistics::BettingTest test(design, 0.0);
  design.alpha = alpha / static_cast<double>(several);
  counted_.test = OnMean{test, statistics::BettingGrid(design, steps)};
}

void ScoreDifference::add(double candidate, double base) {
  candidate_.add(candidate);
  base_.add(base);
  counted_.add(candidate - base);
  if (!either_way_) return;
  for (Evidence& each : *either_way_) each.add(candidate - base);
}

void ScoreDifference::add_unplayed() {
  ++unplayed_;
  if (!bound_) return;
  if (!either_way_) either_way_ = {counted_, counted_};
  (*either_way_)[0].add(-*bound_);
  (*either_way_)[1].add(*bound_);
}

double ScoreDifference::p_either_way() const {
  if (unplayed_ == 0) return p();
  if (!either_way_) return 1.0;
  double out = p();
  for (const Evidence& each : *either_way_) {
    if (each.candidate_more() != candidate_more()) return 1.0;
    out = std::max(out, each.p());
  }
  return out;
}

void ScoreDifference::Evidence::add(double difference) {
  seen.add(difference);
  if (auto* const mean = std::get_if<OnMean>(&test)) {
    mean->test.add(difference);
    mean->sequence.add(difference);
  } else {
    std::get<statistics::SymmetricTest>(test).add(difference);
  }
}

double ScoreDifference::Evidence::p() const {
  const auto* const mean = std::get_if<OnMean>(&test);
  return mean == nullptr ? std::get<statistics::SymmetricTest>(test).p() : mean->test.p();
}

bool ScoreDifference::Evidence::candidate_more() const {
  const auto* const mean = std::get_if<OnMean>(&test);
  if (mean == nullptr) return std::get<statistics::SymmetricTest>(test).above();
  using enum statistics::BettingTest::Finding;
  const auto found = mean->test.finding();
  return found == none ? seen.mean() > 0.0 : found == above;
}

statistics::Estimate ScoreDifference::estimate() const {
  const auto* const mean = std::get_if<OnMean>(&counted_.test);
  return {counted_.seen.mean(),
          mean == nullptr ? std::get<statistics::SymmetricTest>(counted_.test).interval() : mean->sequence.interval()};
}

Verification::Verification(std::size_t candidates, double confidence, double deviation, std::optional<double> widest,
                           std::optional<double> bound)
    : alpha_(1.0 - confidence), bound_(bound) {
  // The standard deviation of the difference of two independent scores.
  const double of_difference = std::sqrt(2.0) * deviation;
  of_.assign(candidates, ScoreDifference(of_difference, alpha_, std::max<std::size_t>(candidates, 1), widest, bound));
}

void Verification::add(double base, std::span<const double> candidates, const std::vector<bool>& unplayed) {
  assert(candidates.size() == of_.size());
  assert(unplayed.empty() || unplayed.size() == of_.size());
  ++pairs_;
  if (std::ranges::find(unplayed, true) != unplayed.end()) ++unplayed_;
  for (std::size_t i = 0; i < of_.size(); ++i) {
    if (!unplayed.empty() && unplayed[i])
      of_[i].add_unplayed();
    else if (!std::isnan(base) && !std::isnan(candidates[i]))
      of_[i].add(candidates[i], base);
  }
}

std::vector<double> Verification::adjusted() const { return study::adjusted(of_, &ScoreDifference::p_either_way); }

std::vector<VerifiedAs> Verification::findings() const {
  std::vector<VerifiedAs> out;
  const std::vector<double> p = adjusted(), without = study::adjusted(of_, &ScoreDifference::p);
  for (std::size_t i = 0; i < of_.size(); ++i) {
    out.push_back(p[i] > alpha_ && without[i] <= alpha_ ? VerifiedAs::prevented
                  : p[i] > alpha_                       ? VerifiedAs::undecided
                  : of_[i].candidate_more()             ? VerifiedAs::better
                                                        : VerifiedAs::worse);
  }
  return out;
}

// A prevented test is undecided if there is a bound, because the three tests may agree after more pairs.
bool Verification::decided() const {
  return std::ranges::all_of(findings(), [&](VerifiedAs each) {
    return each == VerifiedAs::prevented ? !bound_ : each != VerifiedAs::undecided;
  });
}

std::vector<Finalist> select_finalists(const MatchSource& source, const SearchFindings& found) {
  const TuningPlan& plan = source.plan;
  std::vector<ParameterValues> chosen;
  for (const ParameterValues& each : found.recommended) {
    if (chosen.size() < plan.finalists() && std::ranges::find(chosen, each) == chosen.end()) chosen.push_back(each);
  }
  PairBatch batch(plan, source.document, chosen, {TuningStage::selection, plan.first_seed(), 0, plan.selection_pairs});
  play_batch(source, batch);
  const double worst = worst_of(batch, chosen.size(), found.worst);
  std::vector<Finalist> out;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out.push_back(
        {chosen[i], seen_in_search(found.scores, chosen[i], plan.confidence()), played_score(plan, batch, i, worst)});
  }
  std::ranges::stable_sort(out, std::greater(), [](const Finalist& each) { return each.selected.counted; });
  return out;
}

std::vector<std::size_t> candidates_among(const TuningPlan& plan, const std::vector<Finalist>& finalists) {
  const ParameterValues base = start_values(plan);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < finalists.size() && i < plan.candidates(); ++i) {
    if (finalists[i].values == base) break;  // the later finalists have lower scores than the base team
    out.push_back(i);
  }
  return out;
}

double deviation_of(const std::vector<Finalist>& finalists, const SearchScores& scores) {
  double variance = 0.0;
  for (const Finalist& each : finalists) {
    const double deviation = each.selected.score.standard_deviation;
    variance += deviation * deviation / static_cast<double>(finalists.size());
  }
  if (variance > 0.0) return std::sqrt(variance);
  // With a single pair per finalist, the variance is 0. Then all scores of the search give the deviation.
  statistics::Moments all;
  for (const auto& [key, set] : scores) {
    for (const double each : set.scores) {
      if (!std::isnan(each)) all.add(each);
    }
  }
  return all.variance() > 0.0 ? all.standard_deviation() : 1.0;
}

std::uint64_t drawn_seed(const TuningPlan& plan, const TunedDocument& document,
                         const std::vector<ParameterValues>& chosen) {
  std::string all = fmt::format("{}\n{}\n{}\n", plan.seed(), in_words(plan.objective), plan.objective.minimise);
  for (const TuningOpponent& each : plan.opponents) {
    all += fmt::format("{} {}\n", each.weight,
                       campaign::fixture_key({}, each.jobs[0].away_inputs, each.jobs[0].common_inputs));
  }
  for (const ParameterValues& each : chosen) all += plugin::content_hash(document.with(each)) + '\n';
  return plugin::content_hash_32(all) & 0x7fffffffu;
}

std::vector<double> slice_values(const TuningPlan& plan, const ParameterValues& tuned, std::size_t parameter) {
  const Parameter& of = plan.parameters[parameter];
  std::vector<double> out;
  for (std::uint64_t i = 0; i < plan.slice_points(); ++i) {
    const double share =
        plan.slice_points() == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(plan.slice_points() - 1);
    const double value = value_at_share(of, share);
    if (value != tuned[parameter] && std::ranges::find(out, value) == out.end()) out.push_back(value);
  }
  return out;
}

Slice slice_of(std::size_t parameter, double tuned_value, std::span<const double> values,
               std::span<const std::vector<double>> scores, const std::vector<double>& tuned, double confidence) {
  Slice out;
  out.parameter = parameter;
  std::vector<std::vector<double>> all{tuned};
  for (std::size_t i = 0; i < values.size(); ++i) {
    out.points.push_back(
        {values[i], mean_of(scores[i], confidence), mean_of(paired_differences(scores[i], tuned), confidence)});
    all.push_back(scores[i]);
  }
  out.points.push_back({tuned_value, mean_of(tuned, confidence), {}});
  std::ranges::sort(out.points, {}, &SlicePoint::value);
  if (const auto found = statistics::two_way_analysis(all)) {
    out.importance = std::sqrt(found->variance_of_rows);
    out.p = found->p;
  }
  return out;
}

std::vector<Slice> slices_around(const MatchSource& source, const ParameterValues& tuned) {
  const TuningPlan& plan = source.plan;
  std::vector<Slice> out;
  if (plan.slice_points() == 0 || plan.slice_pairs() == 0) return out;
  std::vector<ParameterValues> points{tuned};
  std::vector<std::vector<double>> values(plan.parameters.size());
  for (std::size_t parameter = 0; parameter < plan.parameters.size(); ++parameter) {
    if (plan.parameters[parameter].fixed()) continue;
    values[parameter] = slice_values(plan, tuned, parameter);
    for (const double value : values[parameter]) {
      points.push_back(tuned);
      points.back()[parameter] = value;
    }
  }
  PairBatch batch(plan, source.document, points, {TuningStage::slices, plan.first_seed(), 0, plan.slice_pairs()});
  play_batch(source, batch);
  std::size_t next = 1;
  for (std::size_t parameter = 0; parameter < plan.parameters.size(); ++parameter) {
    if (plan.parameters[parameter].fixed()) continue;
    std::vector<std::vector<double>> scores;
    for (std::size_t i = 0; i < values[parameter].size(); ++i) scores.push_back(batch.scores(next++));
    out.push_back(slice_of(parameter, tuned[parameter], values[parameter], scores, batch.scores(0), plan.confidence()));
  }
  std::ranges::stable_sort(out, std::greater(), &Slice::importance);
  return out;
}

VerifiedAs TuningRecord::finding(std::size_t candidate) const {
  const VerifiedAs found = verification.findings()[candidate];
  return found == VerifiedAs::better && candidate_failed[candidate] ? VerifiedAs::undecided : found;
}

std::optional<std::size_t> TuningRecord::better() const {
  for (std::size_t i = 0; i < verification.of().size(); ++i) {
    if (finding(i) == VerifiedAs::better) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> TuningRecord::tuned() const {
  return candidates.empty() ? std::nullopt : std::optional(candidates[better().value_or(0)]);
}

void verify_candidates(const MatchSource& source, double deviation, TuningRecord& record) {
  const TuningPlan& plan = source.plan;
  std::vector<ParameterValues> played;
  for (const std::size_t each : record.candidates) played.push_back(record.finalists[each].values);
  const std::size_t candidates = played.size();
  record.verification =
      Verification(candidates, plan.confidence(), deviation, widest_difference(plan), difference_bound(plan));
  record.candidate_failed.assign(candidates, false);
  record.candidate_packets.assign(candidates, {});
  const std::uint64_t pairs = verification_pairs_of(plan, candidates);
  if (pairs == 0) return;
  const std::uint64_t first_seed = drawn_seed(plan, source.document, played);
  if (!plan.head_to_head()) played.push_back(start_values(plan));
  PairBatch batch(plan, source.document, played, {TuningStage::verification, first_seed, 0, pairs},
                  plan.head_to_head());
  play_batch(source, batch, [&] {
    std::vector<double> scores;
    std::vector<bool> unplayed;
    for (std::size_t i = 0; i < candidates; ++i) {
      scores.push_back(batch.scores(i).back());
      unplayed.push_back(batch.unplayed(i).back() || (!plan.head_to_head() && batch.unplayed(candidates).back()));
      record.candidate_failed[i] = batch.failed(i);
      record.candidate_packets[i] = batch.packets(i);
    }
    record.verification.add(plan.head_to_head() ? 0.0 : batch.scores(candidates).back(), scores, unplayed);
    return !record.verification.decided();
  });
}

void tune(const TuningPlan& plan, const PlayRound& play, const OutOfTime& out_of_time, TuningRecord& record) {
  const TunedDocument document(plan);
  const MatchSource source{plan, document, play, record.tally};

  const SearchFindings found = search_over_pairs(source, out_of_time, record.trace);
  record.ended = found.ended;

  record.stage = TuningStage::selection;
  record.finalists = select_finalists(source, found);
  record.candidates = candidates_among(plan, record.finalists);

  record.stage = TuningStage::verification;
  verify_candidates(source, deviation_of(record.finalists, found.scores), record);

  record.stage = TuningStage::slices;
  record.slices = slices_around(source, record.finalists[record.tuned().value_or(0)].values);

  record.stage.reset();
}

}  // namespace regista::study
