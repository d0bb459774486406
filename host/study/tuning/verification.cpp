// SPDX-License-Identifier: MIT
#include "study/tuning/verification.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/multiplicity.hpp"

namespace regista::study {
namespace {

constexpr int steps = 4000;  // of the grid of mean differences

// What the score of a pair is expected to vary by, before any is known: measured on shipped teams.
double expected_deviation(const TuningPlan& plan) {
  constexpr double goals = 1.0, points = 0.35;  // mean of two matches
  double sum = 0.0;
  for (const ObjectiveTerm& each : plan.objective.terms) {
    sum += std::abs(each.weight) * (each.measure == "points" ? points : goals);
  }
  return std::sqrt(2.0) * sum;
}

}  // namespace

ScoreDifference::ScoreDifference(const TuningPlan& plan, double alpha, std::size_t several)
    : test_(MetricDifference(alpha / static_cast<double>(several))) {
  const std::optional<ScoreBounds> bounds = score_bounds(plan);
  if (!bounds) return;
  const double widest = bounds->high - bounds->low;
  statistics::BettingDesign design{-widest, widest, alpha, std::min(expected_deviation(plan), widest)};
  const statistics::BettingTest test(design, 0.0);
  design.alpha = alpha / static_cast<double>(several);
  test_ = OnMean{test, statistics::BettingGrid(design, steps)};
}

void ScoreDifference::add(double candidate, double base) {
  candidate_.add(candidate);
  base_.add(base);
  difference_.add(candidate - base);
  if (auto* const mean = std::get_if<OnMean>(&test_)) {
    mean->test.add(candidate - base);
    mean->sequence.add(candidate - base);
  } else {
    std::get<MetricDifference>(test_).add(candidate, base);
  }
}

statistics::Estimate ScoreDifference::estimate() const {
  const auto* const mean = std::get_if<OnMean>(&test_);
  if (mean == nullptr) return std::get<MetricDifference>(test_).estimate();
  return {difference_.mean(), mean->sequence.interval()};
}

double ScoreDifference::p() const {
  const auto* const mean = std::get_if<OnMean>(&test_);
  return mean == nullptr ? std::get<MetricDifference>(test_).test().p() : mean->test.p();
}

bool ScoreDifference::candidate_more() const {
  if (const auto* const mean = std::get_if<OnMean>(&test_)) {
    using enum statistics::BettingTest::Finding;
    const auto found = mean->test.finding();
    return found == none ? difference_.mean() > 0.0 : found == above;
  }
  const auto& signs = std::get<MetricDifference>(test_).signs();
  return signs[2] > signs[0];
}

Verification::Verification(const TuningPlan& plan, std::size_t candidates)
    : alpha_(1.0 - plan.confidence), of_(candidates, ScoreDifference(plan, alpha_, std::max<std::size_t>(candidates, 1))) {}

void Verification::add(double base, std::span<const double> candidates) {
  assert(candidates.size() == of_.size());
  ++pairs_;
  for (std::size_t i = 0; i < of_.size(); ++i) {
    if (!std::isnan(base) && !std::isnan(candidates[i])) of_[i].add(candidates[i], base);
  }
}

std::vector<double> Verification::adjusted() const {
  std::vector<double> p;
  for (const ScoreDifference& each : of_) p.push_back(each.p());
  return p.empty() ? p : statistics::holm(p);
}

std::vector<VerifiedAs> Verification::findings() const {
  std::vector<VerifiedAs> out;
  const std::vector<double> p = adjusted();
  for (std::size_t i = 0; i < of_.size(); ++i) {
    out.push_back(p[i] > alpha_              ? VerifiedAs::undecided
                  : of_[i].candidate_more() ? VerifiedAs::better
                                             : VerifiedAs::worse);
  }
  return out;
}

bool Verification::decided() const { return std::ranges::count(findings(), VerifiedAs::undecided) == 0; }

}  // namespace regista::study
