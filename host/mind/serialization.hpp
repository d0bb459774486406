// SPDX-License-Identifier: MIT
// Serializes percepts, packets and outcomes for another process, exact to the last bit (see texts/bytes.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mind/action.hpp"
#include "mind/percepts.hpp"
#include "texts/bytes.hpp"

namespace regista::mind {

void visit(auto& archive, Pose& pose) { archive(pose.x, pose.y, pose.heading); }
void visit(auto& archive, PlacedPose& placed) {
  archive(placed.pose, placed.position_deviation, placed.heading_deviation);
}
void visit(auto& archive, BallSighting& ball) {
  archive(ball.position.x(), ball.position.y(), ball.along, ball.across);
}
void visit(auto& archive, RobotSighting& robot) {
  archive(robot.position.x(), robot.position.y(), robot.along, robot.across, robot.own_team);
}
void visit(auto& archive, LandmarkSighting& landmark) {
  archive(landmark.kind, landmark.position.x(), landmark.position.y(), landmark.along, landmark.across);
}
void visit(auto& archive, View& view) { archive(view.heading, view.half_angle, view.ball_range, view.robot_range); }
void visit(auto& archive, GameTold& game) {
  archive(game.phase, game.set_play, game.own_kick, game.half, game.own_score, game.opponent_score, game.phase_time,
          game.half_time_left, game.match_time_left, game.packets_left, game.own_penalised, game.opponent_penalised);
}
void visit(auto& archive, Percepts& percepts) {
  archive(percepts.time, percepts.odometry, percepts.placed, percepts.camera, percepts.view, percepts.balls,
          percepts.robots, percepts.landmarks, percepts.contact, percepts.whistle, percepts.fallen,
          percepts.time_until_up, percepts.kicking, percepts.penalised, percepts.game);
}

void visit(auto& archive, Walk& walk) { archive(walk.forward, walk.sideways, walk.turn); }
void visit(auto& archive, KickRequest& kick) { archive(kick.kind, kick.direction, kick.distance, kick.receiver); }
void visit(auto& archive, Command& command) { archive(command.walk, command.kick, command.head_yaw); }
void visit(auto& archive, Target& target) { archive(target.x, target.y); }
void visit(auto& archive, SegmentCounts& segments) {
  archive(segments.offered, segments.refused, segments.sent, segments.dropped, segments.heard, segments.bytes);
}
void visit(auto& archive, MetricReport& report) {
  archive(report.metric, report.place, report.count, report.sum, report.least, report.greatest, report.last);
}
void visit(auto& archive, Outcome& outcome) {
  archive(outcome.command, outcome.send, outcome.send_reason, outcome.packet, outcome.role, outcome.assignment,
          outcome.context, outcome.kept, outcome.target, outcome.announced, outcome.segments, outcome.metrics);
}

inline void write_heard(texts::BytesOut& bytes, std::span<const HeardPacket> heard) {
  const auto count = static_cast<std::uint32_t>(heard.size());
  bytes(count);
  for (const HeardPacket& packet : heard) {
    const auto size = static_cast<std::uint32_t>(packet.bytes.size());
    bytes(packet.time_heard, size);
    bytes.raw(packet.bytes.data(), packet.bytes.size());
  }
}

// Does not copy the bytes of packets: `out` is valid as long as the memory that `bytes` reads.
inline void read_heard(texts::BytesIn& bytes, std::vector<HeardPacket>& out) {
  std::uint32_t count = 0;
  bytes(count);
  out.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    HeardPacket& packet = out.emplace_back();
    std::uint32_t size = 0;
    bytes(packet.time_heard, size);
    packet.bytes = bytes.raw(size);
  }
}

}  // namespace regista::mind
