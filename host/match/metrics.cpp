// SPDX-License-Identifier: MIT
#include "match/metrics.hpp"

#include "match/sampling.hpp"
#include "plugin/event_names.hpp"

namespace regista::match {
namespace {

constexpr double minute = 60.0;  // s

}  // namespace

TeamMetrics::TeamMetrics()
    : reasons(plugin::event_names.begin(), plugin::event_names.end()), packets_by_reason(reasons.size(), 0) {}

Metrics::Metrics(const config::Rules& rules, const std::array<config::Robot, 2>& robots,
                 const std::array<std::vector<Role>, 2>& roles, const std::array<std::vector<std::string>, 2>& reasons,
                 const std::array<std::vector<mind::TeamMetric>, 2>& plugin_metrics)
    : roster_{rules.team_size},
      half_(rules.durations.half),
      table_(roles),
      roles_{RoleMeasures(rules.team_size, roles[0]), RoleMeasures(rules.team_size, roles[1])},
      agreements_{AgreementMeasures(rules.team_size, roles[0].size()),
                  AgreementMeasures(rules.team_size, roles[1].size())},
      tenures_{TenureMeasures(rules.team_size, half_), TenureMeasures(rules.team_size, half_)},
      targets_{TargetMeasures(rules.team_size), TargetMeasures(rules.team_size)},
      ball_(rules.team_size, robots),
      worlds_{WorldMeasures(rules.team_size), WorldMeasures(rules.team_size)},
      plugins_{PluginMeasures(plugin_metrics[0], rules.team_size), PluginMeasures(plugin_metrics[1], rules.team_size)},
      play_(rules) {
  for (const Side side : both_sides) {
    if (reasons[index(side)].empty()) continue;
    TeamMetrics& team = result_.teams[index(side)];
    team.reasons = reasons[index(side)];
    team.packets_by_reason.assign(team.reasons.size(), 0);
  }
  own_.reserve(at(rules.team_size));
  opponents_.reserve(at(rules.team_size));
  for (TeamMetrics& team : result_.teams) {
    team.budget_curve.reserve(static_cast<std::size_t>(half_ * rules.durations.halves / minute) + 1);
  }
}

std::uint32_t Metrics::active(Side side, const GameState& state) const {
  return ((1u << roster_.team_size) - 1u) & ~state.penalised[index(side)];
}

void Metrics::decided(Side side, int number, const mind::Outcome& outcome, bool sees_ball, double time,
                      const GameState& state) {
  const bool plays = state.phase == mind::Phase::playing && !state.is_penalised(side, number);
  tenures_[index(side)].decided(number, outcome.role, time, plays);
  SegmentMetrics& segments = result_.teams[index(side)].segments;
  segments.offered += outcome.segments.offered;
  segments.refused += outcome.segments.refused;
  segments.sent += outcome.segments.sent;
  segments.dropped += outcome.segments.dropped;
  segments.heard += outcome.segments.heard;
  segments.bytes += outcome.segments.bytes;
  plugins_[index(side)].decided(number, outcome.metrics);
  took(side, number, outcome, sees_ball, state);
}

void Metrics::crashed(Side side, int number, const GameState& state) {
  tenures_[index(side)].crashed(number);
  plugins_[index(side)].crashed(number);
  took(side, number, {}, false, state);
}

void Metrics::took(Side side, int number, const mind::Outcome& outcome, bool sees_ball, const GameState& state) {
  const std::size_t i = index(side);
  std::optional<Vector> target;
  if (outcome.target) target = Vector{outcome.target->x, outcome.target->y};
  bool plays_ball = outcome.role >= 0 && table_[i][at(outcome.role)].plays_ball;
  // Whoever says where it goes goes there, whatever its role.
  if (outcome.announced) {
    target = Vector{outcome.announced->x, outcome.announced->y};
    plays_ball = false;
  }
  roles_[i].decided(number, outcome.role, outcome.assignment, state.phase == mind::Phase::playing);
  agreements_[i].decided(number, outcome.context, outcome.kept);
  targets_[i].decided(number, target);
  ball_.decided(roster_.id(side, number), plays_ball, outcome.command.kick.has_value(), target);
  worlds_[i].looked(number, sees_ball);
}

void Metrics::believes(Side side, int number, const Belief& belief, std::span<const BodyState> bodies,
                       const GameState& state) {
  const double direction = attack(side, state.half);
  const auto place = [direction](const BodyState& body) { return direction * Vector{body.x, body.y}; };
  own_.clear();
  opponents_.clear();
  for (int id = 0; id < roster_.count(); ++id) {
    const Side whose = roster_.side(id);
    if (whose == side) {
      own_.push_back(place(bodies[at(id)]));
    } else if (!state.is_penalised(whose, roster_.number(id))) {
      opponents_.push_back(place(bodies[at(id)]));
    }
  }
  worlds_[index(side)].compare(number, belief, {place(bodies.back()), own_, active(side, state), opponents_});
}

void Metrics::sent(Side side, int reason, std::size_t bytes, double time) {
  TeamMetrics& team = result_.teams[index(side)];
  ++team.packets;
  team.packet_bytes += static_cast<std::int64_t>(bytes);
  ++team.packets_by_reason[at(reason)];
  roles_[index(side)].sent(time);
}

void Metrics::stepped(const BodyState& ball, int touched_by, const GameState& state) {
  if (touched_by >= 0) {
    last_touch_ = roster_.side(touched_by);
    ++result_.teams[index(*last_touch_)].touches;
  }
  if (state.phase == mind::Phase::playing) play_.step(ball, touched_by, state.half);
}

void Metrics::sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able) {
  add_minutes(state, {&result_.teams[0].budget_curve, &result_.teams[1].budget_curve});
  if (state.phase != mind::Phase::playing) return;
  ++samples_;
  if (state.in_play()) {
    ++in_play_;
    ball_.sample(state, bodies, able);
  }
  for (const Side side : both_sides) {
    const std::size_t i = index(side);
    const std::uint32_t robots = active(side, state);
    roles_[i].sample(robots);
    agreements_[i].sample(robots, roles_[i].agree(robots));
    targets_[i].sample(robots);
    worlds_[i].sample(robots);
    plugins_[i].sample();
  }
  play_.sample(state, bodies, last_touch_, able);
}

RobotSet Metrics::chasing(const GameState& state, const BodyState& ball, RobotSet able) const {
  return state.phase == mind::Phase::playing ? ball_.chasing(state, ball, able) : 0;
}

void Metrics::add_minutes(const GameState& state, std::array<std::vector<int>*, 2> curves) const {
  constexpr double rounding = 1e-6;  // s
  const double played = (state.half - 1) * half_ + state.clock + rounding;
  while (static_cast<double>(curves[0]->size() + 1) * minute <= played) {
    for (const Side side : both_sides) curves[index(side)]->push_back(state.packets_left[index(side)]);
  }
}

MatchMetrics Metrics::result(const GameState& state, double end) const {
  MatchMetrics out = result_;
  add_minutes(state, {&out.teams[0].budget_curve, &out.teams[1].budget_curve});
  out.playing_seconds = seconds(samples_);
  out.in_play_seconds = seconds(in_play_);
  out.ball_rests = ball_.rests();
  out.ball_crowd_seconds = ball_.crowd_seconds();
  out.duels = play_.duels();
  for (const Side side : both_sides) {
    TeamMetrics& team = out.teams[index(side)];
    team.coordination = roles_[index(side)].result(end);
    team.agreement = agreements_[index(side)].result();
    team.tenure = tenures_[index(side)].result();
    team.targets = targets_[index(side)].result();
    team.ball = ball_.result(side);
    team.world_model = worlds_[index(side)].result();
    team.play = play_.result(side);
    team.plugins = plugins_[index(side)].result();
  }
  return out;
}

}  // namespace regista::match
