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
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "../rolling.hpp"

namespace kalman_ball {

struct Parameters {
  RollingModel rolling;
  double timing_noise = 0.0;           // s: of the time at which a sighting was taken
  double speed_prior = 1.0;            // m/s: deviation of each component of a new ball's velocity
  double touch_rate = 0.0;             // 1/s: how often somebody touches the ball, so that its velocity jumps
  int measurements_for_velocity = 4;   // sightings before a velocity is believed
  double gate = 13.8155;               // squared Mahalanobis distance
  double detection_probability = 0.6;  // of a ball well inside the visible area
  double false_density = 0.01;         // false sightings per m^2 and image
  double edge_margin = 0.3;            // m: nearer to the edge of the visible area a miss says nothing
  double surprise = 0.003;             // least probability that the ball is somewhere else altogether
  double prune_weight = 0.01;          // hypotheses below it are dropped
  double merge_distance = 0.1;         // m, and m/s
  double field_area = 54.0;            // m^2: where a ball can appear
};

struct Sighting {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

// A sector of a disc, seen from `apex`.
struct View {
  Eigen::Vector2d apex;
  Eigen::Vector2d right, left;  // unit vectors along its edges
  double half_angle, range;

  // True when `point` is inside and at least `margin` away from every edge.
  bool holds(const Eigen::Vector2d& point, double margin) const {
    constexpr double half_pi = 1.57079632679489662, pi = 2.0 * half_pi;
    const Eigen::Vector2d arm = point - apex;
    const double reach = range - margin;
    if (reach <= 0.0 || arm.squaredNorm() > reach * reach) return false;
    if (half_angle >= pi) return true;
    const bool inside_right = right.x() * arm.y() - right.y() * arm.x() >= margin;
    const bool inside_left = arm.x() * left.y() - arm.y() * left.x() >= margin;
    return half_angle < half_pi ? inside_right && inside_left : inside_right || inside_left;
  }
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

  void reset() {
    count_ = 0;
    nowhere_ = 1.0;
    next_label_ = 1;
  }

  void predict(double dt) {
    for (int i = 0; i < count_; ++i) advance(hypotheses_[index(i)], dt);
  }

  // `sightings`: a range of Sighting, all of one image; empty when no ball was seen.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    const double detection = parameters_.detection_probability;
    if (std::size(sightings) > 0) nowhere_ = std::max(nowhere_, parameters_.surprise);
    const double birth = nowhere_ * detection / (parameters_.field_area * parameters_.false_density);
    std::uint64_t explained = 0;  // sightings that fit a hypothesis
    for (int i = 0; i < count_; ++i) {
      Hypothesis& hypothesis = hypotheses_[index(i)];
      const Sighting* nearest = nullptr;
      Fit best{};
      std::uint64_t bit = 1;
      for (const Sighting& sighting : sightings) {
        const Fit fit = compare(hypothesis.ball, sighting.position, uncertainty(hypothesis, sighting));
        if (fit.distance <= parameters_.gate) {
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
        hypothesis.weight *= 1.0 - detection + detection * density / parameters_.false_density;
        take(hypothesis, uncertainty(hypothesis, *nearest), best);
      } else if (view.holds(hypothesis.ball.position, parameters_.edge_margin)) {
        hypothesis.weight *= 1.0 - detection;
      }
    }
    std::uint64_t bit = 1;
    for (const Sighting& sighting : sightings) {
      if (bit != 0 && (explained & bit) == 0) start(sighting, birth);
      bit <<= 1;
    }
    weigh();
  }

  // What a packet said: the only hypothesis from now on. `moves`: its velocity is believed.
  void replace(const BallState& told, bool moves, double weight, double age_then, double ago) {
    Hypothesis& only = hypotheses_[0];
    only.ball = told;
    only.kind = moves ? Kind::moving : Kind::resting;
    only.label = fresh_label();
    only.sightings = parameters_.measurements_for_velocity;
    only.weight = weight;
    only.age = age_then;
    only.unheard = 0.0;
    if (!moves) {
      only.ball.velocity.setZero();
      only.ball.cross.setZero();
      only.ball.velocity_covariance.setZero();
    }
    count_ = 1;
    nowhere_ = 1.0 - weight;
    if (ago > 0.0) advance(only, ago);
  }
  // A packet that knows of no ball.
  void forget() {
    count_ = 0;
    nowhere_ = 1.0;
  }

  // Best first.
  const Hypothesis* begin() const { return hypotheses_.data(); }
  const Hypothesis* end() const { return hypotheses_.data() + count_; }
  bool velocity_believed(const Hypothesis& hypothesis) const {
    return hypothesis.kind == Kind::moving && hypothesis.sightings >= parameters_.measurements_for_velocity;
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

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

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

  // The Kalman update, in Joseph's form, which stays positive semi-definite.
  static void take(Hypothesis& hypothesis, const Eigen::Matrix2d& covariance, const Fit& fit) {
    BallState& ball = hypothesis.ball;
    Eigen::Matrix2d inverse;
    inverse << fit.xx, fit.xy, fit.xy, fit.yy;
    const Eigen::Matrix2d gain = ball.position_covariance * inverse;
    const Eigen::Matrix2d kept = Eigen::Matrix2d::Identity() - gain;
    ball.position += gain * fit.innovation;
    if (hypothesis.kind == Kind::moving) {
      const Eigen::Matrix2d velocity_gain = ball.cross.transpose() * inverse;
      ball.velocity += velocity_gain * fit.innovation;
      const Eigen::Matrix2d noisy = covariance * velocity_gain.transpose();
      const Eigen::Matrix2d shared = velocity_gain * ball.cross;
      ball.velocity_covariance +=
          velocity_gain * (ball.position_covariance * velocity_gain.transpose() + noisy) - shared - shared.transpose();
      ball.cross = (kept * (ball.cross - ball.position_covariance * velocity_gain.transpose()) + gain * noisy).eval();
      ball.velocity_covariance(1, 0) = ball.velocity_covariance(0, 1);
    }
    ball.position_covariance =
        (kept * ball.position_covariance * kept.transpose() + gain * covariance * gain.transpose()).eval();
    ball.position_covariance(1, 0) = ball.position_covariance(0, 1);
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
    add(fresh);
    fresh.kind = Kind::moving;
    fresh.ball.velocity_covariance.diagonal().setConstant(parameters_.speed_prior * parameters_.speed_prior);
    add(fresh);
  }

  // Takes the place of the weakest when there is no room.
  void add(Hypothesis& fresh) {
    int place = count_;
    if (count_ < capacity) {
      ++count_;
    } else {
      place = 0;
      for (int i = 1; i < count_; ++i) {
        if (hypotheses_[index(i)].weight <= hypotheses_[index(place)].weight) place = i;
      }
      if (hypotheses_[index(place)].weight >= fresh.weight) return;
    }
    fresh.label = fresh_label();
    hypotheses_[index(place)] = fresh;
  }

  // Normalises with "nowhere", merges like ones into the better, drops the weak; best first.
  void weigh() {
    sort();
    double sum = nowhere_;
    for (int i = 0; i < count_; ++i) sum += hypotheses_[index(i)].weight;
    int kept = 0;
    nowhere_ /= sum;
    for (int i = 0; i < count_; ++i) {
      Hypothesis& candidate = hypotheses_[index(i)];
      candidate.weight /= sum;
      int same = 0;
      while (same < kept && !alike(hypotheses_[index(same)], candidate)) ++same;
      if (same < kept) {
        Hypothesis& other = hypotheses_[index(same)];
        other.weight += candidate.weight;
        other.sightings = std::max(other.sightings, candidate.sightings);
        other.age = std::min(other.age, candidate.age);
      } else if (candidate.weight < parameters_.prune_weight) {
        nowhere_ += candidate.weight;
      } else {
        if (kept != i) hypotheses_[index(kept)] = candidate;
        ++kept;
      }
    }
    count_ = kept;
    sort();
  }

  void sort() {
    for (int i = 1; i < count_; ++i) {
      for (int j = i; j > 0 && hypotheses_[index(j)].weight > hypotheses_[index(j - 1)].weight; --j) {
        std::swap(hypotheses_[index(j)], hypotheses_[index(j - 1)]);
      }
    }
  }

  bool alike(const Hypothesis& a, const Hypothesis& b) const {
    const double limit = parameters_.merge_distance * parameters_.merge_distance;
    return a.kind == b.kind && (a.ball.position - b.ball.position).squaredNorm() < limit &&
           (a.ball.velocity - b.ball.velocity).squaredNorm() < limit;
  }

  int fresh_label() {
    const int label = next_label_;
    next_label_ = label == std::numeric_limits<int>::max() ? 1 : label + 1;
    return label;
  }

  Parameters parameters_;
  std::array<Hypothesis, capacity> hypotheses_;
  int count_ = 0;
  double nowhere_ = 1.0;  // probability that the ball is none of the hypotheses
  int next_label_ = 1;
};

}  // namespace kalman_ball
