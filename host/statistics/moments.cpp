// SPDX-License-Identifier: MIT
#include "statistics/moments.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace regista::statistics {

double quantile(std::span<const double> values, double probability) {
  assert(!values.empty() && probability >= 0.0 && probability <= 1.0);
  std::vector<double> ordered(values.begin(), values.end());
  std::ranges::sort(ordered);
  const double place = probability * static_cast<double>(ordered.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  if (below + 1 >= ordered.size()) return ordered.back();
  return ordered[below] + (place - std::floor(place)) * (ordered[below + 1] - ordered[below]);
}

namespace {

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Binomial = boost::math::binomial_distribution<double, Policy>;
using ChiSquared = boost::math::chi_squared_distribution<double, Policy>;
using FisherF = boost::math::fisher_f_distribution<double, Policy>;
using NoncentralT = boost::math::non_central_t_distribution<double, Policy>;
using Normal = boost::math::normal_distribution<double, Policy>;
using StudentT = boost::math::students_t_distribution<double, Policy>;

[[maybe_unused]] bool is_probability(double value) { return value > 0.0 && value < 1.0; }

}  // namespace

double student_t_outside(double t, double degrees) {
  assert(degrees > 0.0);
  return 2.0 * boost::math::cdf(boost::math::complement(StudentT(degrees), std::abs(t)));
}

double student_t_quantile(double probability, double degrees) {
  assert(is_probability(probability) && degrees > 0.0);
  return boost::math::quantile(StudentT(degrees), probability);
}

double noncentral_t_above(double t, double degrees, double noncentrality) {
  assert(degrees > 0.0);
  // Beyond these limits the series of Boost needs too many terms. The normal law of the same mean and second-order
  // variance errs by less than 1e-6: Abramowitz and Stegun, "Handbook of Mathematical Functions", 26.7.10.
  constexpr double most_degrees = 1e4, most_noncentrality = 30.0;
  if (degrees > most_degrees || std::abs(noncentrality) > most_noncentrality) {
    const double z = (t * (1.0 - 1.0 / (4.0 * degrees)) - noncentrality) / std::sqrt(1.0 + t * t / (2.0 * degrees));
    return boost::math::cdf(boost::math::complement(Normal(), z));
  }
  return boost::math::cdf(boost::math::complement(NoncentralT(degrees, noncentrality), t));
}

double chi_squared_quantile(double probability, double degrees) {
  assert(is_probability(probability) && degrees > 0.0);
  return boost::math::quantile(ChiSquared(degrees), probability);
}

double fisher_f_above(double f, double degrees, double residual_degrees) {
  assert(degrees > 0.0 && residual_degrees > 0.0);
  return boost::math::cdf(boost::math::complement(FisherF(degrees, residual_degrees), f));
}

double binomial_share_at_least(std::int64_t successes, std::int64_t trials, double tail) {
  assert(is_probability(tail) && successes >= 0 && successes <= trials && trials > 0);
  if (successes == 0) return 0.0;
  return Binomial::find_lower_bound_on_p(static_cast<double>(trials), static_cast<double>(successes), tail);
}

double binomial_at_least(std::int64_t successes, std::int64_t trials, double rate) {
  if (successes <= 0 || successes > trials) return successes <= 0 ? 1.0 : 0.0;
  const Binomial law(static_cast<double>(trials), rate);
  return boost::math::cdf(boost::math::complement(law, static_cast<double>(successes - 1)));
}

std::optional<TwoWayAnalysis> two_way_analysis(std::span<const std::vector<double>> values) {
  const std::size_t rows = values.size();
  if (rows < 2) return std::nullopt;
  std::vector<std::size_t> blocks;  // complete blocks
  for (std::size_t block = 0; block < values.front().size(); ++block) {
    const auto known = [&](const std::vector<double>& row) { return block < row.size() && !std::isnan(row[block]); };
    if (std::ranges::all_of(values, known)) blocks.push_back(block);
  }
  if (blocks.size() < 2) return std::nullopt;
  const auto r = static_cast<double>(rows), b = static_cast<double>(blocks.size());
  std::vector<double> of_row(rows, 0.0), of_block(blocks.size(), 0.0);
  double mean = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      of_row[i] += values[i][blocks[j]] / b;
      of_block[j] += values[i][blocks[j]] / r;
    }
    mean += of_row[i] / r;
  }
  double between = 0.0, residual = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    between += b * (of_row[i] - mean) * (of_row[i] - mean);
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      const double rest = values[i][blocks[j]] - of_row[i] - of_block[j] + mean;
      residual += rest * rest;
      largest = std::max(largest, std::abs(values[i][blocks[j]]));
    }
  }
  // Rounding gives equal values slightly different means. Differences within this bound count as 0.
  const double rounding = std::numeric_limits<double>::epsilon() * largest * (r + b);
  if (between <= r * b * rounding * rounding) between = 0.0;
  if (residual <= r * b * rounding * rounding) residual = 0.0;
  const double row_degrees = r - 1.0, residual_degrees = (r - 1.0) * (b - 1.0);
  const double row_square = between / row_degrees, residual_square = residual / residual_degrees;
  TwoWayAnalysis out;
  out.variance_of_rows = std::max(0.0, (row_square - residual_square) / b);
  if (residual_square > 0.0) {
    out.f = row_square / residual_square;
    out.p = fisher_f_above(out.f, row_degrees, residual_degrees);
  } else if (row_square > 0.0) {
    out.f = infinite;
    out.p = 0.0;
  }
  return out;
}

std::optional<double> variance_ratio(const PairCounts& pairs, const GameCounts& games) {
  if (total(pairs) == 0 || total(games) == 0) return std::nullopt;
  const SeenScores of_pairs = seen_scores(score_law(pairs)), of_games = seen_scores(score_law(games));
  if (of_games.squares == 0.0) return std::nullopt;
  const auto variance = [](const SeenScores& seen) { return seen.squares / static_cast<double>(seen.units); };
  return 2.0 * variance(of_pairs) / variance(of_games);
}

std::optional<double> variance_ratio(const Moments& means, const Moments& all) {
  if (means.count() < 2 || !(all.variance() > 0.0)) return std::nullopt;
  return 2.0 * means.variance() / all.variance();
}

}  // namespace regista::statistics
