// SPDX-License-Identifier: MIT
#include "statistics/anytime_valid_tests.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace regista::statistics {
namespace {

constexpr double largest_loss = 0.75;  // largest share of a capital that one value may take
constexpr double edge = 1e-9;          // distance of tested means from the ends of the range; there a stake is infinite
constexpr double usual_effect = 0.3;   // the difference that SymmetricTest finds fastest, in standard deviations

double in_unit_range(const BettingDesign& design, double value) {
  assert(design.low <= value && value <= design.high);
  return (value - design.low) / (design.high - design.low);
}

}  // namespace

double Capital::log() const { return std::log(product_) + static_cast<double>(twos_) * std::numbers::ln2; }

void Capital::fold() {
  int twos = 0;
  product_ = std::frexp(product_, &twos);
  twos_ += twos;
}

void HedgedCapital::bet(double stake, double value, double mean) {
  above_.bet(std::min(stake, largest_loss / mean), value, mean);
  below_.bet(-std::min(stake, largest_loss / (1.0 - mean)), value, mean);
}

PlugInStake::PlugInStake(double alpha, double variance)
    : log_level_(2.0 * std::log(2.0 / alpha)), expected_variance_(variance) {
  assert(alpha > 0.0 && alpha < 1.0 && variance > 0.0);
}

double PlugInStake::next() const {
  // The expected variance counts like the squared deviation of one earlier value.
  const double t = static_cast<double>(count_ + 1);
  const double variance = (expected_variance_ + squares_) / t;
  return std::sqrt(log_level_ / (variance * t * std::log1p(t)));
}

void PlugInStake::learn(double value) {
  ++count_;
  sum_ += value;
  const double mean = (0.5 + sum_) / static_cast<double>(count_ + 1);
  squares_ += (value - mean) * (value - mean);
}

BettingTest::BettingTest(const BettingDesign& design, double mean)
    : design_(design),
      mean_((mean - design.low) / (design.high - design.low)),
      stake_(design.alpha, design.expected_variance()) {
  assert(design.low < mean && mean < design.high);
}

void BettingTest::add(double value) {
  const double x = in_unit_range(design_, value);
  capital_.bet(stake_.next(), x, mean_);
  stake_.learn(x);
  const double evidence = log_evidence();
  most_ = std::max(most_, evidence);
  if (finding_ == Finding::none && evidence >= -std::log(design_.alpha)) {
    finding_ = capital_.log_above() > capital_.log_below() ? Finding::above : Finding::below;
  }
}

double BettingTest::log_evidence() const {
  return std::max(capital_.log_above(), capital_.log_below()) - std::numbers::ln2;
}

double BettingTest::p() const { return std::exp(-most_); }

BettingGrid::BettingGrid(const BettingDesign& design, int steps)
    : design_(design),
      steps_(steps),
      last_(steps),
      capitals_(static_cast<std::size_t>(steps) + 1),
      stake_(design.alpha, design.expected_variance()) {
  assert(design.low < design.high && steps >= 2);
}

double BettingGrid::point(int index) const { return static_cast<double>(index) / static_cast<double>(steps_); }

void BettingGrid::add(double value) {
  const double x = in_unit_range(design_, value), stake = stake_.next();
  for (int i = first_; i <= last_; ++i) {
    capitals_[static_cast<std::size_t>(i)].bet(stake, x, std::clamp(point(i), edge, 1.0 - edge));
  }
  stake_.learn(x);
  // log_above() and log_below() start at a capital of 1, but each gambler has only half of it: hence ln 2. Evidence
  // falls from the ends of the grid to the mean.
  const double enough = std::numbers::ln2 - std::log(design_.alpha);
  while (first_ < last_ && capitals_[static_cast<std::size_t>(first_)].log_above() >= enough) ++first_;
  while (first_ < last_ && capitals_[static_cast<std::size_t>(last_)].log_below() >= enough) --last_;
}

Interval BettingGrid::interval() const {
  return {in_units(point(std::max(first_ - 1, 0))), in_units(point(std::min(last_ + 1, steps_)))};
}

BettingTest::Finding BettingGrid::finding(double mean) const {
  const double share = (mean - design_.low) / (design_.high - design_.low);
  if (first_ > 0 && share <= point(first_ - 1)) return BettingTest::Finding::above;
  if (last_ < steps_ && share >= point(last_ + 1)) return BettingTest::Finding::below;
  return BettingTest::Finding::none;
}

SymmetricTest::SymmetricTest(double deviation, double alpha)
    : mixing_variance_(usual_effect * usual_effect / (deviation * deviation)), log_level_(-std::log(alpha)) {
  assert(deviation > 0.0 && alpha > 0.0 && alpha < 1.0);
}

void SymmetricTest::add(double value) {
  ++count_;
  sum_ += value;
  squares_ += value * value;
  const double now = log_evidence(0.0);
  if (now <= most_) return;
  most_ = now;
  above_ = sum_ > 0.0;
}

double SymmetricTest::log_evidence(double centre) const {
  const auto n = static_cast<double>(count_);
  const double sum = sum_ - n * centre;
  const double squares = std::max(0.0, squares_ - 2.0 * centre * sum_ + n * centre * centre);
  const double spread = 1.0 + mixing_variance_ * squares;
  return mixing_variance_ * sum * sum / (2.0 * spread) - 0.5 * std::log(spread);
}

double SymmetricTest::p() const { return std::min(1.0, std::exp(-most_)); }

Interval SymmetricTest::interval() const { return {bound(-1.0), bound(1.0)}; }

// Returns the first centre with enough evidence against it, going from the mean in this direction (+1 or -1).
double SymmetricTest::bound(double direction) const {
  const double middle = mean();
  const double beyond = direction * infinite;
  if (count_ == 0) return beyond;
  // Evidence against a far centre falls again, because the spread around this centre would explain all values.
  double step = 1e-3 / std::sqrt(mixing_variance_ * static_cast<double>(count_));
  double inside = 0.0;
  for (int doublings = 0; log_evidence(middle + direction * step) < log_level_; ++doublings) {
    if (doublings == 120) return beyond;
    inside = step;
    step *= 1.25;
  }
  double outside = step;
  for (int i = 0; i < 60; ++i) {
    const double between = 0.5 * (inside + outside);
    (log_evidence(middle + direction * between) < log_level_ ? inside : outside) = between;
  }
  return middle + direction * outside;
}

double mixture_half_width(const MixtureSample& sample, double alpha) {
  assert(alpha > 0.0 && alpha < 1.0);
  assert(sample.values >= 0 && sample.variance >= 0.0 && sample.mixing_variance > 0.0);
  if (sample.values == 0 || !(sample.variance > 0.0)) return infinite;
  const double n = static_cast<double>(sample.values), s2 = sample.variance, tau2 = sample.mixing_variance;
  const double mixed = s2 + n * tau2;
  return std::sqrt(s2 * mixed / (n * n * tau2) * (std::log(mixed / s2) - 2.0 * std::log(alpha)));
}

}  // namespace regista::statistics
