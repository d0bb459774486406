// SPDX-License-Identifier: MIT
// Where the one ball is: a handful of weighted hypotheses, each a Kalman filter that believes the ball to rest or to
// move. A sighting that a hypothesis does not expect starts another: the same ball, touched since it was last seen,
// which is the likelier the longer that is ago. One that fits nothing at all starts a resting and a moving ball. Those
// that explain what is seen, and what is not seen, win.
//
// Sources: the Kalman filter as in Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
// Navigation" (2001); weights, misses and births by the Bernoulli filter (Ristic, Vo, Vo, Farina, "A Tutorial on
// Bernoulli Filters", IEEE Trans. Signal Processing 61, 2013) with the nearest sighting per hypothesis; resting and
// rolling hypotheses side by side as SPL teams keep them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

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
  double timing_noise = 0.0;       // s: of the time at which a sighting was taken
  double outlier_share = 0.0;      // of sightings that are off by four times their deviation
  double speed_prior = 1.0;        // m/s: deviation of each component of a new ball's velocity
  double touch_rate = 1.0;         // 1/s: how often somebody touches the ball, so that its velocity jumps
  double unseen_touch_rate = 1.0;  // 1/s: the same, in what is told of a ball that is no longer seen
};

enum class Kind { resting, moving };

struct Hypothesis {
  BallState ball;
  Kind kind = Kind::resting;
  int label = 0;
  int sightings = 0;                                         // behind it
  double weight = 0.0;                                       // probability
  double age = 0.0;                                          // s since the last sighting behind it
  double unheard = 0.0;                                      // s since the last sighting or packet behind it
  double touched = std::numeric_limits<double>::infinity();  // s since the touch that it supposes
};

class Filter {
 public:
  static constexpr int capacity = 6;

  Filter() : Filter(Parameters{}) {}
  explicit Filter(const Parameters& parameters) : parameters_(parameters) {}

  void reset() {
    hypotheses_.reset();
    since_image_ = 0.0;
  }

  void predict(double dt) {
    for (Hypothesis& each : hypotheses_) advance(each, dt);
    since_image_ += dt;
  }

  // `sightings`: a range of Sighting, all of one image; empty when no ball was seen.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    const Evidence& evidence = parameters_.evidence;
    const double detection = evidence.detection_probability;
    if (std::size(sightings) > 0) hypotheses_.expect_surprise(-std::expm1(-evidence.surprise * since_image_));
    since_image_ = 0.0;
    const double birth = hypotheses_.nowhere() * detection / (evidence.field_area * evidence.false_density);
    std::array<Hypothesis, most_touched> touched;
    std::size_t touched_count = 0;
    for (const Sighting& sighting : sightings) {
      if (touched_count == most_touched) break;
      if (suppose_touch(sighting, touched[touched_count])) ++touched_count;
    }
    std::uint64_t explained = 0;  // sightings that fit a hypothesis
    for (Hypothesis& hypothesis : hypotheses_) {
      bool seen = false;
      Explanation best;
      std::uint64_t bit = 1;
      for (const Sighting& sighting : sightings) {
        const Explanation each = explain(hypothesis, sighting);
        if (each.fit.distance <= evidence.gate) {
          explained |= bit;
          if (!seen || each.density > best.density) best = each;
          seen = true;
        }
        bit <<= 1;
      }
      if (seen) {
        hypothesis.weight *= 1.0 - detection + detection * best.density / evidence.false_density;
        take(hypothesis, best.covariance, best.fit);
      } else if (view.holds(hypothesis.ball.position, evidence.edge_margin)) {
        hypothesis.weight *= 1.0 - detection;
      }
    }
    std::uint64_t bit = 1;
    for (const Sighting& sighting : sightings) {
      if (bit != 0 && (explained & bit) == 0) start(sighting, birth);
      bit <<= 1;
    }
    for (std::size_t i = 0; i < touched_count; ++i) hypotheses_.add(touched[i]);
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
    const double rate = parameters_.unseen_touch_rate * parameters_.speed_prior * parameters_.speed_prior;
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
      if (advance_kicked(hypothesis.ball, dt, hypothesis.touched, parameters_.rolling)) hypothesis.kind = Kind::resting;
    } else {
      advance_unknown(hypothesis.ball, dt, parameters_.rolling);
    }
    hypothesis.age += dt;
    hypothesis.unheard += dt;
    hypothesis.touched += dt;
  }

 private:
  struct Fit {
    Eigen::Vector2d innovation;
    double xx, xy, yy;  // inverse of the innovation's covariance
    double determinant, distance;
  };

  // How a sighting comes about where the ball is this one: as all, or as one of those that are far off.
  struct Explanation {
    Fit fit;
    Eigen::Matrix2d covariance;  // of the sighting
    double density = 0.0;        // 1/m^2
  };
  Explanation explain(const Hypothesis& hypothesis, const Sighting& sighting) const {
    Explanation out;
    out.covariance = uncertainty(hypothesis, sighting);
    out.fit = compare(hypothesis.ball, sighting.position, out.covariance);
    out.density = density(out.fit);
    if (parameters_.outlier_share == 0.0) return out;
    Explanation off;
    off.covariance = out.covariance + (outlier_deviation * outlier_deviation - 1.0) * sighting.covariance;
    off.fit = compare(hypothesis.ball, sighting.position, off.covariance);
    off.density = parameters_.outlier_share * density(off.fit);
    out.density *= 1.0 - parameters_.outlier_share;
    const double both = out.density + off.density;
    if (off.density > out.density) out = off;
    out.density = both;
    return out;
  }

  static double density(const Fit& fit) {
    return std::exp(-0.5 * fit.distance) / (two_pi * std::sqrt(fit.determinant));
  }

  // Of a sighting: of its place, and along the path of a moving ball that of its time.
  Eigen::Matrix2d uncertainty(const Hypothesis& hypothesis, const Sighting& sighting) const {
    if (hypothesis.kind == Kind::resting) return sighting.covariance;
    const BallState& ball = hypothesis.ball;
    const double variance = parameters_.timing_noise * parameters_.timing_noise;
    return sighting.covariance + variance * (ball.velocity * ball.velocity.transpose() + ball.velocity_covariance);
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

  // The likeliest of the balls that are known to have been touched since it was last seen, so that it is where this
  // sighting is. False where the sighting needs no touch.
  bool suppose_touch(const Sighting& sighting, Hypothesis& likeliest) const {
    const Evidence& evidence = parameters_.evidence;
    double most = 0.0;
    for (const Hypothesis& hypothesis : hypotheses_) {
      if (compare(hypothesis.ball, sighting.position, uncertainty(hypothesis, sighting)).distance < calm) return false;
      Hypothesis fresh = hypothesis;
      fresh.kind = Kind::moving;
      add_touch(fresh.ball, hypothesis.unheard);
      const Eigen::Matrix2d seen = uncertainty(fresh, sighting);
      const Fit fit = compare(fresh.ball, sighting.position, seen);
      if (fit.distance > evidence.gate) continue;
      const double weight = hypothesis.weight * -std::expm1(-parameters_.touch_rate * hypothesis.unheard) *
                            evidence.detection_probability * density(fit) / evidence.false_density;
      if (weight <= most) continue;
      most = weight;
      take(fresh, seen, fit);
      fresh.sightings = 1;
      fresh.touched = 0.0;
      fresh.weight = weight;
      likeliest = fresh;
    }
    return most > 0.0;
  }

  // A touch at an unknown instant of the last `t` seconds: a change of velocity by that of a new ball, and the way that
  // was made with it.
  void add_touch(BallState& ball, double t) const {
    const double variance = parameters_.speed_prior * parameters_.speed_prior;
    ball.position_covariance.diagonal().array() += variance * t * t / 3.0;
    ball.cross.diagonal().array() += variance * t / 2.0;
    ball.velocity_covariance.diagonal().array() += variance;
  }

  void start(const Sighting& sighting, double weight) {
    Hypothesis fresh;
    fresh.ball.position = sighting.position;
    fresh.ball.position_covariance = sighting.covariance;
    fresh.sightings = 1;
    fresh.weight = 0.5 * weight;
    hypotheses_.add(fresh);
    fresh.kind = Kind::moving;
    fresh.touched = 0.0;
    fresh.ball.velocity_covariance.diagonal().setConstant(parameters_.speed_prior * parameters_.speed_prior);
    hypotheses_.add(fresh);
  }

  bool alike(const Hypothesis& a, const Hypothesis& b) const {
    const double limit = parameters_.evidence.merge_distance * parameters_.evidence.merge_distance;
    return a.kind == b.kind && (a.ball.position - b.ball.position).squaredNorm() < limit &&
           (a.ball.velocity - b.ball.velocity).squaredNorm() < limit;
  }

  static constexpr double two_pi = 6.28318530717958648;
  static constexpr double calm = 5.99;  // squared Mahalanobis distance, 0.95 quantile: below it nothing has happened
  static constexpr double outlier_deviation = 4.0;  // times that of other sightings
  static constexpr std::size_t most_touched = 4;    // sightings of one image

  Parameters parameters_;
  double since_image_ = 0.0;  // s
  ball::Hypotheses<Hypothesis, capacity> hypotheses_;
};

}  // namespace kalman_ball
