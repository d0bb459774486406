// SPDX-License-Identifier: MIT
// One ball by interacting multiple models: a Kalman filter each for a ball that rests, that rolls, and that was just
// kicked, mixed by a Markov chain.
//
// Sources: Blom, Bar-Shalom, "The interacting multiple model algorithm for systems with Markovian switching
// coefficients" (IEEE Trans. Automatic Control 33, 1988); a kicked ball slides until it rolls with 5/7 of its speed
// (two-phase model of the Small Size League: ER-Force, Extended Team Description 2016). All is carried over the whole
// time since the last sighting at once, in closed form, so that the steps in between leave no trace.
//
//   from \ to   resting    rolling          kicked      k: a kick since then
//   resting     1 - k      0                k           s: moves no faster than what counts as standing, and had the
//   rolling     s(1 - k)   (1 - s)(1 - k)   k              time to stop
//   kicked      s e        (1 - s) e        1 - e       e: the time of sliding is over
//
// Two things differ from the textbook. The resting mode has no velocity: what it takes from the others is their place.
// And kicks are rare, but wide: an unlikely one, mixed into rolling at every image, would feed it a part of its spread
// and the velocity would never become sure. So e = 0 until the kick has become likelier than all else.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "../ball_view.hpp"
#include "../planar_state.hpp"
#include "../rolling.hpp"

namespace imm_ball {

using ball::RollingModel, ball::View;
using planar::Sighting;
using BallState = planar::State;

enum Mode : std::size_t { resting = 0, rolling = 1, kicked = 2 };

struct Modes {
  std::array<BallState, 3> state;
  std::array<double, 3> probability{1.0, 0.0, 0.0};
};

struct Motion {
  RollingModel rolling;
  double kick_speed = 1.0;            // m/s: deviation of each component of what a kick does to the velocity
  double sliding_deceleration = 3.0;  // m/s^2, of a kicked ball until it rolls
  double timing_noise = 0.002;        // s: deviation of the time at which an image was taken

  // s from the kick until the ball rolls: 2/7 of the speed lost in sliding.
  double kick_duration() const {
    constexpr double root_2 = 1.41421356237309505;
    return 2.0 / 7.0 * root_2 * kick_speed / sliding_deceleration;
  }
};

// Probability that a ball moves so slowly that it counts as standing: the mean of exp(-|v|^2 / 2 s^2) over the
// distribution of its velocity, s = stop_speed.
inline double standing_share(const BallState& ball, const RollingModel& model) {
  const double s2 = model.stop_speed * model.stop_speed;
  if (s2 == 0.0) return 0.0;
  const Eigen::Matrix2d& c = ball.velocity_covariance;
  const double xx = c(0, 0) + s2, xy = c(0, 1), yy = c(1, 1) + s2, determinant = xx * yy - xy * xy;
  const double vx = ball.velocity.x(), vy = ball.velocity.y();
  const double distance = (yy * vx * vx - 2.0 * xy * vx * vy + xx * vy * vy) / determinant;
  return distance > 60.0 ? 0.0 : s2 / std::sqrt(determinant) * std::exp(-0.5 * distance);
}

// It stands, or creeps more slowly than anybody could say.
inline void halt(BallState& ball, const RollingModel& model) {
  ball.velocity.setZero();
  ball.cross.setZero();
  const double creep = 0.5 * model.stop_speed;
  ball.velocity_covariance << creep * creep, 0.0, 0.0, creep * creep;
}

// Carries a moving ball forward. Of one whose direction is hardly known only the uncertainty can be slowed down: it
// spreads until a ball of that speed would have rolled as far.
inline void advance_moving(BallState& ball, double dt, const RollingModel& model) {
  const double known = ball.velocity.squaredNorm();
  const double unknown = ball.velocity_covariance(0, 0) + ball.velocity_covariance(1, 1);
  if (known > unknown) {
    if (advance_rolling(ball, dt, model)) halt(ball, model);
    return;
  }
  const double until = 0.5 * std::sqrt(known + unknown) / model.deceleration;
  advance_unknown(ball, std::min(dt, until), model);
  if (dt < until) return;
  halt(ball, model);
  rest(ball, dt - until, model);
}

// What a kick at an unknown instant of the last `dt` seconds adds: a change of velocity of unknown direction, and the
// way made with it; no longer than such a ball rolls.
inline void add_kick(BallState& ball, double dt, const Motion& motion) {
  const double variance = motion.kick_speed * motion.kick_speed;
  const double way = std::min(dt, 0.5 * std::sqrt(3.0) * motion.kick_speed / motion.rolling.deceleration);
  ball.position_covariance.diagonal().array() += variance * way * way / 3.0;
  ball.cross.diagonal().array() += variance * way / 2.0;
  ball.velocity_covariance.diagonal().array() += variance;
}

// The modes `dt` >= 0 seconds later. `kicks`: expected number of kicks in that time.
inline Modes carried(const Modes& from, double dt, double kicks, const Motion& motion) {
  constexpr double negligible = 1e-7;
  const RollingModel& model = motion.rolling;
  const double stood = from.probability[resting], rolled = from.probability[rolling];
  const double was_kicked = from.probability[kicked];
  const double kick = -std::expm1(-kicks), none = 1.0 - kick;
  const double slows = model.stop_speed > 0.0 ? -std::expm1(-dt * model.deceleration / model.stop_speed) : 0.0;
  const double stops = none * rolled * slows * standing_share(from.state[rolling], model);
  const bool confirmed = was_kicked > rolled + stood;
  const double settles = confirmed ? was_kicked * -std::expm1(-dt / motion.kick_duration()) : 0.0;
  const double caught = confirmed ? settles * standing_share(from.state[kicked], model) : 0.0;
  const double rolls = none * rolled - stops, joins = settles - caught;
  const double fresh = kick * (stood + rolled), stays = was_kicked - settles;

  Modes to;
  to.probability = {none * stood + stops + caught, rolls + joins, fresh + stays};

  BallState& stands = to.state[resting];
  stands = from.state[resting];
  const double stopping = stops + caught;
  if (stopping > negligible * to.probability[resting]) {
    BallState stopped = from.state[rolling];
    if (caught > 0.0) mix(stopped, from.state[kicked], caught / stopping);
    stopped.velocity.setZero();
    stopped.cross.setZero();
    stopped.velocity_covariance.setZero();
    mix(stands, stopped, stopping / to.probability[resting]);
  }
  rest(stands, dt, model);

  BallState& moves = to.state[rolling];
  moves = from.state[rolling];
  if (confirmed) mix(moves, from.state[kicked], joins > 0.0 ? joins / to.probability[rolling] : 0.0);
  advance_moving(moves, dt, model);

  BallState& flies = to.state[kicked];
  flies = from.state[kicked];
  if (stays > 0.0) advance_moving(flies, dt, model);
  if (fresh > negligible * stays || stays == 0.0) {
    BallState hit = from.state[resting];
    if (rolled > negligible * stood) mix(hit, from.state[rolling], rolled / (stood + rolled));
    advance_moving(hit, dt, model);
    add_kick(hit, dt, motion);
    if (stays > 0.0) {
      mix(flies, hit, fresh / (fresh + stays));
    } else {
      flies = hit;
    }
  }
  return to;
}

// How a sighting fits each mode, and all of them.
struct Fit {
  std::array<Eigen::Matrix2d, 3> noise;    // of the sighting, as each mode has it
  std::array<Eigen::Matrix2d, 3> inverse;  // of the covariance of the innovation
  std::array<double, 3> density;           // 1/m^2, of the sighting under each mode
  double nearest = 0.0;                    // least squared Mahalanobis distance
  double total = 0.0;                      // 1/m^2, of the sighting
};

inline Fit compare(const Modes& modes, const Sighting& sighting, const Motion& motion) {
  constexpr double two_pi = 6.28318530717958648;
  const double timing = motion.timing_noise * motion.timing_noise;
  Fit fit;
  for (std::size_t m = 0; m < 3; ++m) {
    const BallState& ball = modes.state[m];
    Eigen::Matrix2d& noise = fit.noise[m];
    noise = sighting.covariance;
    if (m != resting) noise += timing * (ball.velocity * ball.velocity.transpose() + ball.velocity_covariance);
    const double a = ball.position_covariance(0, 0) + noise(0, 0);
    const double b = ball.position_covariance(0, 1) + noise(0, 1);
    const double c = ball.position_covariance(1, 1) + noise(1, 1);
    const double determinant = a * c - b * b, scale = 1.0 / determinant;
    fit.inverse[m] << scale * c, -scale * b, -scale * b, scale * a;
    const Eigen::Vector2d innovation = sighting.position - ball.position;
    const double distance = innovation.dot(fit.inverse[m] * innovation);
    fit.density[m] = distance > 200.0 ? 0.0 : std::exp(-0.5 * distance) / (two_pi * std::sqrt(determinant));
    fit.total += modes.probability[m] * fit.density[m];
    if (m == 0 || distance < fit.nearest) fit.nearest = distance;
  }
  return fit;
}

// Takes a sighting that fits so: the Kalman update of each mode and Bayes' rule for their probabilities. fit.total > 0.
inline void take(Modes& modes, const Sighting& sighting, const Fit& fit) {
  constexpr double least = 1e-9;  // a mode never dies, and no denormal number slows the machine
  double sum = 0.0;
  for (std::size_t m = 0; m < 3; ++m) {
    BallState& ball = modes.state[m];
    update(ball, sighting.position - ball.position, fit.noise[m], fit.inverse[m], m != resting);
    modes.probability[m] = std::max(least, modes.probability[m] * fit.density[m] / fit.total);
    sum += modes.probability[m];
  }
  for (double& each : modes.probability) each /= sum;
}

// All modes as one estimate.
inline BallState combined(const Modes& modes) {
  BallState all = modes.state[resting];
  const double moving = modes.probability[rolling] + modes.probability[kicked];
  if (moving > 0.0) {
    BallState moves = modes.state[rolling];
    mix(moves, modes.state[kicked], modes.probability[kicked] / moving);
    mix(all, moves, moving);
  }
  return all;
}

}  // namespace imm_ball
