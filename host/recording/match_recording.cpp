// SPDX-License-Identifier: MIT
#include "recording/match_recording.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "match/game_state.hpp"
#include "mcap/file_io.hpp"
#include "recording/schemas.hpp"

namespace regista::recording {
namespace {

using texts::JsonText;

constexpr int game_steps = match::physics_steps_per_second / 10;
constexpr double belief_period = 0.5;  // s
// An unchanged decision is written again after this time (s), because its matrix may have changed.
constexpr double decision_period = 5.0;

std::uint64_t nanoseconds(double seconds) { return static_cast<std::uint64_t>(std::llround(seconds * 1e9)); }

// Converts from a team's field frame into the world frame, by half a turn or none. Rounds to 0.01 m and 0.01 rad.
struct ToWorld {
  double direction;

  void point(JsonText& json, const double (&xy)[2]) const {
    json.open('[').number(direction * xy[0], 2).number(direction * xy[1], 2).close(']');
  }
  void pose(JsonText& json, const double (&pose)[3]) const {
    const double turned = direction > 0.0 ? pose[2] : mind::wrap(pose[2] + std::numbers::pi);
    json.open('[').number(direction * pose[0], 2).number(direction * pose[1], 2).number(turned, 2).close(']');
  }
};

// Writes a covariance as xx, xy, yy. Half a turn does not change these values. A robot's has three decimals: its
// ellipse is then drawn right to 3 cm, and a page of a whole match is a tenth smaller.
void covariance(JsonText& json, const double* xx_xy_yy, int decimals) {
  json.open('[').number(xx_xy_yy[0], decimals).number(xx_xy_yy[1], decimals).number(xx_xy_yy[2], decimals).close(']');
}

void numbers_of(JsonText& json, match::RobotSet of_one_side) {
  json.open('[');
  for (const int id : match::Members(of_one_side)) json.integer(id + 1);
  json.close(']');
}

template <class Elements, class Write>
void column(JsonText& json, std::string_view name, const Elements& elements, Write write) {
  json.key(name).open('[');
  for (const auto& element : elements) write(element);
  json.close(']');
}

void integers(JsonText& json, std::string_view name, const std::vector<std::int32_t>& values) {
  column(json, name, values, [&](std::int32_t value) { json.integer(value); });
}

// Writes robots as columns, so that each key occurs once and not once for each robot. This halves the bytes.
void world(JsonText& json, const mind::DistributedWorldModel& snapshot, const ToWorld& to) {
  const regista_ball& ball = snapshot.ball_state;
  json.key("ball");
  if (snapshot.ball_known()) {
    json.open('{').key("at");
    to.point(json, ball.position);
    json.key("velocity");
    to.point(json, ball.velocity);
    json.key("covariance");
    covariance(json, ball.covariance, 4);
    json.key("age").number(ball.age, 2).close('}');
  } else {
    json.null();
  }
  const auto known = [&](std::string_view name, auto write) {
    column(json, name, snapshot.robots, [&](const regista_robot& robot) {
      if ((robot.flags & REGISTA_ROBOT_KNOWN) != 0) write(robot);
    });
  };
  json.key("teammates").open('{');
  known("number", [&](const regista_robot& robot) { json.integer(robot.number); });
  known("pose", [&](const regista_robot& robot) { to.pose(json, robot.pose); });
  known("covariance", [&](const regista_robot& robot) { covariance(json, robot.covariance, 3); });
  known("age", [&](const regista_robot& robot) { json.number(robot.age, 2); });
  known("role", [&](const regista_robot& robot) { json.integer(robot.role); });
  integers(json, "active", snapshot.active);
  json.close('}').key("opponents").open('{');
  column(json, "at", snapshot.opponents, [&](const regista_opponent& opponent) { to.point(json, opponent.position); });
  column(json, "covariance", snapshot.opponents,
         [&](const regista_opponent& opponent) { covariance(json, opponent.covariance, 3); });
  column(json, "age", snapshot.opponents, [&](const regista_opponent& opponent) { json.number(opponent.age, 1); });
  column(json, "weight", snapshot.opponents,
         [&](const regista_opponent& opponent) { json.number(opponent.weight, 2); });
  json.close('}');
}

void placement(JsonText& json, const plugin::Placement& placement, const ToWorld& to) {
  column(json, "waypoints", placement.points, [&](const regista_waypoint& point) {
    json.open('[').number(to.direction * point.x, 2).number(to.direction * point.y, 2);
    json.quantity(point.score, 4).close(']');
  });
  column(json, "edges", placement.edges,
         [&](const regista_edge& edge) { json.open('[').integer(edge.from).integer(edge.to).close(']'); });
}

void tasks(JsonText& json, const mind::Decision& decision, const ToWorld& to) {
  column(json, "tasks", decision.tasks, [&](const regista_task& task) {
    json.open('{').key("role").integer(task.id).key("before");
    to.pose(json, task.before);
    json.key("after");
    const auto kept = std::ranges::find(decision.columns, task.id, &regista_task::id);
    if (kept == decision.columns.end())
      json.null();
    else
      to.pose(json, kept->after);
    json.close('}');
  });
  column(json, "columns", decision.columns, [&](const regista_task& task) { json.integer(task.id); });
}

// Writes the matrix row by row; a forbidden pair of robot and task becomes null.
void matrix(JsonText& json, const std::vector<double>& values, std::size_t columns, int decimals) {
  json.open('[');
  for (std::size_t i = 0; columns > 0 && i + columns <= values.size(); i += columns) {
    json.open('[');
    for (std::size_t j = 0; j < columns; ++j) json.quantity(values[i + j], decimals);
    json.close(']');
  }
  json.close(']');
}

}  // namespace

MatchRecording::MatchRecording(const std::filesystem::path& file, const RecordedSetup& setup, const Options& options)
    : plans_(setup.plans),
      at_stake_(options.at_stake),
      writer_(file, {.library = setup.program, .replace = options.replace, .background = options.background}) {
  add(game_, "game", schema::game);
  add(events_, "event", schema::event);
  add(plays_, "play", schema::play);
  add(packets_, "packet", schema::packet);
  add(heard_, "heard", schema::heard);
  const auto decision = writer_.add_schema("decision", "jsonschema", schema::decision());
  const auto belief = writer_.add_schema("belief", "jsonschema", schema::belief());
  for (const match::Side side : match::both_sides) {
    std::vector<Last>& robots = last_[match::index(side)];
    const mind::TeamPlan& plan = *plans_[match::index(side)];
    const auto team_size = plan.rules().team_size;
    robots.resize(static_cast<std::size_t>(team_size));
    limits_[match::index(side)] = {team_size, static_cast<int>(plan.roles().size()),
                                   static_cast<int>(plan.contexts().size()),
                                   static_cast<std::size_t>(plan.rules().messages.size)};
    with_common_[match::index(side)] = std::ranges::any_of(plan.team().contexts, &config::Context::uses_common);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const std::string whose = std::string("/") + match::name(side) + '/' + std::to_string(i + 1);
      robots[i].decisions.id = writer_.add_channel("/decision" + whose, "json", decision);
      robots[i].beliefs.id = writer_.add_channel("/belief" + whose, "json", belief);
    }
  }
  // Metadata are written outside of chunks, because a crash in the first seconds loses the chunk in memory.
  writer_.write(mcap::Metadata{match_metadata_name, match_metadata(setup)});
}

MatchRecording::~MatchRecording() {
  try {
    writer_.close();
  } catch (const mcap::Error&) {
    // The destructor hides errors. A caller that needs errors calls close() before.
  }
}

void MatchRecording::add(Channel& channel, const std::string& name, std::string (*schema)()) {
  channel.id = writer_.add_channel('/' + name, "json", writer_.add_schema(name, "jsonschema", schema()));
}

void MatchRecording::write(Channel& channel, double time) {
  const std::uint64_t when = nanoseconds(time);
  writer_.write(mcap::Message{*channel.id, channel.count++, when, when, json_.text()});
}

void MatchRecording::write(Channel& channel, double time, const char* name, std::string (*schema)()) {
  if (!channel.id) add(channel, name, schema);
  write(channel, time);
}

void MatchRecording::begin(double time) {
  json_.clear();
  json_.open('{').key("time").number(time);
}

void MatchRecording::begin_of_robot(double time, match::Side side, int robot) {
  begin(time);
  json_.key("side").word(match::name(side)).key("robot").integer(robot);
}

void MatchRecording::write_segments(const mind::Mind& mind, const match::Decision& turn) {
  for (const mind::SegmentEvent& event : mind.segments()) {
    const std::uint64_t handle = sent_.follow(turn.side, mind.number(), event);
    begin(turn.time);
    recording::write(json_, {turn.side, mind.number(), event, handle, turn.packet_charged});
    json_.close('}');
    write(segments_, turn.time, "segment", schema::segment);
  }
}

void MatchRecording::write_log(const mind::Mind& mind, const match::Decision& turn) {
  for (const mind::LogLine& line : mind.log()) {
    begin_of_robot(turn.time, turn.side, mind.number());
    json_.key("plugin").word(line.plugin).key("place").integer(line.place);
    json_.key("tick").integer(static_cast<std::int64_t>(line.tick));
    json_.key("level").word(mind::level_name(line.level)).key("text").string(line.text).close('}');
    write(log_, turn.time, "log", schema::log);
  }
}

void MatchRecording::write_drawings(const mind::Mind& mind, const match::Decision& turn) {
  const double direction = match::attack(turn.side, half_);
  for (const DrawnLayers::Change& each :
       layers_.follow(turn.side, mind.number(), turn.time, mind.drawings(), direction)) {
    begin_of_robot(turn.time, turn.side, mind.number());
    json_.key("plugin").word(each.plugin).key("layer").string(each.layer).key("shapes").json(each.shapes).close('}');
    write(drawings_, turn.time, "draw", schema::draw);
  }
}

void MatchRecording::write_decision(Last& robot, match::Side side, const mind::Mind& mind, double time) {
  const mind::Decision& decision = mind.decision();
  const ToWorld to{match::attack(side, half_)};
  begin(time);
  json_.key("context").integer(decision.context);
  if (decision.context < 0) {
    // Without a context the robot decided nothing, and `decision` still has values of an earlier decision.
    json_.key("knowledge").word("mine");
    for (const char* empty : {"waypoints", "edges", "tasks", "columns", "rows", "utility", "terms"}) {
      json_.key(empty).open('[').close(']');
    }
  } else {
    const bool common = decision.frame.knowledge == REGISTA_COMMON;
    json_.key("knowledge").word(common ? "common" : "mine");
    placement(json_, decision.placement, to);
    tasks(json_, decision, to);
    integers(json_, "rows", (common ? mind.world().common() : mind.world().mine()).active);
    const std::size_t columns = decision.columns.size();
    json_.key("utility");
    matrix(json_, decision.utility.values(), columns, 5);
    column(json_, "terms", decision.utility.terms(), [&](const auto& term) { matrix(json_, term, columns, 4); });
  }
  integers(json_, "assigned", decision.role_of);
  json_.key("role").integer(decision.own_role);
  json_.key("since").number(decision.own_role < 0 ? 0.0 : decision.own_role_since).close('}');
  write(robot.decisions, time);
}

void MatchRecording::write_belief(Last& robot, match::Side side, const mind::Mind& mind, double time) {
  const ToWorld to{match::attack(side, half_)};
  const regista_track& self = mind.world().local().self();
  begin(time);
  json_.key("pose");
  to.pose(json_, {self.x, self.y, self.pose.heading});
  json_.key("sees_ball").boolean(mind.world().local().sees_ball());
  json_.key("mine").open('{');
  world(json_, mind.world().mine(), to);
  json_.close('}');
  if (with_common_[match::index(side)]) {
    json_.key("common").open('{');
    world(json_, mind.world().common(), to);
    json_.close('}');
  }
  json_.close('}');
  write(robot.beliefs, time);
}

void MatchRecording::decided(const mind::Mind& mind, const match::Decision& turn) {
  const match::Side side = turn.side;
  const double time = turn.time;
  Last& last = last_[match::index(side)][static_cast<std::size_t>(mind.number() - 1)];
  const mind::Decision& decision = mind.decision();
  const bool role_changed = last.written.role != decision.own_role;
  for (const mind::HeardPacket& packet : turn.heard) {
    const auto report = mind::decode(packet.bytes, limits_[match::index(side)], heard_segments_);
    if (!report) continue;
    begin_of_robot(packet.time_heard, side, mind.number());
    json_.key("sender").integer(report->sender).key("sent").number(report->time_sent).close('}');
    write(heard_, packet.time_heard);
  }
  if (turn.packet_charged) {
    begin_of_robot(time, side, mind.number());
    json_.key("reason").word(plans_[match::index(side)]->reason(turn.outcome.send_reason));
    json_.key("bytes").integer(static_cast<std::int64_t>(turn.outcome.packet.size())).close('}');
    write(packets_, time);
  }
  write_segments(mind, turn);
  write_log(mind, turn);
  write_drawings(mind, turn);
  if (role_changed && decision.own_role >= 0) {
    // Another robot may hold this role already. The next decisions of such robots are written, too.
    for (Last& other : last_[match::index(side)]) other.shares |= other.written.role == decision.own_role;
  }
  if (!last.written.is(decision) || last.shares || time - last.decision >= decision_period - 1e-9) {
    last.shares = false;
    last.decision = time;
    last.written.take(decision);
    write_decision(last, side, mind, time);
  }
  if (role_changed || last.belief < 0.0 || time - last.belief >= belief_period - 1e-9) {
    last.belief = time;
    write_belief(last, side, mind, time);
  }
}

void MatchRecording::event(double time, const match::Event& event, const match::GameState& state) {
  begin(time);
  json_.key("event").word(match::word(event.kind)).key("side").word(match::name(event.side));
  json_.key("robot").integer(event.number);
  if (event.offence != match::Offence::none) json_.key("offence").word(match::word(event.offence));
  json_.key("score").open('[').integer(state.goals[0]).integer(state.goals[1]).close(']').close('}');
  write(events_, time);
}

void MatchRecording::play(double time, const match::PlayEvent& event) {
  begin(time);
  json_.key("kind").word(match::name(event.kind)).key("side").word(match::name(event.side));
  json_.key("robot").integer(event.number).key("began").number(event.began);
  json_.key("at").open('[').number(event.at.x).number(event.at.y).close(']');
  if (event.outcome != match::PlayOutcome::none) json_.key("outcome").word(match::name(event.outcome));
  if (event.kind == match::PlayKind::pass) json_.key("receiver").integer(event.receiver);
  if (event.kind == match::PlayKind::duel) {
    json_.key("opponent").integer(event.opponent).key("duration").number(event.duration);
  }
  json_.close('}');
  write(plays_, time);
}

void MatchRecording::stepped(const match::Snapshot& snapshot) {
  if (snapshot.time - chunk_began_ >= at_stake_ - 1e-9) {
    writer_.finish_chunk();
    chunk_began_ = snapshot.time;
  }
  const match::GameState& state = snapshot.state;
  half_ = state.half;
  const bool began = state.phase == mind::Phase::playing && phase_ != mind::Phase::playing;
  phase_ = state.phase;
  for (int id = 0; std::vector<Last> & side : last_) {
    for (Last& robot : side) {
      robot.shares |= began;  // the next decision of every robot is written when play begins
      if (snapshot.crashed >> id++ & 1u) robot.written.role = -1;
    }
  }
  if (++steps_ % game_steps != 0) return;
  const auto counts = [&](std::string_view key, const std::array<int, 2>& values) {
    json_.key(key).open('[').integer(values[0]).integer(values[1]).close(']');
  };
  const match::Roster roster{static_cast<int>(last_[0].size())};
  const auto robots = [&](std::string_view key, match::RobotSet all) {
    json_.key(key).open('[');
    numbers_of(json_, all & roster.team(match::Side::home));
    numbers_of(json_, all >> roster.team_size);
    json_.close(']');
  };
  begin(snapshot.time);
  json_.key("half").integer(state.half).key("clock").number(state.clock).key("phase").word(match::name(state.phase));
  json_.key("set_play").word(match::name(state.set_play)).key("kicking").word(match::name(state.kicking));
  counts("score", state.goals);
  counts("packets_left", state.packets_left);
  robots("penalised", state.all_penalised(roster));
  robots("fallen", snapshot.fallen);
  robots("kicks", snapshot.kicking);
  robots("chases", snapshot.chasing);
  const match::BodyState& ball = snapshot.bodies.back();
  json_.key("ball").open('[').number(ball.x).number(ball.y).number(ball.vx).number(ball.vy).close(']');
  for (const match::Side side : match::both_sides) {
    json_.key(match::name(side)).open('[');
    for (const int id : match::Members(roster.team(side))) {
      const match::BodyState& body = snapshot.bodies[match::at(id)];
      json_.open('[').number(body.x).number(body.y).number(mind::wrap(body.heading)).close(']');
    }
    json_.close(']');
  }
  json_.key("roles").open('[');
  for (const auto& side : last_) {
    json_.open('[');
    for (const Last& robot : side) json_.integer(std::max(robot.written.role, REGISTA_UNKNOWN_TASK + 0));
    json_.close(']');
  }
  json_.close(']').close('}');
  write(game_, snapshot.time);
}

}  // namespace regista::recording
