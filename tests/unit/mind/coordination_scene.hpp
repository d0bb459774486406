// SPDX-License-Identifier: MIT
// One robot's coordination on scripted plugins, for tests.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>

#include "mind/coordination/coordination.hpp"
#include "team.hpp"

namespace regista::mind {

struct ScriptedPositioner {
  static constexpr auto id = "positioner", version = "1.0.0", summary = "Scripted";
  static inline std::function<void(const Frame&, Placement)> hook;
  void place(const Frame& frame, Placement out) {
    if (hook) hook(frame, out);
  }
};

template <int N>
struct ScriptedTerm {
  static constexpr auto id = "term", version = "1.0.0", summary = "Scripted";
  static inline std::function<void(const Frame&, Utilities)> hook;
  void score(const Frame& frame, Utilities out) {
    if (hook) hook(frame, out);
  }
};

struct ScriptedAssigner {
  static constexpr auto id = "assigner", version = "1.0.0", summary = "Scripted";
  static constexpr bool negotiates = true;
  static inline std::function<void(const Frame&, UtilityMatrix, Assignment)> hook;
  void assign(const Frame& frame, UtilityMatrix utilities, Assignment out) {
    if (hook) hook(frame, utilities, out);
  }
};

template <int N>
struct ScriptedContext {
  static constexpr auto id = "context", version = "1.0.0", summary = "Scripted";
  static inline bool answer = true;
  static inline int asked = 0, told = -5, knowledge = -1;
  bool holds(const Frame& frame) {
    ++asked;
    knowledge = frame.raw().knowledge;
    told = frame.context();
    EXPECT_EQ(frame.raw().tasks.count, 0u);
    EXPECT_EQ(frame.raw().waypoints.count, 0u);
    EXPECT_EQ(frame.raw().time_to_task.rows, 0u);
    return answer;
  }
};

class CoordinationTest : public testing::Test {
 protected:
  CoordinationTest() { reset_hooks(); }
  ~CoordinationTest() override { reset_hooks(); }

  static void reset_hooks() {
    ScriptedPositioner::hook = nullptr;
    ScriptedTerm<0>::hook = ScriptedTerm<1>::hook = nullptr;
    ScriptedAssigner::hook = nullptr;
    ScriptedContext<0>::answer = false;
    ScriptedContext<1>::answer = true;
    ScriptedContext<0>::asked = ScriptedContext<1>::asked = 0;
  }

  // Context 0, "other", with a list of two roles, and context 1, "playing".
  static config::Team two_contexts() {
    config::Team out = team();
    out.role_lists.push_back({"other", {role("left", place(0.0, 2.0)), role("right", place(0.0, -2.0))}});
    out.contexts.insert(out.contexts.begin(), context("other"));
    out.contexts[0].role_list = 1;
    return out;
  }

  void make(config::Team page, int own_number = 2, config::Rules rules = {}) {
    own = own_number;
    plan = plan_of(std::move(page), std::move(rules));
    world = world_model(*plan, own, made);
    const regista_environment environment = plan->environment(own);
    std::vector<ContextParts> parts;
    for (std::size_t i = 0; i < plan->contexts().size(); ++i) {
      plugin::Context condition(i == 0 ? in_process<ScriptedContext<0>, regista::context>(environment)
                                       : in_process<ScriptedContext<1>, regista::context>(environment));
      std::vector<plugin::Utility> terms;
      terms.emplace_back(in_process<ScriptedTerm<0>, utility>(environment));
      terms.emplace_back(in_process<ScriptedTerm<1>, utility>(environment));
      parts.push_back({std::move(condition),
                       plugin::Positioner(in_process<ScriptedPositioner, positioner>(environment)), std::move(terms),
                       plugin::Assigner(in_process<ScriptedAssigner, assigner>(environment)),
                       plugin::Sender(in_process<stubs::Steady, sender>(environment))});
    }
    coordination = std::make_unique<Coordination>(*plan, own, std::move(parts), made);
  }

  std::vector<BallSighting> balls_seen;

  // What the own robot has sent, as the others decoded it: from then on the common world counts it.
  void send(double time, int role = -1) {
    Report packet = report(own, time, own, 0.0);
    packet.role = role;
    world->hear(packet, time);
  }

  // Robots at (number, 0) tell where they are; the own one sees for itself.
  const Decision& decide(double time, const std::vector<int>& heard, const Vector2d& own_place = {0.0, 0.0}) {
    Percepts given = percepts(time);
    given.placed = placed(own_place.x(), own_place.y());
    given.balls = balls_seen;
    const double dt = time - now;
    now = time;
    world->sense(given, dt, coordination->last_frame());
    for (const int number : heard) world->hear(report(number, time, number, 0.0), time);
    const Decision& last = coordination->decision();
    world->fuse(given, dt, {last.own_role, last.own_role_since, own_place});
    return coordination->decide(*world, time, tick++);
  }

  // Distinct values for every robot, task and term.
  static double value(int term, int robot, int task) { return 10.0 * term + robot + 0.01 * task; }

  static void scripted_values() {
    ScriptedTerm<0>::hook = [](const Frame& frame, Utilities out) { fill(0, frame, out); };
    ScriptedTerm<1>::hook = [](const Frame& frame, Utilities out) { fill(1, frame, out); };
  }
  static void fill(int term, const Frame& frame, Utilities out) {
    for (std::size_t i = 0; i < out.rows(); ++i) {
      for (std::size_t j = 0; j < out.columns(); ++j) {
        out(i, j) = value(term, frame.world().active()[i], frame.tasks()[j].id);
      }
    }
  }

  int own = 2;
  FrameParts made;
  double now = 0.0;
  std::uint64_t tick = 0;
  std::unique_ptr<TeamPlan> plan;
  std::unique_ptr<WorldModel> world;
  std::unique_ptr<Coordination> coordination;
};

constexpr double forbidden = -std::numeric_limits<double>::infinity();

}  // namespace regista::mind
