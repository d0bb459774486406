// SPDX-License-Identifier: MIT
// The troubles of one team in the ongoing of a match: which of its robots suffers what at this moment, by the team's
// disturbance profile. It only says what is wrong; sensing, body and radio make it felt, and minds are told nothing.
//
// Incidents at random are a Poisson process of their own each; bursts of packet loss are a channel with two states for
// each robot (see config::Burst). Times are drawn from event to event, never from step to step.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "config/disturbance.hpp"
#include "config/rules.hpp"
#include "match/geometry.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// Probability that something is lost by either of two independent causes.
constexpr double either(double a, double b) { return 1.0 - (1.0 - a) * (1.0 - b); }

// What is wrong with one robot now.
struct Affliction {
  static constexpr auto most_ghosts = static_cast<std::size_t>(config::most_ghost_balls);

  bool crashed = false;
  bool blind = false;                      // the camera recognises nothing
  double speed = 1.0;                      // factor
  mind::Pose bias;                         // of the pose that its landmarks speak for; field frame
  int flips = 0;                           // how often a mirror flip has struck it so far
  bool flipped = false;                    // and the last of them has not ended
  bool silent = false;                     // sends and hears no packet
  double delay = 0.0, jitter = 0.0;        // s, more than usual, of what it sends and hears
  double loss = 0.0;                       // probability that it misses a packet, more than usual
  std::array<Vector, most_ghosts> ghosts;  // balls that are not there; field frame
  std::size_t ghost_count = 0;
};

class Trouble {
 public:
  // The disturbance is the caller's and must live as long.
  Trouble(const config::Disturbance& disturbance, const config::FieldSize& field, int team_size, std::uint64_t seed,
          Side side);

  // Lets everything happen that happens until `time`, which rises from call to call. False: nothing has changed.
  bool update(double time);

  const Affliction& of(int number) const { return now_[static_cast<std::size_t>(number - 1)]; }
  const config::Disturbance& disturbance() const { return *disturbance_; }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  // One robot in an incident.
  struct Victim {
    double until = -never;  // when it is over
    int strikes = 0;
    Vector ghost;
    bool bad = false;         // state of the channel of a burst loss
    double switches = never;  // when that changes
    std::uint32_t drawn = 0;  // numbers drawn for it so far
  };
  struct OngoingIncident {
    config::Incident incident;
    int object;  // of its streams of chance
    double next = never;
    std::uint32_t occurrence = 0;
    std::vector<Victim> victims;  // by number
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
  std::vector<Affliction> now_;  // by number
  double next_ = 0.0;            // nothing changes before
};

}  // namespace regista::match
