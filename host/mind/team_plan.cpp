// SPDX-License-Identifier: MIT
#include "mind/team_plan.hpp"

#include <algorithm>

#include "mind/world/world_model.hpp"
#include "plugin/description.hpp"

namespace regista::mind {

TeamPlan::TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
                   config::Mistakes&& mistakes)
    : TeamPlan(std::move(team), std::move(rules), std::move(robot), catalogue, mistakes) {}

TeamPlan::TeamPlan(config::Team team, config::Rules rules, config::Robot robot, const plugin::Catalogue& catalogue,
                   config::Mistakes& mistakes)
    : team_(std::move(team)), rules_(std::move(rules)), robot_(std::move(robot)) {
  const auto part = [&](const config::PluginUse& use, int kind, unsigned subject = 0) {
    Part out{nullptr, {}, use};
    // A plugin without a name, or at a location of Mistakes::doubt_place(), belongs to a mistake reported before.
    if (use.plugin.empty() || mistakes.doubtful_place(use.where)) return out;
    mistakes.attempt("", [&] {
      out.found = &catalogue.find(use, kind, subject);
      out.parameters = plugin::resolve(*out.found->descriptor, use, mistakes);
    });
    return out;
  };
  self_ = part(team_.self, REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_SELF);
  ball_ = part(team_.ball, REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_BALL);
  opponents_ = part(team_.opponents, REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_OPPONENTS);
  teammates_ = part(team_.teammates, REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_TEAMMATES);
  for (const config::Context& context : team_.contexts) {
    ContextPlan& parts = contexts_.emplace_back();
    if (!context.positioner.plugin.empty()) parts.positioner = part(context.positioner, REGISTA_KIND_POSITIONER);
    for (const config::UtilityTerm& term : context.terms) {
      parts.terms.push_back({term.name, term.weight, part(term.use, REGISTA_KIND_UTILITY)});
    }
    parts.condition = part(context.use, REGISTA_KIND_CONTEXT);
    parts.assigner = part(context.assigner, REGISTA_KIND_ASSIGNER);
    parts.sender = part(context.sender, REGISTA_KIND_SENDER);
  }

  const auto behaviour = [&](const std::string& name, const config::Location& where) {
    const auto known = std::ranges::find(behaviours_, name, &BehaviourPlan::name);
    if (known != behaviours_.end()) return static_cast<std::size_t>(known - behaviours_.begin());
    behaviours_.push_back({name, part(team_.behaviour_named(name, where), REGISTA_KIND_BEHAVIOUR)});
    return behaviours_.size() - 1;
  };
  for (std::size_t list = 0; list < team_.role_lists.size(); ++list) {
    const config::RoleList& roles = team_.role_lists[list];
    first_role_.push_back(static_cast<int>(roles_.size()));
    for (std::size_t i = 0; i < roles.roles.size(); ++i) {
      const config::Role& role = roles.roles[i];
      roles_.push_back(
          {&role, static_cast<int>(list), static_cast<int>(i), behaviour(role.behaviour, role.behaviour_where)});
      role_table_.push_back({role.name.c_str(), roles.name.c_str(), static_cast<std::int32_t>(i),
                             role.robots.empty() ? 0 : role.robots.front()});
    }
  }
  behaviour_without_role_ = behaviour(team_.behaviour_without_role, team_.behaviour_without_role_where);
  // Also checks the behaviours that no role names, because these may contain mistakes.
  for (const config::Behaviour& each : team_.behaviours) behaviour(each.name, each.use.where);
  constexpr std::size_t most_roles = 254;  // a packet has one byte for the role, with one value for "none"
  if (roles_.size() > most_roles) {
    mistakes.add(config::Error(team_.where, "a team may name at most 254 roles in all its lists, this one has " +
                                                std::to_string(roles_.size())),
                 "roles");
  }
  landmarks_ = landmarks(rules_.field);
  name_reasons();
  name_metrics(mistakes);
  collect_reads();
  for (const config::Kick& kick : robot_.kicks) {
    kicks_.push_back({kick.name.c_str(), kick.minimum_distance, kick.maximum_distance, kick.duration, kick.impact,
                      kick.distance_noise, kick.direction_noise});
  }
}

void TeamPlan::name_reasons() {
  for (std::size_t kind = 0; kind < plugin::event_names.size(); ++kind) {
    events_.push_back({static_cast<std::int32_t>(kind), 0, plugin::event_names[kind]});
    reasons_.emplace_back(plugin::event_names[kind]);
  }
  for (ContextPlan& context : contexts_) {
    if (context.sender.found == nullptr) continue;
    for (const std::string& name : context.sender.found->description->reasons()) {
      const auto known = std::ranges::find(reasons_, name);
      context.own_reasons.push_back(static_cast<int>(known - reasons_.begin()));
      if (known == reasons_.end()) reasons_.push_back(name);
    }
  }
}

void TeamPlan::name_metrics(config::Mistakes& mistakes) {
  for (const Part* part : parts()) {
    if (part->found == nullptr || std::ranges::find(metrics_of_, part->found, &MetricsOf::plugin) != metrics_of_.end())
      continue;
    MetricsOf& own = metrics_of_.emplace_back(MetricsOf{part->found, {}});
    for (const plugin::DeclaredMetric& each : part->found->description->metrics()) {
      const std::string name = part->found->descriptor->id + ('.' + each.name);
      if (std::ranges::find(metrics_, name, &TeamMetric::name) != metrics_.end()) {
        mistakes.add(config::Error(part->use.where,
                                   "two plugins of this team are called " + std::string(part->found->descriptor->id) +
                                       ", and both declare the metric " + each.name + ": give one of them another id"),
                     "plugin");
        continue;
      }
      constexpr std::size_t most = 1024;
      if (metrics_.size() == most) {
        mistakes.add(config::Error(part->use.where, "the plugins of this team declare more than 1024 metrics"),
                     "plugin");
        return;
      }
      own.indices.push_back(static_cast<int>(metrics_.size()));
      metrics_.push_back({name, each.combine});
    }
  }
}

void TeamPlan::collect_reads() {
  const auto reads = [](const Part& part) { return part.found == nullptr ? 0u : part.found->descriptor->reads; };
  std::uint32_t all = REGISTA_READS_NOTHING, positioners = REGISTA_READS_NOTHING;
  for (const Part* part : parts()) all |= reads(*part);
  for (const ContextPlan& context : contexts_) positioners |= context.positioner ? reads(*context.positioner) : 0u;
  frame_parts_ = FrameParts::of(all, positioners);
}

std::span<const int> TeamPlan::metrics_of(const plugin::Found& plugin) const {
  const auto found = std::ranges::find(metrics_of_, &plugin, &MetricsOf::plugin);
  return found == metrics_of_.end() ? std::span<const int>() : std::span<const int>(found->indices);
}

std::vector<const Part*> TeamPlan::parts() const {
  std::vector<const Part*> out{&self_, &ball_, &opponents_, &teammates_};
  for (const ContextPlan& context : contexts_) {
    out.push_back(&context.condition);
    if (context.positioner) out.push_back(&*context.positioner);
    for (const TermPart& term : context.terms) out.push_back(&term.part);
    out.push_back(&context.assigner);
    out.push_back(&context.sender);
  }
  for (const BehaviourPlan& behaviour : behaviours_) out.push_back(&behaviour.part);
  return out;
}

regista_environment TeamPlan::environment(int number, unsigned subject) const {
  const config::FieldSize& field = rules_.field;
  regista_environment out{};
  out.size = sizeof out;
  out.team_size = static_cast<std::uint32_t>(rules_.team_size);
  out.own_number = number;
  out.subject = subject;
  out.field_length = field.length;
  out.field_width = field.width;
  out.border_strip = field.border_strip;
  out.goal_width = field.goal_width;
  out.goal_depth = field.goal_depth;
  out.goal_area_length = field.goal_area_length;
  out.goal_area_width = field.goal_area_width;
  out.penalty_area_length = field.penalty_area_length;
  out.penalty_area_width = field.penalty_area_width;
  out.penalty_mark_distance = field.penalty_mark_distance;
  out.centre_circle_radius = field.centre_circle_diameter / 2.0;
  out.ball_radius = rules_.ball.diameter / 2.0;
  out.robot_radius = robot_.body.radius;
  out.walk_forward = robot_.walk.forward;
  out.walk_sideways = robot_.walk.sideways;
  out.walk_backward = robot_.walk.backward;
  out.turn_rate = robot_.walk.turn;
  out.decision_period = robot_.decision_period;
  out.packet_size = static_cast<std::uint32_t>(rules_.messages.size);
  out.packet_budget = static_cast<std::uint32_t>(config::packets(rules_.messages));
  out.landmarks = abi_span(landmarks_);
  out.roles = abi_span(role_table_);
  out.goal_post_radius = field.post_diameter / 2.0;
  out.ball_deceleration = rules_.ball.rolling_deceleration;
  out.set_play_distance = rules_.set_play_distance;
  out.kick_reach = robot_.body.reach;
  out.kick_reach_angle = robot_.body.reach_angle;
  out.camera_half_angle = robot_.camera.half_angle;
  out.camera_ball_range = robot_.camera.ball_range;
  out.camera_robot_range = robot_.camera.robot_range;
  out.head_yaw = robot_.camera.head_yaw;
  out.head_speed = robot_.camera.head_speed;
  out.halves = static_cast<std::uint32_t>(rules_.durations.halves);
  out.half_length = rules_.durations.half;
  out.events = abi_span(events_);
  out.kicks = abi_span(kicks_);
  return out;
}

}  // namespace regista::mind
