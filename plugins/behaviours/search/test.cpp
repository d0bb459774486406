// SPDX-License-Identifier: MIT
// Searching: to the place, then about; neighbours in opposite directions.
#include <gtest/gtest.h>

#include <algorithm>

#include "../supporting.hpp"
#include "../test_conduct.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

TEST(Searching, WalksToItsPlaceThenTurns) {
  Situation situation = standing(1, 1);
  situation.target = {1.3, 1.39, 0.7};  // 0.49 m away
  EXPECT_TRUE(std::holds_alternative<Turn>(search(situation, {}, {})));
  situation.target = {1.3, 1.41, 0.7};
  const auto walk = std::get<WalkTo>(search(situation, {}, {}));
  EXPECT_EQ(walk.target.x, 1.3);
  EXPECT_EQ(walk.target.y, 1.41);
  EXPECT_EQ(walk.target.heading, 0.7);
  EXPECT_FALSE(walk.brisk || walk.straight || walk.around || walk.creep);
  EXPECT_TRUE(std::holds_alternative<Turn>(search(situation, {.at_target = 1.0}, {})));
}

TEST(Searching, WithoutATaskWhereItStands) {
  Situation situation = standing(-4.4, 0);  // in the own goal area, where its place may not be
  EXPECT_TRUE(std::holds_alternative<WalkTo>(search(situation, {}, {})));
  situation.has_task = false;
  EXPECT_TRUE(std::holds_alternative<Turn>(search(situation, {}, {})));
}

TEST(Searching, NeighboursTurnInOppositeDirections) {
  Situation situation = standing(0, 0);
  for (int number = 1; number <= 11; ++number) {
    situation.facts.own_number = number;
    EXPECT_EQ(std::get<Turn>(search(situation, {.turn_rate = 0.4}, {})).rate, number % 2 == 0 ? 0.4 : -0.4);
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

TEST(SearchPlugin, TurnsWithoutATaskAndWalksWithOne) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "search"), EnvironmentBuilder{}.own(3));
  const Scene scene = FrameBuilder{}.own(3).robot(3).no_ball().task("search_1").at(1, 1).heading(0.5).build();
  const regista_action turn = behaviour.act(scene, BodyBuilder{}.at(-1, 0));
  EXPECT_EQ(turn.motion, REGISTA_MOTION_VELOCITY);
  EXPECT_EQ(turn.velocity[0], 0.0);
  EXPECT_EQ(turn.velocity[1], 0.0);
  EXPECT_EQ(turn.velocity[2], -0.6);
  const regista_action walk = behaviour.act(scene, BodyBuilder{}.at(-1, 0).task(0));
  EXPECT_EQ(walk.motion, REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(walk.pose[0], 1.0);
  EXPECT_EQ(walk.pose[2], 0.5);
}

// Over one sweep the camera sees every direction that the head reaches, and each only in passing.
TEST(SearchPlugin, ScansToBothEnds) {
  Instance behaviour(Loaded(REGISTA_PLUGIN_FILE, "search"), EnvironmentBuilder{}.own(3));
  double lowest = 0.0, highest = 0.0, last = 0.0;
  for (int k = 0; k < 40; ++k) {
    const Scene scene = FrameBuilder{}.own(3).robot(3).no_ball().time(0.1 * k).build();
    const double gaze = behaviour.act(scene, BodyBuilder{}).gaze;
    if (k > 0) {
      EXPECT_LE(std::abs(gaze - last), 0.16) << "to and fro in 4 s, half a turn each way";
    }
    last = gaze;
    lowest = std::min(lowest, gaze);
    highest = std::max(highest, gaze);
  }
  EXPECT_LT(lowest, -1.4);
  EXPECT_GT(highest, 1.4);
}

// Two searchers with tasks, and a third task that nobody has: its part of the field is theirs.
TEST(SearchPlugin, DividesTheFieldAmongThoseWhoSearch) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "search");
  Instance behaviour(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("divides_field", 1));
  double farthest = 0.0;
  double x = -2.0;
  for (int k = 0; k < 1200; ++k) {
    const Scene scene = FrameBuilder{}
                            .own(3)
                            .time(0.1 * k)
                            .robot(3)
                            .at(x, 0)
                            .no_ball()
                            .task("search_1")
                            .at(-2, 0)
                            .task("search_2")
                            .at(3, 0)
                            .build();
    const regista_action action = behaviour.act(scene, BodyBuilder{}.at(x, 0).task(0));
    if (action.motion != REGISTA_MOTION_WALK_TO) continue;
    farthest = std::max(farthest, action.pose[0]);
    x += std::clamp(action.pose[0] - x, -0.025, 0.025);  // it walks 0.25 m/s
  }
  EXPECT_GT(farthest, 2.0) << "the only searcher looks everywhere";
}

TEST(SearchPlugin, TurnsFirstInEachSearch) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "search");
  Instance behaviour(plugin, EnvironmentBuilder{}.own(3), Values(plugin).set("search_turn_seconds", 5));
  const auto motion = [&](double time) {
    const Scene scene = FrameBuilder{}.own(3).time(time).robot(3).no_ball().task("search_1").at(1, 1).build();
    return behaviour.act(scene, BodyBuilder{}.at(-1, 0).task(0)).motion;
  };
  EXPECT_EQ(motion(10.0), REGISTA_MOTION_VELOCITY);
  EXPECT_EQ(motion(12.0), REGISTA_MOTION_VELOCITY);
  EXPECT_EQ(motion(14.9), REGISTA_MOTION_VELOCITY);
  EXPECT_EQ(motion(15.1), REGISTA_MOTION_WALK_TO);
  EXPECT_EQ(motion(18.0), REGISTA_MOTION_WALK_TO) << "still the same search";
  EXPECT_EQ(motion(22.0), REGISTA_MOTION_VELOCITY) << "another one";
}

REGISTA_CONDUCT_TESTS("search", REGISTA_BEHAVIOUR_SEARCHES);

}  // namespace
