// SPDX-License-Identifier: MIT
#include "study/tuning/evaluator.hpp"

#include <gmock/gmock.h>

#include "landscape.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;

// Nine points in a row: six neighbours each, the point itself among them.
TEST(Neighbours, MeansByHand) {
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i) points.push_back(point({i / 8.0}));
  const std::vector<double> values{9, 0, 0, 0, 3, 3, 3, 3, 0};
  // The first has points 0 to 5 (sum 15), the last 3 to 8 (12), the fifth 1 or, as far, 7: the earlier, so 2 to 6 and 1
  // or 7 by distance: 1 and 7 are as far, 1 is earlier (9).
  EXPECT_THAT(best_by_neighbours(points, values, std::vector<Point>{points[8], points[0], points[4]}, 8),
              ElementsAre(points[0], points[8], points[4]));
  EXPECT_THAT(best_by_neighbours(points, values, std::vector<Point>{points[8], points[0], points[4]}, 1),
              ElementsAre(points[0]));
}

TEST(Neighbours, FewPointsAreAllNeighbours) {
  const std::vector<Point> points{point({0.2, 0.3}), point({0.9, 0.1})};
  const std::vector<double> values{1, 2};
  EXPECT_THAT(best_by_neighbours(points, values, points, 8), ElementsAre(points[0], points[1]))
      << "equal means, the earlier first";
}

TEST(Neighbours, TheLuckiestPointIsNotTheBest) {
  Rng draws(5, Rng::Use::random);
  std::vector<Point> points;
  std::vector<double> values;
  const Point optimum = point({0.3, 0.6});
  for (int i = 0; i < 2000; ++i) {
    Point& each = points.emplace_back(2);
    for (double& coordinate : each) coordinate = draws.uniform();
    values.push_back(sphere(each, optimum) + 0.2 * draws.normal());
  }
  points.push_back(point({0.95, 0.05}));
  values.push_back(10.0);
  const Point found = best_by_neighbours(points, values, points, 1).front();
  EXPECT_LT((found - optimum).norm(), 0.25);
}

}  // namespace
}  // namespace regista::study
