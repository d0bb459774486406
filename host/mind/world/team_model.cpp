// SPDX-License-Identifier: MIT
#include "mind/world/team_model.hpp"

#include <algorithm>
#include <utility>

namespace regista::mind {
namespace {

// What a packet leaves out, because it hardly differs from robot to robot.
constexpr double ball_velocity_variance = 0.04;   // (m/s)^2
constexpr double robot_velocity_variance = 0.01;  // (m/s)^2
constexpr double least_deviation = 0.01;          // m; a packet rounds

void set_place(regista_track& track, double deviation) {
  track.covariance[0] = track.covariance[2] = deviation * deviation + least_deviation * least_deviation;
}

void set_motion(regista_track& track, double deviation, double velocity_variance) {
  set_place(track, deviation);
  track.motion[4] = track.motion[6] = velocity_variance;
}

}  // namespace

TeamModel::TeamModel(int team_size, const config::Camera& camera, plugin::Predictor teammates,
                     std::vector<plugin::Predictor> balls, std::vector<plugin::Predictor> opponents)
    : camera_(camera), teammates_(std::move(teammates)) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
    members_.push_back({std::move(balls[i]), std::move(opponents[i]), std::nullopt, nullptr, {}, {}, false, false});
  }
  told_.reserve(Report::most_opponents);
  known_.reserve(plugin::Predictor::track_capacity);
  merged_.reserve(plugin::Predictor::track_capacity + Report::most_opponents);
}

void TeamModel::predict(double dt, const regista_frame* last) {
  teammates_.predict(dt, nullptr, last);
  for (Member& member : members_) {
    if (member.has_ball) member.ball.predict(dt, nullptr, last);
    if (member.has_opponents) member.opponents.predict(dt, nullptr, last);
  }
}

void TeamModel::absorb(const Report& report, double now) {
  Member& member = members_[static_cast<std::size_t>(report.sender - 1)];
  if (member.report && member.report->time_sent >= report.time_sent) return;
  member.report = report;
  member.has_ball = member.has_opponents = true;
  const double age = std::max(0.0, now - report.time_sent);
  absorb_robot(report, age);
  absorb_ball(report, age, member.ball);
  absorb_opponents(report, age, member.opponents);
}

void TeamModel::absorb_robot(const Report& report, double age) {
  told_.clear();
  regista_track& robot = told_.emplace_back();
  robot.label = report.sender;
  robot.flags = REGISTA_TRACK_HAS_TARGET | REGISTA_TRACK_VELOCITY;
  robot.x = report.pose.x;
  robot.y = report.pose.y;
  robot.pose.heading = report.pose.heading;
  robot.vx = report.velocity.x();
  robot.vy = report.velocity.y();
  set_place(robot, report.position_deviation);
  robot.pose.velocity_variance = robot_velocity_variance;
  robot.pose.heading_variance = report.heading_deviation * report.heading_deviation;
  robot.weight = 1.0;
  robot.pose.target[0] = report.target.x();
  robot.pose.target[1] = report.target.y();
  teammates_.absorb(told_, age);
}

void TeamModel::absorb_ball(const Report& report, double age, plugin::Predictor& model) {
  told_.clear();
  if (report.ball) {
    regista_track& ball = told_.emplace_back();
    ball.flags = REGISTA_TRACK_VELOCITY;
    ball.x = report.ball->position.x();
    ball.y = report.ball->position.y();
    ball.vx = report.ball->velocity.x();
    ball.vy = report.ball->velocity.y();
    set_motion(ball, report.ball->deviation, ball_velocity_variance);
    ball.weight = 1.0;
    ball.age = report.ball->age;
    model.absorb(told_, age);  // there is one ball
    return;
  }
  merge(model,
        {report.pose, camera_.half_angle + camera_.head_yaw, camera_.ball_range, camera_.ball_probability,
         Report::tells_ball_for, true},
        age);
}

void TeamModel::absorb_opponents(const Report& report, double age, plugin::Predictor& model) {
  told_.clear();
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const ReportedOpponent& seen = report.opponents[i];
    regista_track& opponent = told_.emplace_back();
    opponent.label = static_cast<std::int32_t>(i) + 1;
    opponent.x = seen.position.x();
    opponent.y = seen.position.y();
    set_motion(opponent, seen.deviation, robot_velocity_variance);
    opponent.weight = 1.0;
    opponent.age = seen.age;
  }
  merge(model,
        {report.pose, camera_.half_angle + camera_.head_yaw, camera_.robot_range, camera_.robot_probability,
         Report::tells_opponents_for, report.opponent_count < Report::most_opponents},
        age);
}

// What was told `age` seconds ago is brought to now by the model's own law, as what is known has been.
void TeamModel::merge(plugin::Predictor& model, const SenderView& sender, double age) {
  const auto known = model.tracks();
  known_.assign(known.begin(), known.end());
  model.absorb(told_, age);
  if (known_.empty()) return;
  const auto told = model.tracks();
  told_.assign(told.begin(), told.end());
  merge_told(known_, told_, sender, merged_);
  model.absorb(merged_, 0.0);
}

void TeamModel::refresh() {
  for (Member& member : members_) {
    member.track = nullptr;
    member.ball_tracks = member.has_ball ? member.ball.tracks() : std::span<const regista_track>{};
    member.opponent_tracks = member.has_opponents ? member.opponents.tracks() : std::span<const regista_track>{};
    member.has_ball = !member.ball_tracks.empty();
    member.has_opponents = !member.opponent_tracks.empty();
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
