// SPDX-License-Identifier: MIT
#include "mind/world/world_model.hpp"

#include <algorithm>

namespace regista::mind {
namespace {

// Obstacles of two robots this near are one (B-Human's release: 1.1 m).
constexpr double merge_distance = 1.1;

// A ball that nobody has seen for so long may be anywhere on the field.
constexpr double ball_forgotten_after = 30.0;

int abi(Phase phase) { return static_cast<int>(phase); }
int abi(SetPlay set_play) { return static_cast<int>(set_play); }
static_assert(static_cast<int>(Phase::finished) == REGISTA_PHASE_FINISHED);
static_assert(static_cast<int>(SetPlay::penalty_kick) == REGISTA_SET_PLAY_PENALTY_KICK);

void set_covariance(regista_robot& robot, const regista_track& track) {
  std::ranges::copy(track.covariance, robot.covariance);
  robot.covariance[5] = track.pose.heading_variance;
}

}  // namespace

WorldModel::WorldModel(const TeamPlan& plan, int own_number, LocalModel local, TeamModel team, FrameParts made)
    : plan_(&plan),
      made_(made),
      own_number_(own_number),
      local_(std::move(local)),
      team_(std::move(team)),
      mine_(plan.rules().team_size),
      common_(plan.rules().team_size),
      negative_(plan.rules().team_size),
      fusion_(merge_distance, static_cast<std::size_t>(plan.rules().team_size)) {
  estimates_.reserve(256);
  seen_teammates_.reserve(static_cast<std::size_t>(plan.rules().team_size));
}

void WorldModel::sense(const Percepts& percepts, double dt, const regista_frame* last) {
  // A teammate's packet may have said that the ball is free: then it no longer lies where the rules put it.
  const regista_game now = game(percepts);
  local_.update(percepts, dt, last, now.phase == REGISTA_PHASE_SET && now.set_play == REGISTA_SET_PLAY_KICK_OFF);
  if (dt > 0.0) team_.predict(dt, last);
}

regista_game WorldModel::game(const Percepts& percepts) const {
  const GameTold& told = percepts.game;
  regista_game game{};
  game.phase = abi(told.phase);
  game.set_play = abi(told.set_play);
  game.own_kick = told.own_kick ? 1 : 0;
  game.half = told.half;
  game.own_score = told.own_score;
  game.opponent_score = told.opponent_score;
  game.phase_time = told.phase_time;
  game.time_left = told.half_time_left;
  // Whoever heard the whistle says so in its packet; the others need not wait for the game controller.
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

// Balls that the own eyes refute are left out of `mine`, unless that leaves nothing: then the old news stay for the
// team's sake, which would otherwise not even agree on what is lost.
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

void WorldModel::fuse_opponents() {
  constexpr int own_eyes = 0;
  estimates_.clear();
  for (const regista_track& opponent : local_.opponents()) estimates_.push_back({&opponent, own_eyes});
  team_.opponents(estimates_);
  fusion_.fuse(estimates_, mine_.opponents, own_number_);
  if (made_.common_opponents()) fusion_.fuse(estimates_, common_.opponents, own_eyes);
}

// The same for both worlds; `mine` gets its own row afterwards.
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
    robot.pose[0] = track->x;
    robot.pose[1] = track->y;
    robot.pose[2] = track->pose.heading;
    robot.velocity[0] = track->vx;
    robot.velocity[1] = track->vy;
    robot.velocity[2] = track->pose.turn_rate;
    set_covariance(robot, *track);
    robot.target[0] = report->target.x();
    robot.target[1] = report->target.y();
    robot.role = report->role;
    robot.role_since = report->role_since;
  }
  mine_.robots = common_.robots;
  common_.robot(own_number_).flags |= REGISTA_ROBOT_SELF;
}

// Teammates that the own eyes see are nearer to there than to where their last packet has them by now. Eyes know no
// numbers: the nearest pair first, and each once.
void WorldModel::sharpen_teammates() {
  seen_teammates_.clear();
  match_teammates(local_.teammates(), mine_.robots, own_number_, seen_teammates_);
  for (const SeenTeammate& each : seen_teammates_) sharpen(mine_.robot(each.number), *each.track);
}

void WorldModel::fill_self(const Percepts& percepts, const OwnRole& own) {
  regista_robot& self = mine_.robot(own_number_);
  const regista_track& track = local_.self();
  self.flags = REGISTA_ROBOT_SELF | REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET |
               (percepts.penalised ? REGISTA_ROBOT_PENALISED : REGISTA_ROBOT_ACTIVE) |
               (percepts.fallen ? REGISTA_ROBOT_FALLEN : 0);
  self.age = 0.0;
  self.time_until_up = percepts.time_until_up;
  self.pose[0] = track.x;
  self.pose[1] = track.y;
  self.pose[2] = track.pose.heading;
  self.velocity[0] = track.vx;
  self.velocity[1] = track.vy;
  self.velocity[2] = track.pose.turn_rate;
  set_covariance(self, track);
  self.target[0] = own.target.x();
  self.target[1] = own.target.y();
  self.role = own.role;
  self.role_since = own.since;
}

}  // namespace regista::mind
