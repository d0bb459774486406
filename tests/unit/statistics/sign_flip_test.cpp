// SPDX-License-Identifier: MIT
#include "statistics/paired_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

namespace regista::statistics {
namespace {

// Every way in which the decided pairs could have gone.
double by_counting(const WholeCounts& seen) {
  std::vector<std::int64_t> steps;
  std::int64_t of_all = 0;
  for (const auto& [value, count] : seen) {
    of_all += value * count;
    if (value != 0) steps.insert(steps.end(), static_cast<std::size_t>(count), value);
  }
  int as_far = 0;
  for (unsigned signs = 0; signs < 1u << steps.size(); ++signs) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) sum += (signs >> i & 1u) != 0 ? steps[i] : -steps[i];
    as_far += std::abs(sum) >= std::abs(of_all) ? 1 : 0;
  }
  return as_far / std::pow(2.0, static_cast<double>(steps.size()));
}

TEST(SignFlip, IsTheShareOfAllWays) {
  for (Count a = 0; a < 4; ++a) {
    for (Count b = 0; b < 4; ++b) {
      for (Count c = 0; c < 4; ++c) {
        for (Count d = 0; d < 4; ++d) {
          const WholeCounts pairs{{-2, a}, {-1, b}, {0, 5}, {1, c}, {2, d}};
          EXPECT_NEAR(sign_flip_p(pairs), by_counting(pairs), 1e-12);
          const WholeCounts far{{-9, a}, {-3, b}, {6, c}, {15, d}};
          EXPECT_NEAR(sign_flip_p(far), by_counting(far), 1e-12);
        }
      }
    }
  }
}

// Three pairs cannot say more than one in four, however they went; five say no 5 %, six do.
TEST(SignFlip, FewPairsSayLittle) {
  EXPECT_DOUBLE_EQ(sign_flip_p({{4, 3}}), 0.25);
  EXPECT_DOUBLE_EQ(sign_flip_p({{1, 1}, {2, 2}}), 0.25);
  EXPECT_DOUBLE_EQ(sign_flip_p({{0, 9}}), 1.0);
  EXPECT_DOUBLE_EQ(sign_flip_p(WholeCounts{}), 1.0);
  EXPECT_GT(sign_flip_p({{7, 5}}), 0.05);
  EXPECT_LT(sign_flip_p({{7, 6}}), 0.05);
}

// Exact p of many equal steps, where the normal law without correction says 0.0455.
TEST(SignFlip, OfMoreThanCanBeCountedOneByOne) {
  EXPECT_NEAR(sign_flip_p({{1, 24}, {-1, 12}}), 0.0652, 0.0001);
  const std::vector<double> values = [] {
    std::vector<double> out(24, 0.5);
    out.insert(out.end(), 12, -0.5);
    return out;
  }();
  EXPECT_TRUE(sign_flip_of_values_is_exact(values));
  EXPECT_NEAR(sign_flip_p_of_values(values), 0.0652, 0.0001);
}

// Where heads are left out that never come, nothing jumps; and half a million of each sign is nothing.
TEST(SignFlip, ManyPairs) {
  for (const Count ahead : {20, 200, 400}) {
    const double all = sign_flip_p({{-1, 2048 - ahead / 2}, {1, 2048 + ahead / 2}});
    const double some = sign_flip_p({{-1, 2049 - ahead / 2}, {1, 2049 + ahead / 2}});
    EXPECT_NEAR(some / all, 1.0, 0.02) << ahead;
  }
  // By the normal law with continuity correction, which a million pairs leave no room beside.
  const double z = (2000.0 - 1.0) / std::sqrt(1e6);
  EXPECT_NEAR(sign_flip_p({{-1, 499'000}, {1, 501'000}}), std::erfc(z / std::sqrt(2.0)), 1e-6);
  EXPECT_NEAR(sign_flip_p({{-2, 249'000}, {2, 250'000}, {1, 251'000}, {-1, 250'000}}),
              std::erfc((3000.0 - 1.0) / std::sqrt(4.0 * 499'000 + 501'000) / std::sqrt(2.0)), 1e-6);
  EXPECT_LT(sign_flip_p({{-2, 10'000'000}, {2, 20'000'000}}), 1e-300);
}

// The size of the test is what it says, or less: over all numbers of equal steps.
TEST(SignFlip, RejectsNoMoreThanItSays) {
  for (Count n = 6; n < 400; n += 13) {
    double size = 0.0;
    for (Count won = 0; won <= n; ++won) {
      if (sign_flip_p({{-1, n - won}, {1, won}}) > 0.05) continue;
      const auto x = static_cast<double>(won), all = static_cast<double>(n);
      size += std::exp(std::lgamma(all + 1) - std::lgamma(x + 1) - std::lgamma(all - x + 1) - all * std::log(2.0));
    }
    EXPECT_LE(size, 0.05) << n;
    EXPECT_GT(size, 0.015) << n;
  }
}

// The same for any values, against all signs one by one; a value of 0 says nothing.
TEST(SignFlip, OfValuesIsTheShareOfAllSigns) {
  const std::vector<double> values{0.31, -1.7, 2.25, 0.0, 0.9, -0.44, 3.1, 1.05, -0.02, 0.6, 0.61, -2.0, 0.33};
  for (std::size_t count = 0; count <= values.size(); ++count) {
    const std::span<const double> used = std::span(values).first(count);
    double seen = 0.0;
    for (const double value : used) seen += value;
    int as_far = 0;
    for (unsigned signs = 0; signs < 1u << count; ++signs) {
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) sum += (signs >> i & 1u) != 0 ? used[i] : -used[i];
      as_far += std::abs(sum) >= std::abs(seen) - 1e-9 ? 1 : 0;
    }
    EXPECT_NEAR(sign_flip_p_of_values(used), as_far / std::pow(2.0, static_cast<double>(count)), 1e-12) << count;
  }
}

TEST(SignFlip, OfEqualValuesIsThatOfCoins) {
  for (const std::size_t count : {1u, 2u, 5u, 31u, 32u}) {
    const std::vector<double> values(count, 0.1);
    EXPECT_NEAR(sign_flip_p_of_values(values) / std::pow(2.0, 1.0 - static_cast<double>(count)), 1.0, 1e-9) << count;
  }
}

TEST(SignFlip, OfManyValuesIsNearlyThatOfFewer) {
  std::vector<double> values;
  for (int i = 0; i < 32; ++i) values.push_back((i % 3 == 0 ? -1.0 : 1.0) + 0.01 * i);
  const double exact = sign_flip_p_of_values(values);
  values.push_back(1e-9);  // now by the normal law
  EXPECT_NEAR(sign_flip_p_of_values(values), exact, 0.1 * exact);
}

}  // namespace
}  // namespace regista::statistics
