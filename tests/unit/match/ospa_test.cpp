// SPDX-License-Identifier: MIT
// OSPA against closed forms, the axioms of a metric, and all assignments tried one by one.
#include "match/metrics_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace regista::match {
namespace {

using Places = std::vector<Vector>;

double sum(const OspaParts& parts) { return parts.location + parts.cardinality; }

TEST(Ospa, ClosedForms) {
  Ospa ospa(2.0, 4);
  EXPECT_EQ(sum(ospa(Places{}, Places{})), 0.0);
  const Places one{{1.0, 1.0}};
  EXPECT_EQ(sum(ospa(one, Places{})), 2.0);
  EXPECT_EQ(ospa(Places{}, one).cardinality, 2.0);
  EXPECT_EQ(sum(ospa(one, one)), 0.0);
  EXPECT_DOUBLE_EQ(ospa(one, Places{{1.3, 1.4}}).location, 0.5);
  EXPECT_EQ(ospa(one, Places{{9.0, 1.0}}).location, 2.0) << "cut off";
  // Schuhmacher, Vo and Vo 2008, section III: (1/n) (sum of distances + c (n - m)).
  const OspaParts parts = ospa(one, Places{{1.0, 2.0}, {5.0, 5.0}});
  EXPECT_DOUBLE_EQ(parts.location, 0.5);
  EXPECT_DOUBLE_EQ(parts.cardinality, 1.0);
}

TEST(Ospa, TheNearestOfEachIsNotAlwaysTheBest) {
  Ospa ospa(10.0, 2);
  // Who takes the nearest first pays 1 + 5; the others 2 + 2.
  EXPECT_DOUBLE_EQ(ospa(Places{{0.0, 0.0}, {2.0, 0.0}}, Places{{0.0, 2.0}, {2.0, 2.0}}).location, 2.0);
  EXPECT_DOUBLE_EQ(ospa(Places{{0.0, 0.0}, {3.0, 0.0}}, Places{{1.0, 0.0}, {-2.0, 0.0}}).location, 2.0);
}

double by_trying_all(const Places& a, const Places& b, double cutoff) {
  const Places &few = a.size() <= b.size() ? a : b, &many = a.size() <= b.size() ? b : a;
  if (many.empty()) return 0.0;
  std::vector<std::size_t> order(many.size());
  std::iota(order.begin(), order.end(), 0u);
  double best = std::numeric_limits<double>::infinity();
  do {
    double sum = cutoff * static_cast<double>(many.size() - few.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      sum += std::min(cutoff, std::hypot(few[i].x - many[order[i]].x, few[i].y - many[order[i]].y));
    }
    best = std::min(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best / static_cast<double>(many.size());
}

Places random_places(std::mt19937& random, std::size_t most) {
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0);
  Places out(random() % (most + 1));
  for (Vector& each : out) {
    each.x = x(random);
    each.y = y(random);
  }
  return out;
}

TEST(Ospa, IsTheBestOfAllAssignments) {
  std::mt19937 random(1);
  Ospa ospa(2.0, 7);
  for (int i = 0; i < 400; ++i) {
    const Places a = random_places(random, 7), b = random_places(random, 7);
    EXPECT_NEAR(sum(ospa(a, b)), by_trying_all(a, b, 2.0), 1e-12) << a.size() << " and " << b.size();
  }
}

TEST(Ospa, IsAMetric) {
  std::mt19937 random(2);
  Ospa ospa(2.0, 22);
  for (int i = 0; i < 1000; ++i) {
    const Places a = random_places(random, 22), b = random_places(random, 22), c = random_places(random, 22);
    const double ab = sum(ospa(a, b)), bc = sum(ospa(b, c)), ac = sum(ospa(a, c));
    EXPECT_NEAR(ab, sum(ospa(b, a)), 1e-12);
    EXPECT_LE(ac, ab + bc + 1e-12);
    EXPECT_GE(ab, 0.0);
    EXPECT_LE(ab, 2.0 + 1e-12);
    EXPECT_EQ(sum(ospa(a, a)), 0.0);
    Places shuffled = a;
    std::ranges::shuffle(shuffled, random);
    EXPECT_NEAR(sum(ospa(a, shuffled)), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace regista::match
