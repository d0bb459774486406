// SPDX-License-Identifier: MIT
#include "match/decision_digest.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

#include "match/digest.hpp"
#include "match/outcome.hpp"

namespace regista::match {
namespace {

constexpr std::array<std::string_view, decision_steps> names{
    "the own pose", "the ball",      "the opponents",  "the worlds",  "the context", "the points",
    "the tasks",    "the utilities", "the assignment", "the command", "the packet",  "the metrics"};

// Field by field: a struct's padding may hold anything.
class Step {
 public:
  template <class... Values>
  Step& operator()(const Values&... values) {
    (add(values), ...);
    return *this;
  }
  std::uint64_t value() const { return digest_.value(); }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { digest_.add(value); }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(const std::vector<T>& values) {
    digest_.add(values.size());
    digest_.add(std::as_bytes(std::span(values)));
  }
  template <class T, std::size_t N>
  void add(const T (&values)[N]) {
    digest_.add(std::as_bytes(std::span(values)));
  }
  void add(const regista_track& t) {
    operator()(t.label, t.flags, t.x, t.y, t.vx, t.vy, t.weight, t.age, t.covariance, t.motion);
  }
  void add(const regista_robot& r) {
    operator()(r.number, r.flags, r.pose, r.velocity, r.covariance, r.target, r.time_until_up, r.age, r.role,
               r.role_since);
  }
  void add(const regista_opponent& o) { operator()(o.label, o.position, o.velocity, o.covariance, o.weight, o.age); }
  void add(const regista_ball& b) { operator()(b.flags, b.position, b.velocity, b.covariance, b.age); }
  void add(const regista_waypoint& p) { operator()(p.x, p.y, p.score, p.task, p.robot); }
  void add(const regista_edge& e) { operator()(e.from, e.to); }
  void add(const mind::MetricReport& m) { operator()(m.metric, m.place, m.count, m.sum, m.least, m.greatest, m.last); }
  void add(const regista_task& t) { operator()(t.id, t.priority, t.group, t.robot, t.flags, t.before, t.after); }
  Digest digest_;
};

// A track of a robot that has a pose: the union's other part may hold anything.
std::uint64_t step_of_self(const regista_track& t) {
  const regista_track_pose& pose = t.pose;
  return Step{}(t.label, t.flags, t.x, t.y, t.vx, t.vy, t.weight, t.age, t.covariance, pose.heading, pose.turn_rate,
                pose.heading_variance, pose.velocity_variance)
      .value();
}

template <class T>
std::uint64_t step_of(const T& list) {
  Step step;
  for (const auto& each : list) step(each);
  return step.value();
}

std::uint64_t worlds(const mind::WorldModel& model) {
  Step step;
  for (const mind::DistributedWorldModel* world : {&model.mine(), &model.common()}) {
    for (const regista_robot& each : world->robots) step(each);
    for (const regista_opponent& each : world->opponents) step(each);
    step(world->ball_state);
  }
  return step.value();
}

}  // namespace

std::string_view step_name(std::size_t step) { return names.at(step); }

DecisionDigest digest_of(const mind::Mind& mind, const mind::Outcome& outcome) {
  const mind::Decision& decision = mind.decision();
  const mind::LocalModel& local = mind.world().local();
  Step points, utilities;
  for (const regista_waypoint& each : decision.placement.points) points(each);
  for (const regista_edge& each : decision.placement.edges) points(each);
  for (const std::vector<double>& term : decision.utility.terms()) utilities(term);
  utilities(decision.utility.values());
  Digest acts, sends;
  add(acts, outcome.command);
  add(sends, outcome);
  return {step_of_self(local.self()),
          step_of(local.balls()),
          step_of(local.opponents()),
          worlds(mind.world()),
          Step{}(decision.context).value(),
          points.value(),
          step_of(decision.columns),
          utilities.value(),
          Step{}(decision.assigned).value(),
          acts.value(),
          sends.value(),
          step_of(outcome.metrics)};
}

std::string plugins_of_step(const mind::TeamPlan& plan, std::size_t step) {
  std::vector<std::string> ids;
  const auto add = [&ids](const mind::Part& part) {
    const std::string id = part.found->descriptor->id;
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  switch (step) {
    case 0:
      add(plan.self());
      break;
    case 1:
      add(plan.ball());
      break;
    case 2:
      add(plan.opponents());
      break;
    case 3:
      for (const mind::Part* each : {&plan.ball(), &plan.opponents(), &plan.teammates()}) add(*each);
      break;
    case 9:
      for (const mind::BehaviourPlan& behaviour : plan.behaviours()) add(behaviour.part);
      break;
    default:
      for (const mind::ContextPlan& context : plan.contexts()) {
        if (step == 4) add(context.condition);
        if ((step == 5 || step == 6) && context.positioner) add(*context.positioner);
        if (step == 7) {
          for (const mind::TermPart& term : context.terms) add(term.part);
        }
        if (step == 8) add(context.assigner);
        if (step == 10) add(context.sender);
      }
      if (step == 11) {
        for (const mind::Part* each : plan.parts()) {
          if (!plan.metrics_of(*each->found).empty()) add(*each);
        }
      }
  }
  std::string out;
  for (const std::string& id : ids) out += (out.empty() ? "" : ", ") + id;
  return out;
}

}  // namespace regista::match
