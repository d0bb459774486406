// SPDX-License-Identifier: MIT
// Where the one ball is: mostly a single ball followed by interacting multiple models (modes.hpp), and rivals beside it
// while it is doubtful which sightings are the ball. A sighting that is likelier false than the ball that is followed
// moves nothing but starts a rival; the rival that explains what is seen, and what is not seen, wins.
//
// Sources: modes.hpp; weights, misses and births by the Bernoulli filter (Ristic, Vo, Vo, Farina, "A Tutorial on
// Bernoulli Filters", IEEE Trans. Signal Processing 61, 2013) with the best sighting per hypothesis.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "../ball_hypotheses.hpp"
#include "modes.hpp"

namespace imm_ball {

using ball::Evidence;

struct Parameters {
  RollingModel rolling{.acceleration_noise = 0.3};
  Evidence evidence;
  double speed_prior = 1.0;           // m/s: deviation of each component of a new or kicked ball's velocity
  double kick_rate = 2.0;             // 1/s: kicks while a robot is in reach of the ball
  double unseen_kick_rate = 0.02;     // 1/s: kicks while nobody is known to be in reach
  double sliding_deceleration = 3.0;  // m/s^2, of a kicked ball until it rolls
  double timing_noise = 0.002;        // s: deviation of the time at which an image was taken
  double least_deviation = 0.01;      // m: by which sightings err besides what is told of them
};

struct Hypothesis {
  Modes modes;                 // as of the last image or packet
  double elapsed = 0.0;        // s since
  double kicks = 0.0;          // expected number since, of those that a sighting may show
  double unheard_kicks = 0.0;  // of those to reckon with as long as no sighting shows them
  int label = 0;
  int sightings = 0;    // behind it
  double weight = 0.0;  // probability
  double age = 0.0;     // s since the last sighting behind it
};

// Where it is now, roughly and quickly: the place by the likelier of resting and rolling, and how fast it is.
struct Whereabouts {
  Eigen::Vector2d position;
  double speed;
  double deviation;  // m, at the time of the last image or packet
};

// Whether a robot can kick the ball. Where nobody says where robots are, a sighting may show a kick at any time, but
// none is reckoned with before.
enum class Reach { somebody, nobody, untold };

class Filter {
 public:
  static constexpr int capacity = 4;

  Filter() : Filter(Parameters{}) {}
  explicit Filter(const Parameters& parameters)
      : parameters_(parameters),
        motion_{parameters.rolling, parameters.speed_prior, parameters.sliding_deceleration, parameters.timing_noise} {}

  void reset() {
    hypotheses_.reset();
    since_image_ = 0.0;
  }

  // reach: tells of Whereabouts whether a robot can kick that ball.
  template <class ReachOf>
  void predict(double dt, const ReachOf& reach) {
    for (Hypothesis& each : hypotheses_) {
      each.elapsed += dt;
      each.age += dt;
      const Reach robots = reach(whereabouts(each));
      each.kicks += dt * (robots == Reach::nobody ? parameters_.unseen_kick_rate : parameters_.kick_rate);
      each.unheard_kicks += dt * (robots == Reach::somebody ? parameters_.kick_rate : parameters_.unseen_kick_rate);
    }
    since_image_ += dt;
  }

  // `sightings`: a range of Sighting, all of one image; empty when no ball was seen.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    const Evidence& evidence = parameters_.evidence;
    const double detection = evidence.detection_probability;
    if (std::size(sightings) > 0) hypotheses_.expect_surprise(-std::expm1(-evidence.surprise * since_image_));
    since_image_ = 0.0;
    std::array<Hypothesis, most_hard_kicks> kicked_hard;
    std::size_t hard_kicks = 0;
    for (const Sighting& sighting : sightings) {
      if (hard_kicks == most_hard_kicks) break;
      if (suppose_hard_kick(sighting, kicked_hard[hard_kicks])) ++hard_kicks;
    }
    const double birth = hypotheses_.nowhere() * detection / (evidence.field_area * evidence.false_density);
    const double least = (1.0 - detection) * evidence.false_density / detection;
    std::uint64_t explained = 0;  // sightings that may be a ball that is known
    for (Hypothesis& hypothesis : hypotheses_) {
      hypothesis.modes = carried(hypothesis.modes, hypothesis.elapsed, hypothesis.kicks, motion_);
      hypothesis.elapsed = hypothesis.kicks = hypothesis.unheard_kicks = 0.0;
      const Sighting* best_sighting = nullptr;
      Fit best;
      std::uint64_t bit = 1;
      for (const Sighting& sighting : sightings) {
        const Fit fit = compare(hypothesis.modes, blurred(sighting), motion_);
        if (fit.nearest <= evidence.gate && fit.total > least) {
          explained |= bit;
          if (best_sighting == nullptr || fit.total > best.total) {
            best_sighting = &sighting;
            best = fit;
          }
        }
        bit <<= 1;
      }
      if (best_sighting != nullptr) {
        hypothesis.weight *= 1.0 - detection + detection * best.total / evidence.false_density;
        take(hypothesis.modes, *best_sighting, best);
        ++hypothesis.sightings;
        hypothesis.age = 0.0;
      } else if (view.holds(likeliest(hypothesis.modes).position, evidence.edge_margin)) {
        hypothesis.weight *= 1.0 - detection;
      }
    }
    std::uint64_t bit = 1;
    for (const Sighting& sighting : sightings) {
      if (bit != 0 && (explained & bit) == 0) start(sighting, birth);
      bit <<= 1;
    }
    for (std::size_t i = 0; i < hard_kicks; ++i) hypotheses_.add(kicked_hard[i]);
    hypotheses_.weigh(evidence.prune_weight,
                      [this](const Hypothesis& a, const Hypothesis& b) { return alike(a.modes, b.modes); });
  }

  // What a packet said: the only hypothesis from now on. `moves`: its velocity is believed.
  void replace(const BallState& told, bool moves, double weight, double age_then, double ago) {
    Hypothesis& only = hypotheses_.replace(weight);
    only.modes.state.fill(told);
    stand(only.modes.state[resting]);
    if (!moves) only.modes.state.fill(only.modes.state[resting]);
    only.modes.probability = {moves ? 0.0 : 1.0, moves ? 1.0 : 0.0, 0.0};
    only.elapsed = ago;
    only.kicks = only.unheard_kicks = ago * parameters_.unseen_kick_rate;
    only.sightings = parameters_.evidence.measurements_for_velocity;
    only.age = age_then + ago;
  }
  // A packet that knows of no ball.
  void forget() { hypotheses_.forget(); }

  // Best first.
  const Hypothesis* begin() const { return hypotheses_.begin(); }
  const Hypothesis* end() const { return hypotheses_.end(); }

  // Its modes now, or `dt` seconds from now, in which a robot may be in reach of the ball.
  Modes now(const Hypothesis& hypothesis) const {
    return carried(hypothesis.modes, hypothesis.elapsed, hypothesis.unheard_kicks, motion_);
  }
  Modes ahead(const Hypothesis& hypothesis, double dt) const {
    return carried(hypothesis.modes, hypothesis.elapsed + dt, hypothesis.unheard_kicks + dt * parameters_.kick_rate,
                   motion_);
  }
  bool velocity_believed(const Hypothesis& hypothesis) const {
    return hypothesis.sightings >= parameters_.evidence.measurements_for_velocity;
  }

 private:
  static const BallState& likeliest(const Modes& modes) {
    return modes.state[modes.probability[resting] > 0.5 ? resting : rolling];
  }

  Sighting blurred(Sighting sighting) const {
    sighting.covariance.diagonal().array() += parameters_.least_deviation * parameters_.least_deviation;
    return sighting;
  }

  Whereabouts whereabouts(const Hypothesis& hypothesis) const {
    const BallState& ball = likeliest(hypothesis.modes);
    const double deviation = std::sqrt(std::max(ball.position_covariance(0, 0), ball.position_covariance(1, 1)));
    const double speed = std::sqrt(ball.velocity.squaredNorm());
    if (speed <= parameters_.rolling.stop_speed) return {ball.position, speed, deviation};
    const double rolls = std::min(hypothesis.elapsed, time_to_stop(speed, parameters_.rolling));
    const double slower = 0.5 * parameters_.rolling.deceleration * rolls;
    return {ball.position + (rolls * (1.0 - slower / speed)) * ball.velocity, speed, deviation};
  }

  // The likeliest of the balls that are known to have been kicked harder than others since the last image, so that it
  // is where this sighting is. False where an ordinary ball explains the sighting.
  bool suppose_hard_kick(const Sighting& sighting, Hypothesis& likeliest_ball) const {
    const Evidence& evidence = parameters_.evidence;
    const Sighting seen = blurred(sighting);
    Motion hard = motion_;
    hard.kick_speed *= hard_kick;
    double most = 0.0;
    for (const Hypothesis& hypothesis : hypotheses_) {
      const Modes usual = carried(hypothesis.modes, hypothesis.elapsed, hypothesis.kicks, motion_);
      if (compare(usual, seen, motion_).nearest <= calm) return false;
      BallState ball = likeliest(carried(hypothesis.modes, hypothesis.elapsed, 0.0, motion_));
      if (ball.velocity_covariance.isZero()) ball.velocity.setZero();
      add_kick(ball, hypothesis.elapsed, hard);
      Modes fresh;
      fresh.state.fill(ball);
      fresh.probability = {0.0, 0.0, 1.0};
      const Fit fit = compare(fresh, seen, motion_);
      if (fit.nearest > evidence.gate || fit.total <= 0.0) continue;
      const double weight = hypothesis.weight * -std::expm1(-hard_share * hypothesis.kicks) *
                            evidence.detection_probability * fit.total / evidence.false_density;
      if (weight <= most) continue;
      most = weight;
      likeliest_ball = {};
      take(fresh, seen, fit);
      stand(fresh.state[resting]);
      likeliest_ball.modes = fresh;
      likeliest_ball.sightings = 1;
      likeliest_ball.weight = weight;
    }
    return most > 0.0;
  }

  void start(const Sighting& sighting, double weight) {
    Hypothesis fresh;
    BallState ball;
    ball.position = sighting.position;
    ball.position_covariance = blurred(sighting).covariance;
    fresh.modes.state[resting] = ball;
    ball.velocity_covariance.diagonal().setConstant(parameters_.speed_prior * parameters_.speed_prior);
    fresh.modes.state[rolling] = fresh.modes.state[kicked] = ball;
    fresh.modes.probability = {0.5, 0.5, 0.0};
    fresh.sightings = 1;
    fresh.weight = weight;
    hypotheses_.add(fresh);
  }

  bool alike(const Modes& a, const Modes& b) const {
    const double limit = parameters_.evidence.merge_distance * parameters_.evidence.merge_distance;
    const BallState &one = likeliest(a), &other = likeliest(b);
    return (one.position - other.position).squaredNorm() < limit &&
           (one.velocity - other.velocity).squaredNorm() < limit;
  }

  static constexpr double hard_kick = 3.0;           // times speed_prior: as a shot to a pass
  static constexpr double hard_share = 0.1;          // of kicks
  static constexpr double calm = 5.99;               // squared Mahalanobis distance, 0.95 quantile: no hard kick
  static constexpr std::size_t most_hard_kicks = 4;  // sightings of one image

  Parameters parameters_;
  Motion motion_;
  double since_image_ = 0.0;  // s
  ball::Hypotheses<Hypothesis, capacity> hypotheses_;
};

}  // namespace imm_ball
