// SPDX-License-Identifier: MIT
#include "mind/coordination/events.hpp"

#include <cmath>

namespace regista::mind {
namespace {

// Differences below these are noise of sensing, not news.
constexpr double ball_moved_at_least = 0.3, pose_moved_at_least = 0.2;  // m
// A team without the ball for less than this has not lost it.
constexpr double ball_missed_at_least = 1.0;  // s
constexpr int goalkeeper = 1;                 // the rules number it so

}  // namespace

void EventDetector::detect(const Percepts& percepts, const WorldModel& world, const Decision& decision, bool searching,
                           std::vector<regista_event>& out) {
  out.clear();
  const auto add = [&out](int kind, double value) { out.push_back({kind, 0, value}); };
  const DistributedWorldModel& mine = world.mine();
  const DistributedWorldModel& common = world.common();
  const double now = percepts.time;

  if (common.ball_known()) team_ball_seen_at_ = now - common.ball_state.age;
  if (percepts.whistle) add(REGISTA_EVENT_WHISTLE, 0.0);
  if (world.local().sees_ball()) {
    const regista_track& ball = world.local().balls().front();
    const double unseen = now - ball_seen_at_;
    // By now the ball in sight may already have ended the search.
    if ((searching || searching_) && unseen > ball_missed_at_least) add(REGISTA_EVENT_BALL_FOUND, unseen);
    if (own_number_ == goalkeeper && unseen > ball_missed_at_least) add(REGISTA_EVENT_GOALKEEPER_SAW_BALL, unseen);
    const double lacked = now - team_ball_seen_at_;
    if (lacked > ball_missed_at_least) add(REGISTA_EVENT_BALL_KNOWN_AGAIN, lacked);
    if (common.ball_known()) {
      const double moved = (Vector2d(ball.x, ball.y) - common.ball()).norm();
      if (moved > ball_moved_at_least) add(REGISTA_EVENT_BALL_MOVED, moved);
    }
    ball_seen_at_ = now;
  }
  if (decision.own_role != role_ && !first_) add(REGISTA_EVENT_ROLE_CHANGED, decision.own_role);
  if (decision.context != context_ && !first_) add(REGISTA_EVENT_CONTEXT_CHANGED, decision.context);
  const regista_robot& told = common.robot(own_number_);
  if ((told.flags & REGISTA_ROBOT_KNOWN) != 0) {
    const regista_robot& self = mine.robot(own_number_);
    const double moved = std::hypot(self.pose[0] - told.pose[0], self.pose[1] - told.pose[1]);
    if (moved > pose_moved_at_least) add(REGISTA_EVENT_POSE_MOVED, moved);
  }
  if (percepts.fallen && !fallen_) add(REGISTA_EVENT_FELL, 0.0);
  if (!percepts.fallen && fallen_) add(REGISTA_EVENT_GOT_UP, 0.0);
  if (penalised_ && !percepts.penalised) add(REGISTA_EVENT_RETURNED, 0.0);
  if (mine.game.phase != phase_) add(REGISTA_EVENT_PHASE_CHANGED, mine.game.phase);

  role_ = decision.own_role;
  context_ = decision.context;
  phase_ = mine.game.phase;
  fallen_ = percepts.fallen;
  penalised_ = percepts.penalised;
  searching_ = searching;
  first_ = false;
}

}  // namespace regista::mind
