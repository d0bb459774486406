// SPDX-License-Identifier: MIT
#include "study/tuning/verification.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/multiplicity.hpp"

namespace regista::study {

void ScoreDifference::add(double candidate, double base) {
  candidate_.add(candidate);
  base_.add(base);
  difference_.add(candidate - base);
  test_.add(candidate - base);
}

statistics::Estimate ScoreDifference::estimate() const { return {difference_.mean(), test_.interval()}; }

Verification::Verification(std::size_t candidates, double confidence, double deviation) : alpha_(1.0 - confidence) {
  // Of two scores that know nothing of each other.
  const double of_difference = std::sqrt(2.0) * deviation;
  const double share = alpha_ / static_cast<double>(std::max<std::size_t>(candidates, 1));
  of_.assign(candidates, ScoreDifference(of_difference, share));
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
