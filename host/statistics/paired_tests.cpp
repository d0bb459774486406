// SPDX-License-Identifier: MIT
#include "statistics/paired_tests.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <numeric>

namespace regista::statistics {
namespace {

// A distribution of whole numbers: the probability of the number `first`, then of the numbers after it.
struct WholeLaw {
  std::int64_t first = 0;
  std::vector<double> probabilities{1.0};
};

constexpr Count all_of_a_binomial = 4096;  // up to this number of coins, heads_of() keeps all numbers of heads
// For more coins than all_of_a_binomial, heads_of() keeps the numbers within 16 standard deviations. The rest has a
// probability of 1e-57.
constexpr double kept_deviations = 16.0;
constexpr double far_deviations = 12.0;

// Returns the distribution of the number of heads of `coins` fair coins.
WholeLaw heads_of(Count coins) {
  Count least = 0, most = coins;
  if (coins > all_of_a_binomial) {
    const auto reach = static_cast<Count>(kept_deviations * std::sqrt(static_cast<double>(coins)) / 2.0) + 1;
    least = coins / 2 - reach;
    most = coins / 2 + reach;
  }
  WholeLaw out{least, {}};
  const auto all = static_cast<double>(coins);
  for (Count heads = least; heads <= most; ++heads) {
    const auto x = static_cast<double>(heads);
    out.probabilities.push_back(
        std::exp(std::lgamma(all + 1) - std::lgamma(x + 1) - std::lgamma(all - x + 1) - all * std::numbers::ln2));
  }
  return out;
}

// Returns the distribution of x + step * y for independent x and y with the distributions `law` and `other`.
WholeLaw sum_of(const WholeLaw& law, const WholeLaw& other, std::int64_t step) {
  const std::size_t width = static_cast<std::size_t>(step);
  WholeLaw out{law.first + step * other.first, {}};
  out.probabilities.assign(law.probabilities.size() + width * (other.probabilities.size() - 1), 0.0);
  for (std::size_t i = 0; i < other.probabilities.size(); ++i) {
    const double probability = other.probabilities[i];
    double* const to = out.probabilities.data() + width * i;
    for (std::size_t j = 0; j < law.probabilities.size(); ++j) to[j] += probability * law.probabilities[j];
  }
  // Ends with a smaller probability are dropped.
  constexpr double unseen = 1e-290;
  const auto seen = [](double each) { return each > unseen; };
  const auto begin = std::ranges::find_if(out.probabilities, seen);
  const auto end = std::find_if(out.probabilities.rbegin(), out.probabilities.rend(), seen).base();
  out.first += begin - out.probabilities.begin();
  out.probabilities = std::vector<double>(begin, end);
  return out;
}

// Returns the counts of the values in units of 1/2, or nothing if a value is not a multiple of 1/2.
std::optional<WholeCounts> in_halves(std::span<const double> values) {
  constexpr double most = 1e6;
  WholeCounts out;
  for (const double value : values) {
    const double halves = 2.0 * value;
    if (halves != std::round(halves) || std::abs(halves) > most) return std::nullopt;
    ++out[static_cast<std::int64_t>(halves)];
  }
  return out;
}

constexpr std::size_t most_enumerated = 32;

// Returns the sums of the values for all choices of their signs, ascending.
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

// For more pairs than this number N, the step 2/2^N of p values is negligible compared with a level.
constexpr std::int64_t most_with_steps = 50;

// Returns the largest p value at which the test rejects; 0 if the test cannot reject.
double reached_level(std::int64_t pairs, const PowerDesign& design) {
  const double level = design.alpha / static_cast<double>(design.family);
  if (design.test == PairedTest::student_t || pairs > most_with_steps) return level;
  const double step = std::ldexp(2.0, -static_cast<int>(pairs));
  return std::floor(level / step) * step;
}

// Returns the power of so many pairs by Student's t; mean: 0 or more.
double power_of_t(std::int64_t pairs, double mean, double standard_deviation, const PowerDesign& design) {
  const double level = reached_level(pairs, design);
  if (pairs < 2 || level <= 0.0) return 0.0;
  const auto n = static_cast<double>(pairs);
  const double degrees = n - 1.0, noncentrality = mean / standard_deviation * std::sqrt(n);
  const double least = student_t_quantile(1.0 - level / 2.0, degrees);
  return noncentral_t_above(least, degrees, noncentrality) + noncentral_t_above(least, degrees, -noncentrality);
}

// Returns the power of a sign test of so many uneven pairs, each of which has one sign with this probability. mixed:
// sign flips of differences of many sizes reach their level, as a sign test does that decides its border by chance.
double power_of_signs(std::int64_t pairs, double probability, bool mixed, const PowerDesign& design) {
  const double level = reached_level(mixed ? pairs : most_with_steps + 1, design) / 2.0;
  std::int64_t below = pairs / 2, least = pairs;  // `least` equal signs reject, `below` do not
  while (least - below > 1) {
    const std::int64_t middle = below + (least - below) / 2;
    (binomial_at_least(middle, pairs, 0.5) <= level ? least : below) = middle;
  }
  const double equal = binomial_at_least(least, pairs, 0.5), next = binomial_at_least(least - 1, pairs, 0.5);
  const double border = mixed ? (level - equal) / (next - equal) : 0.0;
  const auto with = [&](double each) {
    return std::lerp(binomial_at_least(least, pairs, each), binomial_at_least(least - 1, pairs, each), border);
  };
  return with(probability) + with(1.0 - probability);
}

[[maybe_unused]] bool is_sound(const PowerDesign& design) {
  return design.alpha > 0.0 && design.alpha < 1.0 && design.family >= 1 && design.power > design.alpha &&
         design.power < 1.0;
}

}  // namespace

std::optional<PairedT> paired_t(std::span<const double> values, double confidence) {
  // Compares the values and not their variance, because rounding gives equal values such as 0.1 a tiny variance.
  const auto differs = [&](double value) { return value != values.front(); };
  if (values.size() < 2 || std::none_of(values.begin(), values.end(), differs)) return std::nullopt;
  return paired_t(Moments(values), confidence);
}

std::optional<PairedT> paired_t(const Moments& moments, double confidence) {
  if (moments.count() < 2) return std::nullopt;
  const double error = moments.standard_deviation() / std::sqrt(static_cast<double>(moments.count()));
  if (!(error > 0.0)) return std::nullopt;
  const double degrees = static_cast<double>(moments.count() - 1);
  const double t = moments.mean() / error;
  const double margin = student_t_quantile(0.5 + confidence / 2.0, degrees) * error;
  return PairedT{moments.count(),
                 moments.mean(),
                 moments.standard_deviation(),
                 t,
                 student_t_outside(t, degrees),
                 {moments.mean() - margin, moments.mean() + margin}};
}

double sign_flip_p_of_values(std::span<const double> values) {
  if (const auto whole = in_halves(values)) return sign_flip_p(*whole);
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
  // Every signed sum is a sum of the first half plus a sum of the second half. One pass through the sums of the second
  // half counts the total sums far enough from 0. Sums that differ from the observed sum by rounding count as equal.
  const std::span<const double> all(decided);
  const std::vector<double> first = signed_sums(all.first(all.size() / 2));
  const std::vector<double> second = signed_sums(all.subspan(all.size() / 2));
  const double far = std::abs(sum) - 1e-12 * sizes;
  double beyond = 0.0;
  std::size_t from = second.size();  // first sum of the second half that reaches `far`
  for (const double part : first) {
    while (from > 0 && part + second[from - 1] >= far) --from;
    beyond += static_cast<double>(second.size() - from);
  }
  const double of = static_cast<double>(first.size()) * static_cast<double>(second.size());
  return far <= 0.0 ? 1.0 : std::min(1.0, 2.0 * beyond / of);
}

bool sign_flip_of_values_is_exact(std::span<const double> values) {
  if (in_halves(values)) return true;
  const auto zeros = static_cast<std::size_t>(std::count(values.begin(), values.end(), 0.0));
  return values.size() - zeros <= most_enumerated;
}

double sign_flip_p(const WholeCounts& seen) {
  std::map<std::int64_t, Count> sizes;
  std::int64_t sum = 0, divisor = 0;
  for (const auto& [value, count] : seen) {
    if (value == 0 || count == 0) continue;
    sizes[std::abs(value)] += count;
    sum += value * count;
    divisor = std::gcd(divisor, value);
  }
  if (sum == 0) return 1.0;
  // If h of the n values of one size have the sign of the sum, these n values contribute size (2 h - n). The total over
  // all sizes is 2 (sum of size h) - (sum of size n).
  double squares = 0.0;
  std::int64_t largest = 0;
  bool many = false;
  for (const auto& [size, count] : sizes) {
    const auto each = static_cast<double>(size / divisor);
    squares += each * each * static_cast<double>(count);
    largest += size / divisor * count;
    many = many || count > all_of_a_binomial;
  }
  const std::int64_t far = std::abs(sum) / divisor;
  const double deviations = static_cast<double>(far) / std::sqrt(squares);
  if (many && deviations > far_deviations) return 2.0 * std::exp(-deviations * deviations / 2.0);
  WholeLaw law;
  for (const auto& [size, count] : sizes) law = sum_of(law, heads_of(count), size / divisor);
  const std::int64_t least = (far + largest) / 2;
  double tail = 0.0;
  for (std::size_t i = law.probabilities.size(); i-- > 0;) {
    if (law.first + static_cast<std::int64_t>(i) < least) break;
    tail += law.probabilities[i];
  }
  return std::min(1.0, 2.0 * tail);
}

std::int64_t smallest_pairs(const PowerDesign& design) {
  assert(design.alpha > 0.0 && design.alpha < 1.0 && design.family >= 1);
  if (design.test == PairedTest::student_t) return 2;
  const double level = design.alpha / static_cast<double>(design.family);
  std::int64_t pairs = 1;
  for (double p = 1.0; p > level; p /= 2.0) ++pairs;
  return pairs;
}

double power_of(std::int64_t pairs, double difference, const Spread& spread, const PowerDesign& design) {
  assert(is_sound(design) && spread.deviation > 0.0);
  const double mean = std::abs(difference);
  double square = spread.deviation * spread.deviation + mean * mean;
  // A pilot whose mean is large shows too small a spread for another mean: each uneven pair differs by `unit` or more.
  square = std::max({square, spread.unit * mean, spread.uneven * spread.unit * spread.unit});
  const double share = std::min(1.0, std::max(spread.uneven, mean * mean / square));
  const double sizes = square / share / (spread.unit * spread.unit);
  const bool mixed = !(sizes < 1.3);
  if (design.test == PairedTest::student_t || (spread.uneven > 0.75 && sizes > 4.0))
    return power_of_t(pairs, mean, spread.deviation, design);
  const double probability = std::min(1.0, (1.0 + mean / std::sqrt(square * share)) / 2.0);
  const double middle = share * static_cast<double>(pairs), reach = 6.0 * std::sqrt(middle * (1.0 - share)) + 1.0;
  const auto step = 1 + static_cast<std::int64_t>(reach / 30.0), most = static_cast<std::int64_t>(middle + reach);
  double out = 0.0;
  for (auto uneven = std::max(smallest_pairs(design), static_cast<std::int64_t>(middle - reach));
       uneven <= std::min(pairs, most); uneven += step)
    out += (binomial_at_least(uneven, pairs, share) - binomial_at_least(uneven + step, pairs, share)) *
           power_of_signs(std::min(pairs, uneven + (step - 1) / 2), probability, mixed, design);
  return out;
}

std::optional<std::int64_t> pairs_needed(double difference, const Spread& spread, const PowerDesign& design) {
  assert(difference != 0.0);
  const auto enough = [&](std::int64_t pairs) { return power_of(pairs, difference, spread, design) >= design.power; };
  const std::int64_t fewest = smallest_pairs(design);
  if (enough(fewest)) return fewest;
  // Power grows with the number of pairs, but for the steps of a sign test of equal sizes: there the result is one of
  // several borders. `below` pairs are too few, and `above` pairs are enough.
  std::int64_t below = fewest, above = 2 * fewest;
  while (!enough(above)) {
    if (above >= most_pairs_asked) return std::nullopt;
    below = above;
    above = std::min(2 * above, most_pairs_asked);
  }
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (enough(middle) ? above : below) = middle;
  }
  return above;
}

std::optional<double> difference_found(std::int64_t pairs, const Spread& spread, const PowerDesign& design) {
  if (pairs < smallest_pairs(design)) return std::nullopt;
  const auto enough = [&](double difference) { return power_of(pairs, difference, spread, design) >= design.power; };
  double below = 0.0, above = spread.deviation;
  while (!enough(above)) {
    below = above;
    above *= 2.0;
  }
  constexpr double precision = 1e-9;  // of the difference, relative to the standard deviation
  while (above - below > precision * spread.deviation) {
    const double middle = (below + above) / 2.0;
    (enough(middle) ? above : below) = middle;
  }
  return above;
}

std::array<Spread, 2> spread_interval(const Spread& spread, std::int64_t values) {
  assert(values >= 2);
  const auto degrees = static_cast<double>(values - 1);
  const std::int64_t even = std::llround((1.0 - spread.uneven) * static_cast<double>(values));
  const double low = degrees / chi_squared_quantile(0.975, degrees),
               high = degrees / chi_squared_quantile(0.025, degrees);
  const auto scaled = [&](double variance, double share) {
    return Spread(spread.deviation * std::sqrt(variance), spread.uneven * share, spread.unit);
  };
  const double fewer = binomial_share_at_least(values - even, values, 0.025) / spread.uneven;
  const double more = (1.0 - binomial_share_at_least(std::max<std::int64_t>(even, 1), values, 0.025)) / spread.uneven;
  return {even > 0 && fewer < low ? scaled(fewer, fewer) : scaled(low, 1.0),
          even > 0 && more > high ? scaled(more, more) : scaled(high, 1.0)};
}

std::vector<double> holm(std::span<const double> p) {
  // `order` has the indices by ascending p. Equal p keep their order, so that every compiler gives the same order.
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    assert(p[order[rank]] >= 0.0 && p[order[rank]] <= 1.0);
    largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

}  // namespace regista::statistics
