// SPDX-License-Identifier: MIT
// Outcome is the output of one robot's mind at a decision: a command for the body, perhaps a packet, and the decision
// itself for the metrics. SI units and radians, robot frame.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mind/extensions/plugin_log.hpp"
#include "mind/percepts.hpp"
#include "mind/world/packet.hpp"

namespace regista::mind {

struct Walk {
  double forward = 0.0, sideways = 0.0;  // m/s; the body reduces speeds that it cannot reach
  double turn = 0.0;                     // rad/s
};

struct KickRequest {
  int kind = 0;            // index into config::Robot::kicks
  double direction = 0.0;  // wanted direction in which the ball rolls
  double distance = 0.0;   // wanted distance that the ball rolls; clipped to the kick's range
  int receiver = 0;        // shirt number of the teammate for whom the kick is meant; 0: nobody
};

struct Command {
  Walk walk;
  std::optional<KickRequest> kick;  // the kick begins if the ball is in reach now; else the body ignores it
  double head_yaw = 0.0;            // wanted heading of the camera relative to the body
};

struct Target {  // A point to which a robot goes, in the field frame of the robot's team.
  double x = 0.0, y = 0.0;
};

struct Outcome {
  Command command;
  bool send = false;    // whether `packet` holds a packet to send
  int send_reason = 0;  // index into TeamPlan::reasons()
  std::vector<std::uint8_t> packet;
  int role = -1;                      // the robot's role: row of the team's table of roles; -1: no role
  std::vector<int> assignment;        // by robot (n - 1): row of the table of roles; -1: no role; -2: unknown
  int context = -1;                   // index into Team::contexts; -1: no context's condition holds
  std::vector<int> kept;              // tasks that the filter kept: rows of the table of roles, ascending
  std::optional<Target> target;       // place of the robot's task; empty: the robot has no task
  std::optional<Target> announced;    // target that the behaviour announces in place of `target`; empty: none
  SegmentCounts segments;             // counts of plugins' segments in this decision
  std::vector<MetricReport> metrics;  // reports of plugins in this decision

  // Resets all values, but keeps the allocated memory.
  void clear() {
    command = {};
    send = false;
    send_reason = 0;
    packet.clear();
    role = -1;
    assignment.clear();
    context = -1;
    kept.clear();
    target.reset();
    announced.reset();
    segments = {};
    metrics.clear();
  }
};

// Makes one decision of one robot and fills the Outcome. A match uses minds only through this function.
using Think = std::function<void(const Percepts&, std::span<const HeardPacket>, Outcome&)>;

}  // namespace regista::mind
