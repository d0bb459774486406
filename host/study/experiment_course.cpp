// SPDX-License-Identifier: MIT
#include "study/experiment_course.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "statistics/paired_tests.hpp"

namespace regista::study {
namespace {

double value_of(const std::optional<MatchMeasures>& match, const std::string& measure) {
  return match ? match->value(measure).value_or(no_value) : no_value;
}

std::optional<ShortGamePackets> packets_of(const MatchMeasures& match) {
  const auto spent = match.value(match::packet_metrics[0]), share = match.value(match::packet_metrics[1]),
             over = match.value(match::packet_metrics[2]);
  return spent && share && over ? std::optional(ShortGamePackets{*spent, *share, *over}) : std::nullopt;
}

PartlyPlayed shown_by(const Experiment& course, std::size_t condition, std::size_t measure) {
  return {course.values(condition, measure), course.unplayed(condition)};
}

Contrast contrast_of(const Experiment& course, const Comparison& of, std::size_t measure) {
  return {{shown_by(course, of.first, measure), shown_by(course, of.second, measure)}, {1.0, -1.0}};
}

Contrast contrast_of(const ExperimentPlan& plan, const Experiment& course, std::size_t arm, std::size_t measure) {
  Contrast out{{}, slope_weights(swept_numbers(plan))};
  for (std::size_t value = 0; value < plan.values(); ++value)
    out.conditions.push_back(shown_by(course, plan.condition(arm, value), measure));
  return out;
}

// Tests all members of `family`. The plan fixes the number of tests, so a test without a p-value counts as p = 1.
void test_all(const std::vector<std::pair<Tested*, Contrast>>& family, const ExperimentPlan& plan) {
  std::vector<double> tested, without;
  for (const auto& [of, contrast] : family) {
    if (const auto p = p_of_values(values_of(contrast), plan.test())) {
      of->p = p->p;
      of->by = p->by;
    }
    of->unplayed_pairs = unplayed_pairs(contrast);
    without.push_back(of->p.value_or(1.0));
    tested.push_back(of->p ? p_either_way(contrast, plan.test()) : 1.0);
  }
  if (tested.empty()) return;
  const std::vector<double> adjusted = statistics::holm(tested), adjusted_without = statistics::holm(without);
  for (std::size_t i = 0; i < family.size(); ++i) {
    Tested& each = *family[i].first;
    if (!each.p) continue;
    each.adjusted = adjusted[i];
    each.found = *each.adjusted <= 1.0 - plan.asked.confidence;
    each.prevented = !each.found && adjusted_without[i] <= 1.0 - plan.asked.confidence;
  }
}

}  // namespace

Experiment::Experiment(const ExperimentPlan& plan)
    : plan_(plan),
      conditions_(plan.conditions.size(), {std::vector<Values>(plan.measures.size())}),
      forfeits_(plan.conditions.size() + 1) {}

void Experiment::run(const PlayRound& play) {
  Round round;
  round.matches = plan_.matches();
  round.fixtures = fixtures(plan_);
  round.at = [this](std::uint64_t index) -> std::optional<Round::Place> {
    const Trial each = trial(plan_, index);
    return Round::Place{each.number, each.seed};
  };
  round.job = [this](std::uint64_t index) { return job(plan_, trial(plan_, index)); };
  round.take = [this](std::uint64_t, const campaign::MatchResult* decided) {
    take(*decided);  // an experiment wants all matches
    return !plan_.ended_after || !complete();
  };
  round.may_end_early = plan_.ended_after.has_value();
  round.matches_of_a_pair = 2 * plan_.conditions.size();
  round.first_of_pairing = [this](std::uint64_t index) {
    const Trial each = trial(plan_, index);
    return each.pair == 0 && each.side == 0;
  };
  play(round);
}

void Experiment::take(const campaign::MatchResult& decided) {
  assert(next_ < plan_.matches());
  const Trial trial = study::trial(plan_, next_);
  OfCondition& condition = conditions_[trial.condition];
  std::optional<MatchMeasures> played;
  remarks_.take(next_, decided);
  if (decided.set_aside()) {
    if (++condition.set_aside == most_set_aside && unplayable_.empty())
      unplayable_ = why_unplayable(plan_.asked.arms[plan_.conditions[trial.condition].arm].name, decided.why_set_aside);
  } else if (decided.failure) {
    const bool own = static_cast<std::size_t>(decided.failure->side) == trial.side;
    forfeits_.add(own ? trial.condition : plan_.conditions.size(), *decided.failure, next_);
  } else {
    played.emplace(decided, static_cast<int>(trial.side));
    condition.playing_seconds += played->playing_seconds();
    ++condition.played;
  }
  ++next_;
  if (trial.side == 0) {
    at_home_ = std::move(played);
    at_home_unplayed_ = decided.set_aside();
    return;
  }
  condition.unplayed.push_back(at_home_unplayed_ || decided.set_aside());
  const double seconds = at_home_ && played ? at_home_->playing_seconds() + played->playing_seconds() : 0.0;
  for (std::size_t measure = 0; measure < plan_.measures.size(); ++measure) {
    const std::string& path = plan_.measures[measure];
    const double sum = value_of(at_home_, path) + value_of(played, path);
    condition.values[measure].in_unit.push_back(pair_in_unit(path, sum, seconds));
    condition.values[measure].per_match.push_back(sum / 2.0);
  }
  if (at_home_ && played) {
    for (const MatchMeasures* const match : {&*at_home_, &*played}) {
      if (const auto packets = packets_of(*match)) condition.packets.add(*packets);
    }
  }
  at_home_.reset();
}

std::uint64_t Experiment::unplayed_pairs(std::size_t condition) const {
  return static_cast<std::uint64_t>(std::ranges::count(unplayed(condition), true));
}

std::uint64_t Experiment::unplayed_pairs() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < conditions_.size(); ++i) sum += unplayed_pairs(i);
  return sum;
}

std::optional<double> Experiment::playing_seconds_of_a_match(std::size_t condition) const {
  const OfCondition& of = conditions_[condition];
  return of.played == 0 ? std::nullopt : std::optional(of.playing_seconds / static_cast<double>(of.played));
}

MeanEstimate Experiment::mean(std::size_t condition, std::size_t measure) const {
  return mean_of(values(condition, measure), plan_.asked.confidence);
}

MeanEstimate Experiment::difference(const Comparison& comparison, std::size_t measure) const {
  return mean_of(paired_differences(values(comparison.first, measure), values(comparison.second, measure)),
                 plan_.asked.confidence);
}

MeanEstimate Experiment::slope(std::size_t arm, std::size_t measure) const {
  return mean_of(values_of(contrast_of(plan_, *this, arm, measure)), plan_.asked.confidence);
}

std::optional<std::size_t> measure_index(const ExperimentPlan& plan, const std::string& measure) {
  const auto found = std::ranges::find(plan.measures, measure);
  if (found == plan.measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plan.measures.begin());
}

std::optional<std::size_t> primary_measure(const ExperimentPlan& plan) { return measure_index(plan, plan.primary()); }

Findings findings(const ExperimentPlan& plan, const Experiment& course) {
  const std::optional<std::size_t> measure = primary_measure(plan);
  Findings out;
  if (!measure) return out;
  std::vector<std::pair<Tested*, Contrast>> family;
  out.comparisons.reserve(plan.comparisons().size());
  for (const Comparison& each : plan.comparisons()) {
    out.comparisons.push_back({{}, each, course.difference(each, *measure)});
    family.emplace_back(&out.comparisons.back(), contrast_of(course, each, *measure));
  }
  out.trends.reserve(plan.arms());
  for (std::size_t arm = 0; has_trends(plan) && arm < plan.arms(); ++arm) {
    out.trends.push_back({{}, arm, course.slope(arm, *measure)});
    family.emplace_back(&out.trends.back(), contrast_of(plan, course, arm, *measure));
  }
  if (course.complete()) test_all(family, plan);
  return out;
}

}  // namespace regista::study
