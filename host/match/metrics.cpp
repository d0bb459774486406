// SPDX-License-Identifier: MIT
#include "match/metrics.hpp"

#include <regista/extensions/metric.h>

#include <algorithm>

#include "plugin/description.hpp"

namespace regista::match {

PluginMeasures::PluginMeasures(std::vector<mind::TeamMetric> metrics, int team_size)
    : metrics_(std::move(metrics)), combined_(metrics_.size()), last_told_(metrics_.size()) {
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    if (metrics_[i].combine == REGISTA_METRIC_OVER_TIME) last_told_[i].resize(at(team_size));
  }
}

void PluginMeasures::decided(int number, std::span<const mind::MetricReport> reports) {
  for (const mind::MetricReport& each : reports) {
    const auto metric = static_cast<std::size_t>(each.metric);
    if (metrics_[metric].combine == REGISTA_METRIC_OVER_TIME) {
      std::vector<Told>& robot = last_told_[metric][at(number - 1)];
      const auto known = std::ranges::find(robot, each.place, &Told::place);
      if (known == robot.end())
        robot.push_back({each.place, each.last});
      else
        known->value = each.last;
    } else {
      combined_[metric].add(each);
    }
  }
}

void PluginMeasures::crashed(int number) {
  for (auto& robots : last_told_) {
    if (!robots.empty()) robots[at(number - 1)].clear();
  }
}

void PluginMeasures::sample() {
  for (std::size_t i = 0; i < last_told_.size(); ++i) {
    for (const std::vector<Told>& robot : last_told_[i]) {
      for (const auto& [place, value] : robot) combined_[i].add({0, place, 1, value, value, value, value});
    }
  }
}

PluginMetrics PluginMeasures::result() const {
  PluginMetrics out;
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    const mind::MetricReport& all = combined_[i];
    if (metrics_[i].combine == REGISTA_METRIC_SUM) {
      out.total_names.push_back(metrics_[i].name);
      out.totals.push_back(all.sum);
      continue;
    }
    out.value_names.push_back(metrics_[i].name);
    std::optional<double>& value = out.values.emplace_back();
    if (all.count == 0) continue;
    const std::int32_t combine = metrics_[i].combine;
    value = combine == REGISTA_METRIC_LEAST      ? all.least
            : combine == REGISTA_METRIC_GREATEST ? all.greatest
                                                 : all.sum / static_cast<double>(all.count);
  }
  return out;
}

constexpr double minute = 60.0;  // s

TeamMetrics::TeamMetrics()
    : reasons(plugin::event_names.begin(), plugin::event_names.end()), packets_by_reason(reasons.size(), 0) {}

Metrics::TeamMeasures::TeamMeasures(const config::Rules& rules, const std::vector<Role>& rows,
                                    const std::vector<mind::TeamMetric>& metrics)
    : table(rows),
      roles(rules.team_size, rows),
      agreement(rules.team_size, rows.size()),
      tenures(rules.team_size, rules.durations.half),
      targets(rules.team_size),
      world(rules.team_size),
      plugins(metrics, rules.team_size) {}

Metrics::Metrics(const config::Rules& rules, const std::array<config::Robot, 2>& robots,
                 const std::array<std::vector<Role>, 2>& roles, const std::array<std::vector<std::string>, 2>& reasons,
                 const std::array<std::vector<mind::TeamMetric>, 2>& plugin_metrics)
    : roster_{rules.team_size},
      half_(rules.durations.half),
      teams_{TeamMeasures(rules, roles[0], plugin_metrics[0]), TeamMeasures(rules, roles[1], plugin_metrics[1])},
      ball_(rules.team_size, robots),
      play_(rules) {
  for (const Side side : both_sides) {
    TeamMetrics& team = result_.teams[index(side)];
    if (!reasons[index(side)].empty()) team.reasons = reasons[index(side)];
    team.packets_by_reason.assign(team.reasons.size(), 0);
    team.budget_curve.reserve(static_cast<std::size_t>(half_ * rules.durations.halves / minute) + 1);
  }
  own_.reserve(at(rules.team_size));
  opponents_.reserve(at(rules.team_size));
}

std::uint32_t Metrics::active(Side side, const GameState& state) const {
  return ((1u << roster_.team_size) - 1u) & ~state.penalised[index(side)];
}

void Metrics::decided(Side side, int number, const mind::Outcome& outcome, bool sees_ball, double time,
                      const GameState& state) {
  const bool plays = state.phase == mind::Phase::playing && !state.is_penalised(side, number);
  teams_[index(side)].tenures.decided(number, outcome.role, time, plays);
  result_.teams[index(side)].segments += outcome.segments;
  teams_[index(side)].plugins.decided(number, outcome.metrics);
  took(side, number, outcome, sees_ball, state);
}

void Metrics::crashed(Side side, int number, const GameState& state) {
  teams_[index(side)].tenures.crashed(number);
  teams_[index(side)].plugins.crashed(number);
  took(side, number, {}, false, state);
}

void Metrics::took(Side side, int number, const mind::Outcome& outcome, bool sees_ball, const GameState& state) {
  TeamMeasures& team = teams_[index(side)];
  std::optional<Vector> target;
  if (outcome.target) target = Vector{outcome.target->x, outcome.target->y};
  bool plays_ball = outcome.role >= 0 && team.table[at(outcome.role)].plays_ball;
  // If the behaviour announces a target, this target counts instead of the role's task.
  if (outcome.announced) {
    target = Vector{outcome.announced->x, outcome.announced->y};
    plays_ball = false;
  }
  team.roles.decided(number, outcome.role, outcome.assignment, state.phase == mind::Phase::playing);
  team.agreement.decided(number, outcome.context, outcome.kept);
  team.targets.decided(number, target);
  ball_.decided(roster_.id(side, number), plays_ball, outcome.command.kick.has_value(), target);
  team.world.looked(number, sees_ball);
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
  teams_[index(side)].world.compare(number, belief, {place(bodies.back()), own_, active(side, state), opponents_});
}

void Metrics::sent(Side side, int reason, std::size_t bytes, double time) {
  TeamMetrics& team = result_.teams[index(side)];
  team.packet_bytes += static_cast<std::int64_t>(bytes);
  ++team.packets_by_reason[at(reason)];
  teams_[index(side)].roles.sent(time);
}

void Metrics::stepped(const BodyState& ball, int touched_by, const GameState& state) {
  if (touched_by >= 0) {
    last_touch_ = roster_.side(touched_by);
    ++result_.teams[index(*last_touch_)].touches;
  }
  if (state.phase == mind::Phase::playing) play_.step(ball, touched_by, state.half);
}

void Metrics::sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able) {
  add_minutes(state, result_);
  if (state.phase != mind::Phase::playing) return;
  ++samples_;
  if (state.in_play()) {
    ++in_play_;
    ball_.sample(state, bodies, able);
  }
  for (const Side side : both_sides) {
    TeamMeasures& team = teams_[index(side)];
    const std::uint32_t robots = active(side, state);
    team.roles.sample(robots);
    team.agreement.sample(robots, team.roles.agree(robots));
    team.targets.sample(robots);
    team.world.sample(robots);
    team.plugins.sample();
  }
  play_.sample(state, bodies, last_touch_, able);
}

RobotSet Metrics::chasing(const GameState& state, const BodyState& ball, RobotSet able) const {
  return state.phase == mind::Phase::playing ? ball_.chasing(state, ball, able) : 0;
}

void Metrics::add_minutes(const GameState& state, MatchMetrics& out) const {
  constexpr double rounding = 1e-6;  // s; tolerance, because sums of physics steps are not exact
  const double played = (state.half - 1) * half_ + state.clock + rounding;
  while (static_cast<double>(out.teams[0].budget_curve.size() + 1) * minute <= played) {
    for (std::size_t i = 0; i < 2; ++i) out.teams[i].budget_curve.push_back(state.packets_left[i]);
  }
}

MatchMetrics Metrics::result(const GameState& state, double end) const {
  MatchMetrics out = result_;
  add_minutes(state, out);
  out.playing_seconds = seconds(samples_);
  out.in_play_seconds = seconds(in_play_);
  out.ball_rests = ball_.rests();
  out.ball_crowd_seconds = ball_.crowd_seconds();
  out.duels = play_.duels();
  for (const Side side : both_sides) {
    const TeamMeasures& measures = teams_[index(side)];
    TeamMetrics& team = out.teams[index(side)];
    team.coordination = measures.roles.result(end);
    team.agreement = measures.agreement.result();
    team.tenure = measures.tenures.result();
    team.targets = measures.targets.result();
    team.ball = ball_.result(side);
    team.world_model = measures.world.result();
    team.play = play_.result(side);
    team.plugins = measures.plugins.result();
  }
  return out;
}

}  // namespace regista::match
