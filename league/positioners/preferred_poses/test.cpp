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

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }
  bool chance(double share) { return real(0.0, 1.0) < share; }
  // On the lawn, or up to so far beyond.
  Point anywhere(double beyond) { return {real(-4.5 - beyond, 4.5 + beyond), real(-3.0 - beyond, 3.0 + beyond)}; }
  // Quarters of a metre: distances that are just a reach, equal values at several points.
  Point in_quarters(double beyond) {
    const Point p = anywhere(beyond);
    return {0.25 * std::round(4.0 * p.x), 0.25 * std::round(4.0 * p.y)};
  }

 private:
  std::mt19937 random_;
};

Settings any_settings(Random& random) {
  Settings out;
  out.region = 0.25 * random.below(5);
  out.step = random.below(3) == 0 ? 0.25 : 0.17;
  if (random.chance(0.5)) {
    for (double* reach : {&out.mate_reach, &out.opponent_reach, &out.border_reach, &out.home_reach}) {
      *reach = random.chance(0.5) ? 0.25 * (1 + random.below(12)) : random.real(0.05, 3.0);
    }
    out.home_weight = 0.5 * random.below(7);
    out.last_bonus = 0.25 * random.below(3);
  }
  return out;
}

TEST(PreferredPoses, EqualsTryingEveryPointAndStaysInRegionAndField) {
  Random random(12);
  Search search;  // one for all: nothing may be left over from the scene before
  int moved = 0, kept = 0;
  for (int round = 0; round < 6000; ++round) {
    const Settings settings = any_settings(random);
    const bool in_quarters = random.chance(0.5);
    const auto place = [&](double beyond) {
      return in_quarters ? random.in_quarters(beyond) : random.anywhere(beyond);
    };
    std::vector<Point> mates, opponents;
    for (auto k = random.below(7); k > 0; --k) mates.push_back(place(0.7));
    for (auto k = random.below(12); k > 0; --k) opponents.push_back(place(0.7));
    Scene scene{mates, opponents, lawn.nearest(place(0.3)), std::nullopt};
    if (random.chance(0.5)) {
      const Point by = random.anywhere(0.0);
      scene.last = Point{scene.home.x + 0.03 * by.x, scene.home.y + 0.03 * by.y};
    }
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
  EXPECT_GT(moved, 2000);
  EXPECT_GT(kept, 500);
}

// The same bits above the floor, and nothing above it where the value is not.
TEST(PreferredPoses, ValuesAboveAFloorAreThoseOfTheDefinition) {
  Random random(13);
  FieldAbove field;
  int above = 0, below = 0;
  for (int round = 0; round < 2000; ++round) {
    const Settings settings = any_settings(random);
    std::vector<Point> mates, opponents;
    for (auto k = random.below(7); k > 0; --k) mates.push_back(random.in_quarters(0.5));
    for (auto k = random.below(12); k > 0; --k) opponents.push_back(random.in_quarters(0.5));
    const Scene scene{mates, opponents, random.in_quarters(0.0), std::nullopt};
    const Point low{scene.home.x - 1.0, scene.home.y - 1.0}, high{scene.home.x + 1.0, scene.home.y + 1.0};
    field.begin(scene, lawn, settings, low, high);
    const bool has_floor = random.chance(0.8);
    const double floor = 0.25 * random.below(14) - 1.0;
    if (has_floor) field.set_floor(floor);
    for (int step = 0; step < 20; ++step) {
      const Point p{scene.home.x + 0.25 * (random.below(9) - 4.0),
                    scene.home.y + (step % 2 == 0 ? 0.25 * (random.below(9) - 4.0) : random.real(-1.0, 1.0))};
      const double truth = value_at(p, scene, lawn, settings);
      const bool any = field.begin_row(p.x);
      if (!has_floor || truth > floor) {
        ASSERT_TRUE(any) << round;
        ASSERT_EQ(field.value(p.y), truth) << round;
        ++above;
      } else if (any) {
        ASSERT_LE(field.value(p.y), floor) << round;
        ++below;
      }
    }
  }
  EXPECT_GT(above, 5000);
  EXPECT_GT(below, 5000);
}

TEST(PreferredPoses, FromASquaredDistanceOnAPartIsNoMoreThanItsLevel) {
  Random random(14);
  const auto part = [](double squared, double weight, double reach) {
    return weight * hill(std::sqrt(squared), reach);
  };
  for (int round = 0; round < 20000; ++round) {
    const double weight = random.real(0.01, 10.0), reach = random.real(0.05, 10.0);
    const double level = round % 4 == 0 ? 0.0 : weight * random.real(0.0, 1.0);
    double squared = squared_until(level, weight, reach);
    ASSERT_LT(squared, 1.01 * reach * reach);
    if (squared > 1e-6) {
      EXPECT_GE(part(squared * (1.0 - 1e-3), weight, reach), level);  // not for nothing
    }
    for (int k = 0; k < 20; ++k) {
      ASSERT_LE(part(squared, weight, reach), level);
      squared = k < 10 ? std::nextafter(squared, 1e9) : squared * 1.1;
    }
  }
  EXPECT_EQ(squared_until(1.0, 1.0, 2.0), 0.0);
  EXPECT_EQ(squared_until(0.0, 0.0, 2.0), 0.0);
  EXPECT_TRUE(std::isinf(squared_until(-0.1, 1.0, 2.0)));
  EXPECT_TRUE(std::isinf(squared_until(-0.1, 0.0, 2.0)));
}

}  // namespace
