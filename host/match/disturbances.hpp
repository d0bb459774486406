// SPDX-License-Identifier: MIT
// Disturbances computes which robots of one team are disturbed at a given moment, and how. The team's disturbance
// profile lists the incidents. Sensing, Body and Radio apply the effects; minds do not learn of them. Each random
// incident is a separate Poisson process. For bursts of packet loss each robot has a two-state channel (see
// config::Burst). When an event happens, Disturbances draws the time of the next event. Other steps draw no number.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "config/disturbance.hpp"
#include "config/rules.hpp"
#include "match/plane.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// Probability that at least one of two independent events with the probabilities `a` and `b` happens.
constexpr double either(double a, double b) { return 1.0 - (1.0 - a) * (1.0 - b); }

// The disturbances of one robot at the time of the last Disturbances::update().
struct Affliction {
  static constexpr auto most_ghosts = static_cast<std::size_t>(config::most_ghost_balls);

  bool crashed = false;                    // the robot does not decide, walk or kick
  bool blind = false;                      // the camera recognises nothing
  double speed = 1.0;                      // factor of the walking speed
  mind::Pose bias;                         // offset from the true pose to the pose that landmarks suggest; field frame
  int flips = 0;                           // number of mirror flips of this robot so far
  bool flipped = false;                    // a mirror flip of this robot is in force
  bool silent = false;                     // the radio of the robot neither sends nor receives
  double delay = 0.0, jitter = 0.0;        // s, added to delay and jitter of the radio profile
  double loss = 0.0;                       // probability of losing a packet, added to that of the radio profile
  std::array<Vector, most_ghosts> ghosts;  // positions of balls that do not exist; field frame
  std::size_t ghost_count = 0;
};

class Disturbances {
 public:
  // The caller owns `disturbance`, which must outlive this object.
  Disturbances(const config::Disturbance& disturbance, const config::FieldSize& field, int team_size,
               std::uint64_t seed, Side side);

  // Applies all events up to `time`. `time` must not decrease between calls. Returns whether a disturbance changed.
  bool update(double time);

  const Affliction& of(int number) const { return now_[at(number - 1)]; }  // the disturbances of robot `number`
  const config::Disturbance& disturbance() const { return *disturbance_; }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  // What one incident does to one robot at present.
  struct Victim {
    double until = -never;    // match time at which the disturbance ends, s
    int strikes = 0;          // number of occurrences that hit this robot
    Vector ghost;             // position of the ghost ball; field frame
    bool bad = false;         // burst loss: the channel is in its bad state, which loses packets
    double switches = never;  // match time of the next change of `bad`, s
    std::uint32_t drawn = 0;  // number of random numbers drawn for this robot so far
  };
  struct OngoingIncident {
    config::Incident incident;
    int object;                    // index of the incident, used in the names of random streams
    double next = never;           // match time of the next occurrence, s
    std::uint32_t occurrence = 0;  // number of occurrences so far
    std::vector<Victim> victims;   // by robot (n - 1)
  };

  void schedule(OngoingIncident& ongoing, double after) const;
  void strike(OngoingIncident& ongoing, double time) const;
  void strike(OngoingIncident& ongoing, Victim& victim, int number, Vector ghost, double time) const;
  void switch_channel(const OngoingIncident& ongoing, Victim& victim, int number, double time) const;
  void afflict(const OngoingIncident& ongoing, const Victim& victim, Affliction& out) const;

  const config::Disturbance* disturbance_;
  config::FieldSize field_;
  int team_size_;
  std::uint64_t seed_;
  Side side_;
  std::vector<OngoingIncident> incidents_;
  std::vector<Affliction> now_;  // by robot (n - 1)
  double next_ = 0.0;            // match time of the next change of any disturbance, s
};

}  // namespace regista::match
