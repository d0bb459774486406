// SPDX-License-Identifier: MIT
// Where a role is best played, by a field over its region (Weigel, Gutmann, Dietl, Kleiner and Nebel, "CS Freiburg:
// Coordinating Robots for Successful Soccer Playing", IEEE T-RA 18(5), 2002, who take the idea from Veloso, Bowling and
// Stone's positioning by attraction and repulsion): teammates, opponents and the border repel, the role's own place
// attracts, and the pose that was preferred last counts a little more.
//
// Our decisions: every part falls linearly with the distance down to 0; the parts' reach and weights; the region, a
// square about the role's own place; the points that are compared: those of a grid that is fixed to the field, so that
// the best one does not creep along with the ball, the role's own place and the last one.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace preferred_poses {

// Field frame, m.
struct Point {
  double x, y;
};

struct Settings {
  double region = 0.75;     // m: the region reaches so far from the role's own place along either axis
  double step = 0.25;       // m: of the grid, > 0
  double mate_reach = 1.5;  // m, each reach > 0
  double opponent_reach = 1.0;
  double border_reach = 0.5;
  double home_reach = 2.0;
  double home_weight = 1.0;  // attraction of the role's own place, at that place; what repels has the weight 1
  double last_bonus = 0.05;  // of the last pose
};

// The lawn within the lines: |x| <= half_length, |y| <= half_width.
struct Lawn {
  double half_length, half_width;
  Point nearest(const Point& p) const {
    return {std::clamp(p.x, -half_length, half_length), std::clamp(p.y, -half_width, half_width)};
  }
};

// Falls from 1 at distance 0 to 0 at `reach`.
inline double hill(double distance, double reach) { return std::max(0.0, 1.0 - distance / reach); }

inline double distance(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

struct Scene {
  std::span<const Point> mates, opponents;
  Point home;                 // the role's own place, on the lawn
  std::optional<Point> last;  // the pose that was preferred last
};

// The field at a point of the lawn, without the bonus for the last pose.
inline double value_at(const Point& p, const Scene& scene, const Lawn& lawn, const Settings& settings) {
  double value = settings.home_weight * hill(distance(p, scene.home), settings.home_reach);
  for (const Point& mate : scene.mates) value -= hill(distance(p, mate), settings.mate_reach);
  for (const Point& opponent : scene.opponents) value -= hill(distance(p, opponent), settings.opponent_reach);
  const double inside = std::min(lawn.half_length - std::abs(p.x), lawn.half_width - std::abs(p.y));
  return value - hill(inside, settings.border_reach);
}

// Finds the best point of a region. Reuse one object: it keeps its memory.
class Search {
 public:
  void reserve(std::size_t most_robots) {
    mates_.reserve(most_robots);
    opponents_.reserve(most_robots);
  }

  // The best of the last pose, the role's own place and the grid's points, if they lie in the region and on the lawn;
  // of equal ones the first in this order, the grid by x, then y.
  Point best(const Scene& scene, const Lawn& lawn, const Settings& settings) {
    assert(settings.step > 0.0);
    const Point low = lawn.nearest({scene.home.x - settings.region, scene.home.y - settings.region});
    const Point high = lawn.nearest({scene.home.x + settings.region, scene.home.y + settings.region});
    keep_near(scene.mates, low, high, settings.mate_reach, mates_);
    keep_near(scene.opponents, low, high, settings.opponent_reach, opponents_);
    const Scene near{mates_, opponents_, scene.home, scene.last};
    Point best = scene.home;
    double most = value_at(best, near, lawn, settings);
    if (scene.last && within(*scene.last, low, high)) {
      const double value = value_at(*scene.last, near, lawn, settings) + settings.last_bonus;
      if (value >= most) {
        best = *scene.last;
        most = value;
      }
    }
    const double first_y = std::ceil(low.y / settings.step), last_y = std::floor(high.y / settings.step);
    const double last_x = std::floor(high.x / settings.step);
    for (double i = std::ceil(low.x / settings.step); i <= last_x; ++i) {
      for (double j = first_y; j <= last_y; ++j) {
        const Point p{i * settings.step, j * settings.step};
        const double value = value_at(p, near, lawn, settings);
        if (value <= most || !within(p, low, high)) continue;
        best = p;
        most = value;
      }
    }
    return best;
  }

 private:
  static bool within(const Point& p, const Point& low, const Point& high) {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
  // Those that reach into the rectangle.
  static void keep_near(std::span<const Point> all, const Point& low, const Point& high, double reach,
                        std::vector<Point>& near) {
    near.clear();
    for (const Point& p : all) {
      if (within(p, {low.x - reach, low.y - reach}, {high.x + reach, high.y + reach})) near.push_back(p);
    }
  }

  std::vector<Point> mates_, opponents_;
};

}  // namespace preferred_poses
