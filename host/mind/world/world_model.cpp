// SPDX-License-Identifier: MIT
#include "mind/world/world_model.hpp"

#include <algorithm>
#include <utility>

namespace regista::mind {
namespace {

// Covariance of a sighting from its standard deviations along and across the line of sight, in the frame of `line`.
struct Spread {
  double xx, xy, yy;
  Spread(const Vector2d& line, double along, double across) {
    const double length2 = line.squaredNorm();
    const double c2 = length2 > 0.0 ? line.x() * line.x() / length2 : 1.0;
    const double cs = length2 > 0.0 ? line.x() * line.y() / length2 : 0.0;
    const double a = along * along, b = across * across;
    xx = c2 * a + (1.0 - c2) * b;
    xy = cs * (a - b);
    yy = (1.0 - c2) * a + c2 * b;
  }
};

void set_position_covariance(regista_measurement& measurement, double xx, double xy, double yy) {
  measurement.covariance[0] = xx;
  measurement.covariance[1] = xy;
  measurement.covariance[2] = yy;
}

// Values for received tracks. Packets do not contain these values, because they hardly differ between robots.
constexpr double ball_velocity_variance = 0.04;   // (m/s)^2
constexpr double robot_velocity_variance = 0.01;  // (m/s)^2
constexpr double least_deviation = 0.01;          // m; packets round positions, so no deviation is smaller

regista_track& add(std::vector<regista_track>& told, const Vector2d& position, double deviation) {
  regista_track& track = told.emplace_back();
  track.x = position.x();
  track.y = position.y();
  track.covariance[0] = track.covariance[2] = deviation * deviation + least_deviation * least_deviation;
  track.weight = 1.0;
  return track;
}

void set_velocity(regista_track& track, const Vector2d& velocity) {
  track.flags |= REGISTA_TRACK_VELOCITY;
  track.vx = velocity.x();
  track.vy = velocity.y();
}

// An estimate without a sighting for this time (s) is dropped: the ball may then be anywhere on the field.
constexpr double ball_forgotten_after = 30.0;

static_assert(static_cast<int>(Phase::finished) == REGISTA_PHASE_FINISHED);
static_assert(static_cast<int>(SetPlay::penalty_kick) == REGISTA_SET_PLAY_PENALTY_KICK);

void set_motion(regista_robot& robot, const regista_track& track) {
  robot.pose[0] = track.x;
  robot.pose[1] = track.y;
  robot.pose[2] = track.pose.heading;
  robot.velocity[0] = track.vx;
  robot.velocity[1] = track.vy;
  robot.velocity[2] = track.pose.turn_rate;
  std::ranges::copy(track.covariance, robot.covariance);
  robot.covariance[5] = track.pose.heading_variance;
}

void set_role(regista_robot& robot, int role, double since, const Vector2d& target) {
  robot.role = role;
  robot.role_since = since;
  robot.target[0] = target.x();
  robot.target[1] = target.y();
}

}  // namespace

LocalModel::LocalModel(const TeamPlan& plan, plugin::Predictor self, plugin::Predictor ball,
                       plugin::Predictor opponents, plugin::Predictor teammates)
    : decision_period_(plan.robot().decision_period),
      self_model_(std::move(self)),
      ball_model_(std::move(ball)),
      opponent_model_(std::move(opponents)),
      teammate_model_(std::move(teammates)) {
  measurements_.reserve(64);
}

regista_measurement& LocalModel::add(int kind, double x, double y) {
  regista_measurement& measurement = measurements_.emplace_back();
  measurement.kind = kind;
  measurement.position[0] = x;
  measurement.position[1] = y;
  return measurement;
}

void LocalModel::measure_self(const Percepts& percepts) {
  measurements_.clear();
  if (percepts.placed) {
    const Pose& pose = percepts.placed->pose;
    regista_measurement& measurement = add(REGISTA_MEASURED_POSE, pose.x, pose.y);
    measurement.heading = pose.heading;
    const double variance = percepts.placed->position_deviation * percepts.placed->position_deviation;
    set_position_covariance(measurement, variance, 0.0, variance);
    measurement.covariance[5] = percepts.placed->heading_deviation * percepts.placed->heading_deviation;
  }
  for (const LandmarkSighting& sighting : percepts.landmarks) {
    regista_measurement& measurement = add(REGISTA_MEASURED_LANDMARK, sighting.position.x(), sighting.position.y());
    measurement.label = sighting.kind;
    const Spread spread(sighting.position, sighting.along, sighting.across);
    set_position_covariance(measurement, spread.xx, spread.xy, spread.yy);
  }
}

void LocalModel::add_in_field_frame(int kind, const Vector2d& seen, double along, double across) {
  const Vector2d offset = frame_.direction_to_field(seen);
  regista_measurement& measurement = add(kind, self_.x + offset.x(), self_.y + offset.y());
  const Spread spread(offset, along, across);
  // A heading error moves the sighting across the line of sight. So the heading's variance adds to the covariance.
  const double turn = self_.pose.heading_variance;
  set_position_covariance(measurement, spread.xx + self_.covariance[0] + turn * offset.y() * offset.y(),
                          spread.xy + self_.covariance[1] - turn * offset.x() * offset.y(),
                          spread.yy + self_.covariance[2] + turn * offset.x() * offset.x());
}

void LocalModel::update(const Percepts& percepts, double dt, const regista_frame* last, bool ball_on_centre) {
  const regista_motion motion{percepts.odometry.x, percepts.odometry.y, percepts.odometry.heading};

  // The area has no direction yet, because the robot's pose is not yet updated. The model of the robot's own pose needs
  // no direction, because it takes landmarks in the robot frame.
  regista_visible_area area{};
  area.half_angle = percepts.view.half_angle;
  area.range_ball = percepts.view.ball_range;
  area.range_robot = percepts.view.robot_range;
  if (dt > 0.0) self_model_.predict(dt, &motion, last);
  measure_self(percepts);
  if (!measurements_.empty()) self_model_.correct(measurements_, area);
  self_ = self_model_.tracks().front();

  frame_ = Frame2(pose());
  area.x = self_.x;
  area.y = self_.y;
  area.heading = wrap(self_.pose.heading + percepts.view.heading);

  const auto updated = [&](plugin::Predictor& model, auto measure) {
    if (dt > 0.0) model.predict(dt, &motion, last);
    measurements_.clear();
    measure();
    if (percepts.camera || !measurements_.empty()) model.correct(measurements_, area);
    return model.tracks();
  };
  balls_ = updated(ball_model_, [&] {
    sighted_ = !percepts.balls.empty();  // before the plugin is asked, which may ask for it
    for (const BallSighting& ball : percepts.balls) {
      add_in_field_frame(REGISTA_MEASURED_BALL, ball.position, ball.along, ball.across);
    }
    if (ball_on_centre) set_position_covariance(add(REGISTA_MEASURED_BALL, 0.0, 0.0), 0.0025, 0.0, 0.0025);
  });
  const auto measure_robots = [&](bool own_team) {
    for (const RobotSighting& robot : percepts.robots) {
      if (!percepts.camera || robot.own_team != own_team) continue;
      add_in_field_frame(REGISTA_MEASURED_ROBOT, robot.position, robot.along, robot.across);
    }
  };
  opponents_ = updated(opponent_model_, [&] { measure_robots(false); });
  teammates_ = updated(teammate_model_, [&] { measure_robots(true); });
}

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
  regista_track& robot = add(told_, position(report.pose), report.position_deviation);
  robot.label = report.sender;
  robot.flags = REGISTA_TRACK_HAS_TARGET;
  set_velocity(robot, report.velocity);
  robot.pose.heading = report.pose.heading;
  robot.pose.velocity_variance = robot_velocity_variance;
  robot.pose.heading_variance = report.heading_deviation * report.heading_deviation;
  robot.pose.target[0] = report.target.x();
  robot.pose.target[1] = report.target.y();
  teammates_.absorb(told_, age);
}

void TeamModel::absorb_ball(const Report& report, double age, plugin::Predictor& model) {
  told_.clear();
  if (report.ball) {
    regista_track& ball = add(told_, report.ball->position, report.ball->deviation);
    set_velocity(ball, report.ball->velocity);
    ball.motion[4] = ball.motion[6] = ball_velocity_variance;
    ball.age = report.ball->age;
    model.absorb(told_, age);  // replaces the known track without merge_told(), because only one ball exists
    return;
  }
  const double half_angle = camera_.half_angle + camera_.head_yaw;
  merge(model, {report.pose, half_angle, camera_.ball_range, camera_.ball_probability, Report::tells_ball_for}, age);
}

void TeamModel::absorb_opponents(const Report& report, double age, plugin::Predictor& model) {
  told_.clear();
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const ReportedOpponent& seen = report.opponents[i];
    regista_track& opponent = add(told_, seen.position, seen.deviation);
    opponent.label = static_cast<std::int32_t>(i) + 1;
    opponent.motion[4] = opponent.motion[6] = robot_velocity_variance;
    opponent.age = seen.age;
  }
  merge(model,
        {report.pose, camera_.half_angle + camera_.head_yaw, camera_.robot_range, camera_.robot_probability,
         Report::tells_opponents_for, report.opponent_count < Report::most_opponents},
        age);
}

// Merges received tracks into a model. The model itself carries the received tracks forward by `age` seconds.
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

WorldModel::WorldModel(const TeamPlan& plan, int own_number, LocalModel local, TeamModel team, FrameParts made)
    : plan_(&plan),
      made_(made),
      own_number_(own_number),
      local_(std::move(local)),
      team_(std::move(team)),
      mine_(plan.rules().team_size),
      common_(plan.rules().team_size),
      negative_(plan.rules().team_size) {
  estimates_.reserve(static_cast<std::size_t>(plan.rules().team_size));
  seen_teammates_.reserve(static_cast<std::size_t>(plan.rules().team_size));
}

void WorldModel::sense(const Percepts& percepts, double dt, const regista_frame* last) {
  // game() also uses packets: a teammate may have reported Playing, and the ball may then no longer be on the centre.
  const regista_game now = game(percepts);
  local_.update(percepts, dt, last, now.phase == REGISTA_PHASE_SET && now.set_play == REGISTA_SET_PLAY_KICK_OFF);
  if (dt > 0.0) team_.predict(dt, last);
}

regista_game WorldModel::game(const Percepts& percepts) const {
  const GameTold& told = percepts.game;
  regista_game game{};
  game.phase = static_cast<int>(told.phase);
  game.set_play = static_cast<int>(told.set_play);
  game.own_kick = told.own_kick ? 1 : 0;
  game.half = told.half;
  game.own_score = told.own_score;
  game.opponent_score = told.opponent_score;
  game.phase_time = told.phase_time;
  game.time_left = told.half_time_left;
  // A robot that heard the whistle reports Playing in its packet, so teammates need not wait for the game controller.
  if (told.phase == Phase::set) {
    for (int number = 1; number <= plan_->rules().team_size; ++number) {
      const Report* report = team_.report(number);
      if (report != nullptr && report->playing && report->time_sent > percepts.time - told.phase_time) {
        game.phase = REGISTA_PHASE_PLAYING;
      }
    }
  }
  return game;
}

void WorldModel::fuse(const Percepts& percepts, double dt, const OwnRole& own) {
  team_.refresh();
  mine_.game = common_.game = game(percepts);
  fuse_balls(percepts, dt);
  fuse_opponents();
  fill_robots(percepts);
  sharpen_teammates();
  fill_self(percepts, own);
  mine_.close();
  common_.close();
}

// `mine` does not use estimates of the ball that this robot's camera refutes. If the camera refutes all estimates,
// `mine` uses all estimates, so that the robots of the team still agree on the place of the lost ball.
void WorldModel::fuse_balls(const Percepts& percepts, double dt) {
  const auto forgotten = [](const Estimate& each) { return each.track->age > ball_forgotten_after; };
  estimates_.clear();
  if (!local_.balls().empty()) estimates_.push_back({&local_.balls().front(), 0});
  team_.balls(own_number_, estimates_);
  std::erase_if(estimates_, forgotten);
  negative_.look(estimates_, local_.frame(), percepts, dt);
  const auto refuted = [this](const Estimate& each) { return negative_.refutes(each.source); };
  ball_refuted_ = std::ranges::all_of(estimates_, refuted);
  if (!ball_refuted_) std::erase_if(estimates_, refuted);
  mine_.ball_state = fuse_ball(estimates_);

  estimates_.clear();
  team_.balls(0, estimates_);
  std::erase_if(estimates_, forgotten);
  common_.ball_state = fuse_ball(estimates_);
}

// `mine` is `common` and LM. What the robot told in its own packets is in both. Covariance intersection allows for that
// in the place; the weight counts it twice. With that the list of matches is no worse (OSPA), and is computed once.
void WorldModel::fuse_opponents() {
  const auto most = static_cast<std::size_t>(plan_->rules().team_size);
  fusion_.clear();
  for (int number = 1; number <= plan_->rules().team_size; ++number) fusion_.add(team_.opponents(number), number);
  if (made_.common_opponents) fusion_.write(most, common_.opponents);
  constexpr int own_camera = 0;
  fusion_.add(local_.opponents(), own_camera);
  fusion_.write(most, mine_.opponents);
}

// Fills the robots of both worlds from packets. fill_self() later fills this robot's row of `mine`.
void WorldModel::fill_robots(const Percepts& percepts) {
  for (regista_robot& robot : common_.robots) {
    const Report* report = team_.report(robot.number);
    const regista_track* track = team_.track(robot.number);
    const bool penalised = (percepts.game.own_penalised >> (robot.number - 1) & 1u) != 0;
    robot.flags = penalised ? REGISTA_ROBOT_PENALISED : 0;
    robot.age = std::max(0.0, percepts.time - (report != nullptr ? report->time_sent : 0.0));
    if (report == nullptr || track == nullptr) continue;
    robot.flags |= REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET;
    if (!penalised && robot.age <= plan_->team().forget_teammate_after) robot.flags |= REGISTA_ROBOT_ACTIVE;
    robot.time_until_up = std::max(0.0, report->time_until_up - robot.age);
    if (robot.time_until_up > 0.0) robot.flags |= REGISTA_ROBOT_FALLEN;
    set_motion(robot, *track);
    set_role(robot, report->role, report->role_since, report->target);
  }
  mine_.robots = common_.robots;
  common_.robot(own_number_).flags |= REGISTA_ROBOT_SELF;
}

// Improves positions of old packets in `mine` with this robot's camera. It sees no numbers, so positions are paired.
void WorldModel::sharpen_teammates() {
  seen_teammates_.clear();
  match_teammates(local_.teammates(), mine_.robots, own_number_, seen_teammates_);
  for (const SeenTeammate& each : seen_teammates_) sharpen(mine_.robot(each.number), *each.track);
}

void WorldModel::fill_self(const Percepts& percepts, const OwnRole& own) {
  regista_robot& self = mine_.robot(own_number_);
  self.flags = REGISTA_ROBOT_SELF | REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET |
               (percepts.penalised ? REGISTA_ROBOT_PENALISED : REGISTA_ROBOT_ACTIVE) |
               (percepts.fallen ? REGISTA_ROBOT_FALLEN : 0);
  self.age = 0.0;
  self.time_until_up = percepts.time_until_up;
  set_motion(self, local_.self());
  set_role(self, own.role, own.since, own.target);
}

}  // namespace regista::mind
