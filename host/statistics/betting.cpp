// SPDX-License-Identifier: MIT
#include "statistics/betting.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace regista::statistics {
namespace {

constexpr double largest_loss = 0.75;  // share of a capital that one value may take

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

double in_unit_range(const BettingDesign& design, double value) {
  assert(design.low <= value && value <= design.high);
  return (value - design.low) / (design.high - design.low);
}

double log_hedged(const HedgedCapital& capital) {
  return std::max(capital.log_above(), capital.log_below()) - std::numbers::ln2;
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
  // One value at 1/2, with the variance that is expected, was seen before all others.
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

double BettingTest::log_evidence() const { return log_hedged(capital_); }
double BettingTest::p() const { return std::exp(-most_); }

BettingSequence::BettingSequence(const BettingDesign& design)
    : design_(design), stake_(design.alpha, design.expected_variance()) {
  assert(design.low < design.high);
}

void BettingSequence::add(double value) {
  const double x = in_unit_range(design_, value);
  past_.push_back({stake_.next(), x});
  stake_.learn(x);
  sum_ += x;
}

double BettingSequence::mean() const {
  const double mean = past_.empty() ? 0.5 : sum_ / static_cast<double>(past_.size());
  return design_.low + mean * (design_.high - design_.low);
}

double BettingSequence::log_evidence(double mean) const {
  HedgedCapital capital;
  for (const Bet& each : past_) capital.bet(each.stake, each.value, mean);
  return log_hedged(capital);
}

// Between a mean at the edge of the range and one that is not excluded: the evidence falls along the way.
double BettingSequence::bound(double from, double inside) const {
  const auto beyond = [&](double mean) { return log_evidence(mean) + std::log(design_.alpha); };
  const double at_edge = beyond(from), at_inside = beyond(inside);
  if (at_edge < 0.0) return from;
  if (at_inside >= 0.0) return inside;
  std::uintmax_t steps = 100;
  const boost::math::tools::eps_tolerance<double> precision(40);  // bits
  const auto [low, high] =
      from < inside
          ? boost::math::tools::toms748_solve(beyond, from, inside, at_edge, at_inside, precision, steps, Policy())
          : boost::math::tools::toms748_solve(beyond, inside, from, at_inside, at_edge, precision, steps, Policy());
  return from < inside ? low : high;  // the outer end: rather too wide than too narrow
}

Interval BettingSequence::interval() const {
  if (past_.empty()) return {design_.low, design_.high};
  // The mean at which neither gambler wins: the one who bets on more earns less the larger the tested mean, the other
  // more, so one of them is poor there.
  constexpr double edge = 1e-12;
  const auto difference = [&](double mean) {
    HedgedCapital capital;
    for (const Bet& each : past_) capital.bet(each.stake, each.value, mean);
    return capital.log_above() - capital.log_below();
  };
  double inside = 0.5;
  const double at_low = difference(edge), at_high = difference(1.0 - edge);
  if (at_low <= 0.0) {
    inside = edge;
  } else if (at_high >= 0.0) {
    inside = 1.0 - edge;
  } else {
    std::uintmax_t steps = 100;
    const auto [below, above] = boost::math::tools::toms748_solve(
        difference, edge, 1.0 - edge, at_low, at_high, boost::math::tools::eps_tolerance<double>(40), steps, Policy());
    inside = below + (above - below) / 2.0;
  }
  const double width = design_.high - design_.low;
  const double low = bound(edge, inside), high = bound(1.0 - edge, inside);
  return {low <= edge ? design_.low : design_.low + low * width,
          high >= 1.0 - edge ? design_.high : design_.low + high * width};
}

}  // namespace regista::statistics
