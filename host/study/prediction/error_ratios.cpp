// SPDX-License-Identifier: MIT
#include "study/prediction/error_ratios.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "statistics/quantile.hpp"

namespace regista::study {
namespace {

constexpr std::size_t draws = 1000;

// Errors by size, and the blocks they come from, so that a drawn sample needs no sorting.
class Ordered {
 public:
  Ordered(std::span<const PairedError> errors, double PairedError::*error) {
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return errors[i].*error; });
    for (const std::size_t i : order) {
      values_.push_back(errors[i].*error);
      blocks_.push_back(errors[i].block);
    }
  }

  // The least error that `share` of the sample does not exceed. times: how often each block was drawn; total: their
  // errors.
  double quantile(double share, const std::vector<std::uint32_t>& times, std::size_t total) const {
    const double wanted = share * static_cast<double>(total);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      seen += times[blocks_[i]];
      if (static_cast<double>(seen) >= wanted) return values_[i];
    }
    return values_.back();
  }

 private:
  std::vector<double> values_;
  std::vector<std::size_t> blocks_;
};

ErrorRatio ratio_of(double value, std::vector<double>& drawn) {
  return {value, statistics::quantile(drawn, 0.025), statistics::quantile(drawn, 0.975)};
}

}  // namespace

ErrorRatios error_ratios(std::span<const PairedError> errors) {
  std::size_t blocks = 0;
  for (const PairedError& each : errors) blocks = std::max(blocks, each.block + 1);
  std::vector<std::size_t> sizes(blocks, 0);
  for (const PairedError& each : errors) ++sizes[each.block];
  std::vector<std::size_t> present;  // blocks without any error are no blocks
  for (std::size_t block = 0; block < blocks; ++block) {
    if (sizes[block] > 0) present.push_back(block);
  }

  const Ordered predictor(errors, &PairedError::predictor), baseline(errors, &PairedError::baseline);
  const auto ratio = [&](double share, const std::vector<std::uint32_t>& times, std::size_t total) {
    return predictor.quantile(share, times, total) / baseline.quantile(share, times, total);
  };
  const std::vector<std::uint32_t> once(blocks, 1);
  std::array<std::vector<double>, 2> drawn;
  std::vector<std::uint32_t> times(blocks);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::ranges::fill(times, 0U);
    std::size_t total = 0;
    for (std::size_t i = 0; i < present.size(); ++i) {
      const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(draw), 0, 0}};
      const double uniform = r123::Philox4x32{}(counter, r123::Philox4x32::key_type{{0, 0}})[0] * 0x1p-32;
      const std::size_t block = present[static_cast<std::size_t>(uniform * static_cast<double>(present.size()))];
      ++times[block];
      total += sizes[block];
    }
    drawn[0].push_back(ratio(0.5, times, total));
    drawn[1].push_back(ratio(0.9, times, total));
  }
  return {ratio_of(ratio(0.5, once, errors.size()), drawn[0]), ratio_of(ratio(0.9, once, errors.size()), drawn[1])};
}

}  // namespace regista::study
