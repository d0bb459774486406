// SPDX-License-Identifier: MIT
#include "mind/mind.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "config/rules.hpp"
#include "mind/assembly.hpp"
#include "mind/body/walking.hpp"

namespace regista::mind {
namespace {

constexpr double time_rounding = 1e-3;  // s; packets round times to milliseconds

}  // namespace

struct Mind::Impl {
  Impl(const TeamPlan& team_plan, int own_number, std::uint64_t seed, plugin::CallTracing tracing, MindOptions options)
      : plan(team_plan),
        made(options.whole_frame ? FrameParts{} : team_plan.frame_parts()),
        number(own_number),
        caller{team_plan.team().name, own_number, 0, tracing, &rooms},
        extensions(caller, std::move(options.log), options.drawings),
        mailboxes(static_cast<std::size_t>(team_plan.rules().messages.size), options.segments),
        assembly(team_plan, own_number, seed, mailboxes, extensions, caller),
        // Braces fix the order of evaluation, and so the order in which plugins are created; parentheses do not.
        world{team_plan, own_number, assembly.local_model(), assembly.team_model(), made},
        coordination(team_plan, own_number, assembly.contexts(), made),
        detector(own_number),
        behaviours(assembly.behaviours()) {
    limits.team_size = plan.rules().team_size;
    limits.role_count = static_cast<int>(plan.roles().size());
    limits.context_count = static_cast<int>(plan.contexts().size());
    limits.size = static_cast<std::size_t>(plan.rules().messages.size);
    extensions.answer_with(
        {[this](int of) { return of < 1 || of > limits.team_size ? nullptr : world.team().report(of); },
         [this] { return world.local().sees_ball(); }, [this] { return budget(); }});
    events.reserve(REGISTA_EVENT_COUNT);
    segments.reserve(limits.size / segment_heading);
    points_near.reserve(RobotMemory::most);
  }

  void listen_to(const HeardPacket& packet);
  Vector2d target() const;
  regista_body body(const Percepts& percepts);
  Command act(const Percepts& percepts);
  void decide_to_send(const Percepts& percepts, Outcome& out);
  regista_budget budget() const;
  Report report(const Percepts& percepts) const;
  void say_receiver(Command& command);

  const TeamPlan& plan;
  FrameParts made;
  int number;
  plugin::AnswerBuffers rooms;
  plugin::Caller caller;
  PacketLimits limits;
  Extensions extensions;
  Mailboxes mailboxes;
  Assembly assembly;
  WorldModel world;
  Coordination coordination;
  EventDetector detector;
  std::vector<plugin::Behaviour> behaviours;
  RobotMemory robots_near;
  std::vector<regista_point> points_near;
  std::optional<Vector2d> told_target;  // target that the behaviour announces; empty: the task's place is the target

  GameTold game;  // state of the game in this decision
  bool first = true;
  double now = 0.0;
  double own_sent_at = 0.0, team_sent_at = 0.0;
  std::vector<regista_event> events;
  std::vector<Segment> segments;
};

Mind::Mind(const TeamPlan& plan, int number, std::uint64_t seed, plugin::CallTracing tracing, MindOptions options)
    : parts_(std::make_unique<Impl>(plan, number, seed, tracing, std::move(options))) {}
Mind::~Mind() = default;
Mind::Mind(Mind&&) noexcept = default;
Mind& Mind::operator=(Mind&&) noexcept = default;

const Decision& Mind::decision() const { return parts_->coordination.decision(); }
const WorldModel& Mind::world() const { return parts_->world; }
std::span<const regista_event> Mind::events() const { return parts_->events; }
std::span<const SegmentEvent> Mind::segments() const { return parts_->mailboxes.journal(); }
std::span<const LogLine> Mind::log() const { return parts_->extensions.log().lines(); }
std::span<const DrawnShape> Mind::drawings() const { return parts_->extensions.drawings().shapes(); }
int Mind::number() const { return parts_->number; }
const Part& Mind::part(int place) const { return parts_->assembly.part(static_cast<std::size_t>(place)); }

void Mind::think(const Percepts& percepts, std::span<const HeardPacket> heard, Outcome& out) {
  Impl& parts = *parts_;
  const double dt = parts.first ? 0.0 : percepts.time - parts.now;
  assert(dt >= 0.0);
  out.clear();
  parts.now = percepts.time;
  parts.game = percepts.game;
  parts.caller.begin_decision();
  parts.extensions.begin(percepts.time);
  parts.mailboxes.begin(percepts.time);

  parts.world.sense(percepts, dt, parts.coordination.last_frame());
  for (const HeardPacket& packet : heard) parts.listen_to(packet);
  const Decision& last = parts.coordination.decision();
  parts.world.fuse(percepts, dt, {last.own_role, last.own_role_since, parts.target()});
  const Decision& decision = parts.coordination.decide(parts.world, percepts.time, parts.caller.tick);
  out.command = parts.act(percepts);
  parts.say_receiver(out.command);
  parts.decide_to_send(percepts, out);
  out.role = decision.own_role;
  out.assignment.assign(decision.role_of.begin(), decision.role_of.end());
  out.context = decision.context;
  for (const regista_task& task : decision.columns) out.kept.push_back(task.id);
  if (decision.own_task != nullptr) out.target = Target{decision.own_task->after[0], decision.own_task->after[1]};
  if (parts.told_target) out.announced = Target{parts.told_target->x(), parts.told_target->y()};
  out.segments = parts.mailboxes.take_counts();
  parts.extensions.metrics().take(out.metrics);
  if (const auto& wrong = parts.extensions.metrics().violation()) {
    throw plugin::Failure(*wrong->plugin, &parts.caller, "metric", wrong->what);
  }
  parts.extensions.mute(true);
  parts.mailboxes.complete_journal();
  parts.extensions.mute(false);
  parts.first = false;
  ++parts.caller.tick;
}

void Mind::Impl::say_receiver(Command& command) {
  const std::optional<MeantPass>& pass = extensions.pass();
  if (!command.kick || !pass) return;
  if (pass->receiver < 1 || pass->receiver > limits.team_size || pass->receiver == number) {
    throw plugin::Failure(*pass->plugin, &caller, "pass",
                          "a kick meant for robot " + std::to_string(pass->receiver) +
                              "; teammates are those from 1 to " + std::to_string(limits.team_size) + " but " +
                              std::to_string(number));
  }
  command.kick->receiver = pass->receiver;
}

void Mind::Impl::listen_to(const HeardPacket& packet) {
  const std::optional<Report> report = decode(packet.bytes, limits, segments);
  // A packet is noise if it names this robot as sender or a sending time in the future.
  const auto is_noise = [&](const Report& told) {
    return told.sender == number || told.time_sent > now + time_rounding;
  };
  if (!report) {
    const std::optional<Report> core = decode_core(packet.bytes, limits);
    if (core && !is_noise(*core)) mailboxes.wrong_length(core->sender, core->time_sent, packet.time_heard);
    return;
  }
  if (is_noise(*report)) return;
  world.hear(*report, now);
  team_sent_at = std::max(team_sent_at, report->time_sent);
  for (std::size_t at = 0; at < segments.size(); ++at) {
    mailboxes.deliver(segments[at], static_cast<int>(at), report->sender, report->time_sent, packet.time_heard);
  }
}

// Returns the target that this robot's packets contain.
Vector2d Mind::Impl::target() const {
  if (told_target) return *told_target;
  const regista_task* task = coordination.decision().own_task;
  return task != nullptr ? Vector2d(task->after[0], task->after[1]) : position(world.local().pose());
}

regista_body Mind::Impl::body(const Percepts& percepts) {
  const Decision& decision = coordination.decision();
  const auto flag = [](bool is, std::uint32_t bit) { return is ? bit : 0u; };
  points_near.clear();
  for (const Vector2d& each : robots_near.positions()) points_near.push_back({each.x(), each.y()});
  const Pose pose = world.local().pose();
  regista_body out{};
  out.size = sizeof out;
  out.flags = flag(world.local().sees_ball(), REGISTA_BODY_SEES_BALL) |
              flag(world.ball_refuted(), REGISTA_BODY_BALL_REFUTED) | flag(percepts.fallen, REGISTA_BODY_FALLEN) |
              flag(percepts.penalised, REGISTA_BODY_PENALISED) | flag(percepts.kicking, REGISTA_BODY_KICKING) |
              flag(percepts.contact.has_value(), REGISTA_BODY_TOUCHED);
  out.task = decision.own_task == nullptr ? -1 : static_cast<std::int32_t>(decision.own_task - decision.columns.data());
  out.pose[0] = pose.x;
  out.pose[1] = pose.y;
  out.pose[2] = pose.heading;
  out.motion[0] = percepts.odometry.x;
  out.motion[1] = percepts.odometry.y;
  out.motion[2] = percepts.odometry.heading;
  out.head_yaw = percepts.view.heading;
  out.time_until_up = percepts.time_until_up;
  out.contact = percepts.contact.value_or(0.0);
  out.robots_near = abi_span(points_near);
  return out;
}

Command Mind::Impl::act(const Percepts& percepts) {
  robots_near.update(percepts, world.local().frame(), 2.0 * plan.robot().body.radius);
  const int role = coordination.decision().own_role;
  const std::size_t behaviour =
      role < 0 ? plan.behaviour_without_role() : plan.roles()[static_cast<std::size_t>(role)].behaviour;
  const regista_action& action = behaviours[behaviour].act(coordination.decision().frame, body(percepts));
  told_target.reset();
  if ((action.flags & REGISTA_ACTION_TARGET) != 0) told_target.emplace(action.target[0], action.target[1]);
  return carry_out({plan.rules(), plan.robot(), world.mine(), number, world.local().pose(), world.local().frame(),
                    robots_near.positions()},
                   action);
}

regista_budget Mind::Impl::budget() const {
  const config::Rules& rules = plan.rules();
  const double sending_left = sending_time_left(rules.durations, game);
  regista_budget out{};
  out.size = sizeof out;
  out.packets_left = game.packets_left;
  out.line = config::packet_line(rules, sending_left);
  out.match_time_left = config::packet_time_left(rules, sending_left);
  out.since_own = now - own_sent_at;
  out.since_team = now - std::max(own_sent_at, team_sent_at);
  out.bytes_free = mailboxes.bytes_free();
  out.share = rules.messages.share;
  return out;
}

void Mind::Impl::decide_to_send(const Percepts& percepts, Outcome& out) {
  const Decision& decision = coordination.decision();
  const bool searching = decision.own_role >= 0 && (plan.purposes(decision.own_role) & REGISTA_BEHAVIOUR_SEARCHES) != 0;
  detector.detect(percepts, world, decision, searching, events);

  const Phase phase = percepts.game.phase;
  const bool may_send = phase == Phase::ready || phase == Phase::set || phase == Phase::playing;
  if (!may_send || percepts.penalised || decision.context < 0) return;

  const plugin::SendDecision send_decision =
      coordination.sender().decide(decision.frame, events, mailboxes.pending(), budget());
  if (!send_decision.send) return;
  out.send = true;
  out.packet.reserve(limits.size);  // reserves all memory at once, so that segments cause no later allocation
  encode(report(percepts), out.packet);
  out.send_reason = send_decision.reason;
  if (send_decision.reason >= REGISTA_REASON_OWN) {
    const ContextPlan& context = plan.contexts()[static_cast<std::size_t>(decision.context)];
    out.send_reason = context.own_reasons[static_cast<std::size_t>(send_decision.reason - REGISTA_REASON_OWN)];
  }
  mailboxes.load(send_decision.granted, out.packet);
  own_sent_at = now;
  // Decodes this robot's own packet, because all robots' common worlds must contain the same rounded values.
  const std::optional<Report> decoded = decode(out.packet, limits, segments);
  assert(decoded);
  if (decoded) world.hear(*decoded, now);
}

Report Mind::Impl::report(const Percepts& percepts) const {
  const Decision& decision = coordination.decision();
  const regista_track& self = world.local().self();
  Report report;
  report.sender = number;
  report.time_sent = now;
  report.pose = world.local().pose();
  report.position_deviation = std::sqrt(0.5 * (self.covariance[0] + self.covariance[2]));
  report.heading_deviation = std::sqrt(self.pose.heading_variance);
  report.velocity = {self.vx, self.vy};
  report.target = target();
  report.fallen = percepts.fallen;
  report.time_until_up = percepts.time_until_up;
  report.playing = world.mine().game.phase == REGISTA_PHASE_PLAYING;
  report.role = decision.own_role;
  report.role_since = decision.own_role_since;
  report.context = decision.context;
  const auto balls = world.local().balls();
  if (!balls.empty() && balls.front().age < Report::tells_ball_for) {
    const regista_track& ball = balls.front();
    // Reports velocity 0 if the track's velocity is unreliable, because teammates move the ball with this velocity.
    const bool moves = (ball.flags & REGISTA_TRACK_VELOCITY) != 0;
    report.ball = ReportedBall{{ball.x, ball.y},
                               moves ? Vector2d(ball.vx, ball.vy) : Vector2d(0.0, 0.0),
                               std::sqrt(0.5 * (ball.covariance[0] + ball.covariance[2])),
                               ball.age};
  }
  // Chooses the five opponents that were seen last; of two opponents with equal age, the likelier one.
  std::array<regista_track, Report::most_opponents> youngest;
  const auto key = [](const regista_track& track) { return std::tuple(track.age, -track.weight, track.label); };
  const auto end = std::ranges::partial_sort_copy(world.local().opponents(), youngest, {}, key, key).out;
  for (const regista_track& track : std::span(youngest.begin(), end)) {
    if (track.age > Report::tells_opponents_for) break;
    report.opponents[report.opponent_count++] = {
        {track.x, track.y}, std::sqrt(0.5 * (track.covariance[0] + track.covariance[2])), track.age};
  }
  return report;
}

}  // namespace regista::mind
