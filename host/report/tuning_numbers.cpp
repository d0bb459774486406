// SPDX-License-Identifier: MIT
#include "report/tuning_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/distributions.hpp"
#include "study/measure.hpp"

namespace regista::report {
namespace {

// No minus before zero.
double without_sign_of_nought(double value) { return value == 0.0 ? 0.0 : value; }

statistics::Interval turned(const study::TuningObjective& objective, const statistics::Interval& scores) {
  const double a = report::of_objective(objective, scores.low), b = report::of_objective(objective, scores.high);
  return {std::min(a, b), std::max(a, b)};
}

study::MeanEstimate mean_of(const statistics::Moments& moments, double confidence) {
  study::MeanEstimate out;
  out.pairs = moments.count();
  out.mean = moments.mean();
  out.standard_deviation = moments.standard_deviation();
  if (out.pairs < 2 || out.standard_deviation == 0.0) return out;
  const double margin = statistics::student_t_quantile(0.5 + confidence / 2.0, static_cast<double>(out.pairs - 1)) *
                        out.standard_deviation / std::sqrt(static_cast<double>(out.pairs));
  out.interval = {out.mean - margin, out.mean + margin};
  return out;
}

RangeEnd end_of(const study::Parameter& parameter, double value) {
  constexpr double near = 0.01;
  const double share = study::share_of(parameter, value);
  return share <= near ? RangeEnd::lower : share >= 1.0 - near ? RangeEnd::upper : RangeEnd::none;
}

}  // namespace

double of_objective(const study::TuningObjective& objective, double score) {
  return without_sign_of_nought(study::value_of(objective, score));
}

statistics::Estimate of_objective(const study::TuningObjective& objective, const statistics::Estimate& score) {
  return {of_objective(objective, score.value), turned(objective, score.interval)};
}

study::MeanEstimate of_objective(const study::TuningObjective& objective, study::MeanEstimate score) {
  score.mean = of_objective(objective, score.mean);
  if (score.interval) score.interval = turned(objective, *score.interval);
  return score;
}

std::string unit_of(const study::TuningObjective& objective) {
  const bool one = objective.terms.size() == 1 && objective.terms.front().weight == 1.0;
  return one ? study::unit_of(objective.terms.front().measure) : std::string();
}

MatchesByStage matches_by_stage(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  const std::uint64_t pair = plan.matches_of_pair();
  MatchesByStage out;
  if (!record.trace.empty()) out.search = record.trace.back().matches;
  out.selection = record.finalists.size() * plan.selection_pairs * pair;
  const std::uint64_t candidates = record.verification.of().size();
  out.verification = record.verification.pairs() * (plan.head_to_head() ? 2 * candidates : (candidates + 1) * pair);
  if (record.slices.empty()) return out;
  std::uint64_t points = 1;  // the tuned one, which all slices share
  for (const study::Slice& each : record.slices) points += each.points.size() - 1;
  out.slices = points * plan.slice_pairs() * pair;
  return out;
}

const study::SearchStep* best_step(const study::TuningRecord& record) {
  const study::SearchStep* best = nullptr;
  for (const study::SearchStep& each : record.trace) {
    if (best == nullptr || each.played.counted > best->played.counted) best = &each;
  }
  return best;
}

std::vector<TunedValue> tuned_values(const TuningView& view) {
  const std::optional<std::size_t> kept = view.record.tuned();
  std::vector<TunedValue> out;
  if (!kept) return out;
  for (std::size_t i = 0; i < view.plan.parameters.size(); ++i) {
    const study::Parameter& parameter = view.plan.parameters[i];
    if (parameter.fixed()) continue;
    const double tuned = view.record.finalists[*kept].values[i];
    out.push_back({i, parameter.start, tuned, end_of(parameter, tuned)});
  }
  return out;
}

std::optional<std::size_t> slice_centre(const study::TuningRecord& record) {
  if (record.finalists.empty()) return std::nullopt;
  return record.tuned().value_or(0);
}

std::vector<CandidateVerdict> candidate_verdicts(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  const study::TuningRecord& record = view.record;
  const std::vector<double> adjusted = record.verification.adjusted();
  std::vector<CandidateVerdict> out;
  for (std::size_t i = 0; i < record.verification.of().size(); ++i) {
    const study::ScoreDifference& scores = record.verification.of()[i];
    const study::Finalist& finalist = record.finalists[record.candidates[i]];
    CandidateVerdict& each = out.emplace_back();
    each.candidate = i;
    each.finalist = record.candidates[i];
    each.finding = record.finding(i);
    each.forfeited = record.candidate_failed[i];
    each.packets = record.candidate_packets[i];
    if (finalist.seen) each.seen = of_objective(plan.objective, finalist.seen->score);
    each.selected = of_objective(plan.objective, finalist.selected.score);
    each.pairs = scores.difference().count();
    each.difference = each.pairs == 0 ? statistics::Estimate{0.0, {-HUGE_VAL, HUGE_VAL}}
                                      : of_objective(plan.objective, scores.estimate());
    each.p = scores.p();
    each.adjusted = adjusted[i];
    if (!plan.head_to_head() && each.pairs > 0) {
      each.value = of_objective(plan.objective, mean_of(scores.candidate(), plan.confidence()));
      each.base = of_objective(plan.objective, mean_of(scores.base(), plan.confidence()));
    }
    const bool known = plan.head_to_head() ? finalist.selected.score.pairs > 0 : each.pairs > 0;
    if (finalist.seen && finalist.seen->score.pairs > 0 && known) {
      each.optimism =
          finalist.seen->score.mean - (plan.head_to_head() ? finalist.selected.score.mean : scores.candidate().mean());
    }
  }
  return out;
}

}  // namespace regista::report
