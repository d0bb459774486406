// SPDX-License-Identifier: MIT
#include "study/experiment.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "statistics/multiplicity.hpp"
#include "study/either_way.hpp"

namespace regista::study {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double value_of(const std::optional<MatchMeasures>& match, const std::string& measure) {
  return match ? match->value(measure).value_or(nothing) : nothing;
}

std::optional<ShortGamePackets> packets_of(const MatchMeasures& match) {
  std::array<double, match::packet_metrics.size()> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto value = match.value(match::packet_metrics[i]);
    if (!value) return std::nullopt;
    numbers[i] = *value;
  }
  return ShortGamePackets{numbers[0], numbers[1], numbers[2]};
}

}  // namespace

Experiment::Experiment(const ExperimentPlan& plan)
    : plan_(plan),
      values_(plan.conditions.size() * plan.measures.size()),
      playing_seconds_(plan.conditions.size(), 0.0),
      played_(plan.conditions.size(), 0),
      packets_(plan.conditions.size()),
      unplayed_(plan.conditions.size()),
      set_aside_(plan.conditions.size(), 0),
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
  round.take = [this](std::uint64_t, const campaign::Decided* decided) {
    take(*decided);  // all matches are wanted
    return true;
  };
  round.first_of_pairing = [this](std::uint64_t index) {
    const Trial each = trial(plan_, index);
    return each.pair == 0 && each.side == 0;
  };
  play(round);
}

void Experiment::take(const campaign::Decided& decided) {
  assert(next_ < plan_.matches());
  const Trial trial = study::trial(plan_, next_);
  std::optional<MatchMeasures> played;
  remarks_.take(next_, decided);
  if (decided.set_aside()) {
    // There is nothing to be counted.
    if (++set_aside_[trial.condition] == most_set_aside && unplayable_.empty())
      unplayable_ = why_unplayable(plan_.asked.arms[plan_.conditions[trial.condition].arm].name, decided.why_set_aside);
  } else if (decided.failure) {
    const bool own = static_cast<std::size_t>(decided.failure->side) == trial.side;
    forfeits_.add(own ? trial.condition : plan_.conditions.size(), *decided.failure, next_);
  } else {
    played.emplace(decided, static_cast<int>(trial.side));
    playing_seconds_[trial.condition] += played->playing_seconds();
    ++played_[trial.condition];
  }
  ++next_;
  if (trial.side == 0) {
    at_home_ = std::move(played);
    at_home_unplayed_ = decided.set_aside();
    return;
  }
  unplayed_[trial.condition].push_back(at_home_unplayed_ || decided.set_aside());
  const double seconds = at_home_ && played ? at_home_->playing_seconds() + played->playing_seconds() : 0.0;
  for (std::size_t measure = 0; measure < plan_.measures.size(); ++measure) {
    const std::string& path = plan_.measures[measure];
    const double sum = value_of(at_home_, path) + value_of(played, path);
    Values& values = values_[trial.condition * plan_.measures.size() + measure];
    values.in_unit.push_back(pair_in_unit(path, sum, seconds));
    values.per_match.push_back(sum / 2.0);
  }
  if (at_home_ && played) {
    for (const MatchMeasures* const match : {&*at_home_, &*played}) {
      if (const auto packets = packets_of(*match)) packets_[trial.condition].add(*packets);
    }
  }
  at_home_.reset();
}

std::uint64_t Experiment::unplayed_pairs(std::size_t condition) const {
  return static_cast<std::uint64_t>(std::ranges::count(unplayed_[condition], true));
}

std::uint64_t Experiment::unplayed_pairs() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < unplayed_.size(); ++i) sum += unplayed_pairs(i);
  return sum;
}

const Experiment::Values& Experiment::at(std::size_t condition, std::size_t measure) const {
  return values_[condition * plan_.measures.size() + measure];
}

std::span<const double> Experiment::values(std::size_t condition, std::size_t measure) const {
  return at(condition, measure).in_unit;
}

std::span<const double> Experiment::per_match(std::size_t condition, std::size_t measure) const {
  return at(condition, measure).per_match;
}

std::optional<double> Experiment::playing_seconds_of_a_match(std::size_t condition) const {
  if (played_[condition] == 0) return std::nullopt;
  return playing_seconds_[condition] / static_cast<double>(played_[condition]);
}

MeanEstimate Experiment::mean(std::size_t condition, std::size_t measure) const {
  return mean_of(values(condition, measure), plan_.asked.confidence);
}

MeanEstimate Experiment::difference(const Comparison& comparison, std::size_t measure) const {
  return difference_of(values(comparison.first, measure), values(comparison.second, measure), plan_.asked.confidence);
}

std::optional<std::size_t> primary_measure(const ExperimentPlan& plan) {
  const std::string primary = plan.primary();
  const auto found = std::ranges::find(plan.measures, primary);
  if (primary.empty() || found == plan.measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plan.measures.begin());
}

std::vector<Finding> findings(const ExperimentPlan& plan, const Experiment& course) {
  const std::optional<std::size_t> measure = primary_measure(plan);
  std::vector<Finding> out;
  if (!measure) return out;
  std::vector<double> tested, without;
  for (const Comparison& each : plan.comparisons()) {
    Finding& finding = out.emplace_back(Finding{each, course.difference(each, *measure), {}, {}, {}, false});
    if (!course.complete()) continue;
    const PartlyPlayed first{course.values(each.first, *measure), course.unplayed(each.first)},
        second{course.values(each.second, *measure), course.unplayed(each.second)};
    const auto p = p_of_difference(first.values, second.values, plan.test());
    if (p) {
      finding.p = p->p;
      finding.by = p->by;
    }
    finding.unplayed_pairs = unplayed_pairs(first, second);
    // How many comparisons there are was fixed beforehand: one without a p is none that was never asked for.
    without.push_back(finding.p.value_or(1.0));
    tested.push_back(finding.p ? p_either_way(first, second, plan.test()) : 1.0);
  }
  if (tested.empty()) return out;
  const std::vector<double> adjusted = statistics::holm(tested), adjusted_without = statistics::holm(without);
  for (std::size_t i = 0; i < out.size(); ++i) {
    Finding& each = out[i];
    if (!each.p) continue;
    each.adjusted = adjusted[i];
    each.found = *each.adjusted <= 1.0 - plan.asked.confidence;
    each.prevented = !each.found && adjusted_without[i] <= 1.0 - plan.asked.confidence;
  }
  return out;
}

}  // namespace regista::study
