// SPDX-License-Identifier: MIT
// The field against values by hand, the search against trying every point, and what must hold of any scene.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "field.hpp"

namespace {

using namespace preferred_poses;

constexpr Lawn lawn{4.5, 3.0};

double value(const Point& p, const std::vector<Point>& mates, const std::vector<Point>& opponents, const Point& home) {
  return value_at(p, {mates, opponents, home, std::nullopt}, lawn, {});
}

TEST(PreferredPoses, ValuesByHand) {
  EXPECT_DOUBLE_EQ(value({0, 0}, {}, {}, {0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(value({0.3, 0.4}, {}, {}, {0, 0}), 0.75);  // half a metre of two
  EXPECT_DOUBLE_EQ(value({3, 0}, {}, {}, {0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(value({0, 0}, {{0.6, 0.8}}, {}, {0, 0}), 1.0 - (1.0 - 1.0 / 1.5));
  EXPECT_DOUBLE_EQ(value({0, 0}, {{0, 1.6}}, {{0, 1.1}}, {0, 0}), 1.0);  // out of reach
  EXPECT_DOUBLE_EQ(value({0, 0}, {}, {{0.3, 0.4}}, {0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(value({0, 0}, {{0, 0}, {0, 0.75}}, {{0, 0}}, {0, 0}), 1.0 - 1.0 - 0.5 - 1.0);
  EXPECT_DOUBLE_EQ(value({0, 2.75}, {}, {}, {0, 2.75}), 0.5);  // a quarter of a metre from the touch line
  EXPECT_DOUBLE_EQ(value({-4.5, 0}, {}, {}, {-4.5, 0}), 0.0);
  EXPECT_NEAR(value({4.4, -2.9}, {}, {}, {4.4, -2.9}), 1.0 - 0.8, 1e-12);  // the nearer line alone
  // All of it: home 0.5 m off, a mate 0.9 m, an opponent 0.5 m, the line 0.3 m.
  EXPECT_NEAR(value({0, 2.7}, {{0.9, 2.7}}, {{-0.4, 2.4}}, {0.3, 2.3}), 0.75 - 0.4 - 0.5 - 0.4, 1e-15);
}

TEST(PreferredPoses, NothingNearNothingMoves) {
  Search search;
  const Point best = search.best({{}, {}, {0.13, -0.07}, std::nullopt}, lawn, {});
  EXPECT_EQ(best.x, 0.13);
  EXPECT_EQ(best.y, -0.07);
}

TEST(PreferredPoses, AnOpponentOnTheSpotIsEvaded) {
  Search search;
  const std::vector<Point> opponents{{0.0, 0.0}};
  // The hill of the opponent is twice as steep as that of the role's own place: to the corner of the region.
  const Point best = search.best({{}, opponents, {0.0, 0.0}, std::nullopt}, lawn, {});
  EXPECT_DOUBLE_EQ(std::abs(best.x), 0.75);
  EXPECT_DOUBLE_EQ(std::abs(best.y), 0.75);
}

TEST(PreferredPoses, TheLastPoseStaysUntilAnotherOneIsBetterByMoreThanItsBonus) {
  Search search;
  const Point home{0.0, 0.0};
  const auto best_after = [&](const Point& last) { return search.best({{}, {}, home, last}, lawn, {}); };
  EXPECT_EQ(best_after({0.09, 0.0}).x, 0.09);  // worse by 0.045
  EXPECT_EQ(best_after({0.11, 0.0}).x, 0.0);   // by 0.055
  EXPECT_EQ(best_after({2.0, 0.0}).x, 0.0);    // not in the region
}

// The definition: candidates in their order, the first best.
Point by_definition(const Scene& scene, const Settings& settings) {
  Point best = scene.home;
  const Scene& s = scene;
  double most = value_at(best, s, lawn, settings);
  const auto within = [&](const Point& p) {
    return p.x >= std::max(-4.5, scene.home.x - settings.region) &&
           p.x <= std::min(4.5, scene.home.x + settings.region) &&
           p.y >= std::max(-3.0, scene.home.y - settings.region) &&
           p.y <= std::min(3.0, scene.home.y + settings.region);
  };
  if (scene.last && within(*scene.last)) {
    const double v = value_at(*scene.last, s, lawn, settings) + settings.last_bonus;
    if (v >= most) {
      most = v;
      best = *scene.last;
    }
  }
  for (int i = -30; i <= 30; ++i) {
    for (int j = -30; j <= 30; ++j) {
      const Point p{i * settings.step, j * settings.step};
      if (!within(p)) continue;
      const double v = value_at(p, s, lawn, settings);
      if (v <= most) continue;
      most = v;
      best = p;
    }
  }
  return best;
}

TEST(PreferredPoses, EqualsTryingEveryPointAndStaysInRegionAndField) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0), beyond_x(-5.2, 5.2), beyond_y(-3.7, 3.7);
  Search search;  // one for all: nothing may be left over from the scene before
  int moved = 0, kept = 0;
  for (int round = 0; round < 1000; ++round) {
    Settings settings;
    settings.region = 0.25 * static_cast<double>(random() % 5);
    settings.step = round % 3 == 0 ? 0.25 : 0.17;
    std::vector<Point> mates, opponents;
    for (auto k = random() % 7; k > 0; --k) mates.push_back({beyond_x(random), beyond_y(random)});
    for (auto k = random() % 8; k > 0; --k) opponents.push_back({beyond_x(random), beyond_y(random)});
    Scene scene{mates, opponents, {x(random), y(random)}, std::nullopt};
    if (round % 2 == 0) scene.last = Point{scene.home.x + 0.03 * x(random), scene.home.y + 0.03 * y(random)};
    const Point found = search.best(scene, lawn, settings), truth = by_definition(scene, settings);
    ASSERT_EQ(found.x, truth.x) << round;
    ASSERT_EQ(found.y, truth.y) << round;
    ASSERT_LE(std::abs(found.x - scene.home.x), settings.region + 1e-12);
    ASSERT_LE(std::abs(found.y - scene.home.y), settings.region + 1e-12);
    ASSERT_LE(std::abs(found.x), 4.5);
    ASSERT_LE(std::abs(found.y), 3.0);
    ASSERT_GE(value_at(found, scene, lawn, settings),
              value_at(scene.home, scene, lawn, settings) - settings.last_bonus);
    moved += found.x != scene.home.x ? 1 : 0;
    kept += scene.last && found.x == scene.last->x ? 1 : 0;
  }
  EXPECT_GT(moved, 300);
  EXPECT_GT(kept, 50);
}

}  // namespace
