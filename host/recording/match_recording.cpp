// SPDX-License-Identifier: MIT
#include "recording/match_recording.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "match/game_state.hpp"
#include "mcap/file_io.hpp"
#include "mcap/writer.hpp"
#include "mind/world/packet.hpp"
#include "recording/plugin_records.hpp"
#include "recording/schemas.hpp"
#include "texts/json_text.hpp"

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

// Writes a covariance as xx, xy, yy. Half a turn does not change these values.
void covariance(JsonText& json, const double* xx_xy_yy) {
  json.open('[').number(xx_xy_yy[0], 4).number(xx_xy_yy[1], 4).number(xx_xy_yy[2], 4).close(']');
}

void numbers_of(JsonText& json, std::uint32_t set) {
  json.open('[');
  for (int number = 1; set != 0; ++number, set >>= 1) {
    if ((set & 1u) != 0) json.integer(number);
  }
  json.close(']');
}

// Writes a list with one entry for each element.
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
    covariance(json, ball.covariance);
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
  known("covariance", [&](const regista_robot& robot) { covariance(json, robot.covariance); });
  known("age", [&](const regista_robot& robot) { json.number(robot.age, 2); });
  known("role", [&](const regista_robot& robot) { json.integer(robot.role); });
  integers(json, "active", snapshot.active);
  json.close('}').key("opponents").open('{');
  column(json, "at", snapshot.opponents, [&](const regista_opponent& opponent) { to.point(json, opponent.position); });
  column(json, "covariance", snapshot.opponents,
         [&](const regista_opponent& opponent) { covariance(json, opponent.covariance); });
  column(json, "age", snapshot.opponents, [&](const regista_opponent& opponent) { json.number(opponent.age, 2); });
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

struct MatchRecording::Impl {
  struct Channel {
    std::optional<mcap::ChannelId> id;  // missing: no message was written yet
    std::uint32_t count = 0;            // number of messages
  };
  struct Last {
    LastDecision written;                  // the last written decision; role -1 after a crash of the robot
    double decision = 0.0, belief = -1.0;  // s; times of the last written messages
    bool shares = false;  // the next decision is written: another robot took the same role, or play has begun
    Channel decisions, beliefs;
  };

  Impl(const std::filesystem::path& file, const RecordedSetup& setup, const Options& options)
      : plans(setup.plans),
        at_stake(options.at_stake),
        writer(file, {.library = setup.program, .replace = options.replace, .background = options.background}) {
    add(game, "game", schema::game);
    add(events, "event", schema::event);
    add(plays, "play", schema::play);
    add(packets, "packet", schema::packet);
    add(heard, "heard", schema::heard);
    const auto decision = writer.add_schema("decision", "jsonschema", schema::decision());
    const auto belief = writer.add_schema("belief", "jsonschema", schema::belief());
    for (const match::Side side : match::both_sides) {
      std::vector<Last>& robots = last[match::index(side)];
      const mind::TeamPlan& plan = *plans[match::index(side)];
      const auto team_size = plan.rules().team_size;
      robots.resize(static_cast<std::size_t>(team_size));
      limits[match::index(side)] = {team_size, static_cast<int>(plan.roles().size()),
                                    static_cast<int>(plan.contexts().size()),
                                    static_cast<std::size_t>(plan.rules().messages.size)};
      with_common[match::index(side)] = std::ranges::any_of(plan.team().contexts, &config::Context::uses_common);
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const std::string whose = std::string("/") + match::name(side) + '/' + std::to_string(i + 1);
        robots[i].decisions.id = writer.add_channel("/decision" + whose, "json", decision);
        robots[i].beliefs.id = writer.add_channel("/belief" + whose, "json", belief);
      }
    }
    // Metadata are written outside of chunks, because a crash in the first seconds loses the chunk in memory.
    writer.write(mcap::Metadata{match_metadata_name, match_metadata(setup)});
  }

  ToWorld to_world(match::Side side) const { return {match::attack(side, half)}; }

  void add(Channel& channel, const std::string& name, std::string (*schema)()) {
    channel.id = writer.add_channel('/' + name, "json", writer.add_schema(name, "jsonschema", schema()));
  }
  void write(Channel& channel, double time) {
    const std::uint64_t when = nanoseconds(time);
    writer.write(mcap::Message{*channel.id, channel.count++, when, when, json.text()});
  }
  // Adds the channel with its first message, because most matches do not need this channel.
  void write(Channel& channel, double time, const char* name, std::string (*schema)()) {
    if (!channel.id) add(channel, name, schema);
    write(channel, time);
  }

  void begin(double time) {
    json.clear();
    json.open('{').key("time").number(time);
  }
  void begin_of_robot(double time, match::Side side, int robot) {
    begin(time);
    json.key("side").word(match::name(side)).key("robot").integer(robot);
  }

  void write_segments(const mind::Mind& mind, const match::Decision& turn);
  void write_log(const mind::Mind& mind, const match::Decision& turn);
  void write_drawings(const mind::Mind& mind, const match::Decision& turn);
  void write_decision(Last& robot, match::Side side, const mind::Mind& mind, double time);
  void write_belief(Last& robot, match::Side side, const mind::Mind& mind, double time);

  std::array<const mind::TeamPlan*, 2> plans;
  double at_stake;
  mcap::Writer writer;
  JsonText json;
  Channel game, events, plays, packets, heard, segments, log, drawings;
  std::array<mind::PacketLimits, 2> limits;
  std::array<bool, 2> with_common{};  // true: a context of the team uses the common world
  std::vector<mind::Segment> heard_segments;
  SentSegments sent;
  DrawnLayers layers;
  std::array<std::vector<Last>, 2> last;  // by side and number - 1
  std::uint64_t steps = 0;
  double chunk_began = 0.0;
  int half = 1;
  mind::Phase phase = mind::Phase::initial;
};

void MatchRecording::Impl::write_segments(const mind::Mind& mind, const match::Decision& turn) {
  for (const mind::SegmentEvent& event : mind.segments()) {
    const std::uint64_t handle = sent.follow(turn.side, mind.number(), event);
    begin(turn.time);
    recording::write(json, {turn.side, mind.number(), event, handle, turn.packet_charged});
    json.close('}');
    write(segments, turn.time, "segment", schema::segment);
  }
}

void MatchRecording::Impl::write_log(const mind::Mind& mind, const match::Decision& turn) {
  for (const mind::LogLine& line : mind.log()) {
    begin_of_robot(turn.time, turn.side, mind.number());
    json.key("plugin").word(line.plugin).key("place").integer(line.place);
    json.key("tick").integer(static_cast<std::int64_t>(line.tick));
    json.key("level").word(mind::level_name(line.level)).key("text").string(line.text).close('}');
    write(log, turn.time, "log", schema::log);
  }
}

void MatchRecording::Impl::write_drawings(const mind::Mind& mind, const match::Decision& turn) {
  const double direction = match::attack(turn.side, half);
  for (const DrawnLayers::Change& each :
       layers.follow(turn.side, mind.number(), turn.time, mind.drawings(), direction)) {
    begin_of_robot(turn.time, turn.side, mind.number());
    json.key("plugin").word(each.plugin).key("layer").string(each.layer).key("shapes").json(each.shapes).close('}');
    write(drawings, turn.time, "draw", schema::draw);
  }
}

void MatchRecording::Impl::write_decision(Last& robot, match::Side side, const mind::Mind& mind, double time) {
  const mind::Decision& decision = mind.decision();
  const ToWorld to = to_world(side);
  begin(time);
  json.key("context").integer(decision.context);
  if (decision.context < 0) {
    // Without a context the robot decided nothing, and `decision` still has values of an earlier decision.
    json.key("knowledge").word("mine");
    for (const char* empty : {"waypoints", "edges", "tasks", "columns", "rows", "utility", "terms"}) {
      json.key(empty).open('[').close(']');
    }
  } else {
    const bool common = decision.frame.knowledge == REGISTA_COMMON;
    json.key("knowledge").word(common ? "common" : "mine");
    placement(json, decision.placement, to);
    tasks(json, decision, to);
    integers(json, "rows", (common ? mind.world().common() : mind.world().mine()).active);
    const std::size_t columns = decision.columns.size();
    json.key("utility");
    matrix(json, decision.utility.values(), columns, 5);
    column(json, "terms", decision.utility.terms(), [&](const auto& term) { matrix(json, term, columns, 4); });
  }
  integers(json, "assigned", decision.role_of);
  json.key("role").integer(decision.own_role);
  json.key("since").number(decision.own_role < 0 ? 0.0 : decision.own_role_since).close('}');
  write(robot.decisions, time);
}

void MatchRecording::Impl::write_belief(Last& robot, match::Side side, const mind::Mind& mind, double time) {
  const ToWorld to = to_world(side);
  const regista_track& self = mind.world().local().self();
  begin(time);
  json.key("pose");
  to.pose(json, {self.x, self.y, self.pose.heading});
  json.key("sees_ball").boolean(mind.world().local().sees_ball());
  json.key("mine").open('{');
  world(json, mind.world().mine(), to);
  json.close('}');
  if (with_common[match::index(side)]) {
    json.key("common").open('{');
    world(json, mind.world().common(), to);
    json.close('}');
  }
  json.close('}');
  write(robot.beliefs, time);
}

MatchRecording::MatchRecording(const std::filesystem::path& file, const RecordedSetup& setup, const Options& options)
    : parts_(std::make_unique<Impl>(file, setup, options)) {}

MatchRecording::~MatchRecording() {
  try {
    if (parts_) parts_->writer.close();
  } catch (const mcap::Error&) {
    // The destructor hides errors. A caller that needs errors calls close() before.
  }
}

void MatchRecording::decided(const mind::Mind& mind, const match::Decision& turn) {
  const match::Side side = turn.side;
  const double time = turn.time;
  Impl& parts = *parts_;
  Impl::Last& last = parts.last[match::index(side)][static_cast<std::size_t>(mind.number() - 1)];
  const mind::Decision& decision = mind.decision();
  const bool role_changed = last.written.role != decision.own_role;
  for (const mind::HeardPacket& packet : turn.heard) {
    const auto report = mind::decode(packet.bytes, parts.limits[match::index(side)], parts.heard_segments);
    if (!report) continue;
    parts.begin_of_robot(packet.time_heard, side, mind.number());
    parts.json.key("sender").integer(report->sender).key("sent").number(report->time_sent).close('}');
    parts.write(parts.heard, packet.time_heard);
  }
  if (turn.packet_charged) {
    parts.begin_of_robot(time, side, mind.number());
    parts.json.key("reason").word(parts.plans[match::index(side)]->reason(turn.outcome.send_reason));
    parts.json.key("bytes").integer(static_cast<std::int64_t>(turn.outcome.packet.size())).close('}');
    parts.write(parts.packets, time);
  }
  parts.write_segments(mind, turn);
  parts.write_log(mind, turn);
  parts.write_drawings(mind, turn);
  if (role_changed && decision.own_role >= 0) {
    // Another robot may hold this role already. The next decisions of such robots are written, too.
    for (Impl::Last& other : parts.last[match::index(side)]) other.shares |= other.written.role == decision.own_role;
  }
  if (!last.written.is(decision) || last.shares || time - last.decision >= decision_period - 1e-9) {
    last.shares = false;
    last.decision = time;
    last.written.take(decision);
    parts.write_decision(last, side, mind, time);
  }
  if (role_changed || last.belief < 0.0 || time - last.belief >= belief_period - 1e-9) {
    last.belief = time;
    parts.write_belief(last, side, mind, time);
  }
}

void MatchRecording::event(double time, const match::Event& event, const match::GameState& state) {
  Impl& parts = *parts_;
  parts.begin(time);
  parts.json.key("event").word(match::word(event.kind)).key("side").word(match::name(event.side));
  parts.json.key("robot").integer(event.number);
  if (event.offence != match::Offence::none) parts.json.key("offence").word(match::word(event.offence));
  parts.json.key("score").open('[').integer(state.goals[0]).integer(state.goals[1]).close(']').close('}');
  parts.write(parts.events, time);
}

void MatchRecording::play(double time, const match::PlayEvent& event) {
  Impl& parts = *parts_;
  JsonText& json = parts.json;
  parts.begin(time);
  json.key("kind").word(match::name(event.kind)).key("side").word(match::name(event.side));
  json.key("robot").integer(event.number).key("began").number(event.began);
  json.key("at").open('[').number(event.at.x).number(event.at.y).close(']');
  if (event.outcome != match::PlayOutcome::none) json.key("outcome").word(match::name(event.outcome));
  if (event.kind == match::PlayKind::pass) json.key("receiver").integer(event.receiver);
  if (event.kind == match::PlayKind::duel) {
    json.key("opponent").integer(event.opponent).key("duration").number(event.duration);
  }
  json.close('}');
  parts.write(parts.plays, time);
}

void MatchRecording::stepped(const match::Snapshot& snapshot) {
  Impl& parts = *parts_;
  if (snapshot.time - parts.chunk_began >= parts.at_stake - 1e-9) {
    parts.writer.finish_chunk();
    parts.chunk_began = snapshot.time;
  }
  const match::GameState& state = snapshot.state;
  parts.half = state.half;
  const bool began = state.phase == mind::Phase::playing && parts.phase != mind::Phase::playing;
  parts.phase = state.phase;
  for (int id = 0; std::vector<Impl::Last> & side : parts.last) {
    for (Impl::Last& robot : side) {
      robot.shares |= began;  // the next decision of every robot is written when play begins
      if (snapshot.crashed >> id++ & 1u) robot.written.role = -1;
    }
  }
  if (++parts.steps % game_steps != 0) return;
  JsonText& json = parts.json;
  const auto counts = [&](std::string_view key, const std::array<int, 2>& values) {
    json.key(key).open('[').integer(values[0]).integer(values[1]).close(']');
  };
  const std::size_t team_size = parts.last[0].size();
  const auto robots = [&](std::string_view key, match::RobotSet all) {
    json.key(key).open('[');
    for (const std::size_t side : {0u, 1u}) {
      numbers_of(json, static_cast<std::uint32_t>(all >> (side * team_size) & ((match::RobotSet{1} << team_size) - 1)));
    }
    json.close(']');
  };
  parts.begin(snapshot.time);
  json.key("half").integer(state.half).key("clock").number(state.clock).key("phase").word(match::name(state.phase));
  json.key("set_play").word(match::name(state.set_play)).key("kicking").word(match::name(state.kicking));
  counts("score", state.goals);
  counts("packets_left", state.packets_left);
  robots("penalised", state.penalised[0] | static_cast<match::RobotSet>(state.penalised[1]) << team_size);
  robots("fallen", snapshot.fallen);
  robots("kicks", snapshot.kicking);
  robots("chases", snapshot.chasing);
  const match::BodyState& ball = snapshot.bodies.back();
  json.key("ball").open('[').number(ball.x).number(ball.y).number(ball.vx).number(ball.vy).close(']');
  for (const std::size_t side : {0u, 1u}) {
    json.key(side == 0 ? "home" : "away").open('[');
    for (std::size_t i = 0; i < team_size; ++i) {
      const match::BodyState& body = snapshot.bodies[side * team_size + i];
      json.open('[').number(body.x).number(body.y).number(mind::wrap(body.heading)).close(']');
    }
    json.close(']');
  }
  json.key("roles").open('[');
  for (const auto& side : parts.last) {
    json.open('[');
    for (const Impl::Last& robot : side) json.integer(std::max(robot.written.role, REGISTA_UNKNOWN_TASK + 0));
    json.close(']');
  }
  json.close(']').close('}');
  parts.write(parts.game, snapshot.time);
}

void MatchRecording::close() { parts_->writer.close(); }

}  // namespace regista::recording
