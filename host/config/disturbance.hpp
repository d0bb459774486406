// SPDX-License-Identifier: MIT
// The disturbance profile: the troubles of one team on top of ordinary noise, all of them off by default. `radio` and
// `camera` hold for the whole team and the whole match; an incident strikes some of its robots at some time. What each
// does: docs/disturbances.md. SI units; radians in memory (degrees in YAML, in keys that end in _deg).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/rules.hpp"

namespace regista::config {

// Bursts of packet loss: a channel that is good or bad by turns, each for an exponentially distributed time, and loses
// packets while it is bad. Gilbert, "Capacity of a Burst-Noise Channel", BSTJ 39 (1960); Elliott, "Estimates of Error
// Rates for Codes on Burst-Noise Channels", BSTJ 42 (1963).
struct Burst {
  double mean_good = 10.0, mean_bad = 1.0;  // s
  double loss = 0.0;                        // probability per packet and receiver while it is bad
};

struct Incident {
  // In the order of incident_kinds.
  enum class Kind {
    pose_bias,
    mirror_flip,
    ghost_ball,
    blind_camera,
    radio_delay,
    radio_jitter,
    burst_loss,
    radio_silence,
    crash,
    slow_robot,
  };
  // Whom it strikes: all robots, one drawn anew each time, or these numbers.
  struct Whom {
    enum class Choice { all, any, listed } choice = Choice::all;
    std::vector<int> numbers;  // ascending; of `listed`
  };

  std::optional<std::string> name;
  Kind kind = Kind::pose_bias;
  Whom robots;
  std::vector<double> at;          // s of match time, ascending; or
  std::optional<double> per_hour;  // at random, so often on average
  std::optional<double> duration;  // s; none: to the end
  // Each belongs to the kinds that incident_values() names.
  std::optional<double> x, y;                       // m, field frame of the own team
  std::optional<double> heading;                    // rad
  std::optional<double> delay, jitter;              // s
  std::optional<double> mean_good, mean_bad, loss;  // as Burst's
  std::optional<double> speed;                      // factor
};

struct Disturbance {
  struct Radio {
    double loss = 0.0;                 // probability per packet and receiver
    double delay = 0.0, jitter = 0.0;  // s
    Burst burst;
    bool silence = false;
  };
  struct Camera {
    double ball_blindness = 0.0;  // probability that a sighting of the ball is lost
    double ghost_balls = 0.0;     // false ones per second and robot
  };

  std::string name = "none";
  Radio radio;
  Camera camera;
  std::vector<Incident> incidents;
};

const std::vector<std::string>& incident_kinds();

// So many incidents can show a ghost ball to one robot at a time, at the most.
inline constexpr int most_ghost_balls = 8;

// "incidents.flip", or "incidents.0" where it has no name: how `--set` and messages address it.
std::string path_of(const Disturbance& disturbance, std::size_t incident);

// Tells of the values of the document that make no sense for the kind of their incident, or are missing.
void check(const Disturbance& disturbance, const Node& document, Mistakes& mistakes);

// Throws Error where an incident strikes a robot that a team of these rules does not have, and at the ghost ball that
// is one too many for a robot.
void check(const Disturbance& disturbance, const Rules& rules, const Node& document);

}  // namespace regista::config
