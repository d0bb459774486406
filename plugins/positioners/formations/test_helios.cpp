// SPDX-License-Identifier: MIT
// The formations of HELIOS base: all load; at each sample exactly its positions come out; inside the triangles the
// barycentric mean by another formula; nothing jumps over their sides; and the triangulation is Delaunay.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "formation.hpp"
#include "formation_file.hpp"

namespace {

using namespace formations;

const std::filesystem::path folder = std::filesystem::path(REGISTA_SHARED_DATA) / "formations/helios_base";
constexpr double scale_x = 9.0 / 105.0, scale_y = 6.0 / 68.0;

struct Loaded {
  std::string name;
  std::vector<Sample> samples;
};

std::vector<Loaded> all() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".conf") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Loaded> out;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    out.push_back({file.filename().string(), read_formation(bytes)});
  }
  return out;
}

class Helios : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no data in " << folder;
  }
};

TEST_F(Helios, AllLoad) {
  std::size_t formations = 0, of_one_sample = 0;
  for (const Loaded& one : all()) {
    ++formations;
    if (one.samples.size() == 1) ++of_one_sample;
    for (const Sample& sample : one.samples) EXPECT_EQ(sample.positions.size(), 11u) << one.name;
  }
  EXPECT_EQ(formations, 14u);
  EXPECT_EQ(of_one_sample, 5u);
}

TEST_F(Helios, TheLeftIsLeft) {
  // In the file number 2, the left centre back, stands at (-15.53, -5.42) for the ball at the centre: y to the right.
  for (const Loaded& one : all()) {
    if (one.name != "normal-formation.conf") continue;
    const Formation formation(one.samples, scale_x, scale_y, Beyond::nearest_point);
    const Position left_back = formation.position(formation.shares({0.0, 0.0}), 1);
    EXPECT_GT(left_back.y, 0.0);
    EXPECT_LT(left_back.x, 0.0);
  }
}

TEST_F(Helios, AtEachSampleExactlyItsPositions) {
  std::size_t checked = 0;
  for (const Loaded& one : all()) {
    for (const Beyond beyond : {Beyond::nearest_point, Beyond::nearest_sample}) {
      const Formation formation(one.samples, scale_x, scale_y, beyond);
      for (std::size_t i = 0; i < one.samples.size(); ++i) {
        const Shares shares = formation.shares(formation.ball(i));
        for (std::size_t k = 0; k < 11; ++k, ++checked) {
          const Position& expected = one.samples[i].positions[k];
          EXPECT_EQ(formation.position(shares, k), (Position{expected.x * scale_x, expected.y * scale_y}))
              << one.name << ", sample " << i << ", position " << k + 1;
        }
      }
    }
  }
  EXPECT_EQ(checked, 2u * 11u * (115u * 3u + 42u + 21u + 25u + 21u + 45u + 46u + 5u));
}

long double doubled_area(const Position& a, const Position& b, const Position& c) {
  return (static_cast<long double>(b.x) - a.x) * (static_cast<long double>(c.y) - a.y) -
         (static_cast<long double>(b.y) - a.y) * (static_cast<long double>(c.x) - a.x);
}

TEST_F(Helios, BarycentricInsideEachTriangle) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.01, 1.0);
  for (const Loaded& one : all()) {
    const Formation formation(one.samples, scale_x, scale_y, Beyond::nearest_point);
    for (const Triangulation::Triangle& triangle : formation.triangulation().triangles) {
      std::array<double, 3> share;
      for (double& s : share) s = uniform(random);
      const double sum = share[0] + share[1] + share[2];
      Position ball{0.0, 0.0};
      for (std::size_t c = 0; c < 3; ++c) {
        const Position& corner = formation.ball(static_cast<std::size_t>(triangle.corner[c]));
        ball.x += share[c] / sum * corner.x;
        ball.y += share[c] / sum * corner.y;
      }
      const Shares shares = formation.shares(ball);
      for (std::size_t k = 0; k < 11; ++k) {
        Position expected{0.0, 0.0};
        for (std::size_t c = 0; c < 3; ++c) {
          const Position& p = one.samples[static_cast<std::size_t>(triangle.corner[c])].positions[k];
          expected.x += share[c] / sum * p.x * scale_x;
          expected.y += share[c] / sum * p.y * scale_y;
        }
        const Position got = formation.position(shares, k);
        EXPECT_NEAR(got.x, expected.x, 1e-10) << one.name;
        EXPECT_NEAR(got.y, expected.y, 1e-10) << one.name;
      }
    }
  }
}

// The triangles cover the hull once, and no sample is inside of a circle: checked in integers of centimetres.
TEST_F(Helios, TheTriangulationIsDelaunay) {
  for (const Loaded& one : all()) {
    std::vector<GridPoint> grid;
    for (const Sample& sample : one.samples) grid.push_back({sample.ball.x / 100, sample.ball.y / 100});
    const Triangulation triangulation = triangulate(grid);
    if (grid.size() == 1) {
      EXPECT_TRUE(triangulation.triangles.empty());
      continue;
    }
    const auto at = [&](int i) { return grid[static_cast<std::size_t>(i)]; };
    const auto cross = [&](int a, int b, int c) {
      return (at(b).x - at(a).x) * (at(c).y - at(a).y) - (at(b).y - at(a).y) * (at(c).x - at(a).x);
    };
    std::int64_t area = 0, hull = 0;
    for (const auto& [a, b] : triangulation.border) hull += at(a).x * at(b).y - at(b).x * at(a).y;
    for (const Triangulation::Triangle& t : triangulation.triangles) {
      const auto& c = t.corner;
      const std::int64_t twice = cross(c[0], c[1], c[2]);
      EXPECT_GT(twice, 0);
      area += twice;
      // centre + offset by Cramer's rule: |p - a|^2 * D >= p . (X, Y) with D = 2 * twice
      const std::int64_t bx = at(c[1]).x - at(c[0]).x, by = at(c[1]).y - at(c[0]).y;
      const std::int64_t cx = at(c[2]).x - at(c[0]).x, cy = at(c[2]).y - at(c[0]).y;
      const std::int64_t b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
      const std::int64_t X = cy * b2 - by * c2, Y = bx * c2 - cx * b2;
      for (const GridPoint& p : grid) {
        const std::int64_t px = p.x - at(c[0]).x, py = p.y - at(c[0]).y;
        EXPECT_GE((px * px + py * py) * twice, px * X + py * Y) << one.name;
      }
    }
    EXPECT_EQ(area, hull) << one.name;
    EXPECT_EQ(triangulation.triangles.size(), 2 * grid.size() - 2 - triangulation.border.size()) << one.name;
  }
}

// The steepest change of a position, in metres for a metre of the ball: the largest gradient of all triangles.
double steepest(const Formation& formation, const std::vector<Sample>& samples) {
  double out = 0.0;
  for (const Triangulation::Triangle& t : formation.triangulation().triangles) {
    const auto ball = [&](std::size_t c) { return formation.ball(static_cast<std::size_t>(t.corner[c])); };
    const double ux = ball(1).x - ball(0).x, uy = ball(1).y - ball(0).y;
    const double vx = ball(2).x - ball(0).x, vy = ball(2).y - ball(0).y, area = ux * vy - uy * vx;
    for (std::size_t k = 0; k < 11; ++k) {
      const auto at = [&](std::size_t c) {
        const Position& p = samples[static_cast<std::size_t>(t.corner[c])].positions[k];
        return Position{p.x * scale_x, p.y * scale_y};
      };
      const auto gradient = [&](double first, double second) {
        return std::hypot((first * vy - second * uy) / area, (second * ux - first * vx) / area);
      };
      out = std::max(out, std::hypot(gradient(at(1).x - at(0).x, at(2).x - at(0).x),
                                     gradient(at(1).y - at(0).y, at(2).y - at(0).y)));
    }
  }
  return out;
}

// Everywhere, on the field and far outside: a step of a micrometre moves nobody by more than the steepest triangle may.
TEST_F(Helios, NothingJumps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-6.0, 6.0), y(-4.0, 4.0), angle(0.0, 6.28);
  for (const Loaded& one : all()) {
    const Formation formation(one.samples, scale_x, scale_y, Beyond::nearest_point);
    const double most = 1.001e-6 * steepest(formation, one.samples) + 1e-13;
    const auto moves_little = [&](const Position& ball) {
      const double a = angle(random);
      const Shares from = formation.shares(ball),
                   to = formation.shares({ball.x + 1e-6 * std::cos(a), ball.y + 1e-6 * std::sin(a)});
      for (std::size_t k = 0; k < 11; ++k) {
        const Position p = formation.position(from, k), q = formation.position(to, k);
        EXPECT_LE(std::hypot(p.x - q.x, p.y - q.y), most) << one.name << " at " << ball.x << ", " << ball.y;
      }
    };
    for (const Triangulation::Triangle& t : formation.triangulation().triangles) {
      for (std::size_t c = 0; c < 3; ++c) {  // on the sides, and at their ends
        const Position &a = formation.ball(static_cast<std::size_t>(t.corner[c])),
                       &b = formation.ball(static_cast<std::size_t>(t.corner[(c + 1) % 3]));
        for (const double s : {0.0, 0.3, 0.5, 0.9}) moves_little({(1 - s) * a.x + s * b.x, (1 - s) * a.y + s * b.y});
      }
    }
    for (int i = 0; i < 2000; ++i) {
      const double px = x(random);
      moves_little({px, y(random)});
    }
  }
}

// Wherever the ball is, the triangle found is one that holds it: found again by looking at all.
TEST_F(Helios, TheWalkFindsTheTriangle) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> x(-6.0, 6.0), y(-4.0, 4.0);
  for (const Loaded& one : all()) {
    const Formation formation(one.samples, scale_x, scale_y, Beyond::nearest_sample);
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
      Position ball{0.0, 0.0};
      ball.x = x(random);
      ball.y = y(random);
      const Shares shares = formation.shares(ball);
      const auto holds = [&](const Triangulation::Triangle& t) {
        for (std::size_t c = 0; c < 3; ++c) {
          if (doubled_area(formation.ball(static_cast<std::size_t>(t.corner[c])),
                           formation.ball(static_cast<std::size_t>(t.corner[(c + 1) % 3])), ball) < 0.0L) {
            return false;
          }
        }
        return true;
      };
      const auto& triangles = formation.triangulation().triangles;
      const auto found = std::ranges::find_if(triangles, holds);
      if (found == triangles.end()) {  // librcsc's rule
        for (std::size_t k = 0; k < one.samples.size(); ++k) {
          EXPECT_GE(
              std::hypot(ball.x - formation.ball(k).x, ball.y - formation.ball(k).y) + 1e-12,
              std::hypot(ball.x - formation.ball(shares.sample[0]).x, ball.y - formation.ball(shares.sample[0]).y));
        }
        EXPECT_EQ(shares.share[0], 1.0);
        continue;
      }
      ++inside;
      Position back{0.0, 0.0};
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::ranges::find(found->corner, static_cast<int>(shares.sample[c])) != found->corner.end());
        EXPECT_GE(shares.share[c], 0.0);
        back.x += shares.share[c] * formation.ball(shares.sample[c]).x;
        back.y += shares.share[c] * formation.ball(shares.sample[c]).y;
      }
      EXPECT_NEAR(back.x, ball.x, 1e-12);
      EXPECT_NEAR(back.y, ball.y, 1e-12);
    }
    if (one.samples.size() > 1) {
      EXPECT_GT(inside, 1000) << one.name;
    }
  }
}

}  // namespace
