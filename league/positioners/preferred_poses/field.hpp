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
#include <limits>
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

// A squared distance from which on `weight` times hill() is at most `level`; infinity when there is none. It is so with
// every rounding: no step of the computation grows with the distance, so what holds at one holds at all beyond.
inline double squared_until(double level, double weight, double reach) {
  if (weight <= level) return 0.0;
  const double distance = reach * (1.0 + 1e-12 - level / weight), squared = distance * distance;
  return weight * hill(std::sqrt(squared), reach) <= level ? squared : std::numeric_limits<double>::infinity();
}

// value_at(), with the same bits, for who asks for many points of a rectangle and only for values above a floor. Parts
// of 0 are left out. All that is subtracted is >= 0, so with some of it left out the same order gives no less: when
// that is not above the floor, the value is not.
class FieldAbove {
 public:
  void reserve(std::size_t most_robots) {
    near_.reserve(2 * most_robots);
    in_row_.reserve(2 * most_robots);
  }

  // The rectangle from `low` to `high` on the lawn; no floor.
  void begin(const Scene& scene, const Lawn& lawn, const Settings& settings, const Point& low, const Point& high) {
    home_ = scene.home;
    lawn_ = lawn;
    settings_ = settings;
    near_.clear();
    keep_near(scene.mates, low, high, settings.mate_reach);
    keep_near(scene.opponents, low, high, settings.opponent_reach);
    floor_ = -std::numeric_limits<double>::infinity();
    home_until_ = -floor_;
  }

  void set_floor(double floor) {
    floor_ = floor;
    home_until_ = squared_until(floor, settings_.home_weight, settings_.home_reach);
  }

  // From here on, points with this x. Whether any of them may be above the floor.
  bool begin_row(double x) {
    const double dx = x - home_.x;
    home_squared_ = dx * dx;
    if (home_squared_ >= home_until_) return false;
    to_goal_line_ = lawn_.half_length - std::abs(x);
    in_row_.clear();
    for (const Repeller& each : near_) {
      const double d = x - each.x, squared = d * d;
      if (squared < each.until) in_row_.push_back({squared, each.y, each.reach, each.until});
    }
    return true;
  }

  // The value at (x, y), or, when that is not above the floor, anything that is not.
  double value(double y) const {
    const double dy = y - home_.y, squared = home_squared_ + dy * dy;
    if (squared >= home_until_) return floor_;
    double value = settings_.home_weight * hill(std::sqrt(squared), settings_.home_reach);
    const double inside = std::min(to_goal_line_, lawn_.half_width - std::abs(y));
    const double border = inside < settings_.border_reach ? hill(inside, settings_.border_reach) : 0.0;
    if (value - border <= floor_) return floor_;
    for (const InRow& each : in_row_) {
      const double d = y - each.y, away = each.squared + d * d;
      if (away >= each.until) continue;
      value -= hill(std::sqrt(away), each.reach);
      if (value - border <= floor_) return floor_;
    }
    return value - border;
  }

 private:
  struct Repeller {
    double x, y, reach;
    double until;  // squared distance from which on it counts 0
  };
  struct InRow {
    double squared;  // of its distance from the row
    double y, reach, until;
  };

  // Those that count at any point of the rectangle.
  void keep_near(std::span<const Point> all, const Point& low, const Point& high, double reach) {
    const double until = squared_until(0.0, 1.0, reach);
    for (const Point& p : all) {
      const double dx = std::max(0.0, std::max(low.x - p.x, p.x - high.x));
      const double dy = std::max(0.0, std::max(low.y - p.y, p.y - high.y));
      if (dx * dx + dy * dy < until) near_.push_back({p.x, p.y, reach, until});
    }
  }

  Point home_{};
  Lawn lawn_{};
  Settings settings_;
  double floor_ = 0.0, home_until_ = 0.0;  // home_until_: squared distance from home that is not above the floor
  double home_squared_ = 0.0, to_goal_line_ = 0.0;  // of the row
  std::vector<Repeller> near_;                      // mates, then opponents
  std::vector<InRow> in_row_;                       // those of them that count at any point of the row
};

// Finds the best point of a region. Reuse one object: it keeps its memory.
class Search {
 public:
  void reserve(std::size_t most_robots) { field_.reserve(most_robots); }

  // The best of the last pose, the role's own place and the grid's points, if they lie in the region and on the lawn;
  // of equal ones the first in this order, the grid by x, then y.
  Point best(const Scene& scene, const Lawn& lawn, const Settings& settings) {
    assert(settings.step > 0.0);
    const Point low = lawn.nearest({scene.home.x - settings.region, scene.home.y - settings.region});
    const Point high = lawn.nearest({scene.home.x + settings.region, scene.home.y + settings.region});
    field_.begin(scene, lawn, settings, low, high);
    Point best = scene.home;
    field_.begin_row(best.x);
    double most = field_.value(best.y);
    if (scene.last && within(*scene.last, low, high)) {
      field_.begin_row(scene.last->x);
      const double value = field_.value(scene.last->y) + settings.last_bonus;
      if (value >= most) {
        best = *scene.last;
        most = value;
      }
    }
    field_.set_floor(most);
    const Range rows = steps_within(low.x, high.x, settings.step), columns = steps_within(low.y, high.y, settings.step);
    for (double i = rows.first; i <= rows.last; ++i) {
      const double x = i * settings.step;
      if (!field_.begin_row(x)) continue;
      for (double j = columns.first; j <= columns.last; ++j) {
        const double y = j * settings.step, value = field_.value(y);
        if (value <= most) continue;
        best = {x, y};
        most = value;
        field_.set_floor(most);
      }
    }
    return best;
  }

 private:
  static bool within(const Point& p, const Point& low, const Point& high) {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }

  struct Range {
    double first, last;
  };
  // The whole numbers of steps in [low, high]. What the division let in beyond an end is left out.
  static Range steps_within(double low, double high, double step) {
    Range out{std::ceil(low / step), std::floor(high / step)};
    if (out.first * step < low) ++out.first;
    if (out.last * step > high) --out.last;
    return out;
  }

  FieldAbove field_;
};

}  // namespace preferred_poses
