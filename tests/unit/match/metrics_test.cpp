// SPDX-License-Identifier: MIT
// The measures on courses that can be counted by hand.
#include "match/metrics.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace regista::match {
namespace {

const std::vector<Role> table{{"goalkeeper", "playing", 0, 1},
                              {"striker", "playing", 1, 0},
                              {"supporter", "playing", 2, 0},
                              {"libero", "playing", 3, 0},
                              {"searcher", "searching", 0, 0}};

struct Course : testing::Test {
  Metrics metrics{3, {table, {}}};
  GameState state;
  Course() { state.phase = mind::Phase::playing; }

  void decide(int number, int role, std::vector<int> assignment = {}) {
    metrics.decided(Side::home, number, role, assignment, state);
  }
  void sample(int times) {
    for (int i = 0; i < times; ++i) metrics.sample(state);
  }
  const RoleMetrics& role(std::size_t row) {
    result = metrics.result();
    return result.teams[0].roles[row];
  }
  MatchMetrics result;
};

TEST_F(Course, CountsOverlapAndWhatIsUncovered) {
  decide(1, 0);
  decide(2, 1);
  decide(3, 1);
  sample(10);
  EXPECT_NEAR(role(1).overlap_seconds, 1.0, 1e-9);
  EXPECT_NEAR(role(2).uncovered_seconds, 1.0, 1e-9);
  EXPECT_EQ(role(3).uncovered_seconds, 0.0) << "three robots need not cover a fourth role";
  EXPECT_EQ(role(4).uncovered_seconds, 0.0) << "of a list that is not in force";
  EXPECT_NEAR(role(1).robot_seconds[1], 1.0, 1e-9);
  EXPECT_NEAR(role(1).robot_seconds[2], 1.0, 1e-9);
  EXPECT_EQ(role(1).robot_seconds[0], 0.0);
  decide(3, 2);
  sample(5);
  EXPECT_NEAR(role(1).overlap_seconds, 1.0, 1e-9);
  EXPECT_NEAR(role(2).uncovered_seconds, 1.0, 1e-9);
}

TEST_F(Course, PenalisedRobotsHoldNothingAndWantNothing) {
  decide(1, 0);
  decide(2, 1);
  decide(3, 1);
  state.penalised[0] = 0b001;
  sample(10);
  EXPECT_EQ(role(0).uncovered_seconds, 0.0) << "bound to a robot that cannot take it";
  EXPECT_EQ(role(2).uncovered_seconds, 0.0) << "only two robots";
  state.penalised[0] = 0b110;
  sample(10);
  EXPECT_NEAR(role(1).overlap_seconds, 1.0, 1e-9);
}

TEST_F(Course, CountsOnlyWhilePlaying) {
  state.phase = mind::Phase::ready;
  decide(2, 1);
  decide(3, 1);
  sample(10);
  EXPECT_EQ(role(1).overlap_seconds, 0.0);
  EXPECT_EQ(role(1).switches, 0);
  EXPECT_EQ(result.playing_seconds, 0.0);
}

TEST_F(Course, CountsRolesTaken) {
  decide(2, 1);
  decide(2, 1);
  decide(2, 2);
  decide(2, 1);
  decide(2, -1);
  decide(2, 1);
  EXPECT_EQ(role(1).switches, 3);
  EXPECT_EQ(role(2).switches, 1);
}

TEST_F(Course, AgreementIsTheShareOfEqualAssignments) {
  for (int number = 1; number <= 3; ++number) decide(number, -1, {0, 1, 2});
  sample(6);
  decide(3, -1, {0, 2, 1});
  sample(2);
  EXPECT_NEAR(metrics.result().teams[0].agreement, 6.0 / 8.0, 1e-12);
  state.penalised[0] = 0b100;
  sample(2);
  EXPECT_NEAR(metrics.result().teams[0].agreement, 8.0 / 10.0, 1e-12);
}

TEST_F(Course, PossessionGoesToTheLastTouchWhileTheBallIsInPlay) {
  sample(10);
  metrics.touched(Side::away);
  sample(20);
  state.set_play = mind::SetPlay::kick_in;
  sample(30);
  const MatchMetrics all = metrics.result();
  EXPECT_NEAR(all.playing_seconds, 6.0, 1e-9);
  EXPECT_NEAR(all.in_play_seconds, 3.0, 1e-9);
  EXPECT_NEAR(all.teams[1].possession_seconds, 2.0, 1e-9);
  EXPECT_EQ(all.teams[0].possession_seconds, 0.0);
}

TEST_F(Course, AccountsPacketsByReason) {
  metrics.sent(Side::home, 0);
  metrics.sent(Side::home, 5);
  metrics.sent(Side::home, 5);
  const TeamMetrics team = metrics.result().teams[0];
  EXPECT_EQ(team.packets, 3);
  EXPECT_EQ(team.packets_by_reason[0], 1);
  EXPECT_EQ(team.packets_by_reason[5], 2);
}

}  // namespace
}  // namespace regista::match
