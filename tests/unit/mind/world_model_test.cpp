// SPDX-License-Identifier: MIT
// The distributed world model: what is common is common, who counts as active, what grows old, who started the game.
#include "mind/world/world_model.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "team.hpp"

namespace regista::mind {
namespace {

class World : public testing::Test {
 protected:
  std::unique_ptr<TeamPlan> plan = plan_of(team());
  std::unique_ptr<WorldModel> world = world_model(*plan, 2);
  double now = 0.0;

  void tick(double time, Percepts given, const std::vector<Report>& heard = {}) {
    const double dt = time - now;
    now = given.time = time;
    world->sense(given, dt, nullptr);
    for (const Report& each : heard) world->hear(each, time);
    world->fuse(given, dt, OwnRole{});
  }
  void tick(double time, const std::vector<Report>& heard = {}) { tick(time, percepts(time), heard); }
};

bool same_bytes(const auto& a, const auto& b) {
  static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(a)>>);
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_F(World, CommonIsBitEqualForAllWhoHeardTheSame) {
  std::mt19937_64 engine(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  const auto other = world_model(*plan, 5);
  for (int k = 1; k <= 300; ++k) {
    const double time = 0.1 * k;
    std::vector<Report> heard;
    for (int sender = 1; sender <= 7; ++sender) {
      if (in(0, 1) > 0.1) continue;
      Report each = report(sender, time - in(0.0, 0.1), in(-4, 4), in(-3, 3));
      each.velocity = {in(-0.3, 0.3), in(-0.3, 0.3)};
      if (in(0, 1) < 0.5)
        each.ball = ReportedBall{{in(-1, 1), in(-1, 1)}, {in(-1, 1), in(-1, 1)}, in(0, 0.3), in(0, 2)};
      each.opponent_count = 2;
      for (std::size_t i = 0; i < 2; ++i) each.opponents[i] = {{in(-4, 4), in(-3, 3)}, in(0, 0.5), in(0, 3)};
      heard.push_back(each);
    }
    // What the two see themselves differs.
    Percepts mine = percepts(time), theirs = percepts(time);
    mine.odometry = {in(0, 0.02), 0.0, in(-0.1, 0.1)};
    theirs.odometry = {in(0, 0.02), 0.0, in(-0.1, 0.1)};
    mine.balls.push_back({{in(0.5, 3), in(-1, 1)}, 0.1, 0.05});
    theirs.robots.push_back({{in(0.5, 3), in(-1, 1)}, 0.1, 0.05, false});
    const double before = now;
    tick(time, mine, heard);
    const double dt = now - before;  // not 0.1 to the last bit
    other->sense(theirs, dt, nullptr);
    for (const Report& each : heard) other->hear(each, time);
    other->fuse(theirs, dt, OwnRole{});

    const DistributedWorldModel &a = world->common(), &b = other->common();
    EXPECT_TRUE(same_bytes(a.ball_state, b.ball_state));
    EXPECT_TRUE(same_bytes(a.game, b.game));
    EXPECT_EQ(a.active, b.active);
    ASSERT_EQ(a.opponents.size(), b.opponents.size());
    for (std::size_t i = 0; i < a.opponents.size(); ++i) EXPECT_TRUE(same_bytes(a.opponents[i], b.opponents[i]));
    for (int number = 1; number <= 7; ++number) {
      regista_robot one = a.robot(number), two = b.robot(number);
      EXPECT_EQ((one.flags & REGISTA_ROBOT_SELF) != 0, number == 2);
      EXPECT_EQ((two.flags & REGISTA_ROBOT_SELF) != 0, number == 5);
      one.flags &= ~std::uint32_t{REGISTA_ROBOT_SELF};
      two.flags &= ~std::uint32_t{REGISTA_ROBOT_SELF};
      EXPECT_TRUE(same_bytes(one, two)) << "robot " << number << " at " << time;
    }
  }
}

TEST_F(World, RobotsNeverHeardOfHaveNoRoleAndNoFreshNews) {
  tick(0.0);
  tick(12.0);
  for (int number = 1; number <= 7; ++number) {
    if (number == 2) continue;
    const regista_robot& robot = world->mine().robot(number);
    EXPECT_EQ(robot.number, number);
    EXPECT_EQ(robot.flags, 0u);
    EXPECT_EQ(robot.role, -1);
    EXPECT_EQ(robot.age, 12.0);
  }
  EXPECT_EQ(world->mine().active, std::vector<std::int32_t>{2});
  EXPECT_TRUE(world->common().active.empty()) << "the own robot has not said anything yet";
  EXPECT_FALSE(world->mine().ball_known());
}

TEST_F(World, TellsWhatAPacketSaidCarriedForward) {
  Report told = report(4, 1.0, 1.0, -1.0);
  told.pose.heading = 0.5;
  told.velocity = {0.2, -0.1};
  told.target = {3.0, 2.0};
  told.role = 6;
  told.role_since = 0.4;
  told.time_until_up = 2.0;
  told.heading_deviation = 0.2;
  tick(1.2, {told});
  tick(2.0);
  for (const DistributedWorldModel* each : {&world->mine(), &world->common()}) {
    const regista_robot& robot = each->robot(4);
    EXPECT_EQ(robot.flags, std::uint32_t{REGISTA_ROBOT_ACTIVE | REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET |
                                         REGISTA_ROBOT_FALLEN});
    EXPECT_NEAR(robot.pose[0], 1.2, 1e-12);
    EXPECT_NEAR(robot.pose[1], -1.1, 1e-12);
    EXPECT_NEAR(robot.pose[2], 0.5, 1e-12);
    EXPECT_NEAR(robot.age, 1.0, 1e-12);
    EXPECT_NEAR(robot.time_until_up, 1.0, 1e-12);
    EXPECT_EQ(robot.role, 6);
    EXPECT_EQ(robot.role_since, 0.4);
    EXPECT_EQ(robot.target[0], 3.0);
    EXPECT_EQ(robot.target[1], 2.0);
    EXPECT_NEAR(robot.covariance[0], 0.1 * 0.1, 2e-4);
    EXPECT_NEAR(robot.covariance[5], 0.04, 1e-12);
  }
  tick(3.1);
  EXPECT_EQ(world->mine().robot(4).flags & REGISTA_ROBOT_FALLEN, 0u) << "up again by now";
}

TEST_F(World, AStalePacketDoesNotOverwriteANewer) {
  tick(5.0, {report(3, 4.9, 1.0), report(3, 4.5, -2.0), report(3, 4.9, 4.0)});
  EXPECT_EQ(world->mine().robot(3).pose[0], 1.0);
  Report old = report(3, 4.8, -2.0);
  old.ball = ReportedBall{{1, 1}, {0, 0}, 0.1, 0.0};
  old.opponent_count = 1;
  tick(5.1, {old});
  EXPECT_EQ(world->mine().robot(3).pose[0], 1.0);
  EXPECT_FALSE(world->common().ball_known());
  EXPECT_TRUE(world->common().opponents.empty());
  tick(5.2, {report(3, 5.0, 2.0)});
  EXPECT_EQ(world->mine().robot(3).pose[0], 2.0);
}

TEST_F(World, ANewPacketReplacesBallAndOpponentsToo) {
  Report told = report(3, 1.0);
  told.ball = ReportedBall{{1, 1}, {0, 0}, 0.1, 0.5};
  told.opponent_count = 2;
  told.opponents[0].position = {2, 2};
  told.opponents[1].position = {-2, 2};
  tick(1.0, {told});
  EXPECT_TRUE(world->common().ball_known());
  EXPECT_DOUBLE_EQ(world->common().ball_state.age, 0.5);
  EXPECT_EQ(world->common().opponents.size(), 2u);
  tick(2.0, {report(3, 2.0)});
  EXPECT_FALSE(world->common().ball_known()) << "seen 1.5 s ago, its sender would have told it";
  EXPECT_TRUE(world->common().opponents.empty());
}

TEST_F(World, APacketKeepsWhatItsSenderLeavesOutForItsAge) {
  Report told = report(3, 1.0);
  told.ball = ReportedBall{{1, 1}, {0, 0}, 0.1, 9.5};
  told.opponent_count = 2;
  told.opponents[0] = {{-4, 2}, 0.1, 3.5};
  told.opponents[1] = {{-4, -2}, 0.1, 3.5};
  tick(1.0, {told});
  Report next = report(3, 2.0);
  next.opponent_count = 1;
  next.opponents[0] = {{-4, -1.8}, 0.1, 0.0};
  tick(2.0, {next});
  EXPECT_TRUE(world->common().ball_known());
  EXPECT_DOUBLE_EQ(world->common().ball_state.age, 10.5);
  ASSERT_EQ(world->common().opponents.size(), 2u);
  std::vector<double> y;
  for (const regista_opponent& each : world->common().opponents) y.push_back(each.position[1]);
  std::ranges::sort(y);
  EXPECT_NEAR(y[0], -1.8, 1e-9);
  EXPECT_NEAR(y[1], 2.0, 1e-9) << "4.5 s old: its sender would not tell it any more";
}

TEST_F(World, ASeenTeammateIsWhereTheEyesSeeIt) {
  Percepts given = percepts(1.0);
  given.placed = PlacedPose{{0.0, 0.0, 0.0}, 0.01, 0.01};
  given.robots.push_back({{2.0, 0.5}, 0.05, 0.05, true});
  Report told = report(4, 1.0, 2.0, 0.0);
  told.position_deviation = 0.5;
  tick(1.0, given, {told, report(5, 1.0, -3.0, 0.0)});
  EXPECT_NEAR(world->mine().robot(4).pose[1], 0.5, 0.02);
  EXPECT_LT(world->mine().robot(4).covariance[2], 0.01);
  EXPECT_EQ(world->common().robot(4).pose[1], 0.0) << "what the eyes see is not common";
}

TEST_F(World, PenalisedBitsBelongToTheirRobots) {
  tick(1.0, {report(1, 1.0), report(3, 1.0), report(7, 1.0)});
  EXPECT_EQ(world->mine().active, (std::vector<std::int32_t>{1, 2, 3, 7}));
  EXPECT_EQ(world->common().active, (std::vector<std::int32_t>{1, 3, 7}));
  Percepts given = percepts(1.1);
  given.game.own_penalised = 1u << 0 | 1u << 6;
  tick(1.1, given);
  EXPECT_EQ(world->mine().active, (std::vector<std::int32_t>{2, 3}));
  EXPECT_EQ(world->common().active, (std::vector<std::int32_t>{3}));
  for (const int number : {1, 7}) {
    EXPECT_NE(world->mine().robot(number).flags & REGISTA_ROBOT_PENALISED, 0u);
    EXPECT_NE(world->common().robot(number).flags & REGISTA_ROBOT_PENALISED, 0u);
  }
  tick(1.2);
  EXPECT_EQ(world->common().active, (std::vector<std::int32_t>{1, 3, 7})) << "let in again";
  given = percepts(1.3);
  given.penalised = true;
  tick(1.3, given);
  EXPECT_EQ(world->mine().active, (std::vector<std::int32_t>{1, 3, 7})) << "the robot itself knows at once";
}

TEST_F(World, ForgetsATeammateAfterTwentyFiveSeconds) {
  tick(1.0, {report(4, 1.0)});
  tick(25.9);
  EXPECT_TRUE(world->mine().is_active(4));
  EXPECT_TRUE(world->common().is_active(4));
  tick(26.1);
  EXPECT_FALSE(world->mine().is_active(4));
  EXPECT_FALSE(world->common().is_active(4));
  EXPECT_NE(world->mine().robot(4).flags & REGISTA_ROBOT_KNOWN, 0u);
  tick(27.0, {report(4, 26.9)});
  EXPECT_TRUE(world->mine().is_active(4)) << "it speaks again";
}

TEST_F(World, ATeammateThatHeardTheWhistleStartsTheGame) {
  Percepts waiting = percepts(100.0, Phase::set);
  waiting.game.phase_time = 4.0;  // since 96.0
  Report told = report(6, 95.9);
  told.playing = true;
  tick(100.0, waiting, {told});
  EXPECT_EQ(world->mine().game.phase, REGISTA_PHASE_SET) << "that was before this Set";
  waiting.game.phase_time = 4.1;
  told.time_sent = 100.05;
  tick(100.1, waiting, {told});
  EXPECT_EQ(world->mine().game.phase, REGISTA_PHASE_PLAYING);
  EXPECT_EQ(world->common().game.phase, REGISTA_PHASE_PLAYING);
  Percepts ready = percepts(100.2, Phase::ready);
  tick(100.2, ready);
  EXPECT_EQ(world->mine().game.phase, REGISTA_PHASE_READY);
}

TEST_F(World, TheBallOfAKickOffLiesOnTheCentreUntilSomebodyHeardTheWhistle) {
  Percepts waiting = percepts(100.0, Phase::set);
  waiting.game.set_play = SetPlay::kick_off;
  waiting.placed = placed(-1.0, 0.0);
  tick(100.0, waiting);
  EXPECT_TRUE(world->mine().ball_known());
  EXPECT_NEAR(world->mine().ball().norm(), 0.0, 1e-12);
  EXPECT_FALSE(world->local().sees_ball()) << "nobody saw it";
  waiting.placed.reset();
  Report told = report(6, 100.05);
  told.playing = true;
  tick(100.1, waiting, {told});
  waiting.balls.push_back({{3.0, 0.0}, 0.1, 0.05});  // it has been kicked
  tick(100.2, waiting);
  EXPECT_TRUE(world->local().sees_ball());
  EXPECT_NEAR(world->local().balls().front().x, 2.0, 1e-9);
}

TEST_F(World, SightingsComeIntoTheFieldFrameWithTheOwnUncertainty) {
  Percepts given = percepts(1.0);
  given.placed = PlacedPose{{1.0, 2.0, pi / 2}, 0.1, 0.05};
  given.balls.push_back({{2.0, 0.0}, 0.3, 0.2});
  given.robots.push_back({{0.0, 1.0}, 0.1, 0.1, false});
  given.robots.push_back({{1.0, 1.0}, 0.1, 0.1, true});
  tick(1.0, given);
  const regista_track& ball = world->local().balls().front();
  EXPECT_NEAR(ball.x, 1.0, 1e-12);
  EXPECT_NEAR(ball.y, 4.0, 1e-12);
  // Along the line of sight, now y: 0.3; across it, x: 0.2 and 2 m times 0.05 rad; 0.1 of the own place to both.
  EXPECT_NEAR(ball.covariance[0], 0.04 + 0.01 + 0.01, 1e-12);
  EXPECT_NEAR(ball.covariance[2], 0.09 + 0.01, 1e-12);
  EXPECT_NEAR(ball.covariance[1], 0.0, 1e-12);
  ASSERT_EQ(world->local().teammates().size(), 1u);
  EXPECT_NEAR(world->local().teammates()[0].x, 0.0, 1e-12);
  EXPECT_NEAR(world->local().teammates()[0].y, 3.0, 1e-12);
  ASSERT_EQ(world->local().opponents().size(), 1u) << "the own team is no opponent";
  EXPECT_NEAR(world->local().opponents()[0].x, 0.0, 1e-12);
  EXPECT_NEAR(world->local().opponents()[0].y, 2.0, 1e-12);
}

// The covariance of an oblique sighting against the sample covariance of many noisy ones.
TEST_F(World, SightingCovarianceAgainstSampling) {
  Percepts given = percepts(1.0);
  given.placed = PlacedPose{{-1.0, 0.5, 0.7}, 0.05, 0.04};
  given.balls.push_back({{2.0, 1.0}, 0.2, 0.05});
  tick(1.0, given);
  const regista_track& ball = world->local().balls().front();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  const Vector2d line = Vector2d(2.0, 1.0).normalized(), side(-line.y(), line.x());
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double dx = 0.05 * normal(engine), dy = 0.05 * normal(engine), dh = 0.04 * normal(engine);
    const double along = 0.2 * normal(engine), across = 0.05 * normal(engine);
    const Vector2d seen = Vector2d(2.0, 1.0) + along * line + across * side;
    const Vector2d error = Frame2(Pose{-1.0 + dx, 0.5 + dy, 0.7 + dh}).to_field(seen) - Vector2d(ball.x, ball.y);
    sum += error * error.transpose() / n;
  }
  EXPECT_NEAR(ball.covariance[0], sum(0, 0), 0.03 * sum(0, 0));
  EXPECT_NEAR(ball.covariance[2], sum(1, 1), 0.03 * sum(1, 1));
  EXPECT_NEAR(ball.covariance[1], sum(0, 1), 0.03 * sum(0, 0));
}

TEST_F(World, ABallLookedForInVainIsRefuted) {
  Report told = report(3, 1.0, 3.0, 0.0);
  told.ball = ReportedBall{{2.0, 0.0}, {0, 0}, 0.1, 0.0};
  Percepts looking = percepts(1.0);
  looking.view = {0.0, 0.5, 5.0, 4.0};
  looking.placed = placed(0.0, 0.0);
  tick(0.9, looking);
  looking.placed.reset();
  tick(1.0, looking, {told});
  for (int k = 1; k <= 4; ++k) tick(1.0 + 0.1 * k, looking);
  EXPECT_FALSE(world->ball_refuted());
  for (int k = 5; k <= 8; ++k) tick(1.0 + 0.1 * k, looking);
  EXPECT_TRUE(world->ball_refuted());
  EXPECT_TRUE(world->common().ball_known());
  // Fresh news start the count again; a ball behind one's back is never refuted.
  told.time_sent = 1.85;
  tick(1.9, looking, {told});
  EXPECT_FALSE(world->ball_refuted());
  looking.view.heading = pi / 2;
  for (int k = 10; k <= 30; ++k) tick(1.0 + 0.1 * k, looking);
  EXPECT_FALSE(world->ball_refuted());
}

}  // namespace
}  // namespace regista::mind
