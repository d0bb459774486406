// SPDX-License-Identifier: MIT
// Which world each step of coordination knows: common knowledge and the own one.
#include "coordination_scene.hpp"

namespace regista::mind {
namespace {

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
  std::vector<int> asked;  // worlds that the plugins compute on, in their order
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

TEST_F(CoordinationTest, TheNextRobotTakesTheRoleOfAnAbsentOne) {
  config::Team page = team();
  page.role_lists[0].roles[0].robots = {1, 3, 2};
  ScriptedContext<0>::answer = true;
  make(page);
  EXPECT_EQ(decide(1.0, {1, 3}).tasks[0].robot, 1);
  EXPECT_EQ(decide(40.0, {3}).tasks[0].robot, 3) << "robot 1 has been silent for too long";
  const Decision& decision = decide(80.0, {});
  EXPECT_EQ(decision.tasks[0].robot, 2);
  EXPECT_EQ(decision.columns.front().id, 0) << "it is kept";
}

TEST_F(CoordinationTest, ARoleIsOpenToEnoughRobots) {
  config::Team page = team();
  page.role_lists[0].roles[0].robots = {1, 2};
  page.role_lists[0].roles[0].least_in_play = 2;
  ScriptedContext<0>::answer = true;
  make(page);
  EXPECT_EQ(decide(1.0, {}).tasks[0].robot, 2) << "it hears nobody, but six others are in play";
  config::Rules of_one;
  of_one.team_size = 1;
  page.role_lists[0].roles[0].robots = {1};
  make(page, 1, of_one);
  ScriptedAssigner::hook = [](const Frame&, UtilityMatrix, Assignment out) { out[0] = 0; };
  const Decision& alone = decide(1.0, {});
  EXPECT_EQ(alone.tasks[0].robot, -1);
  EXPECT_EQ(alone.own_role, 1) << "the striker";
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
