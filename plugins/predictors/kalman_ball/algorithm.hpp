// SPDX-License-Identifier: MIT
// Where the one ball is: a handful of weighted hypotheses, each a Kalman filter that believes the ball to rest or to
// move. A sighting that fits no hypothesis starts a resting and a moving one; those that explain what is seen, and
// what is not seen, win.
//
// Sources: the Kalman filter as in Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
// Navigation" (2001); weights, misses and births by the Bernoulli filter (Ristic, Vo, Vo, Farina, "A Tutorial on
// Bernoulli Filters", IEEE Trans. Signal Processing 61, 2013) with the nearest sighting per hypothesis; resting and
// rolling hypotheses side by side as SPL teams keep them.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "../ball_hypotheses.hpp"
#include "../ball_view.hpp"
#include "../planar_state.hpp"
#include "../rolling.hpp"

namespace kalman_ball {

using ball::Evidence, ball::RollingModel, ball::View;
using planar::Sighting;
using BallState = planar::State;

struct Parameters {
  RollingModel rolling;
  Evidence evidence;
  double timing_noise = 0.0;  // s: of the time at which a sighting was taken
  double speed_prior = 1.0;   // m/s: deviation of each component of a new ball's velocity
  double touch_rate = 0.0;    // 1/s: how often somebody touches the ball, so that its velocity jumps
};

enum class Kind { resting, moving };

struct Hypothesis {
  BallState ball;
  Kind kind = Kind::resting;
  int label = 0;
  int sightings = 0;     // behind it
  double weight = 0.0;   // probability
  double age = 0.0;      // s since the last sighting behind it
  double unheard = 0.0;  // s since the last sighting or packet behind it
};

class Filter {
 public:
  static constexpr int capacity = 6;

  Filter() : Filter(Parameters{}) {}
  explicit Filter(const Parameters& parameters) : parameters_(parameters) {}

  void reset() { hypotheses_.reset(); }

  void predict(double dt) {
    for (Hypothesis& each : hypotheses_) advance(each, dt);
  }

  // `sightings`: a range of Sighting, all of one image; empty when no ball was seen.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    const Evidence& evidence = parameters_.evidence;
    const double detection = evidence.detection_probability;
    if (std::size(sightings) > 0) hypotheses_.expect_surprise(evidence.surprise);
    const double birth = hypotheses_.nowhere() * detection / (evidence.field_area * evidence.false_density);
    std::uint64_t explained = 0;  // sightings that fit a hypothesis
    for (Hypothesis& hypothesis : hypotheses_) {
      const Sighting* nearest = nullptr;
      Fit best{};
      std::uint64_t bit = 1;
      for (const Sighting& sighting : sightings) {
        const Fit fit = compare(hypothesis.ball, sighting.position, uncertainty(hypothesis, sighting));
        if (fit.distance <= evidence.gate) {
          explained |= bit;
          if (nearest == nullptr || fit.distance < best.distance) {
            nearest = &sighting;
            best = fit;
          }
        }
        bit <<= 1;
      }
      if (nearest != nullptr) {
        constexpr double two_pi = 6.28318530717958648;
        const double density = std::exp(-0.5 * best.distance) / (two_pi * std::sqrt(best.determinant));
        hypothesis.weight *= 1.0 - detection + detection * density / evidence.false_density;
        take(hypothesis, uncertainty(hypothesis, *nearest), best);
      } else if (view.holds(hypothesis.ball.position, evidence.edge_margin)) {
        hypothesis.weight *= 1.0 - detection;
      }
    }
    std::uint64_t bit = 1;
    for (const Sighting& sighting : sightings) {
      if (bit != 0 && (explained & bit) == 0) start(sighting, birth);
      bit <<= 1;
    }
    hypotheses_.weigh(evidence.prune_weight, [this](const Hypothesis& a, const Hypothesis& b) { return alike(a, b); });
  }

  // What a packet said: the only hypothesis from now on. `moves`: its velocity is believed.
  void replace(const BallState& told, bool moves, double weight, double age_then, double ago) {
    Hypothesis& only = hypotheses_.replace(weight);
    only.ball = told;
    only.kind = moves ? Kind::moving : Kind::resting;
    only.sightings = parameters_.evidence.measurements_for_velocity;
    only.age = age_then;
    if (!moves) stand(only.ball);
    if (ago > 0.0) advance(only, ago);
  }
  // A packet that knows of no ball.
  void forget() { hypotheses_.forget(); }

  // Best first.
  const Hypothesis* begin() const { return hypotheses_.begin(); }
  const Hypothesis* end() const { return hypotheses_.end(); }
  bool velocity_believed(const Hypothesis& hypothesis) const {
    return hypothesis.kind == Kind::moving && hypothesis.sightings >= parameters_.evidence.measurements_for_velocity;
  }

  // The hypothesis as it is to be told. A hypothesis itself takes the ball for untouched, and a sighting that tells of
  // a touch starts another; whoever is told nothing more must reckon with touches that nobody saw: jumps of the
  // velocity by that of a new ball, at the times of a Poisson process, which leave the mean where it is.
  BallState told(const Hypothesis& hypothesis) const {
    BallState out = hypothesis.ball;
    const double t = hypothesis.unheard;
    const double rate = parameters_.touch_rate * parameters_.speed_prior * parameters_.speed_prior;
    out.position_covariance.diagonal().array() += rate * t * t * t / 3.0;
    out.cross.diagonal().array() += rate * t * t / 2.0;
    out.velocity_covariance.diagonal().array() += rate * t;
    return out;
  }

  // Carries one hypothesis forward; for looking ahead as well.
  void advance(Hypothesis& hypothesis, double dt) const {
    if (hypothesis.kind == Kind::resting) {
      rest(hypothesis.ball, dt, parameters_.rolling);
    } else if (velocity_believed(hypothesis)) {
      if (advance_rolling(hypothesis.ball, dt, parameters_.rolling)) hypothesis.kind = Kind::resting;
    } else {
      advance_unknown(hypothesis.ball, dt, parameters_.rolling);
    }
    hypothesis.age += dt;
    hypothesis.unheard += dt;
  }

 private:
  struct Fit {
    Eigen::Vector2d innovation;
    double xx, xy, yy;  // inverse of the innovation's covariance
    double determinant, distance;
  };

  // Of a sighting: of its place, and along the path of a moving ball that of its time.
  Eigen::Matrix2d uncertainty(const Hypothesis& hypothesis, const Sighting& sighting) const {
    if (!velocity_believed(hypothesis)) return sighting.covariance;
    const Eigen::Vector2d slip = parameters_.timing_noise * hypothesis.ball.velocity;
    return sighting.covariance + slip * slip.transpose();
  }

  static Fit compare(const BallState& ball, const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance) {
    Fit fit;
    fit.innovation = position - ball.position;
    const Eigen::Matrix2d spread = ball.position_covariance + covariance;
    fit.determinant = spread(0, 0) * spread(1, 1) - spread(0, 1) * spread(1, 0);
    fit.xx = spread(1, 1) / fit.determinant;
    fit.yy = spread(0, 0) / fit.determinant;
    fit.xy = -spread(0, 1) / fit.determinant;
    const double x = fit.innovation.x(), y = fit.innovation.y();
    fit.distance = fit.xx * x * x + 2.0 * fit.xy * x * y + fit.yy * y * y;
    return fit;
  }

  static void take(Hypothesis& hypothesis, const Eigen::Matrix2d& covariance, const Fit& fit) {
    Eigen::Matrix2d inverse;
    inverse << fit.xx, fit.xy, fit.xy, fit.yy;
    update(hypothesis.ball, fit.innovation, covariance, inverse, hypothesis.kind == Kind::moving);
    ++hypothesis.sightings;
    hypothesis.age = 0.0;
    hypothesis.unheard = 0.0;
  }

  void start(const Sighting& sighting, double weight) {
    Hypothesis fresh;
    fresh.ball.position = sighting.position;
    fresh.ball.position_covariance = sighting.covariance;
    fresh.sightings = 1;
    fresh.weight = 0.5 * weight;
    hypotheses_.add(fresh);
    fresh.kind = Kind::moving;
    fresh.ball.velocity_covariance.diagonal().setConstant(parameters_.speed_prior * parameters_.speed_prior);
    hypotheses_.add(fresh);
  }

  bool alike(const Hypothesis& a, const Hypothesis& b) const {
    const double limit = parameters_.evidence.merge_distance * parameters_.evidence.merge_distance;
    return a.kind == b.kind && (a.ball.position - b.ball.position).squaredNorm() < limit &&
           (a.ball.velocity - b.ball.velocity).squaredNorm() < limit;
  }

  Parameters parameters_;
  ball::Hypotheses<Hypothesis, capacity> hypotheses_;
};

}  // namespace kalman_ball
