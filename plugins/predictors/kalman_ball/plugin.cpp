// SPDX-License-Identifier: MIT
// Glue of the predictor `kalman_ball`; the filter is in algorithm.hpp, the motion of the ball in rolling.hpp.
#include <algorithm>
#include <regista/predictor.hpp>

#include "../ball_exchange.hpp"
#include "../ball_parameters.hpp"
#include "../planar_exchange.hpp"
#include "algorithm.hpp"

namespace {

using kalman_ball::BallState;
using kalman_ball::Hypothesis;
using kalman_ball::Parameters;

struct KalmanBall {
  static constexpr auto id = "kalman_ball", version = "1.3.0",
                        summary = "Ball: weighted Kalman hypotheses, resting or rolling";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;

  Parameters settings;
  static constexpr std::tuple parameters{regista::within(
      &KalmanBall::settings,
      regista::within(
          &Parameters::rolling,
          ball::rolling_parameters("Standard deviation of the speed after one second of rolling; assumption"),
          ball::drag_parameter, ball::slide_parameter, ball::resting_noise_parameter.tunable()),
      regista::real("timing_noise", &Parameters::timing_noise, {0.0, 0.1}, "s",
                    "Standard deviation of the time at which a sighting was taken, by which a moving ball is off along "
                    "its path; 0.003 to 0.004 for the cameras of the Small Size League, 0 in Regista's matches"),
      regista::real(
          "outlier_share", &Parameters::outlier_share, {0.0, 0.5}, "1",
          "Share of sightings that are off by four times their stated deviation; 0.05 where two cameras disagree, 0 in "
          "Regista's matches"),
      regista::real("speed_prior", &Parameters::speed_prior, {0.1, 10.0}, "m/s",
                    "Standard deviation of the velocity of a ball just seen, each component; SPL kicks are 0.98 to "
                    "1.8 m/s")
          .tunable()
          .log_scale(),
      regista::real("touch_rate", &Parameters::touch_rate, {0.0, 10.0}, "1/s",
                    "How often somebody touches the ball: a sighting that the known ball does not explain is then that "
                    "ball, touched since; about 1 in the Small Size League")
          .tunable(),
      regista::real("unseen_touch_rate", &Parameters::unseen_touch_rate, {0.0, 10.0}, "1/s",
                    "How often a ball that is no longer seen is touched: the reported uncertainty grows by these "
                    "touches besides the rolling; 0 reports an untouched ball")
          .tunable(),
      regista::within(
          &Parameters::evidence,
          ball::evidence_parameters(
              "Largest squared Mahalanobis distance of a sighting to a hypothesis; 13.8 is the 0.999 quantile of "
              "chi-square with 2 degrees of freedom",
              "Hypotheses of one kind nearer than this, in place and (m/s) velocity, become one; a ball's diameter")))};

  void setup(const regista::Environment& environment) {
    settings.evidence.field_area = environment->field_length * environment->field_width;
    filter = kalman_ball::Filter(settings);
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
        const double variance = settings.speed_prior * settings.speed_prior;
        planar::write_velocity_covariance(variance, 0.0, variance, track);  // told as standing until believed
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
