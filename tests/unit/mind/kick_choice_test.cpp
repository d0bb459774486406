// SPDX-License-Identifier: MIT
// Which kick is chosen: the open goal, not through an opponent, not now this and now that.
#include "mind/behaviour/kick_choice.hpp"

#include <gtest/gtest.h>

#include <random>

namespace regista::mind {
namespace {

class KickChoice : public testing::Test {
 protected:
  KickPlan choose(const Vector2d& ball, const std::optional<KickPlan>& last = {}) {
    Situation situation{.rules = rules,
                        .robot = robot,
                        .world = world,
                        .placement = placement,
                        .own_number = 2,
                        .pose = pose,
                        .frame = Frame2(pose),
                        .target = pose,
                        .robots_near = {}};
    situation.ball = ball;
    return choose_kick(situation, last);
  }
  void opponent(double x, double y) {
    regista_opponent each{};
    each.position[0] = x;
    each.position[1] = y;
    each.weight = 1.0;
    world.opponents.push_back(each);
  }
  // y where the ball crosses the opponent's goal line.
  static double crosses(const Vector2d& ball, const KickPlan& plan) {
    return ball.y() + plan.direction.y() / plan.direction.x() * (4.5 - ball.x());
  }
  bool scores(const Vector2d& ball, const KickPlan& plan) const {
    if (plan.direction.x() <= 0.0) return false;
    const double to_line = (4.5 - ball.x()) / plan.direction.x();
    return std::abs(crosses(ball, plan)) < 0.75 && plan.distance > to_line;
  }
  // Least distance of an opponent from the segment that the ball rolls.
  double clearance(const Vector2d& ball, const KickPlan& plan) const {
    double least = 1e9;
    for (const regista_opponent& each : world.opponents) {
      const Vector2d at(each.position[0], each.position[1]);
      const Vector2d nearest = nearest_on_segment(ball, ball + plan.direction * plan.distance, at);
      least = std::min(least, (nearest - at).norm());
    }
    return least;
  }

  config::Rules rules;
  config::Robot robot;
  DistributedWorldModel world{7};
  plugin::Placement placement;
  Pose pose;
};

TEST_F(KickChoice, ShootsAtAnOpenGoal) {
  for (const double x : {1.0, 2.0, 3.0, 3.5}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      EXPECT_TRUE(scores({x, y}, choose({x, y}))) << "from " << x << ", " << y;
    }
  }
}

TEST_F(KickChoice, ShootsBesideTheOneInTheWay) {
  opponent(3.6, 0.0);
  const Vector2d ball(2.5, 0.0);
  const KickPlan plan = choose(ball);
  EXPECT_GT(clearance(ball, plan), 0.1);
  EXPECT_LT(plan.direction.x(), 1.0);
}

// Too far from the goal for a shot.
TEST_F(KickChoice, AvoidsABlockedLine) {
  const Vector2d ball(-2.0, 0.0);
  EXPECT_NEAR(choose(ball).direction.y(), 0.0, 1e-9);
  opponent(-1.0, 0.0);
  const KickPlan plan = choose(ball);
  EXPECT_GT(clearance(ball, plan), 0.3);
  EXPECT_GT(plan.direction.x(), 0.0) << "still forward";
}

TEST_F(KickChoice, DoesNotShootThroughAnOpponent) {
  const Vector2d ball(0.0, 0.0);
  opponent(1.0, 0.0);
  EXPECT_GT(clearance(ball, choose(ball)), 0.3);
}

TEST_F(KickChoice, KeepsItsChoiceUnlessAnotherIsClearlyBetter) {
  const Vector2d ball(-2.0, 0.0);
  opponent(-0.5, 0.0);  // left and right are equally good
  const KickPlan first = choose(ball);
  KickPlan mirrored = first;
  mirrored.direction.y() = -mirrored.direction.y();
  ASSERT_GT(std::abs(first.direction.y()), 0.1);
  const KickPlan kept = choose(ball, mirrored);
  EXPECT_NEAR(kept.direction.y(), mirrored.direction.y(), 1e-9);
  EXPECT_EQ(kept.kind, mirrored.kind);
  // The kept side is closed: it changes.
  opponent(-0.5, mirrored.direction.y() * 1.5 / mirrored.direction.x());
  EXPECT_LT(choose(ball, mirrored).direction.y() * mirrored.direction.y(), 0.0);
}

TEST_F(KickChoice, AnyPlanIsAKickThatTheRobotHas) {
  std::mt19937_64 engine(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  for (int round = 0; round < 1000; ++round) {
    world.opponents.clear();
    const int count = static_cast<int>(engine() % 8);
    for (int i = 0; i < count; ++i) {
      const double x = in(-4.5, 4.5), y = in(-3, 3);
      opponent(x, y);
    }
    const double x = in(-4.6, 4.6), y = in(-3.1, 3.1);
    const KickPlan plan = choose({x, y});
    ASSERT_GE(plan.kind, 0);
    ASSERT_LT(static_cast<std::size_t>(plan.kind), robot.kicks.size());
    const config::Kick& kick = robot.kicks[static_cast<std::size_t>(plan.kind)];
    EXPECT_GE(plan.distance, kick.minimum_distance);
    EXPECT_LE(plan.distance, kick.maximum_distance);
    EXPECT_NEAR(plan.direction.norm(), 1.0, 1e-9);
  }
}

TEST_F(KickChoice, PassesOnlyToWhoStandsAndSpoke) {
  // Every way ahead is closed but the one to the teammate on the left.
  for (int k = -5; k <= 2; ++k) opponent(-1.0, 0.3 * k);
  regista_robot& mate = world.robot(5);
  mate.pose[0] = -0.5;
  mate.pose[1] = 2.8;
  mate.flags = REGISTA_ROBOT_ACTIVE | REGISTA_ROBOT_KNOWN;
  const Vector2d aim = Vector2d(1.8, 2.8).normalized();
  const Vector2d ball(-2.0, 0.0);
  EXPECT_GT(choose(ball).direction.dot(aim), 0.99);
  mate.flags |= REGISTA_ROBOT_FALLEN;
  EXPECT_LT(choose(ball).direction.dot(aim), 0.99);
  mate.flags = REGISTA_ROBOT_KNOWN;
  EXPECT_LT(choose(ball).direction.dot(aim), 0.99);
}

}  // namespace
}  // namespace regista::mind
