// SPDX-License-Identifier: MIT
#include "study/tuning/verification.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/multiplicity.hpp"

namespace regista::study {

namespace {

constexpr int steps = 4000;  // of the grid of mean differences

}  // namespace

ScoreDifference::ScoreDifference(double deviation, double alpha, std::size_t several, std::optional<double> widest)
    : test_(statistics::SymmetricTest(deviation, alpha / static_cast<double>(several))) {
  if (!widest) return;
  statistics::BettingDesign design{-*widest, *widest, alpha, std::min(deviation, *widest)};
  const statistics::BettingTest test(design, 0.0);
  design.alpha = alpha / static_cast<double>(several);
  test_ = OnMean{test, statistics::BettingGrid(design, steps)};
}

void ScoreDifference::add(double candidate, double base) {
  candidate_.add(candidate);
  base_.add(base);
  const double difference = candidate - base;
  difference_.add(difference);
  if (auto* const mean = std::get_if<OnMean>(&test_)) {
    mean->test.add(difference);
    mean->sequence.add(difference);
  } else {
    std::get<statistics::SymmetricTest>(test_).add(difference);
  }
}

statistics::Estimate ScoreDifference::estimate() const {
  const auto* const mean = std::get_if<OnMean>(&test_);
  return {difference_.mean(),
          mean == nullptr ? std::get<statistics::SymmetricTest>(test_).interval() : mean->sequence.interval()};
}

double ScoreDifference::p() const {
  const auto* const mean = std::get_if<OnMean>(&test_);
  return mean == nullptr ? std::get<statistics::SymmetricTest>(test_).p() : mean->test.p();
}

bool ScoreDifference::candidate_more() const {
  const auto* const mean = std::get_if<OnMean>(&test_);
  if (mean == nullptr) return std::get<statistics::SymmetricTest>(test_).above();
  using enum statistics::BettingTest::Finding;
  const auto found = mean->test.finding();
  return found == none ? difference_.mean() > 0.0 : found == above;
}

Verification::Verification(std::size_t candidates, double confidence, double deviation, std::optional<double> widest)
    : alpha_(1.0 - confidence) {
  // Of two scores that know nothing of each other.
  const double of_difference = std::sqrt(2.0) * deviation;
  of_.assign(candidates, ScoreDifference(of_difference, alpha_, std::max<std::size_t>(candidates, 1), widest));
}

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
    out.push_back(p[i] > alpha_             ? VerifiedAs::undecided
                  : of_[i].candidate_more() ? VerifiedAs::better
                                            : VerifiedAs::worse);
  }
  return out;
}

bool Verification::decided() const { return std::ranges::count(findings(), VerifiedAs::undecided) == 0; }

}  // namespace regista::study
