// SPDX-License-Identifier: MIT
// Glue of all behaviours: reads the situation from the host's frame and body. Beliefs are those of `mine`.
#pragma once

#include <vector>

#include <regista/behaviour.hpp>

#include "situation.hpp"

namespace behaviours {

static_assert(static_cast<int>(Phase::initial) == REGISTA_PHASE_INITIAL &&
              static_cast<int>(Phase::ready) == REGISTA_PHASE_READY &&
              static_cast<int>(Phase::set) == REGISTA_PHASE_SET &&
              static_cast<int>(Phase::playing) == REGISTA_PHASE_PLAYING &&
              static_cast<int>(Phase::finished) == REGISTA_PHASE_FINISHED);
static_assert(static_cast<int>(SetPlay::none) == REGISTA_SET_PLAY_NONE &&
              static_cast<int>(SetPlay::kick_off) == REGISTA_SET_PLAY_KICK_OFF &&
              static_cast<int>(SetPlay::kick_in) == REGISTA_SET_PLAY_KICK_IN &&
              static_cast<int>(SetPlay::goal_kick) == REGISTA_SET_PLAY_GOAL_KICK &&
              static_cast<int>(SetPlay::corner_kick) == REGISTA_SET_PLAY_CORNER_KICK &&
              static_cast<int>(SetPlay::pushing_free_kick) == REGISTA_SET_PLAY_PUSHING_FREE_KICK &&
              static_cast<int>(SetPlay::penalty_kick) == REGISTA_SET_PLAY_PENALTY_KICK);

class SituationReader {
 public:
  static constexpr std::size_t most_nodes = 256, most_edges = 768,
                               most_tasks = 64;  // more than there are; only memory depends on it

  explicit SituationReader(Duty duty) { situation_.duty = duty; }

  void setup(const regista::Environment& environment) {
    Facts& facts = situation_.facts;
    facts.field = {.length = environment->field_length,
                   .width = environment->field_width,
                   .goal_width = environment->goal_width,
                   .goal_area_length = environment->goal_area_length,
                   .goal_area_width = environment->goal_area_width,
                   .penalty_area_length = environment->penalty_area_length,
                   .penalty_mark_distance = environment->penalty_mark_distance,
                   .centre_circle_radius = environment->centre_circle_radius};
    facts.ball_radius = environment->ball_radius;
    facts.ball_deceleration = environment->ball_deceleration;
    facts.set_play_distance = environment->set_play_distance;
    facts.robot_radius = environment->robot_radius;
    facts.reach = environment->kick_reach;
    facts.walk_forward = environment->walk_forward;
    facts.head_yaw = environment->head_yaw;
    facts.can_kick = !environment.kicks().empty();
    facts.own_number = environment->own_number;
    nodes_.reserve(most_nodes);
    targets_.reserve(most_tasks);
    edges_.reserve(most_edges);
  }

  const Facts& facts() const { return situation_.facts; }

  // ball_trusted_for: s; nobody acts on older news of the ball. Valid until the next call.
  const Situation& read(const regista::Frame& frame, const regista::Body& body, double ball_trusted_for) {
    Situation& s = situation_;
    const regista::World world = frame.mine();
    s.phase = known(world.game().phase, REGISTA_PHASE_FINISHED) ? static_cast<Phase>(world.game().phase) : Phase{};
    s.set_play = known(world.game().set_play, REGISTA_SET_PLAY_PENALTY_KICK)
                     ? static_cast<SetPlay>(world.game().set_play)
                     : SetPlay::none;
    s.own_kick = world.game().own_kick != 0;
    s.time = frame.time();
    s.pose = {body->pose[0], body->pose[1], body->pose[2]};
    s.frame = Frame2(s.pose);
    s.incapable = body.is(REGISTA_BODY_FALLEN | REGISTA_BODY_PENALISED | REGISTA_BODY_KICKING);
    const regista::Task* task = body.task(frame);
    s.has_task = task != nullptr;
    s.target = s.has_task ? Pose{task->after[0], task->after[1], task->after[2]} : s.pose;
    s.along_edges = s.has_task && (task->flags & REGISTA_TASK_ALONG_EDGES) != 0;
    const regista::Ball& ball = world.ball();
    s.sees_ball = body.is(REGISTA_BODY_SEES_BALL);
    s.ball_trusted = world.ball_known() && ball.age < ball_trusted_for && !body.is(REGISTA_BODY_BALL_REFUTED);
    s.ball = {ball.position[0], ball.position[1]};
    s.ball_velocity = {ball.velocity[0], ball.velocity[1]};
    return s;
  }

  // Of what was read last: for those who keep apart from each other. Valid until the next call.
  void read_targets(const regista::Frame& frame, const regista::Body& body) {
    targets_.clear();
    for (std::int32_t i = 0; i < body->task; ++i) {
      const regista::Task& task = frame.tasks()[static_cast<std::size_t>(i)];
      targets_.emplace_back(task.after[0], task.after[1]);
    }
    situation_.more_important = targets_;
  }

  // The targets of the tasks that these teammates have by the last assignment: for those who divide the field. Valid
  // until the next call of this or of read_targets().
  std::span<const Vector2d> read_targets_of(const regista::Frame& frame, std::span<const Teammate> teammates) {
    targets_.clear();
    for (const Teammate& mate : teammates) {
      const int held = frame.previous_task(mate.number);
      for (const regista::Task& task : frame.tasks()) {
        if (task.id == held) targets_.emplace_back(task.after[0], task.after[1]);
      }
    }
    return targets_;
  }

  // Of what was read last: for walks along the edges.
  void read_graph(const regista::Frame& frame) {
    nodes_.clear();
    edges_.clear();
    if (situation_.along_edges) {
      for (const regista::Waypoint& point : frame.waypoints()) nodes_.emplace_back(point.x, point.y);
      for (const regista::Edge& edge : frame.edges()) edges_.push_back({edge.from, edge.to});
    }
    situation_.graph = {nodes_, edges_};
  }

 private:
  // Leagues to come may have more.
  static bool known(int enumerator, int last) { return enumerator >= 0 && enumerator <= last; }

  Situation situation_;
  std::vector<Vector2d> nodes_, targets_;
  std::vector<Edge> edges_;
};

// The teammates that play and stand. Replaces what `out` holds.
inline void read_teammates(const regista::Frame& frame, const Situation& situation, std::vector<Teammate>& out) {
  out.clear();
  for (const regista::Robot& robot : frame.mine().robots()) {
    const bool able = (robot.flags & REGISTA_ROBOT_ACTIVE) != 0 && (robot.flags & REGISTA_ROBOT_FALLEN) == 0 &&
                      robot.number != situation.facts.own_number;
    if (able) out.push_back({{robot.pose[0], robot.pose[1]}, robot.age, robot.number});
  }
}

// The opponents that it believes in. Replaces what `out` holds.
inline void read_opponents(const regista::Frame& frame, std::vector<Blocker>& out) {
  out.clear();
  for (const regista::Opponent& opponent : frame.mine().opponents()) {
    out.push_back({{opponent.position[0], opponent.position[1]}, opponent.weight});
  }
}

}  // namespace behaviours
