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
  // Of two scores that know nothing of each other.
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

std::vector<double> Verification::adjusted() const {
  std::vector<double> p;
  for (const ScoreDifference& each : of_) p.push_back(each.p_either_way());
  return p.empty() ? p : statistics::holm(p);
}

std::vector<VerifiedAs> Verification::findings() const {
  std::vector<VerifiedAs> out;
  const std::vector<double> p = adjusted();
  std::vector<double> without;
  for (const ScoreDifference& each : of_) without.push_back(each.p());
  if (!without.empty()) without = statistics::holm(without);
  for (std::size_t i = 0; i < of_.size(); ++i) {
    out.push_back(p[i] > alpha_ && without[i] <= alpha_ ? VerifiedAs::prevented
                  : p[i] > alpha_                       ? VerifiedAs::undecided
                  : of_[i].candidate_more()             ? VerifiedAs::better
                                                        : VerifiedAs::worse);
  }
  return out;
}

// With a bound, more pairs may yet bring the ways to count those that could not be played together.
bool Verification::decided() const {
  return std::ranges::all_of(findings(), [&](VerifiedAs each) {
    return each == VerifiedAs::prevented ? !bound_ : each != VerifiedAs::undecided;
  });
}

}  // namespace regista::study
