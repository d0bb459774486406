// SPDX-License-Identifier: MIT
// Where to look: at the ball most of the time, about the field for landmarks and other robots the rest; to and fro
// while the ball is lost. The robots of a team look about at different moments.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "situation.hpp"

namespace behaviours {

struct GazeSettings {
  double sweep_period = 4.0;         // s to and fro
  double glance_every = 4.0;         // s
  double glance_lasts = 1.2;         // s
  double eyes_on_ball_within = 0.8;  // m
  double phase_per_robot = 0.37;     // s
};

namespace detail {

// A wave of straight lines in [-1, 1], of period 1; 1 at whole phases plus a half, -1 at whole ones.
inline double triangle(double phase) { return 4.0 * std::abs(phase - std::floor(phase + 0.5)) - 1.0; }

}  // namespace detail

// Wanted heading of the camera, robot frame, as far as the head turns.
inline double look(const Situation& situation, const GazeSettings& settings) {
  const double limit = situation.facts.head_yaw;
  const double shifted = situation.time + settings.phase_per_robot * situation.facts.own_number;
  if (!situation.ball_trusted) return limit * detail::triangle(shifted / settings.sweep_period);
  const Vector2d ball = situation.frame.to_robot(situation.ball);
  const bool glance =
      std::fmod(shifted, settings.glance_every) < settings.glance_lasts && ball.norm() > settings.eyes_on_ball_within;
  if (glance) return limit * detail::triangle(std::fmod(shifted, settings.glance_every) / settings.glance_lasts);
  return std::clamp(angle_of(ball), -limit, limit);
}

// --- Searching together: what of the field was looked at in vain, when, and by whom. The field is divided into
// squares. Each robot marks those that it sees, and those about its teammates as their packets tell where they are: so
// what one looked at, the others need not. A look grows old, for the ball moves. The field is also divided among the
// searchers: everybody looks at the squares that are nearest to the place of its own task.
//
// Grids of what was seen when are common in search by several robots; that poses alone are shared, which every packet
// carries, is ours.

struct LookedAtSettings {
  bool divides = false;         // otherwise everybody turns about at its place
  double sight = 2.5;           // m: a ball that lies farther away may be missed
  double forgotten_after = 30;  // s: no look is older than this
  double walk_cost = 3.0;       // s of age that each metre of the way has to gain
};

class LookedAt {
 public:
  // Starts afresh on this field: nothing was looked at.
  void begin(const Field& field) {
    columns_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(field.length / square)));
    rows_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(field.width / square)));
    width_ = field.length / static_cast<double>(columns_);
    height_ = field.width / static_cast<double>(rows_);
    corner_ = {-field.length / 2.0, -field.width / 2.0};
    looked_.assign(columns_ * rows_, never);
    goal_.reset();
  }
  std::size_t squares() const { return looked_.size(); }

  // The centre of a square.
  Vector2d centre(std::size_t i) const {
    const auto column = static_cast<double>(i % columns_), row = static_cast<double>(i / columns_);
    return corner_ + Vector2d((column + 0.5) * width_, (row + 0.5) * height_);
  }

  // The robot itself looks: to where its head turns, to and fro.
  void see(const Situation& situation, const LookedAtSettings& settings) {
    constexpr double half_view = 0.4;  // rad beyond the head's limit that the camera still sees
    const double limit = std::cos(std::min(pi, situation.facts.head_yaw + half_view));
    for (std::size_t i = 0; i < looked_.size(); ++i) {
      const Vector2d at = situation.frame.to_robot(centre(i));
      const double distance = at.norm();
      if (distance > settings.sight || at.x() < limit * distance) continue;
      looked_[i] = situation.time;
    }
  }

  // Assumption: teammates had looked all about them when their last packets left, from where they are believed to be
  // now.
  void hear(const Situation& situation, const LookedAtSettings& settings, std::span<const Teammate> teammates) {
    for (const Teammate& mate : teammates) {
      for (std::size_t i = 0; i < looked_.size(); ++i) {
        if ((centre(i) - mate.position).norm() > settings.sight) continue;
        looked_[i] = std::max(looked_[i], situation.time - mate.age);
      }
    }
  }

  // The square to look at next, of those that are nearer to `own` than to all `others`: old looks and short ways first.
  // Nothing when none is nearer. The last one counts as a square's width nearer, so that it does not go to and fro.
  std::optional<Vector2d> next(const Situation& situation, const LookedAtSettings& settings, const Vector2d& own,
                               std::span<const Vector2d> others) {
    std::optional<std::size_t> best;
    double best_worth = 0.0;
    for (std::size_t i = 0; i < looked_.size(); ++i) {
      const double distance = (centre(i) - own).squaredNorm();
      const bool mine = std::all_of(others.begin(), others.end(), [&](const Vector2d& other) {
        return distance <= (centre(i) - other).squaredNorm();
      });
      if (!mine) continue;
      const double kept = goal_ == i ? settings.walk_cost * square : 0.0;
      const double worth = std::min(settings.forgotten_after, situation.time - looked_[i]) + kept -
                           settings.walk_cost * (centre(i) - situation.frame.origin()).norm();
      if (best && worth <= best_worth) continue;
      best = i;
      best_worth = worth;
    }
    goal_ = best;
    if (!best) return std::nullopt;
    return centre(*best);
  }

 private:
  static constexpr double square = 1.5, never = -1e9;  // m; s

  std::size_t columns_ = 0, rows_ = 0;
  double width_ = 0.0, height_ = 0.0;  // m, of a square
  Vector2d corner_{0, 0};
  std::vector<double> looked_;       // match time of the last look, by square
  std::optional<std::size_t> goal_;  // square
};

}  // namespace behaviours
