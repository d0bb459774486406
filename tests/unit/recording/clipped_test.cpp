// SPDX-License-Identifier: MIT
// Lines and polygons at the edge of a picture. Expected points follow from the geometry.
#include "recording/field_svg.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace regista::recording::picture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Rectangle square{-1.0, -1.0, 1.0, 1.0};
using Line = std::vector<Point>;

double area(const Line& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

TEST(ClippedLine, WhatIsInsideStays) {
  const Line line{{-1.0, -1.0}, {0.5, 0.25}, {0.5, 0.25}, {1.0, 1.0}};
  EXPECT_THAT(clipped_line(line, square), ElementsAre(line));
  EXPECT_THAT(clipped_line(Line{{0.0, 0.0}}, square), IsEmpty());
  EXPECT_THAT(clipped_line(Line{}, square), IsEmpty());
}

TEST(ClippedLine, PiecesEndAtTheEdge) {
  const Line line{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.5}, {-2.0, 0.5}, {-2.0, 3.0}, {0.0, 3.0}};
  EXPECT_THAT(clipped_line(line, square), ElementsAre(Line{{0.0, 0.0}, {1.0, 0.0}}, Line{{1.0, 0.5}, {-1.0, 0.5}}));
}

TEST(ClippedLine, PassesTheCornerOutside) {
  EXPECT_THAT(clipped_line(Line{{0.0, 2.5}, {2.5, 0.0}}, square), IsEmpty());
  EXPECT_THAT(clipped_line(Line{{2.0, -1.0}, {2.0, 1.0}}, square), IsEmpty());
}

TEST(ClippedPolygon, IsTheSameInside) {
  const Line triangle{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  EXPECT_THAT(clipped_polygon(triangle, square), ElementsAre(triangle[0], triangle[1], triangle[2]));
  EXPECT_THAT(clipped_polygon(Line{{5.0, 0.0}, {6.0, 0.0}, {5.0, 1.0}}, square), IsEmpty());
  EXPECT_THAT(clipped_polygon(Line{}, square), IsEmpty());
}

TEST(ClippedPolygon, OneAroundEverythingFillsTheRectangle) {
  EXPECT_DOUBLE_EQ(area(clipped_polygon(Line{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}}, square)), 4.0);
  EXPECT_DOUBLE_EQ(
      area(clipped_polygon(Line{{-1e300, -1e300}, {1e300, -1e300}, {1e300, 1e300}, {-1e300, 1e300}}, square)), 4.0);
  // A half plane.
  EXPECT_NEAR(area(clipped_polygon(Line{{0.25, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {0.25, 1e6}}, square)), 1.5, 1e-6);
}

// Random lines: what is left lies within, and each of its points lies on the line.
TEST(Clipped, LiesWithinAndOnWhatItIsOf) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> digit(-3.0, 3.0);
  for (int trial = 0; trial < 5000; ++trial) {
    const Point a{digit(random), digit(random)}, b{digit(random), digit(random)};
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    double left = 0.0;
    for (const Line& piece : clipped_line(Line{a, b}, square)) {
      ASSERT_EQ(piece.size(), 2u);
      left += std::hypot(piece[1][0] - piece[0][0], piece[1][1] - piece[0][1]);
      for (const Point& p : piece) {
        ASSERT_TRUE((Rectangle{-1.0 - 1e-9, -1.0 - 1e-9, 1.0 + 1e-9, 1.0 + 1e-9}.holds(p)));
        ASSERT_NEAR(((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length, 0.0, 1e-9);
      }
    }
    // As many of a thousand places on the line lie within.
    int within = 0;
    for (int i = 0; i < 1000; ++i) {
      const double share = (i + 0.5) / 1000.0;
      within += square.holds({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}) ? 1 : 0;
    }
    ASSERT_NEAR(left / length, within / 1000.0, 0.0021);
  }
}

}  // namespace
}  // namespace regista::recording::picture
