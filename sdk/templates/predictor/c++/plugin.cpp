// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which calls it answers.
#include <algorithm>
#include <cmath>
#include <optional>

#include <regista/predictor.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0", summary = "Ball: keeps its velocity";
  static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;
  // It reads no part of frames; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  double noise = 1.0, first_speed = 1.0, forget_after = 5.0;
  static constexpr std::tuple parameters{
      regista::real("noise", &Plugin::noise, {0.01, 10.0}, "m/s^1.5", "How fast the velocity becomes uncertain")
          .tunable()
          .log_scale(),
      regista::real("first_speed", &Plugin::first_speed, {0.1, 10.0}, "m/s",
                    "Standard deviation of each component of the velocity of a ball just found")
          .tunable(),
      regista::real("forget_after", &Plugin::forget_after, {0.5, 60.0}, "s",
                    "Time without news after which the ball is lost")};

  std::optional<MovingBall> ball;

  void reset(std::uint64_t) { ball.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) {
    if (!ball) return;
    ::predict(*ball, dt, noise);
    if (ball->age > forget_after) ball.reset();
  }

  // Of several balls in an image it takes the one that is nearest to where it expects its own.
  void correct(regista::Span<regista::Measurement> seen, const regista::VisibleArea&) {
    const regista::Measurement* best = nullptr;
    for (const regista::Measurement& each : seen) {
      if (each.kind != REGISTA_MEASURED_BALL) continue;
      if (best == nullptr || (ball && distance(each) < distance(*best))) best = &each;
    }
    if (best == nullptr) return;
    const double x = best->position[0], y = best->position[1], variance = most_variance(best->covariance);
    if (ball) {
      ::correct(*ball, x, y, variance);
    } else {
      ball = MovingBall{.x = x, .y = y, .place = variance, .velocity = first_speed * first_speed};
    }
  }

  // A packet: this is the ball now, or nobody knows one.
  void absorb(regista::Span<regista::Track> told, double age) {
    ball.reset();
    if (told.empty()) return;
    const regista::Track& best = told[0];
    ball = MovingBall{.x = best.x, .y = best.y, .vx = best.vx, .vy = best.vy, .age = best.age};
    ball->place = most_variance(best.covariance);
    ball->velocity = most_variance(best.motion + 4);
    ::predict(*ball, age, noise);
  }

  void tracks(regista::Tracks out) const {
    if (!ball) return;
    regista::Track& track = out.add();
    track.label = 1;
    track.flags = REGISTA_TRACK_VELOCITY;
    track.x = ball->x;
    track.y = ball->y;
    track.vx = ball->vx;
    track.vy = ball->vy;
    track.weight = 1.0;
    track.age = ball->age;
    track.covariance[0] = track.covariance[2] = ball->place;
    track.motion[0] = track.motion[3] = ball->cross;
    track.motion[4] = track.motion[6] = ball->velocity;
  }

  double distance(const regista::Measurement& seen) const {
    return std::hypot(seen.position[0] - ball->x, seen.position[1] - ball->y);
  }

  // In no direction is the variance of (xx, xy, yy) larger than this.
  static double most_variance(const double* of) {
    constexpr double least = 1e-6;  // nothing is seen better than to 1 mm
    return std::max(of[0], of[2]) + std::abs(of[1]) + least;
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::predictor)
