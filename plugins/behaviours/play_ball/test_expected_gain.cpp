// SPDX-License-Identifier: MIT
// The choice of a kick by its expected gain, in scenes with known answers.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <regista/testkit/dice.hpp>

#include "../expected_gain.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

class Gain : public testing::Test {
 protected:
  // The robot stands so far behind the ball, on the line from the own goal.
  Situation behind(const Vector2d& ball, double distance = 0.25) const { return at(ball, Vector2d(distance, 0.0)); }
  // It stands at the ball less `offset`, and looks at it.
  static Situation at(const Vector2d& ball, const Vector2d& offset) {
    const Vector2d own = ball - offset;
    return with_ball(standing(own.x(), own.y(), angle_of(offset)), ball);
  }
  KickScene kicks(const Situation& situation, const std::optional<KickPlan>& last = {}) const {
    return {situation.facts.field, situation.ball, kinds, teammates, opponents, last};
  }
  KickPlan choose(const Situation& situation, const std::optional<KickPlan>& last = {}) const {
    const KickScene scene = kicks(situation, last);
    return gain.choose(gain.scene(scene, situation, error, waited));
  }
  double value(const Situation& situation, double angle, double distance) const {
    const KickScene scene = kicks(situation);
    return gain.value(gain.scene(scene, situation, error, waited), {std::cos(angle), std::sin(angle)}, distance);
  }
  static double crosses(const Vector2d& ball, const KickPlan& plan, double line = 4.5) {
    return ball.y() + plan.direction.y() / plan.direction.x() * (line - ball.x());
  }
  static bool scores(const Vector2d& ball, const KickPlan& plan) {
    return plan.direction.x() > 0.0 && std::abs(crosses(ball, plan)) < 0.75 &&
           plan.distance > (4.5 - ball.x()) / plan.direction.x();
  }
  static double angle(const KickPlan& plan) { return angle_of(plan.direction); }
  void opponent(double x, double y) { opponents.push_back({{x, y}, 1.0}); }

  double waited = 0.0;  // s
  GainSettings settings;
  ExpectedGain gain{settings};
  double error = 7.0 * pi / 180.0;  // of a NAO
  std::vector<KickKind> kinds{{1.6, 4.5}, {5.4, 5.4}, {0.4, 1.0}};
  std::vector<Teammate> teammates;
  std::vector<Blocker> opponents;
};

TEST_F(Gain, PlacesAreWorthWhatTheyAreToTheOtherTeamWithTheOtherSign) {
  const Field field;
  EXPECT_EQ(gain.worth(field, {0, 1}), 0.0);
  EXPECT_NEAR(gain.worth(field, {4.5, 0}), 1.0 - std::exp(-3.0), 1e-12);
  regista::testkit::Dice dice(1);
  for (int round = 0; round < 100; ++round) {
    const Vector2d place(dice.real(-4.5, 4.5), dice.real(-3, 3));
    EXPECT_NEAR(gain.worth(field, place), -gain.worth(field, -place), 1e-12);
  }
}

TEST_F(Gain, AShotThatCannotMissIsWorthAGoal) {
  error = 0.0;
  EXPECT_NEAR(value(behind({2.5, 0}, 0.22), 0.0, 3.5), settings.goal, 1e-9) << "without a way to the ball";
  EXPECT_NEAR(value(behind({2.5, 0}, 0.72), 0.0, 3.5), settings.goal - 2.0 * settings.hurry, 1e-9) << "after 2 s";
  EXPECT_LT(value(behind({2.5, 0}), 0.0, 1.9), settings.goal - 0.2) << "short of the line";
}

// A ball on the middle line sees the goal, less its own radius, under this half angle. Of the five directions of the
// law, at quantiles 0.1 to 0.9, those within it go in; the others are goal kicks of the opponents. So the worth is
// known exactly, and it is that of the normal law up to half of a direction on each side.
TEST_F(Gain, AShotIsWorthTheShareOfItsErrorsThatGoesIn) {
  const double missed = gain.worth({}, {3.9, 1.1}) - settings.possession;
  std::vector<int> seen;
  for (const double x : {2.5, 1.0, -0.4}) {
    const double half_angle = std::atan2(0.7, 4.5 - x);
    int in = 0;
    for (const double quantile : {-1.2816, -0.5244, 0.0, 0.5244, 1.2816}) in += std::abs(quantile) * error < half_angle;
    seen.push_back(in);
    const double share = in / 5.0;
    EXPECT_NEAR(value(behind({x, 0}, 0.22), 0.0, 5.4), share * settings.goal + (1.0 - share) * missed, 1e-9) << x;
    EXPECT_LT(std::abs(share - std::erf(half_angle / error / std::sqrt(2.0))), 0.2) << x;
  }
  EXPECT_EQ(seen, (std::vector<int>{5, 5, 3}));
}

TEST_F(Gain, ShootsAtAnOpenGoal) {
  for (const double x : {1.5, 2.5, 3.5}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      const Vector2d ball(x, y);
      EXPECT_TRUE(scores(ball, choose(behind(ball)))) << "from " << x << ", " << y;
    }
  }
}

TEST_F(Gain, ShootsBesideTheGoalkeeper) {
  error = 0.03;
  opponent(4.1, 0.25);
  const Vector2d ball(3.0, 0.0);
  const KickPlan plan = choose(behind(ball));
  EXPECT_TRUE(scores(ball, plan));
  EXPECT_LT(crosses(ball, plan), 0.0) << "where there is room";
}

TEST_F(Gain, AnOpponentInTheWayTakesTheWorth) {
  error = 0.0;
  const Situation here = behind({2, 0}, 0.22);
  const double free = value(here, 0.0, 3.5);
  opponent(3.3, 0.0);
  EXPECT_LT(value(here, 0.0, 3.5), 0.5 * free);
  EXPECT_GT(value(here, 0.25, 3.5), value(here, 0.0, 3.5)) << "past it, just inside of the post";
  opponents[0].weight = 0.1;
  EXPECT_GT(value(here, 0.0, 3.5), 0.85 * free) << "that is hardly there";
}

// He walks 0.25 m/s, after 0.8 s. The ball needs 0.5 s for 0.8 m and 2.1 s for 2.6 m.
TEST_F(Gain, AnOpponentReachesFartherTheLongerTheBallRolls) {
  error = 0.0;
  const Situation here = behind({1.5, 0}, 0.22);
  const double free = value(here, 0.0, 4.0);
  const auto cost = [&](double along) {
    opponents.clear();
    opponent(1.5 + along, 0.5);
    return free - value(here, 0.0, 4.0);
  };
  EXPECT_LT(cost(0.8), 0.05 * free) << "the ball is past him before he moves";
  EXPECT_GT(cost(2.6), 0.3 * free) << "he is there in time";
}

TEST_F(Gain, PassesToWhoStandsFreeInFrontOfTheGoal) {
  const Vector2d ball(2.0, -2.0);
  for (const double x : {2.5, 2.7, 2.9}) opponent(x, -1.7 + (x - 2.5));
  opponent(4.1, 0.0);
  teammates = {{{2.6, 1.2}, 0.2, 5}};
  EXPECT_EQ(choose(at(ball, {0.05, 0.25})).receiver, 5);
  teammates[0].age = 4.1;
  EXPECT_EQ(choose(at(ball, {0.05, 0.25})).receiver, 0) << "who may be somewhere else by now";
}

// An opponent is at the ball in no time: there is none for the way around it.
TEST_F(Gain, KicksWhereItStandsWhenItIsPressed) {
  const Vector2d ball(-1.0, 0.0);
  const Situation beside = at(ball, {0.0, 0.22});
  const double at_leisure = std::abs(angle(choose(beside)) - pi / 2);
  opponent(-0.6, 0.0);
  const double pressed = std::abs(angle(choose(beside)) - pi / 2);
  EXPECT_GT(at_leisure, 0.3) << "to its right, towards the goal";
  EXPECT_LT(pressed, at_leisure);
}

TEST_F(Gain, ShootsNotWhereNoGoalCounts) {
  const Vector2d ball(3.6, -2.4);
  teammates = {{{3.4, 0.4}, 0.2, 4}};
  const Situation corner = in_set_play(at(ball, {-0.1, -0.2}), SetPlay::corner_kick, true);
  EXPECT_FALSE(scores(ball, choose(corner)));
  EXPECT_EQ(choose(corner).receiver, 4);
  const Vector2d near(3.0, 0.0);
  EXPECT_FALSE(scores(near, choose(in_set_play(behind(near), SetPlay::pushing_free_kick, true))));
  EXPECT_TRUE(scores(near, choose(in_set_play(behind(near), SetPlay::penalty_kick, true))));
}

// Two that want to get around each other: in the end it kicks from where it stands.
TEST_F(Gain, DoesNotWaitForEver) {
  const Vector2d ball(-1.0, 0.0);
  const auto off = [&](double seconds) {
    waited = seconds;
    return std::abs(wrap(angle(choose(at(ball, {-0.1, 0.35}))) - angle_of({-0.1, 0.35})));
  };
  EXPECT_GT(off(0.0), 0.5) << "around the ball";
  EXPECT_EQ(off(4.0), off(0.0));
  EXPECT_LT(off(20.0), 0.4) << "as far as it turns without walking";
}

TEST_F(Gain, OutOfTheFieldIsTheOpponents) {
  error = 0.0;
  const Situation at_line = behind({0.0, 2.6}, 0.22);
  EXPECT_LT(value(at_line, 0.5, 2.0), value(at_line, 0.0, 2.0));
  EXPECT_NEAR(
      value(at_line, pi / 2, 2.0),
      gain.worth({}, {0.0, 3.0}) - settings.possession - settings.hurry * (settings.walk_around * (pi / 2 - 0.4)), 0.02)
      << "a kick-in where it left";
}

// Whatever stands about: never into the own goal, and always a kick that the robot has.
TEST_F(Gain, NeverIntoTheOwnGoal) {
  regista::testkit::Dice dice(7);
  for (int round = 0; round < 300; ++round) {
    opponents.clear();
    teammates.clear();
    const Vector2d ball(dice.real(-4.4, -2.0), dice.real(-2.9, 2.9));
    for (int k = 0; k < 5; ++k) opponent(dice.real(-4.5, 0), dice.real(-3, 3));
    for (int k = 0; k < 4; ++k) teammates.push_back({{dice.real(-4.5, 2), dice.real(-3, 3)}, dice.real(0, 5), k + 2});
    const double from = dice.real(-pi, pi);
    const KickPlan plan = choose(at(ball, 0.4 * Vector2d(std::cos(from), std::sin(from))));
    ASSERT_GE(plan.kind, 0);
    const KickKind& kind = kinds[static_cast<std::size_t>(plan.kind)];
    EXPECT_GE(plan.distance, kind.minimum_distance);
    EXPECT_LE(plan.distance, kind.maximum_distance);
    EXPECT_NEAR(plan.direction.norm(), 1.0, 1e-12);
    const bool towards_line = plan.direction.x() < 0.0 && ball.x() + plan.direction.x() * plan.distance < -4.5;
    EXPECT_FALSE(towards_line && std::abs(crosses(ball, plan, -4.5)) < 0.75) << "round " << round;
  }
}

TEST_F(Gain, KeepsToItsChoice) {
  const Vector2d ball(-1.0, 0.0);
  opponent(0.5, 0.03);
  const KickPlan first = choose(behind(ball));
  ASSERT_GT(std::abs(angle(first)), 0.2);
  opponents[0].position.y() = -0.03;
  EXPECT_NEAR(angle(choose(behind(ball))), -angle(first), 1e-9) << "the other side";
  EXPECT_NEAR(angle(choose(behind(ball), first)), angle(first), 0.25);
}

TEST_F(Gain, ARobotWithoutKicksHasNone) {
  kinds.clear();
  EXPECT_EQ(choose(behind({0, 0})).kind, KickPlan::no_kind);
}

// A ball on the spot of the robot, of an opponent, of a teammate; on the goal lines and in the corners.
TEST_F(Gain, SaysSomethingFiniteEverywhere) {
  opponent(0, 0);
  teammates = {{{0, 0}, 0.0, 2}};
  for (const Vector2d& ball : {Vector2d(0, 0), Vector2d(4.5, 0), Vector2d(-4.5, 0), Vector2d(4.5, 3),
                               Vector2d(-4.5, -3), Vector2d(5.0, 3.2)}) {
    const KickPlan plan = choose(at(ball, {0, 0}));
    EXPECT_TRUE(plan.direction.allFinite());
    EXPECT_TRUE(std::isfinite(value(at(ball, {0, 0}), 0.3, 2.0)));
  }
}

}  // namespace
