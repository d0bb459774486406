// SPDX-License-Identifier: MIT
#include "match/offence_watch.hpp"

#include <algorithm>

#include "match/placement.hpp"

namespace regista::match {
namespace {

constexpr double still = 1e-3;     // m/s; a robot that is slower does not walk
constexpr double dribbled = 0.25;  // m; a robot that moves the ball farther does not hold the ball

bool longer(double seconds, double limit) { return seconds > limit - 1e-6; }

Vector place_of(const Scene& scene, int id) { return scene.robots[at(id)]; }

Vector steps_of(const Scene& scene, int id) { return scene.steps.empty() ? Vector{} : scene.steps[at(id)]; }

}  // namespace

OffenceWatch::OffenceWatch(const config::Rules& rules, Roster roster)
    : rules_(rules), roster_(roster), watched_(at(roster.count())) {
  calls_.reserve(watched_.size());
}

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
  return roster_.number(id) == 1 &&
         in_penalty_area(rules_.field, -attack(roster_.side(id), state.half), place_of(scene, id));
}

void OffenceWatch::watch_bodies(const Scene& scene, const GameState& state, RobotSet playing, double passed) {
  const config::Offences& limits = rules_.offences;
  const bool play = state.phase == mind::Phase::playing;
  const bool must_stand = state.phase == mind::Phase::set && longer(time_ - state.phase_began, limits.notice_set);
  for (const int id : Members(playing)) {
    Watched& robot = of(id);
    const bool lies = contains(scene.fallen, id);
    robot.lies = lies ? robot.lies + passed : 0.0;
    robot.idle = contains(scene.acted, id) ? 0.0 : robot.idle + passed;
    if (lies && longer(robot.lies, limits.fallen)) call(id, Offence::fallen);
    if (longer(robot.idle, limits.inactive)) call(id, Offence::inactive);
    const bool walks = squared_length(steps_of(scene, id)) > still * still;
    if (must_stand && !lies && (walks || contains(scene.turning, id))) call(id, Offence::motion_in_set);

    if (contains(scene.at_walls, id)) robot.was_at_wall = time_;
    const bool walks_on = recently(robot.was_at_wall) && walks;
    robot.at_wall = walks_on ? robot.at_wall + passed : 0.0;
    if (longer(robot.at_wall, limits.walk_into_goal) && walks_on) call(id, Offence::leaving_the_field);

    if (contains(scene.touching, id)) robot.touched = time_;
    const bool holds = play && state.in_play() && !lies && !contains(scene.kicking, id) && recently(robot.touched);
    if (squared_length(scene.ball - robot.held_at) > dribbled * dribbled) {
      robot.held_at = scene.ball;
      robot.holds = 0.0;
    }
    robot.holds = holds ? robot.holds + passed : std::max(0.0, robot.holds - passed);
    const double limit = guards_its_goal(scene, state, id) ? limits.goalkeeper_holds_ball : limits.hold_ball;
    if (holds && longer(robot.holds, limit)) call(id, Offence::ball_holding);
  }
}

// Returns whether the robot walks towards another robot and not past it. towards: unit vector to the other robot.
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
    const Vector apart = place_of(scene, ids[1]) - place_of(scene, ids[0]);
    const double distance = length(apart);
    if (distance < 1e-6) continue;
    const Vector towards = (1.0 / distance) * apart;
    const std::array<bool, 2> press{presses(scene, ids[0], towards), presses(scene, ids[1], -1.0 * towards)};
    if (press[0] == press[1]) continue;
    const int pusher = press[0] ? ids[0] : ids[1], victim = press[0] ? ids[1] : ids[0];
    if (contains(scene.fallen | scene.kicking, pusher) || guards_its_goal(scene, state, pusher)) continue;
    // A robot that another robot pushes gets no penalty for pushing.
    if (recently(of(pusher).was_pushed)) continue;
    Watched& robot = of(pusher);
    const bool goes_on = robot.victim == victim && recently(robot.pushed);
    robot.pushes = goes_on ? robot.pushes + (time_ - robot.pushed) : passed;
    robot.pushed = time_;
    robot.victim = victim;
    of(victim).was_pushed = time_;
    of(victim).pusher = pusher;
    if (longer(robot.pushes, rules_.offences.pushing_lasts)) call(pusher, Offence::pushing, victim);
  }
  // The pusher also gets a penalty when the pushed robot falls.
  for (const int id : Members(playing)) {
    Watched& robot = of(id);
    const bool lies = contains(scene.fallen, id);
    const bool just_fell = lies && !robot.lay;
    robot.lay = lies;
    if (just_fell && recently(robot.was_pushed) && contains(playing, robot.pusher)) {
      call(robot.pusher, Offence::pushing, id);
    }
  }
}

void OffenceWatch::watch_goal_areas(const Scene& scene, const GameState& state, RobotSet playing) {
  for (const Side side : both_sides) {
    const double end = -attack(side, state.half);
    int inside = 0;
    RobotSet entered = 0;
    for (const int id : Members(roster_.team(side))) {
      Watched& robot = of(id);
      const bool was = robot.in_goal_area;
      robot.in_goal_area = contains(playing, id) && in_goal_area(rules_.field, end, place_of(scene, id));
      if (!robot.in_goal_area) {
        robot.pushed_in = -1.0;
      } else if (was && robot.pushed_in < 0.0) {
        ++inside;
      } else {
        entered |= only(id);
      }
    }
    for (const int id : Members(entered)) {
      Watched& robot = of(id);
      if (inside < rules_.offences.most_in_own_goal_area) {
        ++inside;
        robot.pushed_in = -1.0;
        continue;
      }
      // The time to leave the area starts at the push. While the pushed robot lies, this time starts again.
      if (robot.pushed_in < 0.0 ? recently(robot.was_pushed) : contains(scene.fallen, id)) robot.pushed_in = time_;
      const bool has_time =
          robot.pushed_in >= 0.0 && !longer(time_ - robot.pushed_in, rules_.offences.leave_after_pushed_in);
      if (!has_time) call(id, Offence::illegal_position);
    }
  }
}

bool counts(Offence offence) {
  return offence == Offence::illegal_position || offence == Offence::ball_holding || offence == Offence::pushing ||
         offence == Offence::leaving_the_field;
}

bool on_the_spot(Offence offence) { return offence == Offence::motion_in_set; }

PenaltyBox::PenaltyBox(const config::Penalties& penalties, Roster roster)
    : penalties_(penalties), roster_(roster), remaining_(at(roster.count())), why_(at(roster.count()), Offence::none) {}

void PenaltyBox::send(int id, Offence offence) {
  double lasts = penalties_.removal;
  if (offence == Offence::illegal_position_in_set) lasts = penalties_.illegal_position_in_set;
  if (offence == Offence::motion_in_set) lasts = penalties_.motion_in_set;
  if (counts(offence)) lasts += penalties_.removal_growth * counted_[index(roster_.side(id))]++;
  inside_ |= only(id);
  remaining_[at(id)] = lasts;
  why_[at(id)] = offence;
}

void PenaltyBox::pass(double seconds) {
  for (const int id : Members(inside_)) remaining_[at(id)] -= seconds;
}

}  // namespace regista::match
