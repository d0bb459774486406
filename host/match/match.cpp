// SPDX-License-Identifier: MIT
#include "match/match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "match/body.hpp"
#include "match/chance.hpp"
#include "match/disturbances.hpp"
#include "match/metrics.hpp"
#include "match/placement.hpp"
#include "match/radio.hpp"
#include "match/referee.hpp"
#include "match/sensing.hpp"

namespace regista::match {
namespace {

constexpr double sighting_error = 1.0;  // m; a sighting farther away from the true ball is a false sighting

std::uint32_t steps_per_decision(const config::Robot& robot) {
  const double steps = robot.decision_period / physics_step;
  const double whole = std::round(steps);
  if (!(whole >= 1.0) || std::fabs(steps - whole) > 1e-6) {
    throw std::invalid_argument(
        fmt::format("robot profile '{}': the decision period, {:f} s, is not a multiple of 0.02 s", robot.name,
                    robot.decision_period));
  }
  return static_cast<std::uint32_t>(whole);
}

void check(const Setup& setup, std::size_t home, std::size_t away) {
  const int size = setup.rules.team_size;
  if (size < 1 || size > largest_team) {
    throw std::invalid_argument(fmt::format("team size {} is not in 1..{}", size, largest_team));
  }
  if (home != static_cast<std::size_t>(size) || away != static_cast<std::size_t>(size)) {
    throw std::invalid_argument(
        fmt::format("rules want {} robots a team, minds are given for {} and {}", size, home, away));
  }
  for (const config::Disturbance& disturbance : setup.disturbances) config::check(disturbance, setup.rules, {});
  if (!setup.opening) return;
  if (const auto misfit = config::misfit(*setup.opening, setup.rules, setup.robots)) {
    throw std::invalid_argument(misfit->reason);
  }
}

std::vector<config::Body> bodies_of(const Setup& setup) {
  std::vector<config::Body> bodies;
  for (const Side side : both_sides) {
    bodies.insert(bodies.end(), at(setup.rules.team_size), setup.robots[index(side)].body);
  }
  return bodies;
}

double largest_radius(const Setup& setup) { return std::max(setup.robots[0].body.radius, setup.robots[1].body.radius); }

struct Robot {
  const mind::Think& think;
  const config::Robot& profile;
  Body body;
  Sensing sensing;
  std::uint32_t steps_between, next_decision;  // in physics steps
  bool whistle = false;                        // the robot has heard a whistle since its last decision
  int touches = -1;                            // id of the last robot touched since the last decision; -1: none
  mind::Percepts percepts{};
  mind::Outcome outcome{};
};

class OngoingMatch {
 public:
  OngoingMatch(const Setup& setup, std::span<const mind::Think> home, std::span<const mind::Think> away,
               const Observer& observer, const Beliefs& beliefs);
  Result run();

 private:
  void suffer(Side side);
  void decide(int id);
  void feel_contact(int id, Robot& robot);
  bool sees_ball(int id) const;
  RobotSet fallen() const {
    return those(roster_.everybody(), [this](int id) { return robots_[at(id)].body.fallen(time_); });
  }
  RobotSet kicking() const {
    return those(roster_.everybody(), [this](int id) { return robots_[at(id)].body.kicking(); });
  }
  RobotSet able() const { return roster_.everybody() & ~fallen() & ~crashed_; }
  void ask(int id);
  int move_bodies();
  void jostle();
  void judge(int kicker);
  void follow(const Calls& calls);
  void observe();
  Robot& robot(int id) { return robots_[at(id)]; }
  double ball_distance(int id) const;  // m; infinite if the ball is beside or behind the robot, where no foot reaches

  const Setup& setup_;
  const Observer& observer_;
  const Beliefs& beliefs_;
  Roster roster_;
  std::array<Marks, 2> marks_;  // by side: the landmarks, as the cameras of the side's robots see them
  PhysicsWorld arena_;
  Referee referee_;
  GameControllerFeed feed_;
  std::array<Disturbances, 2> trouble_;
  std::array<Radio, 2> radio_;
  Metrics metrics_;
  Belief belief_;
  Digest digest_;
  std::vector<Robot> robots_;
  std::vector<mind::HeardPacket> heard_;
  std::vector<Vector> positions_, legs_;  // by id: position in m and walking velocity in m/s
  Points in_view_;                        // by id: position in m; `nowhere` for a robot that is out of play
  RobotSet out_of_play_ = 0;              // penalised robots off the field
  RobotSet turning_ = 0;                  // robots that have turned since the last update of the referee
  RobotSet acted_ = 0;                    // robots that have decided since the last update of the referee
  RobotSet crashed_ = 0;
  std::uint32_t tick_ = 0;
  double time_ = 0.0;
};

OngoingMatch::OngoingMatch(const Setup& setup, std::span<const mind::Think> home, std::span<const mind::Think> away,
                           const Observer& observer, const Beliefs& beliefs)
    : setup_(setup),
      observer_(observer),
      beliefs_(beliefs),
      roster_{setup.rules.team_size},
      marks_{Marks(setup.rules.field, setup.robots[0].camera), Marks(setup.rules.field, setup.robots[1].camera)},
      arena_(setup.rules.field, setup.rules.ball, bodies_of(setup)),
      referee_(setup.rules, largest_radius(setup), setup.opening ? &*setup.opening : nullptr),
      feed_(setup.rules),
      trouble_{Disturbances(setup.disturbances[0], setup.rules.field, roster_.team_size, setup.seed, Side::home),
               Disturbances(setup.disturbances[1], setup.rules.field, roster_.team_size, setup.seed, Side::away)},
      radio_{Radio(setup.robots[0].radio, trouble_[0], roster_.team_size, setup.seed, Side::home),
             Radio(setup.robots[1].radio, trouble_[1], roster_.team_size, setup.seed, Side::away)},
      metrics_(setup.rules, setup.robots, setup.roles, setup.reasons, setup.plugin_metrics) {
  if (observer.physics_log != nullptr) {
    *observer.physics_log = {setup.rules.field, setup.rules.ball, bodies_of(setup), {}, {}};
    arena_.record(observer.physics_log);
  }
  metrics_.tell_play(observer.play);
  robots_.reserve(at(roster_.count()));
  heard_.reserve(64);
  positions_.resize(at(roster_.count()));
  legs_.resize(positions_.size());
  in_view_.count = positions_.size();
  for (int id = 0; id < roster_.count(); ++id) {
    const Side side = roster_.side(id);
    const int number = roster_.number(id);
    const config::Robot& profile = setup.robots[index(side)];
    const std::uint32_t steps = steps_per_decision(profile);
    const std::uint32_t first = static_cast<std::uint32_t>(2 * (number - 1) + static_cast<int>(index(side))) % steps;
    robots_.push_back(
        {(side == Side::home ? home : away)[at(number - 1)], profile,
         Body(profile, setup.rules.ball.rolling_deceleration, setup.seed, side, number),
         Sensing(profile, trouble_[index(side)], marks_[index(side)], roster_, id, setup.seed, largest_radius(setup)),
         steps, first});
    // Reserves memory for all sightings of one image: the ball, one false ball and all ghost balls.
    mind::Percepts& percepts = robots_.back().percepts;
    percepts.balls.reserve(2 + Affliction::most_ghosts);
    percepts.robots.reserve(2 * largest_team);
    percepts.landmarks.reserve(most_points);
  }
}

double OngoingMatch::ball_distance(int id) const {
  const BodyState& body = arena_.robot(id);
  const Vector way = arena_.ball_position() - Vector{body.x, body.y};
  const double distance = length(way);
  const double ahead = way.x * body.cosine + way.y * body.sine;
  const bool in_front = ahead >= distance * std::cos(robots_[at(id)].profile.body.reach_angle);
  return in_front ? distance : std::numeric_limits<double>::infinity();
}

Result OngoingMatch::run() {
  const std::optional<double> limit = limit_of(setup_);
  judge(-1);
  while (referee_.state().ended == Ended::no) {
    if (limit && time_ >= *limit - physics_step / 2.0) break;
    for (const Side side : both_sides) {
      if (trouble_[index(side)].update(time_)) suffer(side);
    }
    for (int id = 0; id < roster_.count(); ++id) {
      if (robot(id).next_decision == tick_) decide(id);
    }
    const int kicker = move_bodies();
    arena_.step();
    if (arena_.contacts().robots_on_robots != 0) jostle();
    ++tick_;
    time_ = tick_ * physics_step;
    judge(kicker);
    digest_.add(std::as_bytes(arena_.states()));
    if (tick_ % steps_per_sample == 0) metrics_.sample(referee_.state(), arena_.states(), able());
    observe();
  }
  metrics_.finish();
  const GameState& state = referee_.state();
  MatchMetrics metrics = metrics_.result(state, time_);
  for (int id = 0; id < roster_.count(); ++id) metrics.teams[index(roster_.side(id))].falls += robot(id).body.falls();
  const Ended ended = state.ended == Ended::no ? Ended::limit : state.ended;
  return {state.goals, ended, time_, state.packets, std::move(metrics), digest_.value()};
}

// Applies the disturbances of a side to its bodies. Radio and Sensing read the disturbances themselves.
void OngoingMatch::suffer(Side side) {
  for (int number = 1; number <= roster_.team_size; ++number) {
    const Affliction& affliction = trouble_[index(side)].of(number);
    const int id = roster_.id(side, number);
    Body& body = robot(id).body;
    body.set_speed(affliction.speed);
    if (affliction.crashed == contains(crashed_, id)) continue;
    crashed_ ^= only(id);
    if (affliction.crashed) {
      body.freeze(time_);
      metrics_.crashed(side, number, referee_.state());
    } else {
      body.thaw(time_);
    }
  }
}

void OngoingMatch::decide(int id) {
  Robot& robot = this->robot(id);
  robot.next_decision += robot.steps_between;
  const Side side = roster_.side(id);
  const int number = roster_.number(id);
  const GameState& state = referee_.state();
  heard_.clear();
  radio_[index(side)].deliver(number, time_, tick_, heard_);
  if (contains(crashed_, id)) {  // a crashed robot hears no packet: the delivered packets are dropped
    robot.touches = -1;
    return;
  }
  acted_ |= only(id);

  mind::Percepts& percepts = robot.percepts;
  percepts.time = time_;
  percepts.penalised = state.is_penalised(side, number);
  percepts.fallen = robot.body.fallen(time_);
  percepts.time_until_up = robot.body.time_until_up(time_);
  percepts.kicking = robot.body.kicking();
  percepts.whistle = robot.whistle;
  robot.whistle = false;
  feel_contact(id, robot);
  robot.sensing.sense({arena_.robot(id), arena_.ball_position(), in_view_}, time_, tick_,
                      !percepts.penalised && !percepts.fallen, percepts);
  feed_.tell(id, state, time_, percepts.game);

  mind::Outcome& outcome = robot.outcome;
  outcome.clear();
  robot.think(percepts, heard_, outcome);
  if (const std::string why =
          unsound(outcome, robot.profile,
                  {setup_.roles[index(side)].size(), metrics_.reasons(side), metrics_.plugin_metrics(side)});
      !why.empty()) {
    throw std::runtime_error(fmt::format("{} robot {} at {:f} s: {}", name(side), number, time_, why));
  }

  add(digest_, outcome);
  metrics_.decided(side, number, outcome, sees_ball(id), time_, state);
  ask(id);
  robot.sensing.look(outcome.command.head_yaw);
  if (!percepts.penalised) {
    robot.body.command(outcome.command, time_, outcome.command.kick ? ball_distance(id) : 0.0);
  }
  const int packets = state.packets[index(side)];
  const bool leaves = outcome.send && !percepts.penalised && !trouble_[index(side)].of(number).silent;
  const bool in_the_air = leaves && referee_.packet(side, outcome.packet.size());
  const bool charged = state.packets[index(side)] != packets;
  if (charged) metrics_.sent(side, outcome.send_reason, outcome.packet.size(), time_);
  // The observer is called before send(), because send() reuses the memory of the heard packets.
  if (observer_.decision) observer_.decision({time_, side, number, percepts, heard_, outcome, charged});
  if (in_the_air) radio_[index(side)].send(number, outcome.packet, time_, tick_);
}

void OngoingMatch::feel_contact(int id, Robot& robot) {
  robot.percepts.contact.reset();
  const int other = std::exchange(robot.touches, -1);
  if (other < 0) return;
  Chance chance(setup_.seed, Purpose::contact, roster_.side(id), roster_.number(id), 0, tick_);
  if (!chance.bernoulli(robot.profile.body.contact_felt)) return;
  const BodyState &own = arena_.robot(id), &touched = arena_.robot(other);
  const Vector way = turned({touched.x - own.x, touched.y - own.y}, own.cosine, -own.sine);
  robot.percepts.contact = std::atan2(way.y, way.x);
}

// Returns whether the image of the robot's last decision contained a sighting of the true ball.
bool OngoingMatch::sees_ball(int id) const {
  const Robot& robot = robots_[at(id)];
  if (robot.percepts.balls.empty()) return false;
  const BodyState& body = arena_.robot(id);
  const Vector ball = turned(arena_.ball_position() - Vector{body.x, body.y}, body.cosine, -body.sine);
  return std::ranges::any_of(robot.percepts.balls, [ball](const mind::BallSighting& each) {
    return squared_length(Vector{each.position.x(), each.position.y()} - ball) < sighting_error * sighting_error;
  });
}

// Reads what robot `id` believes, if the robot is in play and this is its first decision of a second.
void OngoingMatch::ask(int id) {
  const GameState& state = referee_.state();
  if (!beliefs_ || state.phase != mind::Phase::playing || contains(out_of_play_, id)) return;
  if (tick_ % physics_steps_per_second >= robot(id).steps_between) return;
  beliefs_(roster_.side(id), roster_.number(id), belief_);
  metrics_.believes(roster_.side(id), roster_.number(id), belief_, arena_.states(), state);
}

// Returns the id of the robot that kicked the ball in this step, or -1.
int OngoingMatch::move_bodies() {
  int kicker = -1;
  Vector kicked{};
  for (int id = 0; id < roster_.count(); ++id) {
    if (contains(out_of_play_, id)) continue;
    Robot& robot = this->robot(id);
    const BodyState& now = arena_.robot(id);
    const Body::Motion motion = robot.body.move(time_, tick_, robot.body.kicking() ? ball_distance(id) : 0.0);
    const config::Walk& limits = robot.profile.walk;
    if (motion.walk.turn != 0.0) turning_ |= only(id);
    Vector& legs = legs_[at(id)];
    legs = turned({motion.walk.forward, motion.walk.sideways}, now.cosine, now.sine);
    arena_.drive(id, legs, motion.walk.turn, limits.acceleration, limits.turn_acceleration);
    if (motion.ball_velocity) {
      metrics_.kicked(id, robot.body.receiver());
      // If two robots kick at once, the robot nearer to the ball hits it.
      if (kicker >= 0 && ball_distance(kicker) <= ball_distance(id)) continue;
      kicked = turned(*motion.ball_velocity, now.cosine, now.sine);
      kicker = id;
    }
  }
  if (kicker >= 0) arena_.kick(kicked);
  return kicker;
}

void OngoingMatch::jostle() {
  const Contacts& contacts = arena_.contacts();
  for (int i = 0; i < contacts.pair_count; ++i) {
    const auto& pair = contacts.pairs[static_cast<std::size_t>(i)];
    robot(pair[0]).touches = pair[1];
    robot(pair[1]).touches = pair[0];
  }
  for (const int id : Members(contacts.robots_on_robots)) robot(id).body.jostled(time_, tick_);
}

void OngoingMatch::judge(int kicker) {
  for (int id = 0; id < roster_.count(); ++id) {
    const BodyState& body = arena_.robot(id);
    positions_[at(id)] = {body.x, body.y};
  }
  const Contacts& contacts = arena_.contacts();
  const int touched_by = contacts.hardest_on_ball >= 0 ? contacts.hardest_on_ball : kicker;
  metrics_.now(time_);
  metrics_.stepped(arena_.ball(), touched_by, referee_.state());
  follow(referee_.update({.time = time_,
                          .ball = arena_.ball_position(),
                          .touched_by = touched_by,
                          .kicked = kicker >= 0 && kicker == touched_by,
                          .robots = positions_,
                          .steps = legs_,
                          .turning = std::exchange(turning_, 0),
                          .touching = contacts.robots_on_ball,
                          .fallen = fallen(),
                          .kicking = kicking(),
                          .acted = acted_,
                          .at_walls = contacts.robots_on_walls,
                          .contacts = std::span(contacts.pairs).first(static_cast<std::size_t>(contacts.pair_count))}));
  acted_ = 0;
  for (int id = 0; id < roster_.count(); ++id) {
    const bool away = contains(out_of_play_, id);
    in_view_.x[at(id)] = away ? nowhere : arena_.robot(id).x;
    in_view_.y[at(id)] = away ? nowhere : arena_.robot(id).y;
  }
}

void OngoingMatch::follow(const Calls& calls) {
  const GameState& state = referee_.state();
  for (const int id : calls.removed) {
    arena_.place(id, waiting_pose(setup_.rules.field, id, largest_radius(setup_)));
    robot(id).body.put_down();
    out_of_play_ |= only(id);
    legs_[at(id)] = {};
    metrics_.penalised(roster_.side(id));
  }
  for (const int id : Members(calls.frozen)) {
    robot(id).body.put_down();
    metrics_.penalised(roster_.side(id));
  }
  for (const Placement& placement : calls.placements) {
    const int id = placement.robot;
    arena_.place(id, placement.pose);
    robot(id).body.put_down();
    robot(id).sensing.put_down(placement.pose, attack(roster_.side(id), state.half), tick_);
    out_of_play_ &= ~only(id);
  }
  if (calls.ball) arena_.place_ball(*calls.ball);
  if (calls.ball_velocity) arena_.kick(*calls.ball_velocity);
  if (calls.announced) {
    feed_.announce(state, time_, calls.told_late ? setup_.rules.durations.state_delay : 0.0, calls.ball_came_free);
  }
  if (calls.whistle) {
    for (int id = 0; id < roster_.count(); ++id) {
      const Side side = roster_.side(id);
      Chance chance(setup_.seed, Purpose::whistle, side, roster_.number(id), 0, tick_);
      if (!chance.bernoulli(setup_.robots[index(side)].hearing.whistle_probability)) continue;
      if (contains(crashed_, id)) continue;
      robot(id).whistle = true;
      feed_.whistle(id, time_);
    }
  }
  for (const Event& event : calls.events) {
    digest_.add(static_cast<std::uint8_t>(event.kind));
    digest_.add(static_cast<std::int32_t>(index(event.side)));
    digest_.add(event.number);
    if (event.kind == EventKind::goal) metrics_.scored(event.side);
    if (observer_.event) observer_.event(time_, event, state);
  }
  if (calls.ball) metrics_.ball_placed();
}

void OngoingMatch::observe() {
  if (observer_.step) {
    const GameState& state = referee_.state();
    const RobotSet chasing = metrics_.chasing(state, arena_.ball(), able());
    observer_.step({time_, state, arena_.states(), fallen(), kicking(), chasing, crashed_});
  }
  if (observer_.second && tick_ % physics_steps_per_second == 0) observer_.second(time_, referee_.state());
}

}  // namespace

Result play(const Setup& setup, std::span<const mind::Think> home, std::span<const mind::Think> away,
            const Observer* observer, const Beliefs& beliefs) {
  check(setup, home.size(), away.size());
  static const Observer nobody;
  return OngoingMatch(setup, home, away, observer != nullptr ? *observer : nobody, beliefs).run();
}

std::optional<double> limit_of(const Setup& setup) {
  return setup.limit || !setup.opening ? setup.limit : setup.opening->length;
}

int most_goal_difference(const Setup& setup) {
  const config::Durations& durations = setup.rules.durations;
  const std::optional<double> limit = limit_of(setup);
  const double between = durations.ready + durations.set;
  const int mercy = setup.rules.mercy_difference;
  if (!limit || !(between > 0.0) || *limit / between >= mercy) return mercy;
  return std::min(mercy, 1 + static_cast<int>(*limit / between));
}

}  // namespace regista::match
