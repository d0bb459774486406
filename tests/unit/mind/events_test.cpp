// SPDX-License-Identifier: MIT
// Each event when it should, and only then. What happens in a moment is told once; what lasts (the team's belief is
// wrong) is told until a packet has mended it.
#include "mind/coordination/coordination.hpp"

#include <gtest/gtest.h>

#include <map>

#include "team.hpp"

namespace regista::mind {
namespace {

class Events : public testing::Test {
 protected:
  void make(int number) {
    own = number;
    plan = plan_of(team());
    world = world_model(*plan, number);
    detector = std::make_unique<EventDetector>(number);
  }

  // One decision at `time`; returns kind -> value.
  std::map<int, double> at(double time, Percepts given, bool searching = false, const std::vector<Report>& heard = {}) {
    const double dt = time - now;
    now = given.time = time;
    world->sense(given, dt, nullptr);
    for (const Report& each : heard) world->hear(each, time);
    world->fuse(given, dt, {});
    std::vector<regista_event> out{{99, 0, 0.0}};
    detector->detect(given, *world, decision, searching, out);
    std::map<int, double> found;
    for (const regista_event& each : out) {
      EXPECT_TRUE(found.emplace(each.kind, each.value).second) << "twice in one decision: " << each.kind;
    }
    return found;
  }
  std::map<int, double> at(double time) { return at(time, percepts(time)); }

  static Percepts with_ball(double time, double x = 1.0) {
    Percepts out = percepts(time);
    out.balls.push_back({{x, 0.0}, 0.05, 0.05});
    return out;
  }
  // Its own packet, as the others decoded it.
  Report own_packet(double time, double ball_x) const {
    Report out = report(own, time);
    out.ball = ReportedBall{{ball_x, 0.0}, {0, 0}, 0.05, 0.0};
    return out;
  }

  int own = 2;
  double now = 0.0;
  Decision decision;
  std::unique_ptr<TeamPlan> plan;
  std::unique_ptr<WorldModel> world;
  std::unique_ptr<EventDetector> detector;
};

using Found = std::map<int, double>;

TEST_F(Events, NothingHappens) {
  make(2);
  at(0.0);
  for (int k = 1; k < 50; ++k) EXPECT_EQ(at(0.1 * k), Found{});
}

TEST_F(Events, Whistle) {
  make(2);
  at(0.0);
  Percepts given = percepts(0.1);
  given.whistle = true;
  EXPECT_EQ(at(0.1, given), (Found{{REGISTA_EVENT_WHISTLE, 0.0}}));
  EXPECT_EQ(at(0.2), Found{});
}

TEST_F(Events, FallingAndGettingUp) {
  make(2);
  at(0.0);
  Percepts lying = percepts(0.0);
  lying.fallen = true;
  EXPECT_EQ(at(0.1, lying), (Found{{REGISTA_EVENT_FELL, 0.0}}));
  EXPECT_EQ(at(0.2, lying), Found{});
  EXPECT_EQ(at(0.3), (Found{{REGISTA_EVENT_GOT_UP, 0.0}}));
  EXPECT_EQ(at(0.4), Found{});
}

TEST_F(Events, ReturnsFromAPenalty) {
  make(2);
  at(0.0);
  Percepts out = percepts(0.0);
  out.penalised = true;
  EXPECT_EQ(at(0.1, out), Found{});
  EXPECT_EQ(at(0.2, out), Found{});
  EXPECT_EQ(at(0.3), (Found{{REGISTA_EVENT_RETURNED, 0.0}}));
  EXPECT_EQ(at(0.4), Found{});
}

TEST_F(Events, PhaseChanges) {
  make(2);
  at(0.0, percepts(0.0, Phase::ready));
  EXPECT_EQ(at(0.1, percepts(0.1, Phase::ready)), Found{});
  EXPECT_EQ(at(0.2, percepts(0.2, Phase::set)), (Found{{REGISTA_EVENT_PHASE_CHANGED, REGISTA_PHASE_SET}}));
  // A teammate's packet starts the game; the game controller says so later, which is no change any more.
  Report told = report(5, 0.25);
  told.playing = true;
  EXPECT_EQ(at(0.3, percepts(0.3, Phase::set), false, {told}),
            (Found{{REGISTA_EVENT_PHASE_CHANGED, REGISTA_PHASE_PLAYING}}));
  EXPECT_EQ(at(0.4), Found{});
}

TEST_F(Events, RoleAndContextChanges) {
  make(2);
  decision.own_role = 3;
  decision.context = 0;
  at(0.0);
  EXPECT_EQ(at(0.1), Found{});
  decision.own_role = 5;
  EXPECT_EQ(at(0.2), (Found{{REGISTA_EVENT_ROLE_CHANGED, 5.0}}));
  EXPECT_EQ(at(0.3), Found{});
  decision.context = 1;
  decision.own_role = -1;
  EXPECT_EQ(at(0.4), (Found{{REGISTA_EVENT_ROLE_CHANGED, -1.0}, {REGISTA_EVENT_CONTEXT_CHANGED, 1.0}}));
  EXPECT_EQ(at(0.5), Found{});
}

TEST_F(Events, ASearcherFindsTheBallOnce) {
  make(2);
  at(0.0);
  EXPECT_EQ(at(5.0, percepts(5.0), true), Found{});
  // Seeing it has ended the search by the time of the decision.
  const Found found = at(5.1, with_ball(5.1), false);
  ASSERT_EQ(found.count(REGISTA_EVENT_BALL_FOUND), 1u);
  EXPECT_NEAR(found.at(REGISTA_EVENT_BALL_FOUND), 5.1, 1e-12);
  EXPECT_EQ(at(5.2, with_ball(5.2), false).count(REGISTA_EVENT_BALL_FOUND), 0u);
}

TEST_F(Events, ASearchThatGoesOnFindsTheBallOnceToo) {
  make(2);
  at(0.0);
  at(5.0, percepts(5.0), true);
  EXPECT_EQ(at(5.1, with_ball(5.1), true).count(REGISTA_EVENT_BALL_FOUND), 1u);
  for (int k = 2; k < 20; ++k) {
    const double time = 5.0 + 0.1 * k;  // now and then missed for a frame
    const Found found = at(time, k % 5 == 0 ? percepts(time) : with_ball(time), true);
    EXPECT_EQ(found.count(REGISTA_EVENT_BALL_FOUND), 0u);
  }
}

TEST_F(Events, WhoDoesNotSearchDoesNotFind) {
  make(2);
  at(0.0);
  EXPECT_EQ(at(5.0, with_ball(5.0)).count(REGISTA_EVENT_BALL_FOUND), 0u);
}

TEST_F(Events, TheGoalkeeperSeesTheBallAgain) {
  for (const int number : {1, 2}) {
    now = 0.0;
    make(number);
    at(0.0);
    at(1.0, with_ball(1.0));
    at(3.0);
    const Found found = at(9.5, with_ball(9.5));
    EXPECT_EQ(found.count(REGISTA_EVENT_GOALKEEPER_SAW_BALL), number == 1 ? 1u : 0u);
    if (number == 1) {
      EXPECT_NEAR(found.at(REGISTA_EVENT_GOALKEEPER_SAW_BALL), 8.5, 1e-12);
    }
    EXPECT_EQ(at(9.6, with_ball(9.6)).count(REGISTA_EVENT_GOALKEEPER_SAW_BALL), 0u);
  }
}

TEST_F(Events, TheBallIsKnownAgainUntilAPacketSaysSo) {
  make(2);
  at(0.0);
  EXPECT_NEAR(at(6.0, with_ball(6.0)).at(REGISTA_EVENT_BALL_KNOWN_AGAIN), 6.0, 1e-12);
  EXPECT_NEAR(at(6.1, with_ball(6.1)).at(REGISTA_EVENT_BALL_KNOWN_AGAIN), 6.1, 1e-12);
  EXPECT_EQ(at(6.2, with_ball(6.2), false, {own_packet(6.15, 1.0)}), Found{});
  EXPECT_EQ(at(7.0, with_ball(7.0)), Found{}) << "not long enough to be news";
  EXPECT_NEAR(at(9.0, with_ball(9.0)).at(REGISTA_EVENT_BALL_KNOWN_AGAIN), 2.85, 1e-9);
}

TEST_F(Events, TheLackOfTheBallCountsOnWhenItIsForgotten) {
  make(2);
  at(0.0);
  at(6.2, with_ball(6.2), false, {own_packet(6.2, 1.0)});
  at(30.0);
  EXPECT_NEAR(at(50.2, with_ball(50.2)).at(REGISTA_EVENT_BALL_KNOWN_AGAIN), 44.0, 1e-9);
}

TEST_F(Events, TheBallLeavesWhatTheTeamBelieves) {
  make(2);
  at(0.0, with_ball(0.0), false, {own_packet(0.0, 1.0)});
  EXPECT_EQ(at(0.1, with_ball(0.1, 1.25)), Found{});
  const Found moved = at(0.2, with_ball(0.2, 1.5));
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_NEAR(moved.at(REGISTA_EVENT_BALL_MOVED), 0.5, 1e-9);
  EXPECT_EQ(at(0.3).count(REGISTA_EVENT_BALL_MOVED), 0u) << "not seen now";
  EXPECT_EQ(at(0.4, with_ball(0.4, 1.5), false, {own_packet(0.35, 1.5)}), Found{});
}

TEST_F(Events, TheRobotLeavesWhatTheTeamBelieves) {
  make(2);
  at(0.0, percepts(0.0), false, {report(2, 0.0)});
  Percepts walking = percepts(0.0);
  walking.odometry.x = 0.15;
  EXPECT_EQ(at(0.1, walking), Found{});
  const Found moved = at(0.2, walking);
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_NEAR(moved.at(REGISTA_EVENT_POSE_MOVED), 0.3, 1e-9);
  EXPECT_EQ(at(0.3, percepts(0.3), false, {report(2, 0.3, 0.3, 0.0)}), Found{});
}

}  // namespace
}  // namespace regista::mind
