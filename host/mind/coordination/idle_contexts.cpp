// SPDX-License-Identifier: MIT
#include "mind/coordination/unused_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "mind/geometry.hpp"
#include "mind/world/mailboxes.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

void make_up(DistributedWorldModel& world, const TeamPlan& plan, int list, int scene, double time, int own,
             int out_of_play, Dice& dice) {
  const double x = plan.rules().field.length / 2.0, y = plan.rules().field.width / 2.0;
  const int team_size = plan.rules().team_size;
  const auto roles = static_cast<int>(plan.team().role_lists[static_cast<std::size_t>(list)].roles.size());
  for (int number = 1; number <= team_size; ++number) {
    regista_robot& robot = world.robot(number);
    robot.flags = REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET;
    robot.flags |= number == out_of_play ? REGISTA_ROBOT_PENALISED : REGISTA_ROBOT_ACTIVE;
    if (number == own) robot.flags |= REGISTA_ROBOT_SELF;
    robot.pose[0] = dice.real(-x, x);
    robot.pose[1] = dice.real(-y, y);
    robot.pose[2] = dice.real(-pi, pi);
    robot.velocity[0] = dice.real(-0.2, 0.2);
    robot.velocity[1] = dice.real(-0.2, 0.2);
    for (const std::size_t k : {0u, 2u, 5u}) robot.covariance[k] = 0.01;
    robot.target[0] = dice.real(-x, x);
    robot.target[1] = dice.real(-y, y);
    robot.age = number == own ? 0.0 : dice.real(0.0, 5.0);
    robot.role = plan.first_role(list) + (number + scene) % roles;
    robot.role_since = time - dice.real(0.0, 20.0);
  }
  for (int k = 0; k < team_size; ++k) {
    regista_opponent& opponent = world.opponents.emplace_back();
    opponent = {};
    opponent.label = k;
    opponent.position[0] = dice.real(-x, x);
    opponent.position[1] = dice.real(-y, y);
    opponent.covariance[0] = opponent.covariance[2] = 0.04;
    opponent.weight = 0.9;
  }
  regista_ball& ball = world.ball_state;
  ball.flags = REGISTA_BALL_KNOWN;
  ball.position[0] = dice.real(-x, x);
  ball.position[1] = dice.real(-y, y);
  ball.velocity[0] = dice.real(-1.0, 1.0);
  ball.velocity[1] = dice.real(-1.0, 1.0);
  for (const std::size_t k : {0u, 2u, 7u, 9u}) ball.covariance[k] = 0.01;
  world.game.phase = REGISTA_PHASE_PLAYING;
  world.game.half = 1;
  world.game.phase_time = time;
  world.game.time_left = plan.rules().durations.half - time;
}

namespace {

constexpr int games = 3000, moments = 4;  // number of games, and of moments in each game
constexpr double unknown_after = 30.0;    // s without news of the ball, after which the ball is unknown

// A made-up game. The conditions are called at 4 moments of the game.
class SyntheticGame {
 public:
  SyntheticGame(const TeamPlan& plan, int own, Dice& dice)
      : plan_(&plan), dice_(&dice), world_(plan.rules().team_size) {
    const config::Rules& rules = plan.rules();
    interval_ = dice.log_real(0.1, 20.0);
    half_ = 1 + dice.below(rules.durations.halves);
    clock_ = dice.chance(0.5) ? dice.real(0.0, rules.durations.half)
                              : rules.durations.half - dice.log_real(0.1, rules.durations.half);
    const int difference = dice.below(2 * rules.mercy_difference - 1) - (rules.mercy_difference - 1);
    const int least_score = dice.below(3);
    own_score_ = least_score + std::max(0, difference);
    opponent_score_ = least_score + std::max(0, -difference);
    stage();
    ball_known_ = dice.chance(0.85);
    ball_seen_ = dice.chance(0.5);
    ball_age_ = ball_seen_ ? 0.0 : dice.log_real(0.1, 2.0 * unknown_after);
    reach_ = dice.log_real(0.05, 3.0);
    opponents_ = dice.below(rules.team_size + 1);
    const int out_of_play = dice.chance(0.2) ? 1 + dice.below(rules.team_size) : 0;
    make_up(world_, plan, 0, 0, 0.0, own, out_of_play, dice);
    if (phase_ != REGISTA_PHASE_PLAYING && set_play_ == REGISTA_SET_PLAY_KICK_OFF) {
      world_.ball_state.position[0] = world_.ball_state.position[1] = 0.0;
    }
    still_ = phase_ != REGISTA_PHASE_PLAYING || dice.chance(0.3);
    gather();
    ball_ = world_.ball_state;
    free_at_ = dice.chance(0.3) ? 1 + dice.below(moments) : moments;
  }

  // Returns the match time at a moment. Match time includes every Initial, Ready and Set before a half.
  double time(int moment) const {
    const config::Durations& durations = plan_->rules().durations;
    const double standing = config::Durations::initial + durations.ready + durations.set;
    return half_ * standing + (half_ - 1) * durations.half + clock_ + moment * interval_;
  }

  // Returns the world at a moment, until the next call. Moments are asked for in their order.
  const DistributedWorldModel& moment(int number) {
    if (number == free_at_) {
      phase_ = REGISTA_PHASE_PLAYING;
      set_play_ = REGISTA_SET_PLAY_NONE;
      phase_began_ = time(number);
    }
    regista_ball& ball = world_.ball_state = ball_;
    if (!still_) {
      ball.position[0] += ball_.velocity[0] * number * interval_;
      ball.position[1] += ball_.velocity[1] * number * interval_;
    } else {
      for (double& each : ball.velocity) each = 0.0;
    }
    ball.age = ball_age_ + (ball_seen_ ? 0.0 : number * interval_);
    if (!ball_known_ || ball.age > unknown_after) ball = {};
    regista_game& game = world_.game;
    game.phase = phase_;
    game.set_play = set_play_;
    game.own_kick = own_kick_ ? 1 : 0;
    game.half = half_;
    game.own_score = own_score_;
    game.opponent_score = opponent_score_;
    game.phase_time = time(number) - phase_began_;
    game.time_left = std::max(0.0, plan_->rules().durations.half - clock_ - number * interval_);
    world_.close();
    return world_;
  }

 private:
  void stage() {
    Dice& dice = *dice_;
    own_kick_ = dice.chance(0.5);
    phase_began_ = time(0) - dice.log_real(0.01, 60.0);
    if (dice.chance(0.3)) {
      phase_ = dice.chance(0.5) ? REGISTA_PHASE_READY : REGISTA_PHASE_SET;
      set_play_ = dice.chance(0.7) ? REGISTA_SET_PLAY_KICK_OFF : REGISTA_SET_PLAY_PENALTY_KICK;
    } else {
      phase_ = REGISTA_PHASE_PLAYING;
      set_play_ = dice.chance(0.5) ? REGISTA_SET_PLAY_NONE : REGISTA_SET_PLAY_KICK_OFF + dice.below(6);
    }
  }

  // In half of the games, moves some robots to places around the ball. Draws the share of moved robots for each side.
  void gather() {
    Dice& dice = *dice_;
    const bool gathered = dice.chance(0.5);
    const double ours = gathered ? dice.real(0.0, 1.0) : 0.0, theirs = gathered ? dice.real(0.0, 1.0) : 0.0;
    const auto place = [&](double share, double* position) {
      if (!dice.chance(share)) return;
      const double angle = dice.real(-pi, pi), distance = dice.real(0.0, reach_);
      position[0] = world_.ball_state.position[0] + distance * std::cos(angle);
      position[1] = world_.ball_state.position[1] + distance * std::sin(angle);
    };
    for (regista_robot& robot : world_.robots) place(ours, robot.pose);
    world_.opponents.resize(static_cast<std::size_t>(opponents_));
    for (regista_opponent& opponent : world_.opponents) {
      place(theirs, opponent.position);
      opponent.weight = dice.chance(0.5) ? 1.0 : dice.real(0.3, 1.0);
    }
  }

  const TeamPlan* plan_;
  Dice* dice_;
  double interval_ = 0.1, clock_ = 0.0, phase_began_ = 0.0;
  int half_ = 1, own_score_ = 0, opponent_score_ = 0;
  int phase_ = REGISTA_PHASE_PLAYING, set_play_ = REGISTA_SET_PLAY_NONE;
  bool own_kick_ = false, ball_known_ = true, ball_seen_ = true, still_ = false;
  double ball_age_ = 0.0, reach_ = 1.0;
  int opponents_ = 0, free_at_ = moments;
  DistributedWorldModel world_;
  regista_ball ball_{};  // at the first moment
};

class Conditions {
 public:
  Conditions(const TeamPlan& plan, const plugin::Caller& caller)
      : number_(caller.robot),
        previous_(static_cast<std::size_t>(plan.rules().team_size), REGISTA_NO_TASK),
        extensions_(caller),
        mailboxes_(static_cast<std::size_t>(plan.rules().messages.size)) {
    for (const ContextPlan& each : plan.contexts()) {
      const plugin::Found& found = *each.condition.found;
      const regista_host* const host = mailboxes_.open(&extensions_.open(found, plan.metrics_of(found)));
      instances_.push_back(std::make_shared<plugin::Instance>(found, each.condition.parameters,
                                                              plan.environment(caller.robot), host, &caller));
      mailboxes_.connect(instances_.back());
      conditions_.emplace_back(instances_.back());
    }
  }
  void reset() {
    for (std::size_t i = 0; i < instances_.size(); ++i) instances_[i]->reset(made_up_seed + i);
  }
  // Asks which conditions hold. context: index of the context in force before; -1: none.
  void ask(const DistributedWorldModel& world, double time, int tick, int context, std::vector<char>& out) {
    regista_frame frame{};
    frame.size = sizeof frame;
    frame.own_number = number_;
    frame.tick = static_cast<std::uint64_t>(tick);
    frame.time = time;
    frame.mine = frame.common = &world.raw;
    frame.knowledge = REGISTA_MINE;
    frame.previous = abi_span(previous_);
    frame.context = context;
    out.clear();
    for (plugin::Context& each : conditions_) out.push_back(each.holds(frame) ? 1 : 0);
  }

 private:
  int number_;
  std::vector<std::int32_t> previous_;  // the robots had no tasks before
  Extensions extensions_;
  Mailboxes mailboxes_;
  std::vector<std::shared_ptr<plugin::Instance>> instances_;
  std::vector<plugin::Context> conditions_;
};

constexpr std::array phases{REGISTA_PHASE_READY, REGISTA_PHASE_SET, REGISTA_PHASE_PLAYING};

// Whether a team may want a context for a set play in this phase. Only a kick-off and a penalty kick have a Ready and a
// Set. From the whistle on, a kick-off is open play for most teams, so a missing context is no mistake.
bool occurs(int set_play, int phase) {
  const bool playing = phase == REGISTA_PHASE_PLAYING;
  return set_play == REGISTA_SET_PLAY_KICK_OFF ? !playing : playing || set_play == REGISTA_SET_PLAY_PENALTY_KICK;
}

// Compares the context in force in set plays with the one in open play, in scenes that are equal otherwise.
SetPlayContexts contexts_of_set_plays(const TeamPlan& plan, Conditions& robot, int own, Dice& dice) {
  constexpr int scenes = 16;
  SetPlayContexts out{};
  std::vector<char> holds;
  for (int scene = 0; scene < scenes; ++scene) {
    DistributedWorldModel world(plan.rules().team_size);
    make_up(world, plan, 0, scene, dice.real(0.0, plan.rules().durations.half), own, 0, dice);
    world.close();
    regista_game& game = world.game;
    const auto in_force = [&](int set_play, int phase, bool own_kick) {
      game.set_play = set_play;
      game.phase = phase;
      game.own_kick = own_kick ? 1 : 0;
      game.phase_time = 1.0;
      robot.reset();
      robot.ask(world, 100.0 + scene, 0, -1, holds);
      return std::ranges::find(holds, 1) - holds.begin();
    };
    for (const bool own_kick : {false, true}) {
      const auto open_play = in_force(REGISTA_SET_PLAY_NONE, REGISTA_PHASE_PLAYING, own_kick);
      for (int kind = 0; kind < REGISTA_SET_PLAY_PENALTY_KICK; ++kind) {
        for (std::size_t p = 0; p < phases.size(); ++p) {
          bool& has_own = out[own_kick ? 1 : 0][static_cast<std::size_t>(kind)][p];
          if (occurs(kind + 1, phases[p]) && !has_own) has_own = in_force(kind + 1, phases[p], own_kick) != open_play;
        }
      }
    }
  }
  return out;
}

}  // namespace

ContextFindings idle_contexts(const TeamPlan& plan, plugin::CallTracing tracing) {
  const int team_size = plan.rules().team_size;
  const std::size_t count = plan.contexts().size();
  plugin::AnswerBuffers rooms;
  std::vector<std::unique_ptr<plugin::Caller>> callers;
  std::vector<std::unique_ptr<Conditions>> robots;
  for (int number = 1; number <= team_size; ++number) {
    callers.push_back(std::make_unique<plugin::Caller>(plugin::Caller{plan.team().name, number, 0, tracing, &rooms}));
    robots.push_back(std::make_unique<Conditions>(plan, *callers.back()));
  }
  Dice dice(made_up_seed);
  ContextFindings out;
  out.contexts.resize(count);
  std::vector<std::vector<char>> covers(count, std::vector<char>(count, 1));  // [j][i]: i held whenever j held
  std::vector<char> holds;
  for (int c = 0; c < games; ++c) {
    const int own = 1 + c % team_size;
    Conditions& robot = *robots[static_cast<std::size_t>(own - 1)];
    robot.reset();
    SyntheticGame game(plan, own, dice);
    int in_force = -1;
    for (int moment = 0; moment < moments; ++moment) {
      robot.ask(game.moment(moment), game.time(moment), moment, in_force, holds);
      ++out.scenes;
      const auto first = std::ranges::find(holds, 1);
      in_force = first == holds.end() ? -1 : static_cast<int>(first - holds.begin());
      if (in_force < 0) ++out.without;
      for (std::size_t j = 0; j < count; ++j) {
        if (holds[j] == 0) continue;
        ++out.contexts[j].held;
        for (std::size_t i = 0; i < j; ++i) covers[j][i] = covers[j][i] != 0 && holds[i] != 0 ? 1 : 0;
      }
      if (in_force >= 0) ++out.contexts[static_cast<std::size_t>(in_force)].in_force;
    }
  }
  out.set_plays = contexts_of_set_plays(plan, *robots.front(), 1, dice);
  for (std::size_t j = 0; j < count; ++j) {
    const auto end = covers[j].begin() + static_cast<std::ptrdiff_t>(j);
    const auto cover = std::find(covers[j].begin(), end, 1);
    if (out.contexts[j].held > 0 && cover != end) {
      out.contexts[j].covered_by = static_cast<int>(cover - covers[j].begin());
    }
  }
  return out;
}

std::vector<config::Warning> idle_context_warnings(const TeamPlan& plan, const ContextFindings& found) {
  std::vector<config::Warning> out;
  const std::vector<config::Context>& contexts = plan.team().contexts;
  bool always = false, any_talks = false;
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    const config::Context& context = contexts[i];
    const ContextFinding& its = found.contexts[i];
    const bool silent = !talks(plan.contexts()[i].condition);
    any_talks = any_talks || !silent;
    const std::string& condition = context.use.plugin;
    if (silent && its.held == 0) {
      out.push_back({context.where, fmt::format("contexts.{}: {} held in none of {} made-up scenes (score, set play, "
                                                "ball, robots): with these parameters it may never hold",
                                                context.name, condition, found.scenes)});
    } else if (silent && its.in_force == 0 && !always) {
      std::string what = "one of those above it, which come";
      if (its.covered_by >= 0) {
        const config::Context& above = contexts[static_cast<std::size_t>(its.covered_by)];
        what = fmt::format("{} ({}), which comes", above.name, to_string(above.where));
      }
      out.push_back({context.where, fmt::format("contexts.{}: in each of the {} made-up scenes in which {} held, {} "
                                                "first, held too: it may never be in force",
                                                context.name, its.held, condition, what)});
    }
    always = always || config::always_holds(context);
  }
  if (found.without > 0 && !any_talks && !contexts.empty()) {
    out.push_back({contexts.back().where, fmt::format("contexts: none holds in {} of {} made-up scenes, and then no "
                                                      "robot has a role: plugin: always, below {}, holds at all times",
                                                      found.without, found.scenes, contexts.back().name)});
  }
  constexpr std::array<const char*, REGISTA_SET_PLAY_PENALTY_KICK> set_plays{
      "kick-off", "kick-in", "goal kick", "corner kick", "pushing free kick", "penalty kick"};
  constexpr std::array<const char*, phases.size()> phase_names{"Ready", "Set", "Playing"};
  for (std::size_t kind = 0; kind < set_plays.size(); ++kind) {
    std::array<std::vector<const char*>, 2> missing;
    for (const std::size_t own : {0u, 1u}) {
      for (std::size_t p = 0; p < phases.size(); ++p) {
        const bool any = std::ranges::any_of(found.set_plays, [p](const auto& side) {
          return std::ranges::any_of(side, [p](const auto& its) { return its[p]; });
        });
        if (any && occurs(static_cast<int>(kind) + 1, phases[p]) && !found.set_plays[own][kind][p])
          missing[own].push_back(phase_names[p]);
      }
    }
    const auto warn = [&](const char* whose, const std::vector<const char*>& in) {
      if (in.empty()) return;
      out.push_back(
          {contexts.front().where,
           fmt::format("contexts: none is for a {}{} in {}, though one is for another set play: robots act as "
                       "in open play",
                       set_plays[kind], whose, fmt::join(in, " and "))});
    };
    if (missing[0] == missing[1]) {
      warn("", missing[0]);
    } else {
      warn(" of this team", missing[1]);
      warn(" of the opponent", missing[0]);
    }
  }
  return out;
}

}  // namespace regista::mind
