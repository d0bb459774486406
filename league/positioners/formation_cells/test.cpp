// SPDX-License-Identifier: MIT
// Cells against their definition, ratings and the ascent by their invariants, hysteresis in scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "algorithm.hpp"
#include "cells.hpp"

namespace {

using namespace formation_cells;
constexpr double pi = std::numbers::pi;

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t below(std::size_t count) { return random_() % count; }
  Point point(double x = 4.5, double y = 3.0) { return {real(-x, x), real(-y, y)}; }
  std::vector<Point> points(std::size_t count) {
    std::vector<Point> out;
    while (out.size() < count) out.push_back(below(4) == 0 && !out.empty() ? out[below(out.size())] : point());
    return out;
  }

 private:
  std::mt19937 random_;
};

// --- Cells -----------------------------------------------------------------------------------------------------------

TEST(Cells, PartitionThePlane) {
  Chance chance(1);
  for (int round = 0; round < 10000; ++round) {
    const std::vector<Point> sites = chance.points(1 + chance.below(11));  // some on the same spot
    // Anywhere, on a site, or half-way between two: the borders too.
    const Point a = sites[chance.below(sites.size())], b = sites[chance.below(sites.size())];
    const Point point = round % 3 == 0 ? chance.point(9, 6) : Point{(a.x + b.x) / 2, (a.y + b.y) / 2};
    std::size_t cells = 0, in = sites.size();
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (!in_cell(point, sites, i)) continue;
      ++cells;
      in = i;
    }
    ASSERT_EQ(cells, 1u);
    ASSERT_EQ(in, cell_of(point, sites));
    for (const Point& site : sites) ASSERT_LE(squared(point, sites[in]), squared(point, site));
  }
}

// The border is as far as the nearest ray that leaves the cell.
TEST(Cells, DistanceFromTheBorder) {
  Chance chance(2);
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> sites = chance.points(2 + chance.below(7));
    const Point point = chance.point();
    const std::size_t own = cell_of(point, sites);
    const double away = from_border(point, sites, own);
    double nearest = 1e9;
    for (int k = 0; k < 720; ++k) {
      const double c = std::cos(k * pi / 360), s = std::sin(k * pi / 360);
      const auto leaves = [&](double d) { return !in_cell({point.x + d * c, point.y + d * s}, sites, own); };
      if (!leaves(20.0)) continue;
      double in = 0.0, out = 20.0;
      for (int step = 0; step < 40; ++step) (leaves((in + out) / 2) ? out : in) = (in + out) / 2;
      nearest = std::min(nearest, out);
    }
    if (nearest > 1e8) {
      EXPECT_GT(away, 1e3);
    } else {
      ASSERT_GE(nearest, away - 1e-6);
      ASSERT_LE(nearest, away / std::cos(pi / 720) + 1e-6);
    }
  }
  EXPECT_TRUE(std::isinf(from_border({1, 1}, std::vector<Point>{{0, 0}}, 0)));
}

// --- Ratings ---------------------------------------------------------------------------------------------------------

double exact(const Point& p, const Surroundings& around, const Position& position, const Ratings& r) {
  const auto bell = [](double d, double sd) { return std::exp(-d * d / (2 * sd * sd)); };
  const auto apart = [](const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); };
  if (std::abs(p.x) > around.field.x || std::abs(p.y) > around.field.y) return 0.0;
  if (cell_of(p, around.sites) != position.site) return 0.0;
  double out = bell(apart(p, around.sites[position.site]), r.base);
  out *= 1 - bell(std::min(around.field.x - std::abs(p.x), around.field.y - std::abs(p.y)), r.border);
  out *= 1 - bell(from_border(p, around.sites, position.site), r.cell);
  if (around.ball) out *= 1 - bell(apart(p, *around.ball), r.ball);
  for (std::size_t i = 0; i < around.mates.size(); ++i) {
    if (i != position.holder) out *= 1 - bell(apart(p, around.mates[i]), r.mates);
  }
  if (position.last_target) out *= 0.5 + 0.5 * bell(apart(p, *position.last_target), r.target);
  return out;
}

struct Scene {
  std::vector<Point> sites, mates;
  Surroundings around;
  Position position;
};

Scene any_scene(Chance& chance) {
  Scene out;
  out.sites = chance.points(1 + chance.below(7));
  out.mates = chance.points(chance.below(8));
  out.around = {{4.5, 3.0}, {}, {}, std::nullopt};
  if (chance.below(4) != 0) out.around.ball = chance.point();
  out.position.site = chance.below(out.sites.size());
  if (chance.below(2) == 0) out.position.last_target = chance.point();
  if (!out.mates.empty() && chance.below(3) != 0) out.position.holder = chance.below(out.mates.size());
  return out;
}
void look(Scene& scene) {
  scene.around.sites = scene.sites;
  scene.around.mates = scene.mates;
}

TEST(Ratings, AreTheProduct) {
  Chance chance(3);
  const Ratings ratings;
  for (int round = 0; round < 10000; ++round) {
    Scene scene = any_scene(chance);
    look(scene);
    const Point p = chance.below(2) == 0 ? scene.sites[scene.position.site] : chance.point(5, 3.5);
    const double wanted = exact(p, scene.around, scene.position, ratings);
    ASSERT_NEAR(rating(p, scene.around, scene.position, ratings), wanted, 1e-12);
    const double enough = chance.real(0.0, 0.2), cut = rating(p, scene.around, scene.position, ratings, enough);
    if (wanted > enough + 1e-12) {
      ASSERT_EQ(cut, rating(p, scene.around, scene.position, ratings));
    } else {
      ASSERT_LE(cut, enough + 1e-12);
    }
  }
}

TEST(Ratings, EachPartAlone) {
  const Ratings r;
  const std::vector<Point> one{{0, 0}}, two{{0, 0}, {0, 2}}, mate{{1, 0}};
  const Position position;
  const auto at = [&](Surroundings around, const Point& p, const Position& which) {
    return rating(p, around, which, r);
  };
  const Surroundings wide{{100, 100}, one, {}, std::nullopt};
  EXPECT_EQ(at(wide, {0, 0}, position), 1.0);
  EXPECT_NEAR(at(wide, {2, 0}, position), std::exp(-0.5), 1e-12);  // sd 2 from the base point
  EXPECT_NEAR(at({{0.6, 9}, one, {}, std::nullopt}, {0, 0}, position), 1 - std::exp(-0.5),
              1e-12);  // sd 0.6 from a line
  EXPECT_NEAR(at({{100, 100}, one, {}, Point{0, 0.5}}, {0, 0}, position), 1 - std::exp(-0.5), 1e-12);
  EXPECT_NEAR(at({{100, 100}, one, mate, std::nullopt}, {0, 0}, position), 1 - std::exp(-0.5), 1e-12);
  EXPECT_EQ(at({{100, 100}, one, mate, std::nullopt}, {0, 0}, {0, std::nullopt, 0}), 1.0);  // oneself
  EXPECT_NEAR(at({{100, 100}, two, {}, std::nullopt}, {0, 0.95}, position),
              std::exp(-0.5 * 0.95 * 0.95 / 4) * (1 - std::exp(-0.5)), 1e-9);  // 0.05 from the border of the cell
  EXPECT_EQ(at({{100, 100}, two, {}, std::nullopt}, {0, 1.05}, position), 0.0);
  EXPECT_NEAR(at(wide, {0, 0}, {0, Point{1, 0}, std::nullopt}), 0.5 + 0.5 * std::exp(-0.5), 1e-12);
  EXPECT_NEAR(at(wide, {0, 0}, {0, Point{50, 0}, std::nullopt}), 0.5, 1e-12);
}

// --- The ascent ------------------------------------------------------------------------------------------------------

TEST(Ascent, NeverDownNeverOutAndTenStepsAtMost) {
  Chance chance(4);
  const Ratings ratings;
  int moved = 0;
  for (int round = 0; round < 10000; ++round) {
    Scene scene = any_scene(chance);
    look(scene);
    const Point base = scene.sites[scene.position.site];
    const auto rate = [&](const Point& p, double enough) {
      return rating(p, scene.around, scene.position, ratings, enough);
    };
    const Found found = ascend(base, rate, ratings);
    ASSERT_GE(found.value, rate(base, 0.0));
    ASSERT_NEAR(found.value, exact(found.place, scene.around, scene.position, ratings), 1e-12);
    ASSERT_LE(std::sqrt(squared(found.place, base)), 1.0 + 1e-9);
    const bool at_base = found.place.x == base.x && found.place.y == base.y;
    if (!at_base) {
      ++moved;
      ASSERT_TRUE(on_field(found.place, scene.around.field));
      ASSERT_TRUE(in_cell(found.place, scene.around.sites, scene.position.site));
    }
    // Ten single steps end there too, and each goes up or stays.
    Ratings one = ratings;
    one.steps = 1;
    Found step{base, rate(base, 0.0)};
    for (int k = 0; k < 10; ++k) {
      const Found next = ascend(step.place, rate, one);
      ASSERT_GE(next.value, step.value);
      step = next;
    }
    ASSERT_EQ(step.place.x, found.place.x);
    ASSERT_EQ(step.place.y, found.place.y);
  }
  EXPECT_GT(moved, 5000);
}

TEST(Ascent, AwayFromATeammateAndTheBall) {
  const Ratings ratings;
  const std::vector<Point> sites{{0, 0}}, mates{{0.3, 0}};
  const auto climbed = [&](const Surroundings& around) {
    const Position position;
    return ascend(
               {0, 0}, [&](const Point& p, double e) { return rating(p, around, position, ratings, e); }, ratings)
        .place;
  };
  EXPECT_NEAR(climbed({{4.5, 3}, sites, mates, std::nullopt}).x, -1.0, 1e-9);
  EXPECT_LT(climbed({{4.5, 3}, sites, {}, Point{0.2, 0}}).x, -0.3);
  const Point free = climbed({{4.5, 3}, sites, {}, std::nullopt});
  EXPECT_EQ(free.x, 0.0);
  EXPECT_EQ(free.y, 0.0);
}

// --- Hysteresis ------------------------------------------------------------------------------------------------------

TEST(Places, TheOldOneStaysWhileTheNewOneIsHardlyBetter) {
  const Ratings ratings;
  const std::vector<Point> sites{{0, 0}};
  Place place;
  std::vector<Point> mates{{0.3, 0}};
  const auto update = [&] { return place.update({{4.5, 3}, sites, mates, std::nullopt}, {}, ratings); };
  EXPECT_NEAR(update().place.x, -1.0, 1e-9);
  mates = {{0, 8}};  // far away: the base point rates 1, the old place exp(-1/8) = 0.88
  EXPECT_NEAR(update().place.x, -1.0, 1e-9);
  mates = {{-1.5, 0}};  // in the way now
  EXPECT_GT(update().place.x, 0.5);
  place.forget();
  mates = {{0, 8}};
  EXPECT_EQ(update().place.x, 0.0);
}

TEST(Places, OneOfAnotherCellIsForgotten) {
  const Ratings ratings;
  Place place;
  std::vector<Point> mates{{0.3, 0}}, sites{{0, 0}};
  const auto update = [&] { return place.update({{4.5, 3}, sites, mates, std::nullopt}, {}, ratings).place; };
  EXPECT_NEAR(update().x, -1.0, 1e-9);
  sites.push_back({-1.5, 0});
  mates = {{0, 8}};
  EXPECT_GT(update().x, -0.75);
}

TEST(Places, StandsWithinOneDistanceAndWalksBeyondAnother) {
  const Ratings ratings;
  const std::vector<Point> sites{{0, 0}};
  std::vector<Point> mates{{3, 0}};
  Place place;
  const Position position{0, std::nullopt, 0};
  const auto target = [&](double x) {
    mates[0].x = x;
    return place.update({{4.5, 3}, sites, mates, std::nullopt}, position, ratings).place.x;
  };
  EXPECT_EQ(target(1.0), 0.0);    // walks
  EXPECT_EQ(target(0.65), 0.0);   // still
  EXPECT_EQ(target(0.59), 0.59);  // stands
  EXPECT_EQ(target(0.70), 0.59);  // it was pushed, and stands where it stopped
  EXPECT_EQ(target(0.76), 0.0);
  EXPECT_EQ(target(0.70), 0.0);
  EXPECT_EQ(target(0.30), 0.30);
}

TEST(Places, ItDoesNotStandInAnotherCell) {
  const Ratings ratings;
  const std::vector<Point> sites{{0, 0}, {0.8, 0}};
  std::vector<Point> mates{{0.5, 0}};
  Place place;
  const Position position{0, std::nullopt, 0};
  const Surroundings around{{4.5, 3}, sites, mates, std::nullopt};
  EXPECT_LT(place.update(around, position, ratings).place.x, 0.4);
  mates[0] = {0.35, 0};
  EXPECT_EQ(place.update(around, position, ratings).place.x, 0.35);
}

// Whatever happens in a long game, the point that is given lies in the cell and on the field.
TEST(Places, AlwaysInsideCellAndField) {
  Chance chance(5);
  const Ratings ratings;
  for (int game = 0; game < 100; ++game) {
    Scene scene = any_scene(chance);
    Place place;
    for (int tick = 0; tick < 100; ++tick) {
      if (chance.below(30) == 0) scene.sites = chance.points(scene.sites.size());
      if (chance.below(5) == 0) scene.mates = chance.points(scene.mates.size());
      if (chance.below(5) == 0) scene.around.ball = chance.point();
      look(scene);
      const Point p = place.update(scene.around, scene.position, ratings).place;
      ASSERT_TRUE(on_field(p, scene.around.field));
      // Of two positions on the same spot the second has no cell, and keeps its base point.
      const bool has_cell = cell_of(scene.sites[scene.position.site], scene.sites) == scene.position.site;
      if (has_cell) {
        ASSERT_EQ(cell_of(p, scene.sites), scene.position.site);
      }
    }
  }
}

}  // namespace
