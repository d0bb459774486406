// SPDX-License-Identifier: MIT
// Glue of the predictor `kalman_ball`; the filter is in algorithm.hpp, the motion of the ball in rolling.hpp.
#include <algorithm>
#include <regista/predictor.hpp>

#include "../ball_exchange.hpp"
#include "../planar_exchange.hpp"
#include "algorithm.hpp"

namespace {

using kalman_ball::BallState;
using kalman_ball::Hypothesis;

struct KalmanBall {
  static constexpr auto id = "kalman_ball", version = "1.1.0",
                        summary = "Ball: weighted Kalman hypotheses, resting or rolling with constant deceleration";
  static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;

  static constexpr kalman_ball::Parameters initial{};
  double deceleration = initial.rolling.deceleration;
  double stop_speed = initial.rolling.stop_speed;
  double acceleration_noise = initial.rolling.acceleration_noise;
  double direction_noise = initial.rolling.direction_noise;
  double resting_noise = initial.rolling.resting_noise;
  double timing_noise = initial.timing_noise;
  double speed_prior = initial.speed_prior;
  double touch_rate = initial.touch_rate;
  int measurements_for_velocity = initial.measurements_for_velocity;
  double gate = initial.gate;
  double detection_probability = initial.detection_probability;
  double false_density = initial.false_density;
  double edge_margin = initial.edge_margin;
  double surprise = initial.surprise;
  double prune_weight = initial.prune_weight;
  double merge_distance = initial.merge_distance;

  static constexpr std::tuple parameters{
      regista::real("deceleration", &KalmanBall::deceleration, {0.05, 1.0}, "m/s^2",
                    "Deceleration of a rolling ball; 0.30 to 0.35 on SPL carpet")
          .tunable(),
      regista::real("stop_speed", &KalmanBall::stop_speed, {0.0, 0.3}, "m/s",
                    "A ball slower than this stands; 0.08 as SPL teams have it"),
      regista::real("acceleration_noise", &KalmanBall::acceleration_noise, {0.01, 3.0}, "m/s^1.5",
                    "Standard deviation of the speed after one second of rolling; assumption")
          .tunable()
          .log_scale(),
      regista::real("direction_noise", &KalmanBall::direction_noise, {0.0, 1.0}, "rad/s^0.5",
                    "Standard deviation of the direction after one second of rolling; assumption")
          .tunable(),
      regista::real("resting_noise", &KalmanBall::resting_noise, {0.0, 0.3}, "m/s^0.5",
                    "Standard deviation of a resting ball's place after one second (nudges); assumption")
          .tunable(),
      regista::real("timing_noise", &KalmanBall::timing_noise, {0.0, 0.1}, "s",
                    "Standard deviation of the time at which a sighting was taken, by which a moving ball is off along "
                    "its path; 0.003 to 0.004 for the cameras of the Small Size League, 0 in Regista's matches"),
      regista::real("speed_prior", &KalmanBall::speed_prior, {0.1, 10.0}, "m/s",
                    "Standard deviation of the velocity of a ball just seen, each component; SPL kicks are 0.98 to "
                    "1.8 m/s")
          .tunable()
          .log_scale(),
      regista::real(
          "touch_rate", &KalmanBall::touch_rate, {0.0, 10.0}, "1/s",
          "How often somebody touches the ball; what is told of a ball that is no longer seen grows uncertain "
          "so; about 1 in the Small Size League, 0 takes every ball for untouched"),
      regista::integer("measurements_for_velocity", &KalmanBall::measurements_for_velocity, {2, 20}, "1",
                       "Sightings before a velocity is believed; 4 as SPL teams have it")
          .tunable(),
      regista::real("gate", &KalmanBall::gate, {1.0, 50.0}, "1",
                    "Largest squared Mahalanobis distance of a sighting to a hypothesis; 13.8 is the 0.999 quantile "
                    "of chi-square with 2 degrees of freedom")
          .tunable(),
      regista::real("detection_probability", &KalmanBall::detection_probability, {0.05, 0.99}, "1",
                    "Probability that a ball well inside the visible area is seen; below the 0.9 of SPL detectors "
                    "because robots hide it for several images in a row")
          .tunable(),
      regista::real("false_density", &KalmanBall::false_density, {1e-5, 1.0}, "1/m^2",
                    "False sightings per square metre and image; well above the 0.0005 per image of SPL detectors "
                    "because false ones come back at the same spot")
          .tunable()
          .log_scale(),
      regista::real("edge_margin", &KalmanBall::edge_margin, {0.0, 2.0}, "m",
                    "Nearer than this to the edge of the visible area a miss says nothing; assumption")
          .tunable(),
      regista::real("surprise", &KalmanBall::surprise, {1e-6, 0.2}, "1",
                    "Least probability, at each sighting, that the ball was somewhere else altogether; assumption")
          .tunable()
          .log_scale(),
      regista::real("prune_weight", &KalmanBall::prune_weight, {1e-4, 0.2}, "1",
                    "Hypotheses below this probability are dropped; assumption")
          .log_scale(),
      regista::real("merge_distance", &KalmanBall::merge_distance, {0.0, 0.5}, "m",
                    "Hypotheses of one kind nearer than this, in place and (m/s) velocity, become one; a ball's "
                    "diameter")};

  void setup(const regista::Environment& environment) {
    kalman_ball::Parameters values;
    values.rolling = {deceleration, stop_speed, acceleration_noise, direction_noise, resting_noise};
    values.timing_noise = timing_noise;
    values.speed_prior = speed_prior;
    values.touch_rate = touch_rate;
    values.measurements_for_velocity = measurements_for_velocity;
    values.gate = gate;
    values.detection_probability = detection_probability;
    values.false_density = false_density;
    values.edge_margin = edge_margin;
    values.surprise = surprise;
    values.prune_weight = prune_weight;
    values.merge_distance = merge_distance;
    values.field_area = environment->field_length * environment->field_width;
    filter = kalman_ball::Filter(values);
  }

  void reset(std::uint64_t) { filter.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { filter.predict(dt); }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea& area) {
    filter.correct(image.read(measurements, REGISTA_MEASURED_BALL, smallest_variance), ball::view_of(area));
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    if (tracks.empty()) return filter.forget();
    const regista::Track& told = tracks[0];
    filter.replace(planar::state_of(told), (told.flags & REGISTA_TRACK_VELOCITY) != 0, told.weight, told.age, age);
  }

  void tracks(regista::Tracks out) const {
    for (const Hypothesis& each : filter) {
      const BallState ball = filter.told(each);
      regista::Track& track = out.add();
      track.label = each.label;
      write_position(ball, track);
      if (filter.velocity_believed(each)) {
        track.flags = REGISTA_TRACK_VELOCITY;
        write_velocity(ball, track);
      } else if (each.kind == kalman_ball::Kind::moving) {
        track.covariance[10] = track.covariance[15] = speed_prior * speed_prior;  // told as standing until believed
      }
      track.weight = std::min(1.0, each.weight);
      track.age = each.age;
    }
  }

  static constexpr double smallest_variance = 1e-6;  // m^2: nothing is seen better than 1 mm

  kalman_ball::Filter filter;
  planar::Image image;
};

}  // namespace

REGISTA_PLUGIN(KalmanBall, regista::predictor)
