// SPDX-License-Identifier: MIT
// How a ball rolls: straight on with a deceleration that is constant (carpet) or grows with the speed (drag, as in the
// 2D simulation league), until it is slower than `stop_speed` and stands. Mean and covariance are carried forward in
// closed form, so that one long step equals many short ones and all robots that start from the same packet get the same
// ball.
//
// A kicked ball may slide first, with a far greater deceleration, until it rolls.
//
// Sources: dv/dt = -a - k v, solved exactly; deceleration a 0.30 to 0.35 m/s^2 on SPL carpet as measured by SPL teams.
// A solid ball that starts to slide without spin rolls once 5/7 of its speed are left (Newton's laws with a constant
// friction; Rojas and Simon, "Like a rolling ball", Free University of Berlin, for the Small Size League).
// The covariance follows the exact Jacobian of that motion plus two noises: white noise on the deceleration along the
// path and a random walk of the direction across it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "planar_state.hpp"

namespace ball {

using planar::State;

struct RollingModel {
  double deceleration = 0.32;       // m/s^2, > 0
  double drag = 0.0;                // 1/s
  double stop_speed = 0.08;         // m/s
  double acceleration_noise = 0.1;  // m/s / sqrt(s), along the path
  double direction_noise = 0.05;    // rad / sqrt(s)
  double resting_noise = 0.01;      // m / sqrt(s)
  double slide_deceleration = 0.0;  // m/s^2, of a kicked ball that does not roll yet; 0: it rolls at once
};

// Seconds until a ball of this speed stands.
inline double time_to_stop(double speed, const RollingModel& model) {
  if (model.drag == 0.0) return std::max(0.0, (speed - model.stop_speed) / model.deceleration);
  const double terminal = model.deceleration / model.drag;
  return std::max(0.0, std::log((speed + terminal) / (model.stop_speed + terminal)) / model.drag);
}

// `dt` seconds of rolling: what comes of the speed, and how the two noises have spread by the end.
struct Roll {
  double after, way;                                      // m/s, m
  double after_slope, way_slope;                          // derivatives by the speed before: 1, s
  double along_position, along_cross, along_velocity;     // of a unit of noise of the acceleration
  double across_position, across_cross, across_velocity;  // of a unit of noise of the direction
};

inline Roll roll_of(double speed, double dt, const RollingModel& model) {
  const double a = model.deceleration, k = model.drag, t2 = dt * dt, t3 = t2 * dt;
  Roll out;
  if (k == 0.0) {
    const double after = speed - a * dt;
    out = {after, 0.5 * dt * (speed + after), 1.0, dt, t3 / 3.0, t2 / 2.0, dt, 0.0, 0.0, 0.0};
    out.across_position = t3 * (after * after / 3.0 + after * a * dt / 4.0 + a * a * t2 / 20.0);
    out.across_cross = after * t2 * (after / 2.0 + a * dt / 6.0);
    out.across_velocity = after * after * dt;
    return out;
  }
  // With u the time before the end, the speed is (after + c) exp(k u) - c, and the way that is left b (exp(k u) - 1) -
  // c u.
  const double c = a / k, kept = std::exp(-k * dt), lost = -std::expm1(-k * dt);
  const double after = (speed + c) * kept - c;
  const double b = (after + c) / k, grown = std::expm1(k * dt), grown_twice = std::expm1(2.0 * k * dt);
  out.after = after;
  out.way = (speed + c) * lost / k - c * dt;
  out.after_slope = kept;
  out.way_slope = lost / k;
  out.along_position = (dt - 2.0 * lost / k - std::expm1(-2.0 * k * dt) / (2.0 * k)) / (k * k);
  out.along_cross = lost * lost / (2.0 * k * k);
  out.along_velocity = -std::expm1(-2.0 * k * dt) / (2.0 * k);
  const double weighted = (dt * (grown + 1.0) - grown / k) / k - t2 / 2.0;  // integral of u (exp(k u) - 1)
  out.across_position =
      b * b * (grown_twice / (2.0 * k) - 2.0 * grown / k + dt) - 2.0 * b * c * weighted + c * c * t3 / 3.0;
  out.across_cross = after * (b * (grown / k - dt) - c * t2 / 2.0);
  out.across_velocity = after * after * dt;
  return out;
}

inline void rest(State& ball, double dt, const RollingModel& model) {
  ball.position_covariance.diagonal().array() += model.resting_noise * model.resting_noise * dt;
}

// The ball stands from now on. What is not known of its velocity becomes uncertainty of the place: a ball that is
// faster by w at this instant rolls on for as long as it takes to lose w, at about stop_speed.
inline void stop(State& ball, const RollingModel& model) {
  const double extra = model.stop_speed / (model.deceleration + model.drag * model.stop_speed);
  ball.position_covariance += extra * (ball.cross + ball.cross.transpose()) + extra * extra * ball.velocity_covariance;
  stand(ball);
}

// `dt` seconds during which it is known to roll; speed = |velocity| > 0.
inline void roll(State& ball, double dt, double speed, const RollingModel& model) {
  const Roll rolled = roll_of(speed, dt, model);
  const double after = rolled.after, way = rolled.way;
  const Eigen::Vector2d ahead = ball.velocity / speed;
  Eigen::Matrix2d along;  // projects onto the path
  along << ahead.x() * ahead.x(), ahead.x() * ahead.y(), ahead.x() * ahead.y(), ahead.y() * ahead.y();
  const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along;

  ball.position += way * ahead;
  ball.velocity = after * ahead;
  const Eigen::Matrix2d to_position =
      rolled.way_slope * along + (way / speed) * across;  // d position / d velocity before
  const Eigen::Matrix2d to_velocity =
      rolled.after_slope * along + (after / speed) * across;  // d velocity / d velocity before
  const Eigen::Matrix2d moved = to_position * ball.velocity_covariance;
  const Eigen::Matrix2d crossed = ball.cross * to_position;
  ball.position_covariance += crossed + crossed.transpose() + moved * to_position;
  ball.cross = ((ball.cross + moved) * to_velocity).eval();
  ball.velocity_covariance = (to_velocity * ball.velocity_covariance * to_velocity).eval();

  // Integrals of the two noises over the step, each carried to its end by the same Jacobian.
  const double q = model.acceleration_noise * model.acceleration_noise;
  const double s = model.direction_noise * model.direction_noise;
  ball.position_covariance += (q * rolled.along_position) * along + (s * rolled.across_position) * across;
  ball.cross += (q * rolled.along_cross) * along + (s * rolled.across_cross) * across;
  ball.velocity_covariance += (q * rolled.along_velocity) * along + (s * rolled.across_velocity) * across;
  rest(ball, dt, model);
}

// Carries a rolling ball `dt` seconds forward. True when it stands at the end.
inline bool advance_rolling(State& ball, double dt, const RollingModel& model) {
  const double speed = std::sqrt(ball.velocity.squaredNorm());
  const double rolls = time_to_stop(speed, model);
  if (dt < rolls) {
    roll(ball, dt, speed, model);
    return false;
  }
  if (rolls > 0.0) roll(ball, rolls, speed, model);
  stop(ball, model);
  rest(ball, dt - rolls, model);
  return true;
}

// Seconds for which a ball of this speed, kicked `since` seconds ago, slides on.
inline double time_to_roll(double speed, double since, const RollingModel& model) {
  if (model.slide_deceleration == 0.0) return 0.0;
  return std::max(0.0, (2.0 * speed / model.slide_deceleration - 5.0 * since) / 7.0);
}

// Carries a ball `dt` seconds forward that was kicked `since` seconds ago. True when it stands at the end.
inline bool advance_kicked(State& ball, double dt, double since, const RollingModel& model) {
  constexpr double unsure = 0.45;  // s^0.5: deviation of the speed after a second of sliding, in decelerations
  const double slides = std::min(dt, time_to_roll(ball.velocity.norm(), since, model));
  if (slides > 0.0) {
    RollingModel sliding = model;
    sliding.deceleration = model.slide_deceleration;
    sliding.acceleration_noise = unsure * model.slide_deceleration;
    if (advance_rolling(ball, slides, sliding)) {
      rest(ball, dt - slides, model);
      return true;
    }
  }
  return dt > slides && advance_rolling(ball, dt - slides, model);
}

// A ball whose velocity is hardly known yet: constant velocity with white noise of acceleration.
inline void advance_unknown(State& ball, double dt, const RollingModel& model) {
  const double q = model.acceleration_noise * model.acceleration_noise;
  ball.position += dt * ball.velocity;
  ball.position_covariance += dt * (ball.cross + ball.cross.transpose()) + dt * dt * ball.velocity_covariance;
  ball.cross += dt * ball.velocity_covariance;
  ball.position_covariance.diagonal().array() += q * dt * dt * dt / 3.0;
  ball.cross.diagonal().array() += q * dt * dt / 2.0;
  ball.velocity_covariance.diagonal().array() += q * dt;
  rest(ball, dt, model);
}

}  // namespace ball
