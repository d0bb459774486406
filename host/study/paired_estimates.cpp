// SPDX-License-Identifier: MIT
#include "study/paired_estimates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "statistics/moments.hpp"
#include "statistics/paired_t.hpp"
#include "statistics/sign_flip.hpp"

namespace regista::study {
namespace {

std::vector<double> differences(std::span<const double> first, std::span<const double> second) {
  std::vector<double> out;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    const double difference = first[i] - second[i];
    if (!std::isnan(difference)) out.push_back(difference);
  }
  return out;
}

MeanEstimate estimate_of(const std::vector<double>& known, double confidence) {
  const statistics::Moments moments(known);
  MeanEstimate out{moments.count(), moments.mean(), moments.standard_deviation(), std::nullopt};
  if (const auto t = statistics::paired_t(known, confidence)) out.interval = t->interval;
  return out;
}

}  // namespace

MeanEstimate mean_of(std::span<const double> values, double confidence) {
  std::vector<double> known(values.begin(), values.end());
  std::erase_if(known, [](double value) { return std::isnan(value); });
  return estimate_of(known, confidence);
}

MeanEstimate difference_of(std::span<const double> first, std::span<const double> second, double confidence) {
  return estimate_of(differences(first, second), confidence);
}

const char* name(PairMethod method) {
  constexpr std::array names{"student_t", "sign_flip", "sign_flip_normal_law"};
  return names[static_cast<std::size_t>(method)];
}

std::optional<PairP> p_of_difference(std::span<const double> first, std::span<const double> second, PairTest test) {
  const std::vector<double> known = differences(first, second);
  if (known.size() < 2) return std::nullopt;
  if (test == PairTest::paired_t) {
    if (std::ranges::all_of(known, [](double each) { return each == 0.0; })) return PairP{1.0, PairMethod::student_t};
    if (const auto t = statistics::paired_t(known)) return PairP{t->p, PairMethod::student_t};
  }
  return PairP{statistics::sign_flip_p_of_values(known), statistics::sign_flip_of_values_is_exact(known)
                                                             ? PairMethod::sign_flip
                                                             : PairMethod::sign_flip_normal_law};
}

}  // namespace regista::study
