// SPDX-License-Identifier: MIT
// OSPA has the properties that its publication proves, and the values that its definition gives by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <regista/testkit/ospa.hpp>

namespace regista::testkit {
namespace {

using Points = std::vector<PlanePoint>;

TEST(Ospa, HasTheValuesOfItsDefinition) {
  EXPECT_EQ(ospa({}, {}, 1.0), 0.0);
  EXPECT_EQ(ospa({{0, 0}}, {}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(ospa({}, {{0, 0}, {1, 1}, {5, 5}}, 0.7), 0.7) << "every cardinality error alone costs the cut-off";
  EXPECT_DOUBLE_EQ(ospa({{0, 0}}, {{0.3, 0.4}}, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(ospa({{0, 0}}, {{3, 4}}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(ospa({{0, 0}, {1, 0}}, {{1, 0}, {0, 0}}, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(ospa({{0, 0}, {1, 0}, {5, 5}}, {{1, 0.3}, {0, 0}}, 2.0), (0.3 + 2.0) / 3.0);
  EXPECT_DOUBLE_EQ(ospa({{0, 0}, {1, 0}, {5, 5}}, {{1, 0.3}, {0, 0}}, 2.0, 2.0), std::sqrt((0.09 + 4.0) / 3.0));
  EXPECT_THROW(ospa(Points(21), {}, 1.0), std::length_error);
}

class OspaProperties : public testing::Test {
 protected:
  Points points(std::size_t most) {
    Points out(std::uniform_int_distribution<std::size_t>(0, most)(random));
    for (PlanePoint& point : out) point = {coordinate(random), coordinate(random)};
    return out;
  }
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> coordinate{-2.0, 2.0};
};

TEST_F(OspaProperties, IsAMetricBoundedByTheCutOff) {
  for (const double order : {1.0, 2.0, 3.5}) {
    for (int i = 0; i < 1000; ++i) {
      const Points a = points(5), b = points(5), c = points(5);
      const double ab = ospa(a, b, 1.2, order), bc = ospa(b, c, 1.2, order), ac = ospa(a, c, 1.2, order);
      EXPECT_EQ(ospa(a, a, 1.2, order), 0.0);
      EXPECT_NEAR(ab, ospa(b, a, 1.2, order), 1e-12) << "but for the order of summation";
      EXPECT_LE(ac, ab + bc + 1e-12) << "triangle inequality";
      EXPECT_GE(ab, 0.0);
      EXPECT_LE(ab, 1.2 + 1e-12);
    }
  }
}

TEST_F(OspaProperties, GrowsWithOrderAndCutOff) {
  for (int i = 0; i < 1000; ++i) {
    const Points a = points(6), b = points(6);
    EXPECT_LE(ospa(a, b, 1.0, 1.0), ospa(a, b, 1.0, 2.0) + 1e-12);
    EXPECT_LE(ospa(a, b, 1.0, 2.0), ospa(a, b, 1.0, 4.0) + 1e-12);
    EXPECT_LE(ospa(a, b, 1.0, 2.0), ospa(a, b, 1.5, 2.0) + 1e-12);
  }
}

TEST_F(OspaProperties, IsTheBestOfAllPairings) {
  for (int i = 0; i < 300; ++i) {
    const Points a = points(6), b = points(6);
    const Points &few = a.size() <= b.size() ? a : b, &many = a.size() <= b.size() ? b : a;
    if (many.empty()) continue;
    std::vector<std::size_t> order(many.size());
    std::iota(order.begin(), order.end(), 0);
    double best = 1e9;
    do {
      double sum = static_cast<double>(many.size() - few.size());
      for (std::size_t k = 0; k < few.size(); ++k) {
        sum += std::min(1.0, std::hypot(few[k].x - many[order[k]].x, few[k].y - many[order[k]].y));
      }
      best = std::min(best, sum / static_cast<double>(many.size()));
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(ospa(a, b, 1.0), best, 1e-12);
  }
}

}  // namespace
}  // namespace regista::testkit
