// SPDX-License-Identifier: MIT
// All that leaves one robot's mind at a decision: what the body shall do, perhaps a packet, and, for whoever keeps
// count, what it decided. Units SI and radians, robot frame.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mind/extensions/metric_reports.hpp"
#include "mind/percepts.hpp"
#include "mind/world/segment_counts.hpp"

namespace regista::mind {

struct Walk {
  double forward = 0.0, sideways = 0.0;  // m/s; the body clips them to what it can do
  double turn = 0.0;                     // rad/s
};

struct KickRequest {
  int kind = 0;            // index into config::Robot::kicks
  double direction = 0.0;  // in which the ball shall go
  double distance = 0.0;   // that it shall roll; clipped to the kind's range
  int receiver = 0;        // the teammate that it is meant for, 0 = nobody
};

struct Command {
  Walk walk;
  std::optional<KickRequest> kick;  // begins when the ball is in reach, else nothing happens
  double head_yaw = 0.0;            // wanted heading of the camera relative to the body
};

// Where the own task is played. Field frame of the own team, so far as the robot knows where that is.
struct Target {
  double x = 0.0, y = 0.0;
};

struct Outcome {
  Command command;
  bool send = false;    // the bytes below are a packet
  int send_reason = 0;  // of the team: TeamPlan::reasons()
  std::vector<std::uint8_t> packet;
  int role = -1;                      // row of the team's table of roles, -1 = none (penalised, no task)
  std::vector<int> assignment;        // per robot (n - 1): row of the table of roles, -1 none, -2 unknown
  int context = -1;                   // of the team's contexts, -1 = none holds
  std::vector<int> kept;              // tasks that the filter kept: rows of the table of roles, ascending
  std::optional<Target> target;       // nothing without a task
  std::optional<Target> announced;    // what the behaviour tells teammates instead
  SegmentCounts segments;             // of this decision
  std::vector<MetricReport> metrics;  // what plugins reported in it, by metric of the team: TeamPlan::metrics()

  // As it is handed to a mind; keeps the memory.
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

// One decision of one robot. A match knows minds only as this.
using Think = std::function<void(const Percepts&, std::span<const HeardPacket>, Outcome&)>;

}  // namespace regista::mind
