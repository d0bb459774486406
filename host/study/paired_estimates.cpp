// SPDX-License-Identifier: MIT
#include "study/paired_estimates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "config/node.hpp"
#include "config/scalar.hpp"
#include "match/metric_table.hpp"
#include "study/experiment_course.hpp"
#include "study/measure.hpp"
#include "study/tournament_course.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

std::vector<double> known_of(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  std::erase_if(out, [](double value) { return std::isnan(value); });
  return out;
}

std::size_t pairs_of(const Contrast& contrast) {
  std::size_t out = contrast.conditions.empty() ? 0 : contrast.conditions.front().values.size();
  for (const PartlyPlayed& each : contrast.conditions) out = std::min(out, each.values.size());
  return out;
}

bool is_unplayed(const Contrast& contrast, std::size_t pair) {
  return std::ranges::any_of(contrast.conditions, [pair](const PartlyPlayed& each) { return each.unplayed[pair]; });
}

// For each pair, the sum over all conditions of weight * value(condition, pair, weight).
template <class Value>
std::vector<double> weighted(const Contrast& contrast, Value value) {
  std::vector<double> out;
  for (std::size_t pair = 0; pair < pairs_of(contrast); ++pair) {
    double sum = 0.0;
    for (std::size_t i = 0; i < contrast.conditions.size(); ++i)
      sum += contrast.weights[i] * value(contrast.conditions[i], pair, contrast.weights[i]);
    out.push_back(sum);
  }
  return out;
}

// Fills in missing values of unplayed pairs: `above` if the condition's weight is above 0, `below` if it is below 0.
std::vector<double> filled(const Contrast& contrast, double above, double below) {
  return weighted(contrast, [&](const PartlyPlayed& condition, std::size_t pair, double weight) {
    return condition.unplayed[pair] ? (weight > 0.0 ? above : below) : condition.values[pair];
  });
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

struct Answer {
  double p = 1.0;
  int side = 0;  // the side of 0 that the test found: 1 above, -1 below, 0 neither
};

Answer by_size(const std::vector<double>& values, PairTest test) {
  const std::optional<PairP> p = p_of_values(values, test);
  double sum = 0.0;
  for (const double each : values) {
    if (!std::isnan(each)) sum += each;
  }
  return p ? Answer{p->p, sign(sum)} : Answer{};
}

// Tests the signs of the pairs. missing: the sign that all unplayed pairs get.
Answer by_signs(const Contrast& contrast, const std::vector<double>& values, int missing) {
  std::vector<double> signs;
  int sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool unplayed = is_unplayed(contrast, i);
    if (!unplayed && std::isnan(values[i])) continue;
    signs.push_back(unplayed ? missing : sign(values[i]));
    sum += unplayed ? missing : sign(values[i]);
  }
  return {statistics::sign_flip_p_of_values(signs), sign(sum)};
}

void learn_names(const campaign::MatchResult& decided, std::vector<std::string>& known) {
  if (!known.empty() || decided.failure || decided.set_aside() || decided.metrics.empty()) return;
  known = texts::names_of(MatchMeasures(decided, 0).all(), &NamedValue::path);
}

std::string unit_of_a_match(const std::string& measure) {
  if (measure == goals_value || measure == "points") return measure + " a match";
  const match::MetricRow* const row = match::find_metric(match::metric_table(), measure);
  return row == nullptr || row->unit.empty() ? "a match" : std::string(row->unit) + " a match";
}

// The first team's number minus the second team's number; nullopt if the match does not have this number.
std::optional<double> difference_in(const campaign::MatchResult& decided, const TournamentPlan& plan,
                                    const std::string& measure, bool first_at_home) {
  if (decided.set_aside()) return std::nullopt;
  const double sign = first_at_home ? 1.0 : -1.0;
  if (measure == goals_value)
    return sign * std::clamp(decided.score[0] - decided.score[1], -plan.most_goals, plan.most_goals);
  if (decided.failure) return std::nullopt;
  const auto home = MatchMeasures(decided, 0).value(measure), away = MatchMeasures(decided, 1).value(measure);
  return home && away ? std::optional(sign * (*home - *away)) : std::nullopt;
}

}  // namespace

MeanEstimate mean_of(std::span<const double> values, double confidence) {
  const std::vector<double> known = known_of(values);
  const statistics::Moments moments(known);
  MeanEstimate out{moments.count(), moments.mean(), moments.standard_deviation(), std::nullopt};
  if (const auto t = statistics::paired_t(known, confidence)) out.interval = t->interval;
  return out;
}

std::vector<double> paired_differences(std::span<const double> first, std::span<const double> second) {
  std::vector<double> out;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) out.push_back(first[i] - second[i]);
  return out;
}

const char* name(PairMethod method) {
  constexpr std::array names{"student_t", "sign_flip", "sign_flip_normal_law"};
  return names[static_cast<std::size_t>(method)];
}

std::optional<PairP> p_of_values(std::span<const double> values, PairTest test) {
  const std::vector<double> known = known_of(values);
  if (known.size() < 2) return std::nullopt;
  if (test == PairTest::paired_t) {
    if (std::ranges::all_of(known, [](double each) { return each == 0.0; })) return PairP{1.0, PairMethod::student_t};
    if (const auto t = statistics::paired_t(known)) return PairP{t->p, PairMethod::student_t};
  }
  return PairP{statistics::sign_flip_p_of_values(known), statistics::sign_flip_of_values_is_exact(known)
                                                             ? PairMethod::sign_flip
                                                             : PairMethod::sign_flip_normal_law};
}

std::vector<double> swept_numbers(const ExperimentPlan& plan) {
  std::vector<double> out;
  if (!plan.swept()) return out;
  try {
    for (const config::Node& each : plan.asked.sweep->values) out.push_back(config::to_real(each, "value"));
  } catch (const config::Error&) {
    return {};
  }
  return out;
}

bool has_trends(const ExperimentPlan& plan) {
  const std::vector<double> numbers = swept_numbers(plan);
  if (numbers.empty() || std::ranges::min(numbers) == std::ranges::max(numbers)) return false;
  return plan.arms() > 1 || numbers.size() > 2;
}

std::vector<double> slope_weights(std::span<const double> places) {
  const double middle = std::accumulate(places.begin(), places.end(), 0.0) / static_cast<double>(places.size());
  double squares = 0.0;
  for (const double each : places) squares += (each - middle) * (each - middle);
  std::vector<double> out;
  for (const double each : places) out.push_back((each - middle) / squares);
  return out;
}

std::vector<double> values_of(const Contrast& contrast) {
  return weighted(contrast, [](const PartlyPlayed& of, std::size_t pair, double) { return of.values[pair]; });
}

std::uint64_t unplayed_pairs(const Contrast& contrast) {
  std::uint64_t out = 0;
  for (std::size_t pair = 0; pair < pairs_of(contrast); ++pair) out += is_unplayed(contrast, pair) ? 1 : 0;
  return out;
}

double p_either_way(const Contrast& contrast, PairTest test) {
  const std::vector<double> values = values_of(contrast);
  const Answer without = by_size(values, test);
  if (unplayed_pairs(contrast) == 0) return without.p;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const PartlyPlayed& condition : contrast.conditions) {
    for (const double each : condition.values) {
      if (std::isnan(each)) continue;
      least = std::min(least, each);
      most = std::max(most, each);
    }
  }
  double p = without.p;
  for (const Answer& each : {by_size(filled(contrast, least, most), test), by_size(filled(contrast, most, least), test),
                             by_signs(contrast, values, -1), by_signs(contrast, values, 1)}) {
    if (each.side != without.side) return 1.0;
    p = std::max(p, each.p);
  }
  return p;
}

PairDifferences pair_differences(const TournamentPlan& plan, const campaign::Store& store, const std::string& measure) {
  PairDifferences out{measure, unit_of_a_match(measure), {}, {}};
  for (const Pairing& each : plan.pairings())
    out.compared.push_back({plan.teams[each.first].label, plan.teams[each.second].label, equal_teams(plan, each), {}});
  Tournament course(plan);
  std::optional<double> at_home;
  read_back(course, store, campaign::Metrics::wanted,
            [&](const Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
              if (decided == nullptr) return;
              learn_names(*decided, out.known);
              const Fixture fixture = course.calendar().at(round.first_row + index);
              const auto difference = difference_in(*decided, plan, measure, !fixture.swapped);
              if (!fixture.swapped) {
                at_home = difference;
              } else if (at_home && difference) {
                out.compared[fixture.pairing].differences.add((*at_home + *difference) / 2.0);
              }
            });
  return out;
}

PairDifferences pair_differences(const ExperimentPlan& plan, const campaign::Store& store, const std::string& measure) {
  PairDifferences out{measure, unit_of(measure), {}, {}};
  ExperimentPlan with = plan;
  with.measures = {measure};
  Experiment course(with);
  read_back(course, store, campaign::Metrics::wanted,
            [&](const Round& /*round*/, std::uint64_t /*index*/, const campaign::MatchResult* decided) {
              if (decided != nullptr) learn_names(*decided, out.known);
            });
  for (const Comparison& each : plan.comparisons()) {
    ComparedPairs& compared = out.compared.emplace_back();
    compared.first = label(plan, each.first);
    compared.second = label(plan, each.second);
    compared.equal = equal_conditions(plan, each);
    for (const double difference :
         known_of(paired_differences(course.values(each.first, 0), course.values(each.second, 0))))
      compared.differences.add(difference);
  }
  return out;
}

statistics::PowerDesign design_of(const TournamentPlan& plan) {
  statistics::PowerDesign out;
  out.family = static_cast<std::int64_t>(plan.pairings().size());
  return out;
}

statistics::PowerDesign design_of(const ExperimentPlan& plan) {
  statistics::PowerDesign out;
  out.alpha = 1.0 - plan.asked.confidence;
  const std::size_t members = plan.comparisons().size() + (has_trends(plan) ? plan.arms() : 0);
  out.family = std::max<std::int64_t>(1, static_cast<std::int64_t>(members));
  if (plan.test() == PairTest::paired_t) out.test = statistics::PairedTest::student_t;
  return out;
}

}  // namespace regista::study
