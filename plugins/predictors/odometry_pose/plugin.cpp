// SPDX-License-Identifier: MIT
// Glue of the predictor `odometry_pose`; the filter is in algorithm.hpp.
#include <optional>
#include <regista/predictor.hpp>

#include "algorithm.hpp"

namespace {

using odometry_pose::Estimate;
using odometry_pose::Parameters;

struct OdometryPose {
  static constexpr auto id = "odometry_pose", version = "1.0.0",
                        summary = "Own pose: odometry corrected by landmarks (extended Kalman filter)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_SELF;

  Parameters settings;
  static constexpr std::tuple parameters{regista::within(
      &OdometryPose::settings,
      regista::real("distance_noise", &Parameters::distance_noise, {0.001, 0.3}, "m/m^0.5",
                    "Standard deviation of the position after one metre of walking; assumption: covers a scale error "
                    "of 3 % and noise of 5 % per step")
          .tunable()
          .log_scale(),
      regista::real("turn_noise", &Parameters::turn_noise, {0.001, 0.3}, "rad^0.5",
                    "Standard deviation of the heading after one radian of turning; assumption, as distance_noise")
          .tunable()
          .log_scale(),
      regista::real("drift_noise", &Parameters::drift_noise, {0.001, 0.3}, "rad/m^0.5",
                    "Standard deviation of the heading after one metre of walking; assumption")
          .tunable()
          .log_scale(),
      regista::real("standing_noise", &Parameters::standing_noise, {0.0, 0.05}, "1/s^0.5",
                    "Standard deviation of position (m) and heading (rad) after one second of standing; assumption"),
      regista::real(
          "gate", &Parameters::gate, {1.0, 50.0}, "1",
          "Largest squared Mahalanobis distance of a sighting to its landmark (chi-square, 2 degrees of freedom: "
          "9.21 is the 0.99 quantile); chosen by simulated walks, see algorithm.hpp")
          .tunable(),
      regista::real("ambiguity_ratio", &Parameters::ambiguity_ratio, {1.0, 10000.0}, "1",
                    "A sighting counts only if its nearest landmark is this many times likelier than the second "
                    "nearest; chosen by simulated walks, see algorithm.hpp")
          .tunable()
          .log_scale(),
      regista::integer(
          "doubt_after", &Parameters::doubt_after, {1, 1000}, "1",
          "When so many more sightings were beyond the gate than within, the covariance is doubled at each "
          "further one; assumption")
          .tunable(),
      regista::real("velocity_smoothing", &Parameters::velocity_smoothing, {0.0, 5.0}, "s",
                    "Time constant of the smoothing of the velocity; about one step of the walk (0.25 s, SPL)"),
      regista::real("velocity_deviation", &Parameters::velocity_deviation, {0.001, 0.5}, "m/s",
                    "Reported standard deviation of each component of the velocity; assumption"))};

  void setup(const regista::Environment& environment) {
    std::vector<odometry_pose::Landmark> landmarks;
    for (const regista::Landmark& each : environment.landmarks()) landmarks.push_back({each.kind, each.x, each.y});
    // Anywhere on the field, facing anywhere: the deviations of uniform laws.
    Estimate unknown;
    unknown.covariance.diagonal() << environment->field_length * environment->field_length / 12.0,
        environment->field_width * environment->field_width / 12.0, odometry_pose::pi * odometry_pose::pi / 3.0;
    filter.emplace(settings, landmarks, unknown);
    number = environment->own_number;
  }

  void reset(std::uint64_t) { filter->reset(); }

  void predict(double dt, const regista::Motion* motion, const regista::Frame*) {
    filter->predict(dt, motion ? motion->x : 0.0, motion ? motion->y : 0.0, motion ? motion->heading : 0.0);
  }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea&) {
    for (const regista::Measurement& each : measurements) {
      const auto& c = each.covariance;
      if (each.kind == REGISTA_MEASURED_POSE) {
        Estimate pose{each.position[0], each.position[1], odometry_pose::normalised(each.heading), {}};
        pose.covariance << c[0], c[1], c[3], c[1], c[2], c[4], c[3], c[4], c[5];
        filter->place(pose);
      } else if (each.kind == REGISTA_MEASURED_LANDMARK) {
        Eigen::Matrix2d noise;
        noise << c[0], c[1], c[1], c[2];
        filter->sight(each.label, {each.position[0], each.position[1]}, noise);
      }
    }
  }

  // Nobody knows this robot's pose better than itself: what a packet said of it just sets the pose.
  void absorb(regista::Span<regista::Track> tracks, double) {
    if (tracks.empty()) return;
    const regista::Track& told = tracks[0];
    Estimate pose{told.x, told.y, odometry_pose::normalised(told.pose.heading), Eigen::Matrix3d::Zero()};
    pose.covariance.topLeftCorner<2, 2>() << told.covariance[0], told.covariance[1], told.covariance[1],
        told.covariance[2];
    pose.covariance(2, 2) = told.pose.heading_variance;
    filter->place(pose);
  }

  void tracks(regista::Tracks out) const {
    const Estimate& pose = filter->estimate();
    const Eigen::Vector2d velocity = filter->velocity();
    regista::Track& track = out.add();
    track.label = number;
    track.flags = REGISTA_TRACK_VELOCITY;
    track.x = pose.x;
    track.y = pose.y;
    track.pose.heading = pose.heading;
    track.vx = velocity.x();
    track.vy = velocity.y();
    track.pose.turn_rate = filter->turn_rate();
    track.covariance[0] = pose.covariance(0, 0);
    track.covariance[1] = pose.covariance(0, 1);
    track.covariance[2] = pose.covariance(1, 1);
    track.pose.velocity_variance = filter->velocity_variance();
    track.pose.heading_variance = pose.covariance(2, 2);
    track.weight = 1.0;
    track.age = filter->age();
  }

  std::optional<odometry_pose::Filter> filter;
  int number = 0;
};

}  // namespace

REGISTA_PLUGIN(OdometryPose, regista::predictor)
