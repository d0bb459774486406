// SPDX-License-Identifier: MIT
// Glue of the predictor `imm_ball`; the filter is in algorithm.hpp, the modes of the ball in modes.hpp.
#include <algorithm>
#include <regista/predictor.hpp>

#include "../ball_exchange.hpp"
#include "../ball_parameters.hpp"
#include "../planar_exchange.hpp"
#include "algorithm.hpp"

namespace {

using imm_ball::BallState;
using imm_ball::Hypothesis;
using imm_ball::Parameters;

struct ImmBall {
  static constexpr auto id = "imm_ball", version = "1.1.0",
                        summary = "Ball: interacting multiple models, resting, rolling or kicked by a robot in reach";
  static constexpr unsigned reads =
      REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON | REGISTA_READS_COVARIANCES;
  static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;

  Parameters settings;
  double reach = 0.3;
  static constexpr std::tuple parameters{
      regista::within(
          &ImmBall::settings,
          regista::within(
              &Parameters::rolling,
              ball::rolling_parameters("Standard deviation of the speed after one second of rolling; "
                                       "assumption: as much as a kick of 1 m/s loses in sliding, 2/7 of it"),
              ball::resting_noise_parameter),
          regista::real("speed_prior", &Parameters::speed_prior, {0.1, 10.0}, "m/s",
                        "Standard deviation of the velocity of a ball just seen, and of what a kick does to it, each "
                        "component; SPL kicks are 0.98 to 1.8 m/s")
              .tunable()
              .log_scale(),
          regista::real("kick_rate", &Parameters::kick_rate, {0.01, 10.0}, "1/s",
                        "Kicks in a second while a robot is in reach of the ball, or while the predictor receives no "
                        "robots; assumption")
              .tunable()
              .log_scale(),
          regista::real("unseen_kick_rate", &Parameters::unseen_kick_rate, {0.0, 1.0}, "1/s",
                        "Kicks in a second while no robot is known to be in reach of the ball; assumption")
              .tunable(),
          regista::real(
              "sliding_deceleration", &Parameters::sliding_deceleration, {0.5, 10.0}, "m/s^2",
              "Deceleration of a kicked ball until it rolls with 5/7 of its speed; Small Size League teams have "
              "3.0 to 3.6")),
      regista::real("reach", &ImmBall::reach, {0.0, 2.0}, "m",
                    "Gap between ball and robot below which a kick is possible; assumption: a step and a leg")
          .tunable(),
      regista::within(
          &ImmBall::settings,
          regista::real(
              "timing_noise", &Parameters::timing_noise, {0.0, 0.05}, "s",
              "Standard deviation of the time of an image: fast balls are seen less well along their way; 0.002 "
              "by the scatter of Small Size League detections, which grows so with the speed"),
          regista::real("least_deviation", &Parameters::least_deviation, {0.001, 0.2}, "m",
                        "Standard deviation of a sighting, per axis, added to its own; 0.01 as two cameras of "
                        "the Small Size League differ on one resting ball"),
          regista::within(
              &Parameters::evidence,
              ball::evidence_parameters(
                  "Largest squared Mahalanobis distance of a sighting to the nearest mode; 13.8 is the 0.999 "
                  "quantile of chi-square with 2 degrees of freedom",
                  "Hypotheses nearer than this, in place and (m/s) velocity, become one; a ball's diameter")))};

  void setup(const regista::Environment& environment) {
    settings.evidence.field_area = environment->field_length * environment->field_width;
    filter = imm_ball::Filter(settings);
    touching = environment->robot_radius + environment->ball_radius + reach;
  }

  void reset(std::uint64_t) { filter.reset(); }

  // The model of a teammate must be the same in all minds: it sees the robots that all know of.
  void predict(double dt, const regista::Motion* motion, const regista::Frame* last) {
    filter.predict(dt, [&](const imm_ball::Whereabouts& ball) {
      if (last == nullptr) return imm_ball::Reach::untold;
      const regista::World& world = motion != nullptr ? last->mine() : last->common();
      return anybody_in_reach(world, ball, ball.speed * dt) ? imm_ball::Reach::somebody : imm_ball::Reach::nobody;
    });
  }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea& area) {
    filter.correct(image.read(measurements, REGISTA_MEASURED_BALL, 0.0), ball::view_of(area));
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    if (tracks.empty()) return filter.forget();
    const regista::Track& told = tracks[0];
    filter.replace(planar::state_of(told), (told.flags & REGISTA_TRACK_VELOCITY) != 0, told.weight, told.age, age);
  }

  void tracks(regista::Tracks out) const {
    for (const Hypothesis& each : filter) {
      const imm_ball::Modes modes = filter.now(each);
      const BallState ball = combined(modes);
      regista::Track& track = out.add();
      track.label = each.label;
      write_position(ball, track);
      if (filter.velocity_believed(each)) {
        const double squared = ball.velocity.squaredNorm();
        if (modes.probability[imm_ball::resting] < 0.5 &&
            squared > settings.rolling.stop_speed * settings.rolling.stop_speed) {
          track.flags = REGISTA_TRACK_VELOCITY;
        }
        write_velocity(ball, track);
      } else {
        const double variance = settings.speed_prior * settings.speed_prior;
        planar::write_velocity_covariance(variance, 0.0, variance, track);  // told as standing until believed
      }
      track.weight = std::min(1.0, each.weight);
      track.age = each.age;
    }
  }

  // `way`: what the ball may roll meanwhile.
  bool anybody_in_reach(const regista::World& world, const imm_ball::Whereabouts& ball, double way) const {
    const double distance = touching + way + 2.0 * ball.deviation, squared = distance * distance;
    const auto near = [&](double x, double y, double variance) {
      const double dx = x - ball.position.x(), dy = y - ball.position.y();
      return dx * dx + dy * dy <= squared + 4.0 * variance;
    };
    for (const regista::Robot& robot : world.robots()) {
      if ((robot.flags & (REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_PENALISED)) != REGISTA_ROBOT_KNOWN) continue;
      if (near(robot.pose[0], robot.pose[1], std::max(robot.covariance[0], robot.covariance[2]))) return true;
    }
    for (const regista::Opponent& each : world.opponents()) {
      if (near(each.position[0], each.position[1], std::max(each.covariance[0], each.covariance[2]))) return true;
    }
    return false;
  }

  imm_ball::Filter filter;
  double touching = 0.0;  // m between the centres of ball and robot
  planar::Image image;
};

}  // namespace

REGISTA_PLUGIN(ImmBall, regista::predictor)
