// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "texts/message.hpp"

namespace regista::plugin {
namespace {

constexpr double tolerance = 1e-9;  // rounding errors, in m, m^2 and rad

// Largest utility; it keeps sums of weighted terms finite.
constexpr double largest = 1e12;

// Returns whether an entry may be outside of [0, largest]. Tests bits, so that the compiler can check several entries
// in one instruction. An entry is suspect if its sign bit is set (also -0), or if the addition of `exponent_step` sets
// the sign bit. The addition sets the sign bit of numbers from 2^40 on, a little more than `largest`.
bool suspect(std::span<const double> values) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63, exponent_step = std::uint64_t{2048 - 1023 - 40} << 52;
  static_assert(std::numeric_limits<double>::is_iec559);
  std::uint64_t seen = 0;
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    seen |= bits | (bits + exponent_step);
  }
  return (seen & sign) != 0;
}

void check_each(const Instance& instance, std::span<const double> values, std::size_t columns) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (value >= 0.0 && value <= largest) continue;
    const char* const rule = !std::isfinite(value) ? ""
                             : value < 0.0         ? "; utilities are at least 0"
                                                   : "; utilities are at most 1e12";
    instance.fail("score", "row {}, column {} is {}{}", i / columns, i % columns, value, rule);
  }
}

constexpr double fastest = 1e4;  // m/s and rad/s
constexpr double half_turn = std::numbers::pi;

// Returns whether |value| <= limit; false for NaN.
bool within(double value, double limit) { return std::abs(value) <= limit; }

void check_points(const Instance& instance, const regista_frame& frame, std::span<const regista_waypoint> points) {
  const regista_environment& field = instance.environment();
  const double x_limit = field.field_length / 2 + field.border_strip + tolerance;
  const double y_limit = field.field_width / 2 + field.border_strip + tolerance;
  const auto tasks = static_cast<std::int64_t>(frame.tasks.count);
  const auto robots = static_cast<std::int64_t>(field.team_size);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const regista_waypoint& p = points[i];
    if (!(std::abs(p.x) <= x_limit && std::abs(p.y) <= y_limit)) [[unlikely]]
      instance.fail("place", "point {} at ({}, {}) is outside the field", i, p.x, p.y);
    if (!(p.score >= 0.0 && p.score <= std::numeric_limits<double>::max())) [[unlikely]]
      instance.fail("place", "score of point {} is {}; scores are finite and at least 0", i, p.score);
    if (p.task < -1 || p.task >= tasks) [[unlikely]]
      instance.fail("place", "point {} belongs to task {} of {}", i, p.task, tasks);
    if (p.robot < 0 || p.robot > robots) [[unlikely]]
      instance.fail("place", "point {} belongs to robot {} of {}", i, p.robot, robots);
  }
}

void check_edges(const Instance& instance, std::span<const regista_edge> edges, std::size_t point_count) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const regista_edge& edge = edges[i];
    if (edge.from >= point_count || edge.to >= point_count) [[unlikely]]
      instance.fail("place", "edge {} joins points {} and {} of {}", i, edge.from, edge.to, point_count);
    if (edge.from == edge.to) [[unlikely]]
      instance.fail("place", "edge {} joins point {} to itself", i, edge.from);
  }
  if (!instance.rooms().strict) return;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto earlier = std::ranges::find_if(edges.first(i), [&](const regista_edge& each) {
      return std::minmax(each.from, each.to) == std::minmax(edges[i].from, edges[i].to);
    });
    if (earlier != edges.begin() + static_cast<std::ptrdiff_t>(i)) [[unlikely]]
      instance.fail("place", "edge {} joins points {} and {} a second time", i, edges[i].from, edges[i].to);
  }
}

void check_cells(const Instance& instance, std::span<const regista_cell> cells,
                 std::span<const regista_vertex> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const regista_vertex& vertex = vertices[i];
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) [[unlikely]]
      instance.fail("place", "vertex {} is at ({}, {})", i, vertex.x, vertex.y);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const regista_cell& cell = cells[i];
    if (cell.robot < 1 || static_cast<std::uint32_t>(cell.robot) > instance.environment().team_size) [[unlikely]]
      instance.fail("place", "cell {} belongs to robot {} of {}", i, cell.robot, instance.environment().team_size);
    if (cell.first > vertices.size() || cell.count > vertices.size() - cell.first) [[unlikely]] {
      instance.fail("place", "cell {} has {} vertices from {} on, but there are {}", i, cell.count, cell.first,
                    vertices.size());
    }
    double twice_area = 0.0;
    for (std::uint32_t k = 0; k < cell.count; ++k) {
      const regista_vertex& a = vertices[cell.first + k];
      const regista_vertex& b = vertices[cell.first + (k + 1 == cell.count ? 0 : k + 1)];
      twice_area += a.x * b.y - b.x * a.y;
    }
    if (twice_area < -tolerance) [[unlikely]]
      instance.fail("place", "cell {} runs clockwise", i);
  }
}

// Records the fields of the action that the motion uses. Other fields may have any values.
void note_answer(const Instance& instance, const regista_action& action) {
  if (!instance.is_traced()) [[likely]]
    return;
  AnswerDigest used;
  used(action.motion, action.gaze, action.kick);
  const bool walks = action.motion == REGISTA_MOTION_WALK_TO;
  if (walks) used(action.walk, action.pose, std::span<const regista_disc>(action.avoid).first(action.avoid_count));
  if (action.motion == REGISTA_MOTION_VELOCITY || (walks && (action.walk & REGISTA_WALK_CREEP) != 0))
    used(action.velocity);
  if (action.kick != REGISTA_NO_KICK) used(action.kick_direction, action.kick_distance);
  if ((action.flags & REGISTA_ACTION_TARGET) != 0) used(action.target);
  instance.answered(used.value());
}

void check_kick(const Instance& instance, const regista_action& action) {
  const regista_span& kicks = instance.environment().kicks;
  if (action.kick < 0 || static_cast<std::uint32_t>(action.kick) >= kicks.count) [[unlikely]]
    instance.fail("act", "kick {} of {} does not exist", action.kick, kicks.count);
  const auto& kick = static_cast<const regista_kick*>(kicks.data)[action.kick];
  if (!(action.kick_distance >= kick.minimum_distance - tolerance &&
        action.kick_distance <= kick.maximum_distance + tolerance)) [[unlikely]] {
    instance.fail("act", "asks kick {} ({}) to roll {} m; it rolls {} to {} m", action.kick, kick.name,
                  action.kick_distance, kick.minimum_distance, kick.maximum_distance);
  }
  if (!within(action.kick_direction, half_turn + tolerance)) [[unlikely]]
    instance.fail("act", "kick's direction is {}; it is within -pi and pi", action.kick_direction);
}

void check_action(const Instance& instance, const regista_action& action) {
  if (!within(action.gaze, half_turn + tolerance)) [[unlikely]]
    instance.fail("act", "gaze is {}; it is within -pi and pi", action.gaze);
  switch (action.motion) {
    case REGISTA_MOTION_STAND:
      break;
    case REGISTA_MOTION_WALK_TO: {
      const double* pose = action.pose;
      if (!within(pose[0], farthest) || !within(pose[1], farthest) || !within(pose[2], farthest)) [[unlikely]]
        instance.fail("act", "walks to ({}, {}), heading {}", pose[0], pose[1], pose[2]);
      if (action.avoid_count > REGISTA_MOST_AVOIDED) [[unlikely]]
        instance.fail("act", "avoids {} discs; there is room for {}", action.avoid_count, int{REGISTA_MOST_AVOIDED});
      for (const regista_disc& disc : std::span(action.avoid).first(action.avoid_count)) {
        if (!within(disc.x, farthest) || !within(disc.y, farthest) || !within(disc.radius, farthest) ||
            disc.radius < 0.0) [[unlikely]]
          instance.fail("act", "avoids a disc at ({}, {}) of radius {}", disc.x, disc.y, disc.radius);
      }
      if ((action.walk & REGISTA_WALK_CREEP) == 0) break;
      [[fallthrough]];
    }
    case REGISTA_MOTION_VELOCITY: {
      const double* velocity = action.velocity;
      if (!within(velocity[0], fastest) || !within(velocity[1], fastest) || !within(velocity[2], fastest)) [[unlikely]]
        instance.fail("act", "velocity is ({}, {}), turn {}", velocity[0], velocity[1], velocity[2]);
      break;
    }
    default:
      instance.fail("act", "motion {} does not exist", action.motion);
  }
  if (action.kick != REGISTA_NO_KICK) check_kick(instance, action);
  if ((action.flags & REGISTA_ACTION_TARGET) != 0 &&
      !(within(action.target[0], farthest) && within(action.target[1], farthest))) [[unlikely]]
    instance.fail("act", "tells of a target at ({}, {})", action.target[0], action.target[1]);
}

constexpr std::uint32_t longest_description = 256;  // bytes, with the zero at the end

}  // namespace

bool Context::holds(const regista_frame& frame) {
  GuardedBuffer<std::int32_t>& answer = instance_->rooms().holds;
  *instance_->open(answer) = 0;
  instance_->call_with([](Inputs& inputs, const regista_frame* seen, auto*) { inputs.add("frame", seen); }, "holds",
                       calls_->holds, instance_->shown(&frame), answer.data());
  instance_->check("holds", Instance::Written{answer, "whether it holds"});
  const std::int32_t out = *answer.data();
  if (out != 0 && out != 1) [[unlikely]]
    instance_->fail("holds", "{} is neither 0 nor 1", out);
  instance_->answered(out);
  return out == 1;
}

void Positioner::place(const regista_frame& frame, Placement& out) {
  AnswerBuffers& rooms = instance_->rooms();
  regista_placement& raw = *instance_->open(rooms.placement);
  raw = {};
  raw.size = sizeof raw;
  const auto room = [this](auto& guarded, std::uint32_t capacity) {
    auto* const data = instance_->open(guarded, capacity);
    return regista_room{data, capacity, 0, sizeof *data, 0};
  };
  raw.points = room(rooms.points, point_capacity);
  raw.edges = room(rooms.edges, edge_capacity);
  raw.cells = room(rooms.cells, cell_capacity);
  raw.vertices = room(rooms.vertices, vertex_capacity);
  instance_->call_with([](Inputs& inputs, const regista_frame* seen, auto*) { inputs.add("frame", seen); }, "place",
                       calls_->place, instance_->shown(&frame), &raw);
  instance_->check("place", Instance::Written{rooms.placement, "the placement itself"},
                   Instance::Written{rooms.points, "points"}, Instance::Written{rooms.edges, "edges"},
                   Instance::Written{rooms.cells, "cells"}, Instance::Written{rooms.vertices, "vertices"});

  // Reads only the counts of the struct, because the plugin may have overwritten the pointers.
  const auto written = [this](const auto& guarded, std::uint32_t count, const char* what) {
    if (count > guarded.size()) [[unlikely]]
      instance_->fail("place", "wrote {} {} into room for {}", count, what, guarded.size());
    return guarded.first(count);
  };
  const auto points = written(rooms.points, raw.points.count, "points");
  const auto edges = written(rooms.edges, raw.edges.count, "edges");
  const auto cells = written(rooms.cells, raw.cells.count, "cells");
  const auto vertices = written(rooms.vertices, raw.vertices.count, "vertices");
  check_points(*instance_, frame, points);
  check_edges(*instance_, edges, points.size());
  check_cells(*instance_, cells, vertices);
  instance_->answered(points, edges, cells, vertices);
  const auto take = [](auto& to, const auto& from, std::uint32_t capacity) {
    to.reserve(capacity);  // allocates at the first call, so that later calls allocate nothing
    to.assign(from.begin(), from.end());
  };
  take(out.points, points, point_capacity);
  take(out.edges, edges, edge_capacity);
  take(out.cells, cells, cell_capacity);
  take(out.vertices, vertices, vertex_capacity);
}

Utility::Utility(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {
  // Opens the largest buffer that a call may need, so that no call allocates.
  const regista_environment& environment = instance_->environment();
  instance_->rooms().utilities.open(std::size_t{environment.team_size} * environment.roles.count);
}

std::span<const double> Utility::score(const regista_frame& frame, std::size_t rows, std::size_t columns) {
  const std::size_t count = rows * columns;
  if (count == 0) return {};
  GuardedBuffer<double>& entries = instance_->rooms().utilities;
  double* const room = instance_->open(entries, count);
  std::fill_n(room, count, 0.0);
  const regista_matrix_room shown{room, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
                                  static_cast<std::uint32_t>(columns), 0};
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_matrix_room* written_to) {
        inputs.add("frame", seen);
        inputs.add("out", written_to, sizeof *written_to);
      },
      "score", calls_->score, instance_->shown(&frame), &shown);
  instance_->check("score", Instance::Written{entries, "utilities"});
  const std::span<const double> answer = entries.first(count);
  if (suspect(answer)) [[unlikely]]
    check_each(*instance_, answer, columns);
  instance_->answered(answer);
  return answer;
}

Assigner::Assigner(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {
  row_of_column_.reserve(instance_->environment().roles.count);
  instance_->rooms().columns.open(instance_->environment().team_size);
}

void Assigner::assign(const regista_frame& frame, const regista_matrix& utilities, std::span<std::int32_t> out) {
  assert(out.size() == utilities.rows);
  constexpr std::int32_t nobody = -1;
  std::int32_t* const room = instance_->open(instance_->rooms().columns, out.size());
  std::fill_n(room, out.size(), REGISTA_NO_TASK);
  const regista_matrix shown = utilities;  // a copy, because the plugin may overwrite its argument
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_matrix* scored, auto*) {
        inputs.add("frame", seen);
        inputs.add("utilities", scored);
      },
      "assign", calls_->assign, instance_->shown(&frame), &shown, room);
  instance_->check("assign", Instance::Written{instance_->rooms().columns, "columns"});
  std::copy_n(room, out.size(), out.begin());
  row_of_column_.assign(utilities.columns, nobody);
  for (std::size_t row = 0; row < out.size(); ++row) {
    const std::int32_t column = out[row];
    if (column == REGISTA_NO_TASK || column == REGISTA_UNKNOWN_TASK) continue;
    if (column < 0 || static_cast<std::uint32_t>(column) >= utilities.columns) [[unlikely]]
      instance_->fail("assign", "row {} got column {} of {}", row, column, utilities.columns);
    const auto index = static_cast<std::size_t>(column);
    if (utilities.values[row * utilities.stride + index] == -std::numeric_limits<double>::infinity()) [[unlikely]]
      instance_->fail("assign", "row {} got column {}, which is forbidden to it", row, column);
    if (row_of_column_[index] != nobody && !negotiates()) [[unlikely]]
      instance_->fail("assign", "column {} given to rows {} and {}", column, row_of_column_[index], row);
    row_of_column_[index] = static_cast<std::int32_t>(row);
  }
  instance_->answered(std::span<const std::int32_t>(out));
}

const regista_action& Behaviour::act(const regista_frame& frame, const regista_body& body) {
  GuardedBuffer<regista_action>& answer = instance_->rooms().action;
  regista_action& out = *instance_->open(answer);
  out = {};
  out.size = sizeof out;
  out.kick = REGISTA_NO_KICK;
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_body* own, auto*) {
        inputs.add("frame", seen);
        inputs.add("body", own);
      },
      "act", calls_->act, instance_->shown(&frame), &body, &out);
  instance_->check("act", Instance::Written{answer, "the action"});
  check_action(*instance_, out);
  note_answer(*instance_, out);
  return out;
}

constexpr std::size_t most_at_first = 64;  // number of offers for which the first buffer has room

Sender::Sender(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {
  instance_->rooms().granted.open(most_at_first);
}

SendDecision Sender::decide(const regista_frame& frame, std::span<const regista_event> events,
                            std::span<const regista_offer> offers, const regista_budget& budget) {
  GuardedBuffer<regista_send>& answer = instance_->rooms().send;
  GuardedBuffer<std::uint64_t>& handles = instance_->rooms().granted;
  *instance_->open(answer) = {sizeof(regista_send), 0, REGISTA_EVENT_PERIOD, 0,
                              instance_->open(handles, offers.size())};
  const regista_span raw_events{events.data(), static_cast<std::uint32_t>(events.size()), sizeof(regista_event)};
  const regista_span raw_offers{offers.data(), static_cast<std::uint32_t>(offers.size()), sizeof(regista_offer)};
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, regista_span happened, regista_span offered,
         const regista_budget* left, auto*) {
        inputs.add("frame", seen);
        inputs.add("events", happened);
        inputs.add("offers", offered);
        inputs.add("budget", left);
      },
      "decide", calls_->decide, instance_->shown(&frame), raw_events, raw_offers, &budget, answer.data());
  instance_->check("decide", Instance::Written{answer, "whether to send"},
                   Instance::Written{handles, "granted handles"});

  const regista_send& out = *answer.data();
  if (out.send != 0 && out.send != 1) [[unlikely]]
    instance_->fail("decide", "send is {}, neither 0 nor 1", out.send);
  if (out.granted_count > offers.size()) [[unlikely]]
    instance_->fail("decide", "granted {} offers of {}", out.granted_count, offers.size());
  if (out.send == 0) {
    instance_->answered(out.send);
    return {};
  }
  const bool own = out.reason >= REGISTA_REASON_OWN &&
                   static_cast<std::uint32_t>(out.reason - REGISTA_REASON_OWN) < calls_->reason_count;
  if (!own && (out.reason < 0 || out.reason >= REGISTA_EVENT_COUNT)) [[unlikely]]
    instance_->fail("decide", "reason {} does not exist", out.reason);
  const std::span<const std::uint64_t> granted = handles.first(out.granted_count);
  for (std::size_t i = 0; i < granted.size(); ++i) {
    if (std::ranges::find(offers, granted[i], &regista_offer::handle) == offers.end()) [[unlikely]]
      instance_->fail("decide", "granted handle {}, which is not on offer", granted[i]);
    const auto earlier = granted.first(i);
    if (std::ranges::find(earlier, granted[i]) != earlier.end()) [[unlikely]]
      instance_->fail("decide", "granted handle {} twice", granted[i]);
  }
  instance_->answered(out.send, out.reason, granted);
  return {true, out.reason, granted};
}

std::optional<Mailbox> Mailbox::of(std::shared_ptr<Instance> instance) {
  if (!instance->implements(REGISTA_KIND_MAILBOX)) return std::nullopt;
  return Mailbox(std::move(instance));
}

void Mailbox::transmitted(std::uint64_t handle) { instance_->call("transmitted", calls_->transmitted, handle); }

void Mailbox::dropped(std::uint64_t handle) { instance_->call("dropped", calls_->dropped, handle); }

void Mailbox::receive(const regista_message& message) {
  instance_->call_with([](Inputs& inputs, const regista_message* heard) { inputs.add("message", heard); }, "receive",
                       calls_->receive, &message);
}

std::string Mailbox::describe(std::span<const std::uint8_t> bytes) {
  if (calls_->describe == nullptr) return {};
  GuardedBuffer<char>& room = instance_->rooms().text;
  char* const text = instance_->open(room, longest_description);
  text[0] = '\0';
  static constexpr std::uint8_t none = 0;  // makes the pointer valid for a message without bytes
  instance_->call_with([](Inputs& inputs, const std::uint8_t* said, std::uint32_t count, char*,
                          std::uint32_t) { inputs.add("bytes", said, count); },
                       "describe", calls_->describe, bytes.empty() ? &none : bytes.data(),
                       static_cast<std::uint32_t>(bytes.size()), text, longest_description);
  instance_->check("describe", Instance::Written{room, "text"});
  const char* const end = std::find(text, text + longest_description, '\0');
  if (end == text + longest_description) {
    instance_->fail("describe", "the text does not end within {} bytes", longest_description);
  }
  const std::string_view said(text, static_cast<std::size_t>(end - text));
  if (said.find_first_of("\r\n") != std::string_view::npos) instance_->fail("describe", "the text is not one line");
  if (texts::visible(said) != said) {
    instance_->fail("describe", "the text is no plain UTF-8: {}", texts::in_quotes(said));
  }
  return std::string(said);
}

}  // namespace regista::plugin
