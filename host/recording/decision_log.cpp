// SPDX-License-Identifier: MIT
#include "recording/decision_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "match/game_state.hpp"
#include "match/teams.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

using Json = nlohmann::ordered_json;

constexpr double millimetres = 1e3, millionths = 1e6;  // parts of a metre and of 1 to which values are rounded

double rounded(double value, double parts) { return std::round(value * parts) / parts; }

Json point(double x, double y) { return {rounded(x, millimetres), rounded(y, millimetres)}; }
Json pose(double x, double y, double heading) {
  return {rounded(x, millimetres), rounded(y, millimetres), rounded(heading, millimetres)};
}
Json pose(const double (&values)[3]) { return pose(values[0], values[1], values[2]); }
Json pose(const match::BodyState& body, double direction) {
  const mind::Pose own = match::in_field_frame({body.x, body.y, body.heading}, direction);
  return pose(own.x, own.y, own.heading);
}

std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

// Returns the name of a role; null for no role, "unknown" while the negotiation has not ended.
Json role_or_null(const std::vector<std::string>& names, int role) {
  if (role == REGISTA_UNKNOWN_TASK) return "unknown";
  if (role < 0) return nullptr;
  return names[static_cast<std::size_t>(role)];
}

Json ball(const mind::DistributedWorldModel& world) {
  if (!world.ball_known()) return nullptr;
  return {{"position", point(world.ball().x(), world.ball().y())}, {"age", rounded(world.ball_state.age, millimetres)}};
}

// Returns the robot's own row of the utility estimation matrix, by task; null if the robot has no row.
Json utilities(const mind::Mind& mind, const std::vector<std::string>& names) {
  const mind::Decision& decision = mind.decision();
  if (decision.context < 0) return nullptr;
  const bool common = decision.frame.knowledge == REGISTA_COMMON;
  const auto& active = (common ? mind.world().common() : mind.world().mine()).active;
  const auto own = std::ranges::find(active, mind.number());
  const std::size_t columns = decision.columns.size();
  if (own == active.end() || decision.utility.values().size() != active.size() * columns) return nullptr;
  const double* const row = decision.utility.values().data() + static_cast<std::size_t>(own - active.begin()) * columns;
  Json out = Json::object();
  for (std::size_t j = 0; j < columns; ++j) {
    const std::string& task = names[static_cast<std::size_t>(decision.columns[j].id)];
    out[task] = std::isfinite(row[j]) ? Json(rounded(row[j], millionths)) : Json(nullptr);
  }
  return out;
}

}  // namespace

DecisionLog::DecisionLog(Write write, const std::array<const mind::TeamPlan*, 2>& plans, std::uint64_t seed)
    : plans_(plans), write_(std::move(write)) {
  for (const match::Side side : match::both_sides) {
    const std::size_t i = match::index(side);
    last_[i].resize(static_cast<std::size_t>(plans[i]->rules().team_size));
    role_names_[i] = match::role_names(match::roles(*plans[i]));
  }
  write_(line(
      {{"kind", "match"}, {"time", 0.0}, {"teams", {plans[0]->team().name, plans[1]->team().name}}, {"seed", seed}}));
}

void DecisionLog::write_segments(const mind::Mind& mind, const match::Decision& turn) {
  for (const mind::SegmentEvent& event : mind.segments()) {
    const std::uint64_t handle = sent_.follow(turn.side, mind.number(), event);
    segment_.clear();
    segment_.open('{').key("kind").word("segment").key("time").number(turn.time);
    recording::write(segment_, {turn.side, mind.number(), event, handle, turn.packet_charged});
    segment_.close('}');
    write_(std::string(segment_.text()) + '\n');
  }
}

void DecisionLog::decided(const mind::Mind& mind, const match::Decision& turn) {
  write_segments(mind, turn);
  const match::Side side = turn.side;
  const std::size_t i = match::index(side);
  LastDecision& last = last_[i][static_cast<std::size_t>(mind.number() - 1)];
  const mind::Decision& decision = mind.decision();
  if (!turn.packet_charged && last.is(decision)) return;
  last.take(decision);

  const std::vector<std::string>& names = role_names_[i];
  const mind::Pose own = mind.world().local().pose();
  Json out{{"kind", "decision"},     {"time", rounded(turn.time, millimetres)}, {"side", match::name(side)},
           {"robot", mind.number()}, {"pose", pose(own.x, own.y, own.heading)}, {"ball", ball(mind.world().mine())}};
  const auto& contexts = plans_[i]->team().contexts;
  out["context"] =
      decision.context < 0 ? Json(nullptr) : Json(contexts[static_cast<std::size_t>(decision.context)].name);
  out["waypoints"] = decision.placement.points.size();
  Json& kept = out["kept"] = Json::array();
  for (const std::int32_t task : last.kept) kept.push_back(role_or_null(names, task));
  out["role"] = role_or_null(names, decision.own_role);
  out["target"] = nullptr;
  if (const regista_task* task = decision.own_task; task != nullptr) {
    out["target"] = {{"before", pose(task->before)}, {"after", pose(task->after)}};
  }
  Json& assignment = out["assignment"] = Json::array();
  for (const std::int32_t role : decision.role_of) assignment.push_back(role_or_null(names, role));
  out["utility"] = utilities(mind, names);
  out["packet"] = turn.packet_charged ? Json(plans_[i]->reason(turn.outcome.send_reason)) : Json(nullptr);
  write_(line(out));
}

void DecisionLog::event(double time, const match::Event& event, const match::GameState& state) {
  Json out{{"kind", "event"},
           {"time", rounded(time, millimetres)},
           {"event", match::word(event.kind)},
           {"side", match::name(event.side)},
           {"robot", event.number > 0 ? Json(event.number) : Json(nullptr)},
           {"score", state.goals}};
  if (event.offence != match::Offence::none) out["offence"] = match::word(event.offence);
  write_(line(out));
}

void DecisionLog::stepped(const match::Snapshot& snapshot) {
  if (++steps_ % match::physics_steps_per_second != 0) return;
  const match::GameState& state = snapshot.state;
  const double direction = match::attack(match::Side::home, state.half);
  const auto team_size = static_cast<std::ptrdiff_t>(plans_[0]->rules().team_size);
  const auto team = [&](std::ptrdiff_t first) {
    Json robots = Json::array();
    for (std::ptrdiff_t id = first; id < first + team_size; ++id) {
      robots.push_back(pose(snapshot.bodies[static_cast<std::size_t>(id)], direction));
    }
    return robots;
  };
  const match::BodyState& body = snapshot.bodies.back();
  Json out{{"kind", "truth"},
           {"time", rounded(snapshot.time, millimetres)},
           {"half", state.half},
           {"clock", rounded(state.clock, millimetres)},
           {"phase", match::name(state.phase)},
           {"set_play", match::name(state.set_play)},
           {"score", state.goals},
           {"packets_left", state.packets_left},
           {"ball", point(direction * body.x, direction * body.y)},
           {"home", team(0)},
           {"away", team(team_size)}};
  write_(line(out));
}

}  // namespace regista::recording
