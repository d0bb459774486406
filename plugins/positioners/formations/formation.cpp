// SPDX-License-Identifier: MIT
#include "formation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace formations {
namespace {

double squared(const Position& a, const Position& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

Formation::Formation(std::span<const Sample> samples, double scale_x, double scale_y, Beyond beyond)
    : beyond_(beyond), positions_(samples.front().positions.size()) {
  std::vector<GridPoint> grid;
  for (const Sample& sample : samples) {
    assert(sample.positions.size() == positions_);
    grid.push_back(sample.ball);
    balls_.push_back({static_cast<double>(sample.ball.x) * grid_step * scale_x,
                      static_cast<double>(sample.ball.y) * grid_step * scale_y});
    for (const Position& position : sample.positions) table_.push_back({position.x * scale_x, position.y * scale_y});
  }
  triangulation_ = triangulate(grid);

  Position high = low_ = balls_.front();
  for (const Position& ball : balls_) {
    low_ = {std::min(low_.x, ball.x), std::min(low_.y, ball.y)};
    high = {std::max(high.x, ball.x), std::max(high.y, ball.y)};
  }
  if (triangulation_.triangles.empty()) return;
  const double width = high.x - low_.x, height = high.y - low_.y;
  per_cell_ = {cells / width, cells / height};
  flat_ = 1e-14 * (std::abs(low_.x) + width) * (std::abs(low_.y) + height);
  starts_.reserve(cells * cells);
  for (std::size_t k = 0; k < cells * cells; ++k) {
    const double column = static_cast<double>(k % cells) + 0.5, row = static_cast<double>(k / cells) + 0.5;
    starts_.push_back(thorough({low_.x + column / per_cell_.x, low_.y + row / per_cell_.y}));
  }
}

// Twice the area of the triangle, > 0 when p is to the left of a -> b; exactly 0 when p is one of the two.
double Formation::turn(int a, int b, const Position& p) const {
  const Position &u = balls_[static_cast<std::size_t>(a)], &v = balls_[static_cast<std::size_t>(b)];
  return (u.x - p.x) * (v.y - p.y) - (u.y - p.y) * (v.x - p.x);
}

std::size_t Formation::cell(const Position& ball) const {
  const auto along = [](double place) {
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(cells - 1)));
  };
  return along((ball.y - low_.y) * per_cell_.y) * cells + along((ball.x - low_.x) * per_cell_.x);
}

// Walks over sides that have the ball beyond them; `outside` when that leads over the hull's.
int Formation::locate(const Position& ball, int start) const {
  int at = start;
  for (std::size_t step = 0; step <= triangulation_.triangles.size(); ++step) {
    const Triangulation::Triangle& triangle = triangulation_.triangles[static_cast<std::size_t>(at)];
    std::size_t side = 0;
    while (side < 3 && turn(triangle.corner[side], triangle.corner[side == 2 ? 0 : side + 1], ball) >= -flat_) ++side;
    if (side == 3) return at;
    at = triangle.neighbour[side];
    if (at == Triangulation::outside) return at;
  }
  return thorough(ball);
}

// The triangle that the ball is least far beyond a side of.
int Formation::thorough(const Position& ball) const {
  int best = 0;
  double best_depth = -std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangulation_.triangles.size(); ++t) {
    const auto& corner = triangulation_.triangles[t].corner;
    const double depth = std::min(
        {turn(corner[0], corner[1], ball), turn(corner[1], corner[2], ball), turn(corner[2], corner[0], ball)});
    if (depth > best_depth) {
      best_depth = depth;
      best = static_cast<int>(t);
    }
  }
  return best;
}

Shares Formation::shares(const Position& ball) const {
  if (!triangulation_.triangles.empty()) {
    const int triangle = locate(ball, starts_[cell(ball)]);
    if (triangle != Triangulation::outside) return inside(triangle, ball);
  }
  return beyond_ == Beyond::nearest_point ? on_border(ball) : at_nearest(ball);
}

Shares Formation::inside(int triangle, const Position& ball) const {
  const auto& corner = triangulation_.triangles[static_cast<std::size_t>(triangle)].corner;
  std::array<double, 3> area{std::max(0.0, turn(corner[1], corner[2], ball)),
                             std::max(0.0, turn(corner[2], corner[0], ball)),
                             std::max(0.0, turn(corner[0], corner[1], ball))};
  const double all = area[0] + area[1] + area[2];
  return {
      {static_cast<std::size_t>(corner[0]), static_cast<std::size_t>(corner[1]), static_cast<std::size_t>(corner[2])},
      {area[0] / all, area[1] / all, area[2] / all}};
}

Shares Formation::on_border(const Position& ball) const {
  Shares out{};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : triangulation_.border) {
    const Position &a = balls_[static_cast<std::size_t>(from)], &b = balls_[static_cast<std::size_t>(to)];
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double along = (ball.x - a.x) * dx + (ball.y - a.y) * dy;
    const double t = length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
    const double distance = squared(ball, {a.x + t * dx, a.y + t * dy});
    if (!(distance < least)) continue;
    least = distance;
    out = {{static_cast<std::size_t>(from), static_cast<std::size_t>(to), static_cast<std::size_t>(from)},
           {1.0 - t, t, 0.0}};
  }
  return out;
}

Shares Formation::at_nearest(const Position& ball) const {
  const auto nearest =
      std::ranges::min_element(balls_, {}, [&ball](const Position& other) { return squared(ball, other); });
  const auto index = static_cast<std::size_t>(nearest - balls_.begin());
  return {{index, index, index}, {1.0, 0.0, 0.0}};
}

Position Formation::position(const Shares& shares, std::size_t index) const {
  assert(index < positions_);
  Position out{0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Position& position = table_[shares.sample[k] * positions_ + index];
    out.x += shares.share[k] * position.x;
    out.y += shares.share[k] * position.y;
  }
  return out;
}

}  // namespace formations
