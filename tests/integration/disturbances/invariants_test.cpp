// SPDX-License-Identifier: MIT
// What holds in every instant of every match, whatever goes wrong: 50 matches of shipped teams, of 3, 5, 7 and 11
// robots a side, from kick-off and from openings, with random troubles on both sides. Their minds are made rogue:
// whoever is penalised tries to walk, to kick and to send.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regista/testkit/dice.hpp>
#include <set>

#include "process/sanitized.hpp"
#include "teams.hpp"

namespace regista {
namespace {

using match::EventKind;
using match::Side;
using mind::Phase;
using mind::SetPlay;

constexpr int matches = sanitized ? 6 : 50;

// Two robots that meet sink in by what they approach each other in one physics step, for Box2D knows of the contact
// only then: 0.02 s of the speeds of two robots that walk head-on. It pushes them apart again, down to b2_linearSlop.
constexpr double slop = 0.005;
constexpr double pushed_apart_within = 0.5;  // s
double deepest_for_a_moment(const config::Robot& robot) {
  const config::Walk& walk = robot.walk;
  return slop + 2.0 * std::max({walk.forward, walk.sideways, walk.backward}) * config::physics_step;
}

// A robot that is penalised where it stands comes to rest within this.
double comes_to_rest(const config::Robot& robot) {
  return robot.walk.forward / robot.walk.acceleration + 3.0 * config::physics_step;
}

// --- Legal transitions ----------------------------------------------------------------------------------------------

struct State {
  Phase phase;
  SetPlay set_play;
  friend auto operator<=>(const State&, const State&) = default;
};

const std::vector<SetPlay> free_kicks{SetPlay::kick_in, SetPlay::goal_kick, SetPlay::corner_kick,
                                      SetPlay::pushing_free_kick};

// From one physics step to the next. A whole half, or the match, may end in any state in which the clock runs.
std::set<std::pair<State, State>> legal_transitions() {
  std::set<std::pair<State, State>> out;
  const State initial{Phase::initial, SetPlay::none}, finished{Phase::finished, SetPlay::none},
      open{Phase::playing, SetPlay::none};
  const auto add = [&](State from, State to) { out.emplace(from, to); };
  std::vector<State> in_half{open};
  for (const SetPlay kind : free_kicks) in_half.push_back({Phase::playing, kind});
  for (const SetPlay kind : {SetPlay::kick_off, SetPlay::penalty_kick}) {
    const State ready{Phase::ready, kind}, set{Phase::set, kind}, playing{Phase::playing, kind};
    add(ready, set);
    add(set, playing);
    in_half.insert(in_half.end(), {ready, set, playing});
  }
  add(initial, {Phase::ready, SetPlay::kick_off});
  for (const State& from : in_half) {
    add(from, initial);
    add(from, finished);
    if (from.phase != Phase::playing) continue;
    // The touch that frees the ball and what comes of it may fall into one step.
    add(from, open);
    for (const SetPlay kind : free_kicks) add(from, {Phase::playing, kind});
    add(from, {Phase::ready, SetPlay::kick_off});      // a goal, or the game is stuck
    add(from, {Phase::ready, SetPlay::penalty_kick});  // a foul
  }
  return out;
}

std::string text(const State& state) {
  return fmt::format("phase {} set play {}", static_cast<int>(state.phase), static_cast<int>(state.set_play));
}

// --- Random troubles and matches -------------------------------------------------------------------------------------

using testkit::Dice;

int below(Dice& dice, int count) { return dice.integer(0, count - 1); }

template <class List>
const auto& one_of(Dice& dice, const List& list) {
  return list[static_cast<std::size_t>(below(dice, static_cast<int>(list.size())))];
}

config::Incident random_incident(Dice& dice, int team_size) {
  using config::Incident;
  using Choice = Incident::Whom::Choice;
  Incident out;
  out.kind = static_cast<Incident::Kind>(below(dice, static_cast<int>(config::incident_kinds().size())));
  out.robots.choice = static_cast<Choice>(below(dice, 3));
  if (out.robots.choice == Choice::listed) out.robots.numbers = {1 + below(dice, team_size)};
  if (dice.chance(0.5)) {
    out.per_hour = dice.real(10.0, 300.0);
  } else {
    out.at = {dice.real(0.0, 20.0), dice.real(20.0, 90.0)};
  }
  if (dice.chance(0.8)) out.duration = dice.real(0.0, 40.0);
  switch (out.kind) {
    case Incident::Kind::pose_bias:
      out.x = dice.real(-2.0, 2.0);
      out.y = dice.real(-2.0, 2.0);
      out.heading = dice.real(-1.0, 1.0);
      break;
    case Incident::Kind::ghost_ball:
      if (dice.chance(0.5)) out.x = dice.real(-5.0, 5.0), out.y = dice.real(-4.0, 4.0);
      break;
    case Incident::Kind::radio_delay:
      out.delay = dice.real(0.0, 10.0);
      break;
    case Incident::Kind::radio_jitter:
      out.jitter = dice.real(0.0, 10.0);
      break;
    case Incident::Kind::slow_robot:
      out.speed = dice.real(0.0, 1.0);
      break;
    default:
      break;
  }
  return out;
}

config::Disturbance random_disturbance(Dice& dice, int team_size) {
  config::Disturbance out;
  if (dice.chance(0.3)) out.radio.loss = dice.real(0.0, 1.0);
  if (dice.chance(0.3)) out.radio.delay = dice.real(0.0, 3.0);
  if (dice.chance(0.3)) out.radio.jitter = dice.real(0.0, 3.0);
  if (dice.chance(0.3)) out.radio.burst = {dice.real(0.1, 10.0), dice.real(0.1, 5.0), dice.real(0.0, 1.0)};
  out.radio.silence = dice.chance(0.05);
  if (dice.chance(0.3)) out.camera = {dice.real(0.0, 1.0), dice.real(0.0, 5.0)};
  for (int i = below(dice, 8); i > 0; --i) out.incidents.push_back(random_incident(dice, team_size));
  return out;
}

struct Fixture {
  match::Setup setup;
  std::array<std::string, 2> teams;
  std::array<bool, 2> spendthrift{}, fidgets{};
};

Fixture random_fixture(int number) {
  static const std::vector<std::string> teams{"paper", "fixed_rate", "events_only", "formation", "scram", "spqr2023"};
  static const std::vector<std::string> openings{"siege", "goalmouth_scramble", "corner_crowd_left",
                                                 "even_midfield_crowd", "open_goal_two_metres"};
  Dice dice(static_cast<std::uint64_t>(number));
  Fixture out;
  match::Setup& setup = out.setup;
  setup.seed = 1000 + static_cast<std::uint64_t>(number);
  const bool scene = number % 2 == 0;
  constexpr std::array sizes{3, 5, 7, 7, 11};
  setup.rules.team_size = scene ? 7 : one_of(dice, sizes);
  setup.rules.messages.budget = dice.chance(0.3) ? below(dice, 20) : 1200;
  setup.rules.durations.half = scene ? 40.0 : dice.real(60.0, 90.0);
  if (dice.chance(0.5)) setup.rules.durations.ready = 10.0;
  if (dice.chance(0.3)) setup.rules.mercy_difference = 1;
  if (scene) {
    setup.opening = config::read_document<config::Opening>(std::filesystem::path(REGISTA_CONFIGS) / "openings" /
                                                           (one_of(dice, openings) + ".yaml"));
    setup.limit = 120.0;
  }
  for (const Side side : match::both_sides) {
    const std::size_t i = match::index(side);
    out.teams[i] = one_of(dice, teams);
    setup.disturbances[i] = random_disturbance(dice, setup.rules.team_size);
    out.spendthrift[i] = dice.chance(0.1);
    out.fidgets[i] = dice.chance(0.2);
    if (dice.chance(0.3)) setup.robots[i].body.falls_per_contact_second = 0.5;
    if (dice.chance(0.3)) setup.robots[i].body.falls_per_walking_minute = 5.0;
  }
  return out;
}

// Thinks, and tries to act where it must not; a spendthrift sends whenever it can, who fidgets moves in Set.
mind::Think rogue(mind::Mind& mind, bool spendthrift, bool fidgets) {
  return [&mind, spendthrift, fidgets](const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
                                       mind::Outcome& out) {
    mind.think(percepts, heard, out);
    if (fidgets && percepts.game.phase == Phase::set) out.command.walk = {0.2, 0.0, 0.0};
    if (spendthrift && !out.send) {
      out.send = true;
      out.packet.assign(20, 1);
    }
    if (!percepts.penalised) return;
    out.command.walk = {0.25, 0.1, 1.0};
    out.command.kick = mind::KickRequest{0, 0.0, 3.0};
    out.send = true;
    out.packet.assign(20, 1);
  };
}

// --- What is watched -------------------------------------------------------------------------------------------------

class Watch {
 public:
  explicit Watch(const match::Setup& setup)
      : setup_(setup),
        roster_{setup.rules.team_size},
        legal_(legal_transitions()),
        deep_since_(static_cast<std::size_t>(roster_.count() * roster_.count()), -1.0),
        penalised_since_(static_cast<std::size_t>(roster_.count()), -1.0) {
    observer.step = [this](const match::Snapshot& now) { step(now); };
    observer.event = [this](double time, const match::Event& event, const match::GameState&) { heard(time, event); };
    observer.decision = [this](const match::Decision& decision) {
      if (decision.packet_charged) ++charged_[match::index(decision.side)];
      if (decision.packet_charged && decision.percepts.penalised) note(decision.time, "a penalised robot has sent");
      if (decision.outcome.send && decision.percepts.penalised) ++sends_refused;
    };
  }

  match::Observer observer;
  std::map<std::string, int> broken;  // what, how often
  double deepest = 0.0, longest_deep = 0.0;
  int goals = 0, sends_refused = 0;
  double penalised_seconds = 0.0;
  std::set<std::pair<State, State>> seen;
  bool sanctioned = false;

 private:
  void note(double time, const std::string& what) {
    if (broken[what]++ == 0) fmt::print("first at {:.2f} s: {}\n", time, what);
  }

  void heard(double time, const match::Event& event) {
    if (event.kind == EventKind::kick_off) kick_off_since_goal_ = true;
    if (event.kind != EventKind::goal && event.kind != EventKind::goal_not_counted) return;
    if (event.kind == EventKind::goal) {
      ++goals;
      if (!kick_off_since_goal_) note(time, "two goals without a kick-off");
      kick_off_since_goal_ = false;
    }
  }

  void step(const match::Snapshot& now) {
    follow(now);
    keep_apart(now);
    stay_inside(now);
    stay_put(now);
    keep_budget(now);
    last_ = now.state;
    began_ = true;
  }

  void follow(const match::Snapshot& now) {
    const State before{last_.phase, last_.set_play}, after{now.state.phase, now.state.set_play};
    if (!began_ || before == after) return;
    seen.emplace(before, after);
    if (!legal_.contains({before, after})) note(now.time, "from " + text(before) + " to " + text(after));
    if (now.state.half != last_.half && (now.state.half != last_.half + 1 || after.phase != Phase::initial)) {
      note(now.time, "another half, but not the next one from its beginning");
    }
    for (const Side side : match::both_sides) {
      const std::size_t i = match::index(side);
      const bool lost_all = now.state.goals[i] == 0 && now.state.sanctioned[i];
      if (now.state.goals[i] < last_.goals[i] && !lost_all) note(now.time, "a goal was taken away");
      if (now.state.goals[i] < 0) note(now.time, "less than no goals");
    }
  }

  bool waits(const match::BodyState& body) const {
    const config::FieldSize& field = setup_.rules.field;
    return std::fabs(body.x) > field.length / 2.0 + field.border_strip ||
           std::fabs(body.y) > field.width / 2.0 + field.border_strip;
  }

  void keep_apart(const match::Snapshot& now) {
    const double apart = setup_.robots[0].body.radius + setup_.robots[1].body.radius;
    for (int a = 0; a < roster_.count(); ++a) {
      for (int b = 0; b < a; ++b) {
        const auto &p = now.bodies[static_cast<std::size_t>(a)], &q = now.bodies[static_cast<std::size_t>(b)];
        const double x = p.x - q.x, y = p.y - q.y;
        double& since = deep_since_[static_cast<std::size_t>(a * roster_.count() + b)];
        if (x * x + y * y > (apart - slop) * (apart - slop)) {
          since = -1.0;
          continue;
        }
        const double depth = apart - std::hypot(x, y);
        deepest = std::max(deepest, depth);
        if (depth > deepest_for_a_moment(setup_.robots[0]) + 1e-4) note(now.time, "robots in each other");
        if (depth < slop + 1e-4) continue;
        if (since < 0.0) since = now.time;
        longest_deep = std::max(longest_deep, now.time - since);
        if (now.time - since > pushed_apart_within) note(now.time, "robots that stay in each other");
      }
    }
  }

  void stay_inside(const match::Snapshot& now) {
    for (const match::BodyState& body : now.bodies) {
      for (const float value : {body.x, body.y, body.heading, body.cosine, body.sine, body.vx, body.vy, body.turn}) {
        if (!std::isfinite(value)) note(now.time, "not finite");
      }
    }
    if (waits(now.bodies.back())) note(now.time, "the ball has left the arena");
    for (int id = 0; id < roster_.count(); ++id) {
      const bool penalised = now.state.is_penalised(roster_.side(id), roster_.number(id));
      if (!penalised && waits(now.bodies[static_cast<std::size_t>(id)])) note(now.time, "a robot has left the arena");
    }
  }

  bool touched(const match::Snapshot& now, int id) const {
    const auto& body = now.bodies[static_cast<std::size_t>(id)];
    for (std::size_t other = 0; other < now.bodies.size(); ++other) {
      if (other == static_cast<std::size_t>(id)) continue;
      if (std::hypot(body.x - now.bodies[other].x, body.y - now.bodies[other].y) < 0.34) return true;
    }
    return false;
  }

  // Penalised robots neither move nor kick. What bumps into them may push them.
  void stay_put(const match::Snapshot& now) {
    for (int id = 0; id < roster_.count(); ++id) {
      double& since = penalised_since_[static_cast<std::size_t>(id)];
      if (!now.state.is_penalised(roster_.side(id), roster_.number(id))) {
        since = -1.0;
        continue;
      }
      penalised_seconds += config::physics_step;
      const auto& body = now.bodies[static_cast<std::size_t>(id)];
      const bool pushed = touched(now, id);
      if (since < 0.0 || pushed) since = now.time;
      if (match::contains(now.kicking, id)) note(now.time, "a penalised robot kicks");
      const bool moves = body.vx != 0.0f || body.vy != 0.0f || body.turn != 0.0f;
      if (!moves || pushed) continue;
      const bool had_time = now.time - since > comes_to_rest(setup_.robots[match::index(roster_.side(id))]);
      if (waits(body) || had_time) note(now.time, "a penalised robot moves");
    }
  }

  void keep_budget(const match::Snapshot& now) {
    for (const Side side : match::both_sides) {
      const std::size_t i = match::index(side);
      const int left = now.state.packets_left[i], sent = now.state.packets[i];
      if (left < 0) note(now.time, "negative budget");
      if (left != std::max(0, setup_.rules.messages.budget - sent)) note(now.time, "the budget does not add up");
      if (sent - last_.packets[i] != charged_[i])
        note(now.time, "the decisions do not tell which packets were charged");
      if (sent > setup_.rules.messages.budget && !now.state.sanctioned[i] && sanction_due_[i]) {
        note(now.time, "over the budget without a sanction");
      }
      sanction_due_[i] = sent > setup_.rules.messages.budget;
      sanctioned = sanctioned || now.state.sanctioned[i];
      charged_[i] = 0;
    }
  }

  const match::Setup& setup_;
  match::Roster roster_;
  std::set<std::pair<State, State>> legal_;
  std::vector<double> deep_since_, penalised_since_;
  std::array<int, 2> charged_{};
  std::array<bool, 2> sanction_due_{};
  bool kick_off_since_goal_ = true, began_ = false;
  match::GameState last_;
};

TEST(Invariants, HoldWhateverGoesWrong) {
  double deepest = 0.0, longest_deep = 0.0, penalised = 0.0;
  int goals = 0, sends_refused = 0, sanctions = 0;
  std::set<std::pair<State, State>> seen;
  for (int number = 1; number <= matches; ++number) {
    SCOPED_TRACE(number);
    Fixture fixture = random_fixture(number);
    match::Setup& setup = fixture.setup;
    std::array<std::unique_ptr<const mind::TeamPlan>, 2> plans;
    std::array<std::vector<mind::Mind>, 2> minds;
    std::array<std::vector<mind::Think>, 2> think;
    for (const Side side : match::both_sides) {
      const std::size_t i = match::index(side);
      plans[i] = shipped::plan(fixture.teams[i], setup.rules, setup.robots[i]);
      setup.roles[i] = match::roles(*plans[i]);
      minds[i] = match::minds(*plans[i], side, setup.seed);
      for (mind::Mind& each : minds[i]) think[i].push_back(rogue(each, fixture.spendthrift[i], fixture.fidgets[i]));
    }
    Watch watch(setup);
    match::play(setup, think[0], think[1], &watch.observer);
    for (const auto& [what, times] : watch.broken) ADD_FAILURE() << what << ", " << times << " times";
    deepest = std::max(deepest, watch.deepest);
    longest_deep = std::max(longest_deep, watch.longest_deep);
    penalised += watch.penalised_seconds;
    goals += watch.goals;
    sends_refused += watch.sends_refused;
    sanctions += watch.sanctioned ? 1 : 0;
    seen.insert(watch.seen.begin(), watch.seen.end());
  }
  fmt::print(
      "deepest overlap {:.2f} mm, deeper than the slop for at most {:.2f} s; {} goals, {:.0f} s of penalties, "
      "{} packets refused to penalised robots, {} matches with a sanction, {} kinds of transitions\n",
      1000.0 * deepest, longest_deep, goals, penalised, sends_refused, sanctions, seen.size());
  // Without these the invariants would have held of an empty field.
  if (matches < 50) return;
  EXPECT_GT(goals, 5);
  EXPECT_GT(penalised, 100.0);
  EXPECT_GT(sends_refused, 1000);
  EXPECT_GT(sanctions, 0);
  EXPECT_GT(seen.size(), 12u);
}

}  // namespace
}  // namespace regista
