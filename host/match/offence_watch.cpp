// SPDX-License-Identifier: MIT
#include "match/offence_watch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "match/areas.hpp"

namespace regista::match {
namespace {

// A contact that was there so recently still is: solvers let bodies part for a step.
constexpr double contact_lasts = 0.2;  // s
constexpr double still = 1e-3;         // m/s
constexpr double dribbled = 0.25;      // m: who moves the ball so far does not hold it

bool longer(double seconds, double limit) { return seconds > limit - 1e-6; }

Vector at(const Scene& scene, int id) { return scene.robots[static_cast<std::size_t>(id)]; }

Vector steps_of(const Scene& scene, int id) {
  return scene.steps.empty() ? Vector{} : scene.steps[static_cast<std::size_t>(id)];
}

}  // namespace

OffenceWatch::OffenceWatch(const config::Rules& rules, Roster roster)
    : rules_(rules), roster_(roster), watched_(static_cast<std::size_t>(roster.count())) {
  calls_.reserve(watched_.size());
}

void OffenceWatch::forget(int id) { of(id) = {}; }

void OffenceWatch::call(int id, Offence offence, int victim) {
  const bool called = std::ranges::find(calls_, id, &Offender::robot) != calls_.end();
  if (!called) calls_.push_back({id, offence, victim});
}

std::span<const Offender> OffenceWatch::watch(const Scene& scene, const GameState& state, RobotSet playing) {
  calls_.clear();
  const double passed = std::max(0.0, scene.time - time_);
  time_ = scene.time;
  if (state.phase == mind::Phase::playing) {
    watch_pushing(scene, state, playing, passed);
    watch_goal_areas(scene, state, playing);
  }
  watch_bodies(scene, state, playing, passed);
  return calls_;
}

bool OffenceWatch::guards_its_goal(const Scene& scene, const GameState& state, int id) const {
  return roster_.number(id) == 1 && in_penalty_area(rules_.field, -attack(roster_.side(id), state.half), at(scene, id));
}

void OffenceWatch::watch_bodies(const Scene& scene, const GameState& state, RobotSet playing, double passed) {
  const config::Offences& limits = rules_.offences;
  const bool play = state.phase == mind::Phase::playing;
  const bool must_stand = state.phase == mind::Phase::set && longer(time_ - state.phase_began, limits.notice_set);
  for (RobotSet rest = playing; rest != 0; rest &= rest - 1) {
    const int id = std::countr_zero(rest);
    Watched& robot = of(id);
    const bool lies = contains(scene.fallen, id);
    robot.lies = lies ? robot.lies + passed : 0.0;
    robot.idle = contains(scene.acted, id) ? 0.0 : robot.idle + passed;
    if (lies && longer(robot.lies, limits.fallen)) call(id, Offence::fallen);
    if (longer(robot.idle, limits.inactive)) call(id, Offence::inactive);
    const bool walks = squared_length(steps_of(scene, id)) > still * still;
    if (must_stand && !lies && (walks || contains(scene.turning, id))) call(id, Offence::motion_in_set);

    if (contains(scene.at_walls, id)) robot.was_at_wall = time_;
    const bool walks_on = time_ - robot.was_at_wall <= contact_lasts && robot.was_at_wall >= 0.0 && walks;
    robot.at_wall = walks_on ? robot.at_wall + passed : 0.0;
    if (longer(robot.at_wall, limits.walk_into_goal) && walks_on) call(id, Offence::leaving_the_field);

    if (contains(scene.touching, id)) robot.touched = time_;
    const bool holds = play && state.in_play() && !lies && !contains(scene.kicking, id) && robot.touched >= 0.0 &&
                       time_ - robot.touched <= contact_lasts;
    if (squared_length(scene.ball - robot.held_at) > dribbled * dribbled) {
      robot.held_at = scene.ball;
      robot.holds = 0.0;
    }
    robot.holds = holds ? robot.holds + passed : std::max(0.0, robot.holds - passed);
    const double limit = guards_its_goal(scene, state, id) ? limits.goalkeeper_holds_ball : limits.hold_ball;
    if (holds && longer(robot.holds, limit)) call(id, Offence::ball_holding);
  }
}

// Its legs carry it that way, and not past it.
bool OffenceWatch::presses(const Scene& scene, int id, Vector towards) const {
  const Vector legs = steps_of(scene, id);
  const double against = dot(legs, towards);
  return against > rules_.offences.pushing_speed && against > 0.5 * length(legs);
}

void OffenceWatch::watch_pushing(const Scene& scene, const GameState& state, RobotSet playing, double passed) {
  for (const auto& contact : scene.contacts) {
    const std::array<int, 2> ids{contact[0], contact[1]};
    if (roster_.side(ids[0]) == roster_.side(ids[1])) continue;
    if (!contains(playing, ids[0]) || !contains(playing, ids[1])) continue;
    const Vector apart = at(scene, ids[1]) - at(scene, ids[0]);
    const double distance = length(apart);
    if (distance < 1e-6) continue;
    const Vector towards = (1.0 / distance) * apart;
    const std::array<bool, 2> press{presses(scene, ids[0], towards), presses(scene, ids[1], -1.0 * towards)};
    if (press[0] == press[1]) continue;
    const int pusher = press[0] ? ids[0] : ids[1], victim = press[0] ? ids[1] : ids[0];
    if (contains(scene.fallen | scene.kicking, pusher) || guards_its_goal(scene, state, pusher)) continue;
    // Who is pushed itself cannot be called.
    if (of(pusher).was_pushed >= 0.0 && time_ - of(pusher).was_pushed <= contact_lasts) continue;
    Watched& robot = of(pusher);
    const bool goes_on = robot.victim == victim && time_ - robot.pushed <= contact_lasts;
    robot.pushes = goes_on ? robot.pushes + (time_ - robot.pushed) : passed;
    robot.pushed = time_;
    robot.victim = victim;
    of(victim).was_pushed = time_;
    of(victim).pusher = pusher;
    if (longer(robot.pushes, rules_.offences.pushing_lasts)) call(pusher, Offence::pushing, victim);
  }
  // Or until the other falls.
  for (RobotSet rest = playing; rest != 0; rest &= rest - 1) {
    const int id = std::countr_zero(rest);
    Watched& robot = of(id);
    const bool lies = contains(scene.fallen, id);
    const bool just_fell = lies && !robot.lay;
    robot.lay = lies;
    if (!just_fell || robot.was_pushed < 0.0 || time_ - robot.was_pushed > contact_lasts) continue;
    if (contains(playing, robot.pusher)) call(robot.pusher, Offence::pushing, id);
  }
}

void OffenceWatch::watch_goal_areas(const Scene& scene, const GameState& state, RobotSet playing) {
  for (const Side side : both_sides) {
    const double end = -attack(side, state.half);
    int inside = 0;
    RobotSet entered = 0;
    for (int number = 1; number <= roster_.team_size; ++number) {
      const int id = roster_.id(side, number);
      Watched& robot = of(id);
      const bool was = robot.in_goal_area;
      robot.in_goal_area = contains(playing, id) && in_goal_area(rules_.field, end, at(scene, id));
      if (!robot.in_goal_area) {
        robot.pushed_in = -1.0;
      } else if (was && robot.pushed_in < 0.0) {
        ++inside;
      } else {
        entered |= only(id);
      }
    }
    for (RobotSet rest = entered; rest != 0; rest &= rest - 1) {
      const int id = std::countr_zero(rest);
      Watched& robot = of(id);
      if (inside < rules_.offences.most_in_own_goal_area) {
        ++inside;
        robot.pushed_in = -1.0;
        continue;
      }
      const bool pushed = robot.was_pushed >= 0.0 && time_ - robot.was_pushed <= contact_lasts;
      // Whom the push has felled has the time after getting up.
      if (robot.pushed_in < 0.0 ? pushed : contains(scene.fallen, id)) robot.pushed_in = time_;
      const bool has_time =
          robot.pushed_in >= 0.0 && !longer(time_ - robot.pushed_in, rules_.offences.leave_after_pushed_in);
      if (!has_time) call(id, Offence::illegal_position);
    }
  }
}

}  // namespace regista::match
