// SPDX-License-Identifier: MIT
// Glue of the predictor `hold_last`; the rule is in algorithm.hpp.
#include <array>
#include <limits>
#include <regista/predictor.hpp>
#include <span>
#include <stdexcept>
#include <string>

#include "algorithm.hpp"

namespace {

using hold_last::Held;
using hold_last::Parameters;
using hold_last::Sighting;

struct HoldLast {
  static constexpr auto id = "hold_last", version = "1.0.0",
                        summary = "Ball, opponents, teammates: stay where they were last measured or said to be";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS | REGISTA_SUBJECT_TEAMMATES;

  Parameters settings;
  double ball_speed = 0.5, robot_speed = 0.2;
  static constexpr std::tuple parameters{
      regista::real("ball_speed", &HoldLast::ball_speed, {0.0, 5.0}, "m/s",
                    "Growth of the standard deviation of a ball's place; assumption: half of a weak SPL kick")
          .tunable(),
      regista::real("robot_speed", &HoldLast::robot_speed, {0.0, 2.0}, "m/s",
                    "Growth of the standard deviation of a robot's place; SPL teams have 0.1 to 0.4")
          .tunable(),
      regista::within(
          &HoldLast::settings,
          regista::real("turn_rate", &Parameters::turn_rate, {0.0, 2.0}, "rad/s",
                        "Growth of the standard deviation of a teammate's heading; assumption"),
          regista::real(
              "match_distance", &Parameters::match_distance, {0.05, 5.0}, "m",
              "An opponent seen farther than this from all that are held is another one; 1.1 as SPL teams merge "
              "them, rounded down"),
          regista::real("forget_after", &Parameters::forget_after, {0.5, 600.0}, "s",
                        "Ball and opponents without news for longer are dropped; 8 as SPL teams have it for robots"))};

  void setup(const regista::Environment& environment) {
    subject = environment->subject;
    team_size = static_cast<int>(environment->team_size);
    settings.speed = subject == REGISTA_SUBJECT_BALL ? ball_speed : robot_speed;
    if (subject == REGISTA_SUBJECT_TEAMMATES) settings.forget_after = std::numeric_limits<double>::infinity();
    memory = hold_last::Memory(settings);
  }

  void reset(std::uint64_t) { memory.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { memory.predict(dt); }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea&) {
    if (subject == REGISTA_SUBJECT_TEAMMATES) return;  // the camera does not tell shirt numbers
    const int kind = subject == REGISTA_SUBJECT_BALL ? REGISTA_MEASURED_BALL : REGISTA_MEASURED_ROBOT;
    std::size_t count = 0;
    for (const regista::Measurement& each : measurements) {
      if (each.kind != kind || count == seen.size()) continue;
      Sighting& sighting = seen[count++];
      sighting.position << each.position[0], each.position[1];
      sighting.covariance << each.covariance[0], each.covariance[1], each.covariance[1], each.covariance[2];
    }
    const std::span image(seen.data(), count);
    if (subject == REGISTA_SUBJECT_BALL) {
      memory.see_the_one(image);
    } else {
      memory.see_many(image);
    }
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    const bool team = subject == REGISTA_SUBJECT_TEAMMATES;
    if (!team) memory.clear();
    for (const regista::Track& told : tracks) {
      if (team && (told.label < 1 || told.label > team_size)) {
        throw std::out_of_range("hold_last: heard of robot " + std::to_string(told.label) + " in a team of " +
                                std::to_string(team_size));
      }
      Held held;
      held.label = subject == REGISTA_SUBJECT_BALL ? 1 : told.label;
      held.position << told.x, told.y;
      held.covariance << told.covariance[0], told.covariance[1], told.covariance[1], told.covariance[2];
      if (team) {
        held.heading = told.pose.heading;
        held.heading_variance = told.pose.heading_variance;
        held.has_target = (told.flags & REGISTA_TRACK_HAS_TARGET) != 0;
        if (held.has_target) held.target << told.pose.target[0], told.pose.target[1];
      }
      held.weight = told.weight;
      held.age_then = told.age;
      held.elapsed = age;
      memory.hear(held);
      if (subject == REGISTA_SUBJECT_BALL) return;  // the best comes first
    }
  }

  // All are written before the first is copied: a copy right behind the writes waits for them.
  void tracks(regista::Tracks out) const {
    std::size_t count = 0;
    for (const Held& held : memory) {
      const hold_last::Growth growth(held, memory.parameters());
      regista::Track& track = present[count++];
      track = {};
      track.label = held.label;
      track.x = held.position.x();
      track.y = held.position.y();
      track.covariance[0] = held.covariance(0, 0) + growth.position;
      track.covariance[1] = held.covariance(0, 1);
      track.covariance[2] = held.covariance(1, 1) + growth.position;
      if (subject == REGISTA_SUBJECT_TEAMMATES) {
        write_pose(held, growth, track);
      } else {
        track.motion[0] = track.motion[3] = growth.cross;
        track.motion[4] = track.motion[6] = growth.velocity;
      }
      track.weight = held.weight;
      track.age = held.age();
    }
    for (std::size_t i = 0; i < count; ++i) out.add(present[i]);
  }

  static void write_pose(const Held& held, const hold_last::Growth& growth, regista::Track& track) {
    track.pose.heading = held.heading;
    track.pose.heading_variance = held.heading_variance + growth.heading;
    track.pose.velocity_variance = growth.velocity;
    if (!held.has_target) return;
    track.flags = REGISTA_TRACK_HAS_TARGET;
    track.pose.target[0] = held.target.x();
    track.pose.target[1] = held.target.y();
  }

  std::uint32_t subject = 0;
  int team_size = 0;
  hold_last::Memory memory;
  std::array<Sighting, 64> seen{};  // of one image; more are ignored
  mutable std::array<regista::Track, hold_last::Memory::capacity> present{};
};

}  // namespace

REGISTA_PLUGIN(HoldLast, regista::predictor)
