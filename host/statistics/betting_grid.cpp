// SPDX-License-Identifier: MIT
#include "statistics/betting_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace regista::statistics {
namespace {

// A mean at the very edge of the range would make a stake infinite.
constexpr double edge = 1e-9;

}  // namespace

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
  assert(design_.low <= value && value <= design_.high);
  const double x = (value - design_.low) / (design_.high - design_.low);
  const double stake = stake_.next();
  for (int i = first_; i <= last_; ++i) {
    capitals_[static_cast<std::size_t>(i)].bet(stake, x, std::clamp(point(i), edge, 1.0 - edge));
  }
  stake_.learn(x);
  sum_ += x;
  ++values_;
  // Half a capital was staked on either side. Evidence falls from both ends towards the mean of the values.
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

double BettingGrid::mean() const { return in_units(values_ == 0 ? 0.5 : sum_ / static_cast<double>(values_)); }

}  // namespace regista::statistics
