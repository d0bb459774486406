// SPDX-License-Identifier: MIT
// Which kick is chosen: the open goal, not through an opponent, not now this and now that.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/dice.hpp>

#include "../kick_choice.hpp"

namespace {

using namespace behaviours;

class KickChoosing : public testing::Test {
 protected:
  KickPlan choose(const Vector2d& ball, const std::optional<KickPlan>& last = {},
                  const KickSettings& settings = {}) const {
    return KickChoice(settings).choose({field, ball, kinds, teammates, opponents, last});
  }
  // y where the ball crosses the opponent's goal line.
  static double crosses(const Vector2d& ball, const KickPlan& plan) {
    return ball.y() + plan.direction.y() / plan.direction.x() * (4.5 - ball.x());
  }
  static bool scores(const Vector2d& ball, const KickPlan& plan) {
    if (plan.direction.x() <= 0.0) return false;
    const double to_line = (4.5 - ball.x()) / plan.direction.x();
    return std::abs(crosses(ball, plan)) < 0.75 && plan.distance > to_line;
  }
  // Least distance of an opponent from the segment that the ball rolls.
  double clearance(const Vector2d& ball, const KickPlan& plan) const {
    double least = 1e9;
    for (const Blocker& each : opponents) {
      const Vector2d nearest = nearest_on_segment(ball, ball + plan.direction * plan.distance, each.position);
      least = std::min(least, (nearest - each.position).norm());
    }
    return least;
  }
  void opponent(double x, double y) { opponents.push_back({{x, y}, 1.0}); }

  Field field;
  std::vector<KickKind> kinds{{1.6, 4.5}, {5.4, 5.4}, {0.4, 1.0}};
  std::vector<Teammate> teammates;
  std::vector<Blocker> opponents;
};

TEST_F(KickChoosing, ShootsAtAnOpenGoal) {
  for (const double x : {1.0, 2.0, 3.0, 3.5}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      EXPECT_TRUE(scores({x, y}, choose({x, y}))) << "from " << x << ", " << y;
    }
  }
}

TEST_F(KickChoosing, ShootsBesideTheOneInTheWay) {
  opponent(3.6, 0.0);
  const Vector2d ball(2.5, 0.0);
  const KickPlan plan = choose(ball);
  EXPECT_GT(clearance(ball, plan), 0.1);
  EXPECT_LT(plan.direction.x(), 1.0);
}

// Aims off the middle by 0.9 * 0.6 of half the goal, 0.405 m.
TEST_F(KickChoosing, AimsAtThreePlacesOfTheGoal) {
  const Vector2d ball(2.5, 0.0);
  EXPECT_NEAR(crosses(ball, choose(ball)), 0.0, 1e-9);
  opponent(3.6, 0.1);
  EXPECT_NEAR(crosses(ball, choose(ball)), -0.405, 1e-9);
  opponents = {{{3.6, -0.1}, 1.0}};
  EXPECT_NEAR(crosses(ball, choose(ball)), 0.405, 1e-9);
  EXPECT_NEAR(crosses(ball, choose(ball, {}, {.beside_keeper = 1.0})), 0.675, 1e-9);
}

// Too far from the goal for a shot.
TEST_F(KickChoosing, AvoidsABlockedLine) {
  const Vector2d ball(-2.0, 0.0);
  EXPECT_NEAR(choose(ball).direction.y(), 0.0, 1e-9);
  opponent(-1.0, 0.0);
  const KickPlan plan = choose(ball);
  EXPECT_GT(clearance(ball, plan), 0.3);
  EXPECT_GT(plan.direction.x(), 0.0) << "still forward";
}

TEST_F(KickChoosing, DoesNotShootThroughAnOpponent) {
  const Vector2d ball(0.0, 0.0);
  opponent(1.0, 0.0);
  EXPECT_GT(clearance(ball, choose(ball)), 0.3);
}

// One that is hardly there does not stop a shot.
TEST_F(KickChoosing, CountsOpponentsByTheirWeight) {
  const Vector2d ball(-2.0, 0.0);
  opponents = {{{-1.0, 0.0}, 0.01}};
  EXPECT_NEAR(choose(ball).direction.y(), 0.0, 1e-9);
  EXPECT_NEAR(choose(ball, {}, {.blocked_cost = 0.1}).direction.y(), 0.0, 1e-9);
}

TEST_F(KickChoosing, KeepsItsChoiceUnlessAnotherIsClearlyBetter) {
  const Vector2d ball(-2.0, 0.0);
  opponent(-0.5, 0.0);  // left and right are equally good
  const KickPlan first = choose(ball);
  KickPlan mirrored = first;
  mirrored.direction.y() = -mirrored.direction.y();
  ASSERT_GT(std::abs(first.direction.y()), 0.1);
  const KickPlan kept = choose(ball, mirrored);
  EXPECT_NEAR(kept.direction.y(), mirrored.direction.y(), 1e-9);
  EXPECT_EQ(kept.kind, mirrored.kind);
  // Another kind of kick in that direction is another choice.
  KickPlan other = mirrored;
  other.kind = 1;
  EXPECT_NEAR(choose(ball, other).direction.y(), first.direction.y(), 1e-9);
  EXPECT_NEAR(choose(ball, mirrored, {.constancy = 0.0}).direction.y(), first.direction.y(), 1e-9);
  // The kept side is closed: it changes.
  opponent(-0.5, mirrored.direction.y() * 1.5 / mirrored.direction.x());
  EXPECT_LT(choose(ball, mirrored).direction.y() * mirrored.direction.y(), 0.0);
}

TEST_F(KickChoosing, AnyPlanIsAKickThatTheRobotHas) {
  regista::testkit::Dice dice(1);
  for (int round = 0; round < 1000; ++round) {
    opponents.clear();
    const int count = dice.integer(0, 7);
    for (int i = 0; i < count; ++i) {
      const double x = dice.real(-4.5, 4.5), y = dice.real(-3, 3);
      opponent(x, y);
    }
    const double x = dice.real(-4.6, 4.6), y = dice.real(-3.1, 3.1);
    const KickPlan plan = choose({x, y});
    ASSERT_GE(plan.kind, 0);
    ASSERT_LT(static_cast<std::size_t>(plan.kind), kinds.size());
    const KickKind& kind = kinds[static_cast<std::size_t>(plan.kind)];
    EXPECT_GE(plan.distance, kind.minimum_distance);
    EXPECT_LE(plan.distance, kind.maximum_distance);
    EXPECT_NEAR(plan.direction.norm(), 1.0, 1e-9);
  }
}

TEST_F(KickChoosing, PassesToWhoSpokeLately) {
  // Every way ahead is closed but the one to the teammate on the left.
  for (int k = -5; k <= 2; ++k) opponent(-1.0, 0.3 * k);
  const Vector2d ball(-2.0, 0.0), mate(-0.5, 2.8);
  const Vector2d aim = Vector2d(1.8, 2.8).normalized();  // 0.3 m before it
  EXPECT_LT(choose(ball).direction.dot(aim), 0.99);
  teammates = {{mate, 5.9}};
  EXPECT_GT(choose(ball).direction.dot(aim), 0.9999);
  EXPECT_NEAR(choose(ball).distance, std::hypot(1.8, 2.8), 1e-9);
  teammates = {{mate, 6.0}};
  EXPECT_LT(choose(ball).direction.dot(aim), 0.99);
  // Too near: no pass; and none with a kick that would end far off.
  teammates = {{mate, 0.0}};
  EXPECT_LT(choose(ball, {}, {.shortest_pass = 4.0}).direction.dot(aim), 0.99);
  kinds = {{0.4, 1.0}};
  EXPECT_LT(choose(ball).direction.dot(aim), 0.99);
}

// 3 m ahead are worth 3 m; turned by 0.4 rad they are worth 2.585 m.
TEST_F(KickChoosing, APassIsWorthMoreThanItsGround) {
  const Vector2d ball(-2.0, 0.0), aim = ball + 3.0 * Vector2d(std::cos(0.4), std::sin(0.4));
  teammates = {{aim - Vector2d(0.3, 0.0), 0.0}};
  EXPECT_NEAR(angle_of(choose(ball).direction), 0.4, 1e-9);
  EXPECT_NEAR(angle_of(choose(ball, {}, {.pass_bonus = 0.4}).direction), 0.0, 1e-9);
}

// After 2 m an opponent is in the way up to 0.35 + 0.15 * 2 = 0.65 m beside the line: at 0.5 m it costs 0.69 m.
TEST_F(KickChoosing, TheCorridorGrows) {
  const Vector2d ball(-2.0, 0.0);
  opponent(0.0, 0.5);
  EXPECT_NEAR(angle_of(choose(ball).direction), -0.4, 1e-9);
  EXPECT_NEAR(angle_of(choose(ball, {}, {.corridor_growth = 0.05}).direction), 0.0, 1e-9);
}

TEST_F(KickChoosing, OpponentsJustBeyondTheEndCount) {
  const Vector2d ball(-2.0, 0.0);
  opponent(1.6, 0.0);
  EXPECT_NEAR(angle_of(choose(ball).direction), 0.0, 1e-9);
  opponents = {{{1.4, 0.0}, 1.0}};
  EXPECT_GT(std::abs(angle_of(choose(ball).direction)), 0.3);
}

TEST_F(KickChoosing, KeepsTheBallOnTheField) {
  kinds = {{3.0, 3.0}};
  const Vector2d ball(3.9, 2.6);
  const KickPlan plan = choose(ball, {}, {.goal_bonus = 0.0, .into_net = 0.0, .over_line = 5.0});
  const Vector2d end = ball + plan.direction * plan.distance;
  EXPECT_LE(std::abs(end.x()), 4.5);
  EXPECT_LE(std::abs(end.y()), 3.0);
}

TEST_F(KickChoosing, WithoutAKickThereIsNoPlan) {
  kinds.clear();
  EXPECT_EQ(choose({0, 0}).kind, KickPlan::no_kind);
  // On the middle of the goal line nothing leads ahead, and this kick does not reach the posts.
  kinds = {{0.1, 0.2}};
  EXPECT_EQ(choose({4.5, 0.0}).kind, KickPlan::no_kind);
}

}  // namespace
