// SPDX-License-Identifier: MIT
// The walk of one robot and of one object, and what is measured and heard on the way.
#include <regista/testkit/measurement_scenario.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <regista/testkit/dice.hpp>

namespace regista::testkit {

namespace {

double wrapped(double angle) {
  const double a = std::remainder(angle, 2.0 * std::numbers::pi);
  return a <= -std::numbers::pi ? std::numbers::pi : a;
}

class MeasurementScenario {
 public:
  MeasurementScenario(std::uint32_t subject, bool observer, std::uint64_t seed)
      : subject_(subject), observer_(observer), dice_(seed) {}

  std::vector<Tick> take(std::size_t ticks) {
    std::vector<Tick> out;
    for (std::size_t i = 0; i < ticks; ++i) out.push_back(tick());
    return out;
  }

 private:
  Tick tick() {
    Tick t;
    const double gap = dice_.real(0.0, 1.0);
    t.dt = gap < 0.02 ? 5.0 : gap < 0.04 ? 1e-3 : 0.1;
    walk(t);
    object_[0] += object_velocity_[0] * t.dt;
    object_[1] += object_velocity_[1] * t.dt;
    for (int k = 0; k < 2; ++k) {
      if (std::abs(object_[k]) > 4.0) object_velocity_[k] = object_[k] > 0 ? -0.5 : 0.5;
    }
    if (observer_) measure(t);
    const bool packet = observer_ ? dice_.chance(0.02) : dice_.chance(0.15);
    if (packet && subject_ != REGISTA_SUBJECT_SELF) hear(t);
    return t;
  }

  void walk(Tick& t) {
    const bool stands = dice_.chance(0.2);
    const double ahead = stands ? 0.0 : dice_.real(-0.2, 0.25) * t.dt;
    const double left = stands ? 0.0 : dice_.real(-0.18, 0.18) * t.dt;
    const double turn = stands ? 0.0 : dice_.real(-1.5, 1.5) * t.dt;
    const double c = std::cos(pose_[2]), s = std::sin(pose_[2]);
    pose_[0] = std::clamp(pose_[0] + c * ahead - s * left, -5.0, 5.0);
    pose_[1] = std::clamp(pose_[1] + s * ahead + c * left, -3.5, 3.5);
    pose_[2] = wrapped(pose_[2] + turn);
    if (observer_) t.motion = regista_motion{ahead, left, turn};
  }

  regista_measurement at(std::int32_t kind, double x, double y) {
    regista_measurement m{};
    m.kind = kind;
    m.position[0] = x;
    m.position[1] = y;
    const double size = dice_.chance(0.05) ? 1e-8 : dice_.chance(0.05) ? 25.0 : 0.02;
    const double ratio = dice_.real(0.1, 1.0), correlation = dice_.real(-0.9, 0.9);
    m.covariance[0] = size;
    m.covariance[2] = size * ratio;
    m.covariance[1] = correlation * size * std::sqrt(ratio);
    return m;
  }

  // A sighting of something at (x, y) of the field: mostly good, sometimes wrong, sometimes absurd.
  regista_measurement sighting(std::int32_t kind, double x, double y) {
    const double luck = dice_.real(0.0, 1.0);
    if (luck < 0.9) {
      const double dx = dice_.real(-0.2, 0.2), dy = dice_.real(-0.2, 0.2);
      return at(kind, x + dx, y + dy);
    }
    const double reach = luck < 0.98 ? 6.0 : 1e3;
    const double fx = dice_.real(-reach, reach), fy = dice_.real(-reach, reach);
    return at(kind, fx, fy);
  }

  void measure(Tick& t) {
    t.corrects = true;
    t.area = {pose_[0], pose_[1], pose_[2], 0.48, 5.0, 4.0};
    if (dice_.chance(0.3)) return;
    if (subject_ == REGISTA_SUBJECT_SELF) {
      landmarks(t);
    } else if (subject_ == REGISTA_SUBJECT_BALL) {
      t.measurements.push_back(sighting(REGISTA_MEASURED_BALL, object_[0], object_[1]));
      if (dice_.chance(0.2)) t.measurements.push_back(sighting(REGISTA_MEASURED_BALL, object_[0], object_[1]));
    } else if (subject_ == REGISTA_SUBJECT_OPPONENTS) {
      const int count = dice_.chance(0.02) ? 60 : dice_.integer(1, 8);
      for (int k = 0; k < count; ++k) {
        t.measurements.push_back(
            sighting(REGISTA_MEASURED_ROBOT, object_[0] + 0.9 * (k % 8), object_[1] - 0.4 * (k % 8)));
      }
    }
    if (!t.measurements.empty() && dice_.chance(0.1)) {
      const regista_measurement again = t.measurements.front();
      t.measurements.push_back(again);
    }
  }

  void landmarks(Tick& t) {
    if (dice_.chance(0.02)) {
      regista_measurement placed = at(REGISTA_MEASURED_POSE, pose_[0], pose_[1]);
      placed.heading = pose_[2];
      placed.covariance[5] = 0.01;
      if (dice_.chance(0.3)) std::fill(std::begin(placed.covariance), std::end(placed.covariance), 0.0);
      t.measurements.push_back(placed);
    }
    struct Known {
      std::int32_t kind;
      double x, y;
    };
    constexpr Known known[] = {{REGISTA_LANDMARK_CENTRE, 0, 0},         {REGISTA_LANDMARK_GOAL_POST, 4.5, 0.8},
                               {REGISTA_LANDMARK_GOAL_POST, 4.5, -0.8}, {REGISTA_LANDMARK_PENALTY_MARK, -3.2, 0},
                               {REGISTA_LANDMARK_CORNER, -4.5, 3},      {REGISTA_LANDMARK_T_JUNCTION, 0, 3}};
    const int count = dice_.integer(0, 4);
    for (int k = 0; k < count; ++k) {
      const Known& which = known[dice_.integer(0, 5)];
      const double dx = which.x - pose_[0], dy = which.y - pose_[1];
      const double c = std::cos(pose_[2]), s = std::sin(pose_[2]);
      regista_measurement m = sighting(REGISTA_MEASURED_LANDMARK, c * dx + s * dy, -s * dx + c * dy);
      m.label = which.kind;
      t.measurements.push_back(m);
    }
  }

  regista_track track(std::int32_t label, double x, double y) {
    regista_track out{};
    out.label = label;
    out.x = x;
    out.y = y;
    const double heading = dice_.chance(0.1) ? std::numbers::pi : dice_.real(-3.1, 3.1);
    out.vx = dice_.real(-0.3, 0.3);
    out.vy = dice_.real(-0.3, 0.3);
    out.flags = dice_.chance(0.5) ? REGISTA_TRACK_VELOCITY : 0;
    for (const std::size_t i : {0u, 2u}) out.covariance[i] = dice_.real(0.0, 0.3);
    const double vx_variance = dice_.real(0.0, 0.1), vy_variance = dice_.real(0.0, 0.1);
    const double heading_variance = dice_.real(0.0, 0.1);
    if (subject_ == REGISTA_SUBJECT_TEAMMATES) {
      out.pose.heading = heading;
      out.pose.heading_variance = heading_variance;
      out.pose.velocity_variance = vx_variance;
    } else {
      out.motion[4] = vx_variance;
      out.motion[6] = vy_variance;
    }
    out.weight = dice_.chance(0.3) ? 1.0 : dice_.real(1e-6, 1.0);
    out.age = dice_.chance(0.05) ? 1e5 : dice_.real(0.0, 10.0);
    return out;
  }

  void hear(Tick& t) {
    std::vector<regista_track> said;
    if (subject_ == REGISTA_SUBJECT_TEAMMATES) {
      const std::int32_t number = dice_.integer(1, 7);
      const double x = dice_.real(-4.5, 4.5), y = dice_.real(-3, 3);
      said.push_back(track(number, x, y));
      if (dice_.chance(0.7)) {
        said.back().flags |= REGISTA_TRACK_HAS_TARGET;
        said.back().pose.target[0] = dice_.chance(0.1) ? x : dice_.real(-4.5, 4.5);
        said.back().pose.target[1] = dice_.chance(0.1) ? y : dice_.real(-3, 3);
      }
    } else {
      const int most = subject_ == REGISTA_SUBJECT_BALL ? 1 : 5;
      const int count = dice_.integer(0, most);
      for (int k = 0; k < count; ++k) {
        const double reach = dice_.chance(0.05) ? 1e3 : 4.0;
        const double x = dice_.real(-reach, reach), y = dice_.real(-reach, reach);
        said.push_back(track(k + 1, x, y));
      }
      if (count > 1 && dice_.chance(0.2)) {
        said.back().x = said.front().x;
        said.back().y = said.front().y;
      }
    }
    t.absorbs = said;
    t.packet_age = dice_.chance(0.05) ? 1e4 : dice_.chance(0.2) ? 0.0 : dice_.real(0.0, 2.0);
  }

  std::uint32_t subject_;
  bool observer_;
  Dice dice_;
  double pose_[3] = {-2.0, 0.5, 0.3};
  double object_[2] = {0.5, 0.5}, object_velocity_[2] = {0.3, -0.2};
};

}  // namespace

std::vector<Tick> measurement_scenario(std::uint32_t subject, bool observer, std::uint64_t seed, std::size_t ticks) {
  return MeasurementScenario(subject, observer, seed).take(ticks);
}

}  // namespace regista::testkit
