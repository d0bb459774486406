// SPDX-License-Identifier: MIT
// The pipeline, watched by plugins that live in the test: what they are given, and what becomes of what they answer.
#include "mind/coordination/coordination.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>

#include "team.hpp"

namespace regista::mind {
namespace {

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

  void make(config::Team page, int own_number = 2) {
    own = own_number;
    plan = plan_of(std::move(page));
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
  FrameParts made = FrameParts::all();
  double now = 0.0;
  std::uint64_t tick = 0;
  std::unique_ptr<TeamPlan> plan;
  std::unique_ptr<WorldModel> world;
  std::unique_ptr<Coordination> coordination;
};

constexpr double forbidden = -std::numeric_limits<double>::infinity();

TEST_F(CoordinationTest, UtilityIsTheWeightedSumOfItsTerms) {
  config::Team page = team();
  page.contexts[0].terms[0].weight = 0.7;
  page.contexts[0].terms[1].weight = 0.2;
  ScriptedContext<0>::answer = true;
  make(page);
  scripted_values();
  const Decision& decision = decide(1.0, {1, 3, 5});
  const std::vector<int> rows{1, 2, 3, 5};
  ASSERT_EQ(decision.rows(), 4u);
  ASSERT_EQ(decision.columns.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const int task = decision.columns[j].id;
      const bool allowed = (task == 0) == (rows[i] == 1);  // task 0, the goalkeeper, is bound to robot 1
      const double sum = 0.7 * value(0, rows[i], task) + 0.2 * value(1, rows[i], task);
      if (allowed) {
        EXPECT_NEAR(decision.utility.values()[4 * i + j], sum, 1e-12);
      } else {
        EXPECT_EQ(decision.utility.values()[4 * i + j], forbidden);
      }
      EXPECT_EQ(decision.utility.terms()[0][4 * i + j], value(0, rows[i], task));
      EXPECT_EQ(decision.utility.terms()[1][4 * i + j], value(1, rows[i], task));
    }
  }
}

TEST_F(CoordinationTest, FrameHoldsWhatItPromisesAtEveryStep) {
  ScriptedContext<0>::answer = true;
  make(team());
  int placed_calls = 0, scored = 0, assigned = 0;
  ScriptedPositioner::hook = [&](const Frame& frame, Placement out) {
    ++placed_calls;
    EXPECT_EQ(frame.tasks().size(), 10u);
    EXPECT_TRUE(frame.waypoints().empty());
    EXPECT_EQ(frame.raw().time_to_task.rows, 0u);
    EXPECT_EQ(frame.own_number(), 2);
    EXPECT_EQ(frame.tick(), 7u);
    EXPECT_EQ(frame.time(), 1.0);
    EXPECT_EQ(frame.context(), 0);
    out.edge(out.point(1.0, 1.0), out.point(2.0, 2.0));
  };
  ScriptedTerm<0>::hook = [&](const Frame& frame, Utilities out) {
    ++scored;
    EXPECT_EQ(out.rows(), 3u);
    EXPECT_EQ(out.columns(), 3u);
    EXPECT_EQ(frame.tasks().size(), 3u);
    EXPECT_EQ(frame.waypoints().size(), 2u);
    EXPECT_EQ(frame.edges().size(), 1u);
    EXPECT_EQ(frame.raw().previous.count, 7u);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Robot& robot = frame.world().robot(frame.world().active()[i]);
        const double x = frame.tasks()[j].after[0] - robot.pose[0], y = frame.tasks()[j].after[1] - robot.pose[1];
        EXPECT_NEAR(frame.time_to_task(i, j), robot.time_until_up + std::hypot(x, y) / 0.25, 1e-12);
      }
    }
  };
  ScriptedAssigner::hook = [&](const Frame&, UtilityMatrix utilities, Assignment out) {
    ++assigned;
    EXPECT_EQ(utilities.rows(), 3u);
    EXPECT_EQ(out.size(), 3u);
  };
  tick = 7;
  decide(1.0, {1, 4});
  EXPECT_EQ(placed_calls, 1);
  EXPECT_EQ(scored, 1);
  EXPECT_EQ(assigned, 1);
}

TEST_F(CoordinationTest, MakesOnlyWhatIsRead) {
  ScriptedContext<0>::answer = true;
  config::Team page = team();
  for (config::Role& role : page.role_lists[0].roles) role.target.facing = place(4.5, 0.0);
  static int turned;  // tasks that the positioner sees facing the goal
  const auto decided = [&](FrameParts parts) -> const Decision& {
    made = parts;
    now = 0.0;
    make(page);
    turned = 0;
    ScriptedPositioner::hook = [](const Frame& frame, Placement out) {
      out.point(2.4, 1.5);
      for (const Task& task : frame.tasks()) turned += task.before[2] != 0.0;
    };
    Report seeing = report(3, 0.5, 3.0, 0.0);
    seeing.opponents[seeing.opponent_count++] = {{1.0, 1.0}, 0.1, 0.0};
    Percepts given = percepts(0.5);
    given.placed = placed(0.0, 0.0);
    world->sense(given, 0.5, nullptr);
    world->hear(seeing, 0.5);
    now = 0.5;
    return decide(1.0, {1});
  };
  const auto facings = [](const Decision& decision) {
    std::vector<double> out;
    for (const regista_task& task : decision.columns) out.push_back(task.after[2]);
    return out;
  };
  const Decision& whole = decided(FrameParts::all());
  const std::vector<double> faced = facings(whole);
  const std::vector<int> roles(whole.role_of.begin(), whole.role_of.end());
  ASSERT_TRUE(std::ranges::any_of(faced, [](double each) { return each != 0.0; }));
  EXPECT_GT(turned, 0);
  EXPECT_EQ(whole.frame.time_to_task.rows, 3u);
  EXPECT_EQ(world->common().opponents.size(), 1u);

  const Decision& kept = decided({REGISTA_READS_FACINGS, REGISTA_READS_NOTHING});
  EXPECT_EQ(facings(kept), faced);
  EXPECT_EQ(turned, 0) << "no positioner reads it";
  EXPECT_EQ(kept.frame.time_to_task.rows, 0u);
  EXPECT_TRUE(world->common().opponents.empty());
  EXPECT_EQ(world->mine().opponents.size(), 1u);
  EXPECT_EQ(kept.role_of, roles);

  const Decision& bare = decided({REGISTA_READS_NOTHING, REGISTA_READS_NOTHING});
  EXPECT_EQ(facings(bare), std::vector<double>(faced.size()));
  EXPECT_EQ(bare.role_of, roles);

  EXPECT_EQ(decided({REGISTA_READS_TIMES, REGISTA_READS_NOTHING}).frame.time_to_task.rows, 3u);
}

TEST_F(CoordinationTest, TimeToTaskWaitsForWhoLies) {
  config::Team page = team();
  ScriptedContext<0>::answer = true;
  page.contexts[0].tasks.offset_at_most = 0.0;
  make(page);
  Report lying = report(3, 1.0, 0.0, 0.0);
  lying.time_until_up = 4.0;
  Percepts given = percepts(1.0);
  given.placed = placed(0.0, 0.0);
  world->sense(given, 1.0, nullptr);
  world->hear(lying, 1.0);
  world->fuse(given, 1.0, {});
  const Decision& decision = coordination->decide(*world, 1.0, 0);
  // The striker's task is at the ball that nobody knows, (0, 0): no way to go for either.
  ASSERT_EQ(decision.columns[0].id, 1);
  EXPECT_DOUBLE_EQ(decision.time_to_task[0], 0.0);
  EXPECT_DOUBLE_EQ(decision.time_to_task[2], 4.0);
}

TEST_F(CoordinationTest, KeepsAsManyTasksAsRobotsAndMovesThem) {
  ScriptedContext<0>::answer = true;
  make(team());
  ScriptedPositioner::hook = [](const Frame&, Placement out) {
    out.point(3.5, -1.5);  // on place_7
    out.point(2.4, 1.5);   // 0.1 from place_6
  };
  const Decision& decision = decide(1.0, {1, 3});
  // Goalkeeper (bound), striker (required), then the nearest to a waypoint: place_7, row 9.
  ASSERT_EQ(decision.kept, (std::vector<std::size_t>{0, 1, 9}));
  EXPECT_EQ(decision.columns[2].after[0], 3.5);
  EXPECT_NEAR(decision.columns[1].after[0], 0.5 * 2.4 / std::hypot(2.4, 1.5), 1e-12);
  EXPECT_EQ(decision.columns[1].before[0], 0.0);
}

TEST_F(CoordinationTest, RolesThatMayNotBeMovedStay) {
  config::Team page = team();
  page.role_lists[0].roles[1].offset = false;
  ScriptedContext<0>::answer = true;
  make(page);
  ScriptedPositioner::hook = [](const Frame&, Placement out) { out.point(0.3, 0.0); };
  const Decision& decision = decide(1.0, {});
  ASSERT_EQ(decision.columns[0].id, 1);
  EXPECT_EQ(decision.columns[0].after[0], 0.0);
}

// Points that belong to tasks name them by their place in the frame of the moment: all tasks for the positioner, the
// kept ones for everyone after it.
TEST_F(CoordinationTest, WaypointsNameTasksByTheirPlaceInTheFrame) {
  ScriptedContext<0>::answer = true;
  make(team());
  std::map<double, int> task_at;  // x of the point -> id of its task
  ScriptedPositioner::hook = [&](const Frame& frame, Placement out) {
    for (std::size_t j = 0; j < frame.tasks().size(); ++j) {
      const double x = 0.4 * static_cast<double>(j) - 2.0;
      out.point(x, 0.5, 1.0, static_cast<int>(j));
      task_at[x] = frame.tasks()[j].id;
    }
  };
  int named = 0, nameless = 0;
  ScriptedTerm<0>::hook = [&](const Frame& frame, Utilities) {
    for (const Waypoint& point : frame.waypoints()) {
      if (point.task < 0) {
        ++nameless;
        continue;
      }
      ++named;
      ASSERT_LT(static_cast<std::size_t>(point.task), frame.tasks().size());
      EXPECT_EQ(frame.tasks()[static_cast<std::size_t>(point.task)].id, task_at[point.x]);
    }
  };
  decide(1.0, {3, 4, 5});
  EXPECT_EQ(named, 4);
  EXPECT_EQ(nameless, 6);
}

TEST_F(CoordinationTest, PreviousIsTheLastAssignmentAndUnknownIsNone) {
  ScriptedContext<0>::answer = true;
  make(team());
  std::vector<int> previous;
  ScriptedTerm<0>::hook = [&](const Frame& frame, Utilities) {
    previous.clear();
    for (int number = 1; number <= 7; ++number) previous.push_back(frame.previous_task(number));
  };
  // Rows 1, 2, 4: robot 1 nothing, robot 2 the second task, robot 4 unknown.
  ScriptedAssigner::hook = [](const Frame&, UtilityMatrix, Assignment out) {
    out[1] = 1;
    out[2] = Assignment::unknown_task;
  };
  const Decision& decision = decide(1.0, {1, 4});
  EXPECT_EQ(previous, std::vector<int>(7, -1));
  EXPECT_EQ(decision.role_of, (std::vector<std::int32_t>{-1, decision.columns[1].id, -1, -2, -1, -1, -1}));
  decide(1.1, {});
  EXPECT_EQ(previous, (std::vector<int>{-1, 1, -1, -1, -1, -1, -1}));
}

TEST_F(CoordinationTest, OwnRoleAndSinceWhen) {
  ScriptedContext<0>::answer = true;
  make(team());
  std::int32_t column = 1;
  ScriptedAssigner::hook = [&](const Frame&, UtilityMatrix, Assignment out) { out[1] = column; };
  const Decision& decision = decide(1.0, {1, 4});
  EXPECT_EQ(decision.own_role, 1);
  EXPECT_EQ(decision.own_role_since, 1.0);
  ASSERT_NE(decision.own_task, nullptr);
  EXPECT_EQ(decision.own_task->id, 1);
  decide(1.1, {});
  EXPECT_EQ(decision.own_role_since, 1.0);
  column = 2;
  decide(1.2, {});
  EXPECT_EQ(decision.own_role, decision.columns[2].id);
  EXPECT_EQ(decision.own_role_since, 1.2);
  column = Assignment::no_task;
  decide(1.3, {});
  EXPECT_EQ(decision.own_role, -1);
  EXPECT_EQ(decision.own_role_since, 1.3);
  EXPECT_EQ(decision.own_task, nullptr);
}

TEST_F(CoordinationTest, UnknownKeepsTheRoleWhileItExists) {
  ScriptedContext<0>::answer = false;
  make(two_contexts());
  std::int32_t column = 1;
  ScriptedAssigner::hook = [&](const Frame&, UtilityMatrix, Assignment out) { out[0] = column; };
  const Decision& decision = decide(1.0, {3});
  const int role = decision.own_role;
  EXPECT_GE(role, 0);
  column = Assignment::unknown_task;
  decide(1.1, {});
  EXPECT_EQ(decision.own_role, role);
  EXPECT_EQ(decision.own_role_since, 1.0);
  EXPECT_EQ(decision.role_of[1], REGISTA_UNKNOWN_TASK);
  ASSERT_NE(decision.own_task, nullptr);
  EXPECT_EQ(decision.own_task->id, role);
  ScriptedContext<0>::answer = true;  // another list of roles
  decide(1.2, {});
  EXPECT_EQ(decision.own_role, -1);
  EXPECT_EQ(decision.own_task, nullptr);
}

TEST_F(CoordinationTest, TheFirstContextThatHoldsIsInForceAndAllAreAsked) {
  make(two_contexts());
  const Decision& decision = decide(1.0, {});
  EXPECT_EQ(decision.context, 1);
  EXPECT_EQ(ScriptedContext<1>::told, -1) << "none has been chosen yet";
  EXPECT_EQ(decision.tasks.size(), 10u);
  EXPECT_EQ(decision.tasks[0].id, 0);
  ScriptedContext<0>::answer = true;
  decide(1.1, {});
  EXPECT_EQ(decision.context, 0);
  EXPECT_EQ(ScriptedContext<1>::told, 1);
  ASSERT_EQ(decision.tasks.size(), 2u);
  EXPECT_EQ(decision.tasks[0].id, 10) << "ids go on through the lists";
  EXPECT_EQ(decision.tasks[1].priority, 1);
  EXPECT_EQ(ScriptedContext<0>::asked, 2);
  EXPECT_EQ(ScriptedContext<1>::asked, 2);
}

// Another place, and still the same role: whoever holds it goes on holding it.
TEST_F(CoordinationTest, AContextMovesARole) {
  config::Team page = two_contexts();
  page.contexts[0].role_list = 0;
  page.contexts[0].targets.resize(10);
  config::TargetRule elsewhere;
  elsewhere.at = place(3.0, 1.0);
  page.contexts[0].targets[2] = elsewhere;
  for (config::Context& each : page.contexts) each.tasks.keep = config::TaskRules::Keep::all;
  make(page);
  // Alone on the field: the only row is its own.
  ScriptedAssigner::hook = [](const Frame& frame, UtilityMatrix, Assignment out) {
    for (std::size_t column = 0; column < frame.tasks().size(); ++column) {
      if (frame.tasks()[column].id == 2) out[0] = static_cast<int>(column);
    }
  };
  const Decision& decision = decide(1.0, {});
  ASSERT_EQ(decision.own_role, 2);
  EXPECT_EQ(decision.own_task->before[0], -3.5);
  ScriptedContext<0>::answer = true;
  decide(1.1, {});
  ASSERT_EQ(decision.context, 0);
  ASSERT_EQ(decision.own_role, 2);
  EXPECT_EQ(decision.own_task->before[0], 3.0);
  EXPECT_EQ(decision.own_task->before[1], 1.0);
  EXPECT_EQ(decision.own_role_since, 1.0);
  EXPECT_EQ(decision.tasks[3].before[0], -2.5) << "others stay where they are";
}

TEST_F(CoordinationTest, WithoutAContextNothingIsAssigned) {
  make(two_contexts());
  ScriptedAssigner::hook = [](const Frame&, UtilityMatrix, Assignment out) { out[0] = 0; };
  const Decision& decision = decide(1.0, {});
  EXPECT_GE(decision.own_role, 0);
  ScriptedContext<1>::answer = false;
  decide(1.1, {});
  EXPECT_EQ(decision.context, -1);
  EXPECT_EQ(decision.own_role, -1);
  EXPECT_EQ(decision.own_role_since, 1.1);
  EXPECT_EQ(decision.own_task, nullptr);
  EXPECT_TRUE(decision.tasks.empty());
  EXPECT_TRUE(decision.columns.empty());
  EXPECT_EQ(decision.role_of, std::vector<std::int32_t>(7, -1));
  EXPECT_EQ(decision.frame.tasks.count, 0u);
}

TEST_F(CoordinationTest, KnowledgeChoosesTheWorldOfEachStep) {
  config::Team page = team();
  using enum config::Knowledge;
  page.contexts[0].utility_knowledge = mine;
  page.contexts[0].tasks.hysteresis = 20.0;
  ScriptedContext<0>::answer = true;
  int place_knowledge = -1, term_knowledge = -1, assign_knowledge = -1;
  ScriptedPositioner::hook = [&](const Frame& frame, Placement out) {
    place_knowledge = frame.raw().knowledge;
    out.point(-3.4, 1.5);  // 0.1 from place_0, far from place_7, task 9
  };
  ScriptedTerm<0>::hook = [&](const Frame& frame, Utilities) { term_knowledge = frame.raw().knowledge; };
  ScriptedAssigner::hook = [&](const Frame& frame, UtilityMatrix, Assignment) {
    assign_knowledge = frame.raw().knowledge;
  };
  for (const auto tasks : {mine, common}) {
    for (const auto waypoints : {mine, common}) {
      for (const auto filter : {mine, common}) {
        page.contexts[0].tasks.knowledge = tasks;
        page.contexts[0].tasks.waypoints_knowledge = waypoints;
        page.contexts[0].tasks.filter_knowledge = filter;
        make(page);
        now = 0.0;
        balls_seen = {{{1.0, 0.5}, 0.1, 0.1}};
        send(0.9, 9);
        const Decision& decision = decide(1.0, {3, 4});
        EXPECT_EQ(place_knowledge, waypoints == common ? REGISTA_COMMON : REGISTA_MINE);
        EXPECT_EQ(term_knowledge, REGISTA_MINE);
        EXPECT_EQ(assign_knowledge, REGISTA_MINE);
        EXPECT_EQ(decision.rows(), 3u);
        // It said that it plays task 9 and has dropped it since: nobody tells the others. A task that is played is
        // kept.
        EXPECT_EQ(decision.columns.back().id == 9, filter == common);
        // Nobody has told of the ball that the own eyes see.
        const bool at_ball = std::ranges::any_of(decision.columns, [](const regista_task& task) {
          return std::hypot(task.before[0] - 1.0, task.before[1] - 0.5) < 0.1;
        });
        EXPECT_EQ(at_ball, tasks == mine);
      }
    }
  }
}

TEST_F(CoordinationTest, AConditionIsAskedAboutTheWorldThatItsContextNames) {
  for (const auto knowledge : {config::Knowledge::mine, config::Knowledge::common}) {
    config::Team page = team();
    page.contexts[0].knowledge = knowledge;
    ScriptedContext<0>::answer = true;
    make(page);
    now = 0.0;
    send(0.9);
    decide(1.0, {3, 4});
    EXPECT_EQ(ScriptedContext<0>::knowledge, knowledge == config::Knowledge::common ? REGISTA_COMMON : REGISTA_MINE);
  }
}

TEST_F(CoordinationTest, OnCommonKnowledgeATeammateNeverHeardOfHasNoRow) {
  config::Team page = team();
  page.contexts[0].tasks.knowledge = page.contexts[0].utility_knowledge = config::Knowledge::common;
  ScriptedContext<0>::answer = true;
  make(page);
  const Decision& decision = decide(1.0, {});
  send(1.05);
  decide(1.1, {});
  EXPECT_EQ(decision.rows(), 1u);
  decide(1.2, {4});
  EXPECT_EQ(decision.rows(), 2u);
}

// Silent for longer than a teammate is reckoned with, robot 2 is given up in its own common world. It plays on, by what
// it knows itself, until it is heard of again.
TEST_F(CoordinationTest, ARobotThatTheCommonWorldHasGivenUpDecidesOnItsOwn) {
  using enum config::Knowledge;
  config::Team page = team();
  page.forget_teammate_after = 25.0;
  config::Context& context = page.contexts[0];
  context.knowledge = context.tasks.knowledge = context.tasks.waypoints_knowledge = context.tasks.filter_knowledge =
      context.utility_knowledge = common;
  ScriptedContext<0>::answer = true;
  make(page);
  std::vector<int> asked;  // worlds that the plugins are told to compute on, in their order
  ScriptedPositioner::hook = [&](const Frame& frame, Placement) { asked.push_back(frame.raw().knowledge); };
  ScriptedTerm<0>::hook = [&](const Frame& frame, Utilities) { asked.push_back(frame.raw().knowledge); };
  ScriptedAssigner::hook = [&](const Frame& frame, UtilityMatrix, Assignment out) {
    asked.push_back(frame.raw().knowledge);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::int32_t>(i);
  };
  balls_seen = {{{1.0, 0.5}, 0.1, 0.1}};  // and never told
  const auto decide_on = [&](double time, const std::vector<int>& heard, int knowledge) -> const Decision& {
    asked.clear();
    const Decision& decision = decide(time, heard);
    EXPECT_EQ(ScriptedContext<0>::knowledge, knowledge) << time;
    EXPECT_EQ(asked, std::vector<int>(3, knowledge)) << time;
    EXPECT_EQ(decision.frame.knowledge, knowledge) << time;
    return decision;
  };
  const auto plays_the_ball_it_sees = [](const Decision& decision) {
    return std::ranges::any_of(decision.columns, [](const regista_task& task) {
      return task.id == 1 && std::hypot(task.before[0] - 1.0, task.before[1] - 0.5) < 0.1;
    });
  };

  send(1.0);
  const Decision& decision = decide_on(25.9, {3, 4}, REGISTA_COMMON);
  EXPECT_FALSE(plays_the_ball_it_sees(decision));
  decide_on(26.1, {3, 4}, REGISTA_MINE);
  EXPECT_EQ(world->common().active, (std::vector<std::int32_t>{3, 4}));
  EXPECT_EQ(decision.rows(), 3u);
  EXPECT_EQ(decision.columns.size(), 3u) << "a task for each of 2, 3 and 4";
  EXPECT_TRUE(plays_the_ball_it_sees(decision));
  EXPECT_EQ(decision.own_role, decision.columns[0].id);
  EXPECT_TRUE(decision.own_task != nullptr);
  decide_on(60.0, {}, REGISTA_MINE);
  EXPECT_EQ(world->common().active.size(), 0u);
  EXPECT_EQ(decision.own_role, 1) << "alone it is the striker";
  send(60.05);
  decide_on(60.1, {}, REGISTA_COMMON);
}

// As in paper.yaml: waypoints and filter on what all know, the rest on what the robot knows itself.
TEST_F(CoordinationTest, ARobotThatTheCommonWorldHasGivenUpKeepsATask) {
  config::Team page = team();
  page.forget_teammate_after = 25.0;
  page.contexts[0].tasks.waypoints_knowledge = page.contexts[0].tasks.filter_knowledge = config::Knowledge::common;
  ScriptedContext<0>::answer = true;
  make(page);
  ScriptedAssigner::hook = [](const Frame&, UtilityMatrix utilities, Assignment out) {
    for (std::size_t i = 0; i < std::min(out.size(), utilities.columns()); ++i) out[i] = static_cast<std::int32_t>(i);
  };
  send(1.0);
  const Decision& decision = decide(1.1, {3});
  EXPECT_EQ(decision.columns.size(), 2u);
  decide(60.0, {});
  EXPECT_EQ(decision.kept.size(), 1u);
  EXPECT_EQ(decision.own_role, 1);
}

TEST(Worlds, TheCommonWorldAnswersIfItCountsTheRobot) {
  constexpr auto mine_asked = config::Knowledge::mine, common_asked = config::Knowledge::common;
  DistributedWorldModel mine(3), common(3);
  for (const bool plays : {false, true}) {
    for (const bool counted : {false, true}) {
      mine.robot(2).flags = plays ? REGISTA_ROBOT_ACTIVE : 0;
      common.robot(2).flags = counted ? REGISTA_ROBOT_ACTIVE : 0;
      const Worlds worlds(mine, common, 2);
      const bool given_up = plays && !counted;  // one that does not play, as under a penalty, is not: nobody counts it
      EXPECT_EQ(worlds.answering(common_asked), given_up ? mine_asked : common_asked);
      EXPECT_EQ(&worlds.of(common_asked), given_up ? &mine : &common);
      EXPECT_EQ(&worlds.of(mine_asked), &mine);
    }
  }
}

TEST_F(CoordinationTest, ATaskBoundToAnAbsentRobotIsNobodys) {
  config::Team page = team();
  page.contexts[0].tasks.keep = config::TaskRules::Keep::all;
  ScriptedContext<0>::answer = true;
  make(page);
  scripted_values();
  const Decision& decision = decide(1.0, {3});
  ASSERT_EQ(decision.columns.size(), 9u) << "all but the goalkeeper of robot 1";
  for (const double each : decision.utility.values()) EXPECT_NE(each, forbidden);
}

TEST_F(CoordinationTest, TasksFaceWhereTheRoleSays) {
  config::Team page = team();
  page.role_lists[0].roles[2].target.facing = place(config::Anchor::opponent_goal);
  page.role_lists[0].roles[3].target.facing = place(-10.0, -1.5);  // place_1 is at (-2.5, -1.5)
  ScriptedContext<0>::answer = true;
  make(page);
  const Decision& decision = decide(1.0, {});
  EXPECT_DOUBLE_EQ(decision.tasks[2].before[2], std::atan2(-1.5, 4.5 + 3.5));
  EXPECT_DOUBLE_EQ(decision.tasks[3].before[2], pi);
  EXPECT_DOUBLE_EQ(decision.tasks[1].before[2], 0.0) << "the striker stands on what it faces";
}

}  // namespace
}  // namespace regista::mind
