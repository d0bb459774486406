// SPDX-License-Identifier: MIT
#include "statistics/sign_flip.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace regista::statistics {
namespace {

constexpr Count most_exact = 4000;

// P(K = k) of a fair coin thrown n times, for all k.
std::vector<double> binomial(Count n) {
  std::vector<double> out(static_cast<std::size_t>(n) + 1);
  for (Count k = 0; k <= n; ++k) {
    const auto x = static_cast<double>(k), all = static_cast<double>(n);
    out[static_cast<std::size_t>(k)] =
        std::exp(std::lgamma(all + 1) - std::lgamma(x + 1) - std::lgamma(all - x + 1) - all * std::numbers::ln2);
  }
  return out;
}

constexpr std::size_t most_enumerated = 32;

// Sums of these values with all signs, ascending.
std::vector<double> signed_sums(std::span<const double> values) {
  std::vector<double> out{0.0};
  for (const double value : values) {
    const std::size_t before = out.size();
    for (std::size_t i = 0; i < before; ++i) {
      out.push_back(out[i] + value);
      out[i] -= value;
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

double sign_flip_p_of_values(std::span<const double> values) {
  std::vector<double> decided;
  double sum = 0.0, squares = 0.0, sizes = 0.0;
  for (const double value : values) {
    if (value == 0.0) continue;
    decided.push_back(value);
    sum += value;
    squares += value * value;
    sizes += std::abs(value);
  }
  if (decided.empty()) return 1.0;
  if (decided.size() > most_enumerated) {
    return std::min(1.0, std::erfc(std::abs(sum) / std::sqrt(squares) / std::numbers::sqrt2));
  }
  // Every signed sum is one of the first half plus one of the second: how many of the latter are far enough is found
  // by walking through them once. What differs from the observed sum by rounding alone is as far as that.
  const std::span<const double> all(decided);
  const std::vector<double> first = signed_sums(all.first(all.size() / 2));
  const std::vector<double> second = signed_sums(all.subspan(all.size() / 2));
  const double far = std::abs(sum) - 1e-12 * sizes;
  double beyond = 0.0;
  std::size_t from = second.size();  // the first of the second half that reaches `far`
  for (const double part : first) {
    while (from > 0 && part + second[from - 1] >= far) --from;
    beyond += static_cast<double>(second.size() - from);
  }
  const double of = static_cast<double>(first.size()) * static_cast<double>(second.size());
  return far <= 0.0 ? 1.0 : std::min(1.0, 2.0 * beyond / of);
}

bool sign_flip_of_values_is_exact(std::span<const double> values) {
  const auto zeros = static_cast<std::size_t>(std::count(values.begin(), values.end(), 0.0));
  return values.size() - zeros <= most_enumerated;
}

double sign_flip_p(const PairCounts& pairs) {
  // In quarters of a point above 1/2: -2, -1, 0, 1, 2.
  const Count ones = pairs.seen[1] + pairs.seen[3], twos = pairs.seen[0] + pairs.seen[4];
  const Count sum = std::abs(pairs.seen[3] - pairs.seen[1] + 2 * (pairs.seen[4] - pairs.seen[0]));
  if (sum == 0) return 1.0;
  if (ones + twos > most_exact) {
    const double deviation = std::sqrt(static_cast<double>(ones) + 4.0 * static_cast<double>(twos));
    // Sums differ by two, or by four where no single step is there.
    const double step = ones > 0 ? 1.0 : 2.0;
    return std::min(1.0, std::erfc((static_cast<double>(sum) - step) / deviation / std::numbers::sqrt2));
  }
  const std::vector<double> of_ones = binomial(ones), of_twos = binomial(twos);
  double tail = 0.0;
  for (Count k = 0; k <= twos; ++k) {
    const Count from_twos = 2 * (2 * k - twos);
    // Those numbers of heads among the ones that bring the sum to `sum` or more: 2 heads - ones >= sum - from_twos.
    const Count least = sum - from_twos + ones;
    double beyond = 0.0;
    for (Count heads = std::max<Count>(0, (least + 1) / 2); heads <= ones; ++heads) {
      beyond += of_ones[static_cast<std::size_t>(heads)];
    }
    tail += of_twos[static_cast<std::size_t>(k)] * beyond;
  }
  return std::min(1.0, 2.0 * tail);
}

}  // namespace regista::statistics
