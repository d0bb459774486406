// SPDX-License-Identifier: MIT
// Glue of the predictor `dead_reckoning`; the rule is in algorithm.hpp.
#include <regista/predictor.hpp>
#include <stdexcept>
#include <string>

#include "algorithm.hpp"

namespace {

using dead_reckoning::Estimate;
using dead_reckoning::Packet;
using dead_reckoning::Parameters;
using dead_reckoning::Teammate;

struct DeadReckoning {
  static constexpr auto id = "dead_reckoning", version = "1.0.0",
                        summary = "Teammates: walk to the sent target at half the sent speed";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_TEAMMATES;

  Parameters settings;
  static constexpr std::tuple parameters{regista::within(
      &DeadReckoning::settings,
      regista::real("speed_factor", &Parameters::speed_factor, {0.0, 2.0}, "1",
                    "Share of the sent speed (of the greatest walking speed where none was sent) at which a silent "
                    "teammate is taken to walk; 0.5 by B-Human, 0 holds it where it was")
          .tunable(),
      regista::real("position_noise", &Parameters::position_noise, {0.0, 1.0}, "m/s",
                    "Growth of the standard deviation of a silent teammate's place; assumption: near half of the "
                    "walking speed")
          .tunable(),
      regista::real("heading_noise", &Parameters::heading_noise, {0.0, 2.0}, "rad/s",
                    "Growth of the standard deviation of a silent teammate's heading; assumption")
          .tunable())};

  void setup(const regista::Environment& environment) {
    team_size = static_cast<int>(environment->team_size);
    settings.walk_speed = environment->walk_forward;
    team = dead_reckoning::Team(environment->team_size, settings);
  }

  void reset(std::uint64_t) { team.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { team.predict(dt); }

  // The camera does not tell shirt numbers.
  void correct(regista::Span<regista::Measurement>, const regista::VisibleArea&) {}

  void absorb(regista::Span<regista::Track> tracks, double age) {
    for (const regista::Track& told : tracks) {
      if (told.label < 1 || told.label > team_size) {
        throw std::out_of_range("dead_reckoning: heard of robot " + std::to_string(told.label) + " in a team of " +
                                std::to_string(team_size));
      }
      Packet packet;
      packet.position << told.x, told.y;
      packet.heading = told.pose.heading;
      if ((told.flags & REGISTA_TRACK_VELOCITY) != 0) packet.speed = std::sqrt(told.vx * told.vx + told.vy * told.vy);
      packet.has_target = (told.flags & REGISTA_TRACK_HAS_TARGET) != 0;
      packet.target << told.pose.target[0], told.pose.target[1];
      packet.covariance << told.covariance[0], told.covariance[1], told.covariance[1], told.covariance[2];
      packet.heading_variance = told.pose.heading_variance;
      packet.weight = told.weight;
      packet.age = told.age;
      team.hear(told.label, packet, age);
    }
  }

  void tracks(regista::Tracks out) const {
    for (const Teammate& mate : team) {
      const Estimate now = mate.now();
      const Packet& packet = mate.packet();
      regista::Track& track = out.add();
      track.label = mate.number();
      track.flags = REGISTA_TRACK_VELOCITY;
      if (packet.has_target) {
        track.flags |= REGISTA_TRACK_HAS_TARGET;
        track.pose.target[0] = packet.target.x();
        track.pose.target[1] = packet.target.y();
      }
      track.x = now.position.x();
      track.y = now.position.y();
      track.pose.heading = packet.heading;
      track.vx = now.velocity.x();
      track.vy = now.velocity.y();
      track.covariance[0] = now.position_covariance(0, 0);
      track.covariance[1] = now.position_covariance(0, 1);
      track.covariance[2] = now.position_covariance(1, 1);
      track.pose.velocity_variance = now.velocity_variance;
      track.pose.heading_variance = now.heading_variance;
      track.weight = packet.weight;
      track.age = now.age;
    }
  }

  dead_reckoning::Team team;
  int team_size = 0;
};

}  // namespace

REGISTA_PLUGIN(DeadReckoning, regista::predictor)
