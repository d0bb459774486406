// SPDX-License-Identifier: MIT
// The disturbance profile of a team: failures in addition to ordinary noise, by default none. `radio` and `camera`
// affect the whole team during the whole match. An incident affects some robots for some time. docs/disturbances.md
// describes all disturbances. SI units; radians in memory (degrees in YAML, in keys that end in _deg).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/rules.hpp"

namespace regista::config {

// Packet loss in bursts. The radio channel changes between a good and a bad state. The duration of each state is
// exponentially distributed. Packets are lost only in the bad state. Gilbert, "Capacity of a Burst-Noise Channel", BSTJ
// 39 (1960); Elliott, "Estimates of Error Rates for Codes on Burst-Noise Channels", BSTJ 42 (1963).
struct Burst {
  double mean_good = 10.0, mean_bad = 1.0;  // mean durations of the two states, s
  double loss = 0.0;                        // probability per packet and receiver while the channel is bad
};

struct Incident {
  // Same order as the names in incident_kinds(). docs/disturbances.md describes each kind.
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
  // The robots that an incident affects: all robots, one robot drawn for each incident, or the listed robots.
  struct Whom {
    enum class Choice { all, any, listed } choice = Choice::all;
    std::vector<int> numbers;  // shirt numbers, ascending; only with `listed`
  };

  std::optional<std::string> name;
  Kind kind = Kind::pose_bias;
  Whom robots;
  std::vector<double> at;          // start times of the incident, s of match time, ascending; empty if per_hour is set
  std::optional<double> per_hour;  // mean number of incidents per hour at random times; missing if `at` is set
  std::optional<double> duration;  // s; missing: the incident lasts until the end of the match
  // values() in disturbance.cpp says which of the following values each kind of incident has.
  std::optional<double> x, y;           // error of the known place, or place of the ghost ball; m, team's field frame
  std::optional<double> heading;        // error of the known heading, rad
  std::optional<double> delay, jitter;  // fixed delay, and width of a uniform distribution that is added, s
  std::optional<double> mean_good, mean_bad, loss;  // same meaning as in Burst
  std::optional<double> speed;                      // remaining share of the robot's speed
};

struct Disturbance {
  struct Radio {
    double loss = 0.0;                 // probability that a receiver loses a packet
    double delay = 0.0, jitter = 0.0;  // fixed delay, and width of a uniform distribution that is added, s
    Burst burst;
    bool silence = false;
  };
  struct Camera {
    double ball_blindness = 0.0;  // probability that a sighting of the ball is lost
    double ghost_balls = 0.0;     // number of false sightings of a ball per second and robot
  };

  std::string name = "none";
  Radio radio;
  Camera camera;
  std::vector<Incident> incidents;
};

const std::vector<std::string>& incident_kinds();

inline constexpr int most_ghost_balls = 8;  // largest number of ghost_ball incidents that may affect the same robot

// Returns the path of an incident for `--set` and messages: "incidents.flip", or "incidents.0" if it has no name.
std::string path_of(const Disturbance& disturbance, std::size_t incident);

Map declare(Disturbance& disturbance);

// Reports incident values that are missing or that do not fit the kind of the incident.
void check(const Disturbance& disturbance, const Node& document, Mistakes& mistakes);

// Throws Error at an incident for a robot number above the team size of the rules. Throws Error at the first ghost_ball
// incident with which more than most_ghost_balls incidents may affect the same robot.
void check(const Disturbance& disturbance, const Rules& rules, const Node& document);

}  // namespace regista::config
