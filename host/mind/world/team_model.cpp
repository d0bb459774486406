// SPDX-License-Identifier: MIT
#include "mind/world/team_model.hpp"

#include <utility>

namespace regista::mind {
namespace {

// What a packet leaves out, because it hardly differs from robot to robot.
constexpr double ball_velocity_variance = 0.04;   // (m/s)^2
constexpr double robot_velocity_variance = 0.01;  // (m/s)^2
constexpr double least_deviation = 0.01;          // m; a packet rounds

void set_covariance(regista_track& track, double deviation, double velocity_variance) {
  const double variance = deviation * deviation + least_deviation * least_deviation;
  track.covariance[0] = track.covariance[5] = variance;
  track.covariance[10] = track.covariance[15] = velocity_variance;
}

}  // namespace

TeamModel::TeamModel(int team_size, plugin::Predictor teammates, std::vector<plugin::Predictor> balls,
                     std::vector<plugin::Predictor> opponents)
    : teammates_(std::move(teammates)) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
    members_.push_back({std::move(balls[i]), std::move(opponents[i]), std::nullopt, nullptr, {}, {}});
  }
  scratch_.reserve(Report::most_opponents);
}

void TeamModel::predict(double dt, const regista_frame* last) {
  teammates_.predict(dt, nullptr, last);
  for (Member& member : members_) {
    if (!member.report) continue;
    if (member.report->ball) member.ball.predict(dt, nullptr, last);
    if (member.report->opponent_count > 0) member.opponents.predict(dt, nullptr, last);
  }
}

void TeamModel::absorb(const Report& report, double now) {
  Member& member = members_[static_cast<std::size_t>(report.sender - 1)];
  if (member.report && member.report->time_sent >= report.time_sent) return;
  member.report = report;
  const double age = std::max(0.0, now - report.time_sent);

  scratch_.clear();
  regista_track& robot = scratch_.emplace_back();
  robot.label = report.sender;
  robot.flags = REGISTA_TRACK_HAS_TARGET | REGISTA_TRACK_VELOCITY;
  robot.x = report.pose.x;
  robot.y = report.pose.y;
  robot.heading = report.pose.heading;
  robot.vx = report.velocity.x();
  robot.vy = report.velocity.y();
  set_covariance(robot, report.position_deviation, robot_velocity_variance);
  robot.heading_variance = report.heading_deviation * report.heading_deviation;
  robot.weight = 1.0;
  robot.target[0] = report.target.x();
  robot.target[1] = report.target.y();
  teammates_.absorb(scratch_, age);

  scratch_.clear();
  if (report.ball) {
    regista_track& ball = scratch_.emplace_back();
    ball.flags = REGISTA_TRACK_VELOCITY;
    ball.x = report.ball->position.x();
    ball.y = report.ball->position.y();
    ball.vx = report.ball->velocity.x();
    ball.vy = report.ball->velocity.y();
    set_covariance(ball, report.ball->deviation, ball_velocity_variance);
    ball.weight = 1.0;
    ball.age = report.ball->age;
  }
  member.ball.absorb(scratch_, age);

  scratch_.clear();
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const ReportedOpponent& seen = report.opponents[i];
    regista_track& opponent = scratch_.emplace_back();
    opponent.label = static_cast<std::int32_t>(i) + 1;
    opponent.x = seen.position.x();
    opponent.y = seen.position.y();
    set_covariance(opponent, seen.deviation, robot_velocity_variance);
    opponent.weight = 1.0;
    opponent.age = seen.age;
  }
  member.opponents.absorb(scratch_, age);
}

void TeamModel::refresh() {
  for (Member& member : members_) {
    member.track = nullptr;
    if (!member.report) continue;
    member.ball_tracks = member.report->ball ? member.ball.tracks() : std::span<const regista_track>{};
    member.opponent_tracks =
        member.report->opponent_count > 0 ? member.opponents.tracks() : std::span<const regista_track>{};
  }
  for (const regista_track& track : teammates_.tracks()) {
    const auto index = static_cast<std::size_t>(track.label - 1);
    if (index < members_.size()) members_[index].track = &track;
  }
}

void TeamModel::balls(int except, std::vector<Estimate>& out) const {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    if (number == except || members_[i].ball_tracks.empty()) continue;
    out.push_back({&members_[i].ball_tracks.front(), number});
  }
}

void TeamModel::opponents(std::vector<Estimate>& out) const {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    for (const regista_track& track : members_[i].opponent_tracks) out.push_back({&track, static_cast<int>(i) + 1});
  }
}

}  // namespace regista::mind
