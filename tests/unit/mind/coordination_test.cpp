// SPDX-License-Identifier: MIT
// The pipeline, watched by plugins that live in the test: what they are given, and what becomes of what they answer.
#include "mind/coordination/coordination.hpp"

#include "coordination_scene.hpp"

namespace regista::mind {
namespace {

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
  const Decision& whole = decided(FrameParts{});
  const std::vector<double> faced = facings(whole);
  const std::vector<int> roles(whole.role_of.begin(), whole.role_of.end());
  ASSERT_TRUE(std::ranges::any_of(faced, [](double each) { return each != 0.0; }));
  EXPECT_GT(turned, 0);
  EXPECT_EQ(whole.frame.time_to_task.rows, 3u);
  EXPECT_EQ(world->common().opponents.size(), 1u);

  const Decision& kept = decided(FrameParts::of(REGISTA_READS_FACINGS, REGISTA_READS_NOTHING));
  EXPECT_EQ(facings(kept), faced);
  EXPECT_EQ(turned, 0) << "no positioner reads it";
  EXPECT_EQ(kept.frame.time_to_task.rows, 0u);
  EXPECT_TRUE(world->common().opponents.empty());
  EXPECT_EQ(world->mine().opponents.size(), 1u);
  EXPECT_EQ(kept.role_of, roles);

  const Decision& bare = decided(FrameParts::of(REGISTA_READS_NOTHING, REGISTA_READS_NOTHING));
  EXPECT_EQ(facings(bare), std::vector<double>(faced.size()));
  EXPECT_EQ(bare.role_of, roles);

  EXPECT_EQ(decided(FrameParts::of(REGISTA_READS_TIMES, REGISTA_READS_NOTHING)).frame.time_to_task.rows, 3u);
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

}  // namespace
}  // namespace regista::mind
