// SPDX-License-Identifier: MIT
#include "statistics/sign_flip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

namespace regista::statistics {
namespace {

// Every way in which the decided pairs could have gone.
double by_counting(const PairCounts& pairs) {
  std::vector<int> steps(static_cast<std::size_t>(pairs.seen[1] + pairs.seen[3]), 1);
  steps.resize(steps.size() + static_cast<std::size_t>(pairs.seen[0] + pairs.seen[4]), 2);
  const auto seen = std::abs(pairs.seen[3] - pairs.seen[1] + 2 * (pairs.seen[4] - pairs.seen[0]));
  int as_far = 0;
  for (unsigned signs = 0; signs < 1u << steps.size(); ++signs) {
    int sum = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) sum += (signs >> i & 1u) != 0 ? steps[i] : -steps[i];
    as_far += std::abs(sum) >= seen ? 1 : 0;
  }
  return as_far / std::pow(2.0, static_cast<double>(steps.size()));
}

TEST(SignFlip, IsTheShareOfAllWays) {
  for (Count ll = 0; ll < 4; ++ll) {
    for (Count ld = 0; ld < 4; ++ld) {
      for (Count wd = 0; wd < 4; ++wd) {
        for (Count ww = 0; ww < 4; ++ww) {
          const PairCounts pairs{{ll, ld, 5, wd, ww}};
          EXPECT_NEAR(sign_flip_p(pairs), by_counting(pairs), 1e-12);
        }
      }
    }
  }
}

// Three pairs cannot say more than one in four, however they went.
TEST(SignFlip, FewPairsSayLittle) {
  EXPECT_DOUBLE_EQ(sign_flip_p(PairCounts{{0, 0, 0, 0, 3}}), 0.25);
  EXPECT_DOUBLE_EQ(sign_flip_p(PairCounts{{0, 0, 0, 1, 2}}), 0.25);
  EXPECT_DOUBLE_EQ(sign_flip_p(PairCounts{{0, 0, 9, 0, 0}}), 1.0);
  EXPECT_DOUBLE_EQ(sign_flip_p(PairCounts{}), 1.0);
}

// Where counting gives way to the normal law, both say the same.
TEST(SignFlip, ManyPairs) {
  for (const Count ahead : {20, 100, 200}) {
    const double exact = sign_flip_p(PairCounts{{0, 2000 - ahead / 2, 0, 2000 + ahead / 2, 0}});
    const double normal = sign_flip_p(PairCounts{{0, 2001 - ahead / 2, 0, 2001 + ahead / 2, 0}});
    EXPECT_NEAR(normal / exact, 1.0, 0.02) << ahead;
  }
  EXPECT_LT(sign_flip_p(PairCounts{{10'000'000, 0, 0, 0, 20'000'000}}), 1e-300);
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
