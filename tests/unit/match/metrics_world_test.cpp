// SPDX-License-Identifier: MIT
// Errors of beliefs whose law is known.
#include "match/metrics_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace regista::match {
namespace {

constexpr std::uint32_t everybody = 0b111;

struct World : testing::Test {
  WorldMeasures measures{3};
  std::vector<Vector> own{{-4.0, 0.0}, {0.0, 1.0}, {1.0, -1.0}};
  std::vector<Vector> opponents{{2.0, 0.0}, {3.0, 1.0}};
  Belief belief;

  World() {
    for (const Vector& each : own) belief.teammates.push_back({true, each, 0.01, 0.0, 0.01});
    belief.self = {true, own[0], 0.01, 0.0, 0.01};
    belief.ball = {true, {}, 0.04, 0.0, 0.04};
    belief.opponents = opponents;
  }
  void compare(std::uint32_t active = everybody) { measures.compare(1, belief, {{0.0, 0.0}, own, active, opponents}); }
};

TEST_F(World, WhoKnowsTheTruthMakesNoError) {
  compare();
  const WorldModelMetrics result = measures.result();
  for (const EstimateMetrics* each : {&result.ball, &result.self, &result.teammates}) {
    EXPECT_EQ(each->known_share, 1.0);
    EXPECT_EQ(each->rmse_metres, 0.0);
    EXPECT_EQ(each->nees, 0.0);
    EXPECT_EQ(each->coverage_95, 1.0);
  }
  EXPECT_EQ(result.ospa_metres, 0.0);
}

TEST_F(World, NothingSampledIsNothingSaid) {
  const WorldModelMetrics result = measures.result();
  EXPECT_EQ(result.ball.known_share, std::nullopt);
  EXPECT_EQ(result.self.rmse_metres, std::nullopt);
  EXPECT_EQ(result.ospa_metres, std::nullopt);
  EXPECT_EQ(result.opponents_listed, std::nullopt);
  EXPECT_EQ(result.ball_seen_share, std::nullopt);
}

TEST_F(World, ErrorsOfABallThatIsKnownHalfTheTime) {
  belief.ball.at = {0.3, 0.4};  // 0.5 m off
  compare();
  belief.ball.at = {0.0, -1.3};
  compare();
  belief.ball.known = false;
  compare();
  compare();
  const EstimateMetrics ball = measures.result().ball;
  EXPECT_DOUBLE_EQ(*ball.known_share, 0.5);
  EXPECT_DOUBLE_EQ(*ball.rmse_metres, std::sqrt((0.25 + 1.69) / 2.0));
  EXPECT_NEAR(*ball.nees, (0.25 + 1.69) / 0.04 / 2.0, 1e-9);
  EXPECT_DOUBLE_EQ(*ball.coverage_95, 0.0);
}

TEST_F(World, EllipsesAreNotCircles) {
  // Error (1, 1); along it the variance is 2, across it 0.02: half the squared length over ... = 2 / 2.
  belief.ball = {true, {1.0, 1.0}, 1.01, 0.99, 1.01};
  compare();
  EXPECT_NEAR(*measures.result().ball.nees, 1.0, 1e-9);
  belief.ball = {true, {1.0, 1.0}, 1.01, -0.99, 1.01};
  compare();
  EXPECT_NEAR(*measures.result().ball.nees, (1.0 + 2.0 / 0.02) / 2.0, 1e-6);
  EXPECT_DOUBLE_EQ(*measures.result().ball.coverage_95, 0.5);
}

TEST_F(World, ACovarianceThatIsNonePromisesNothing) {
  belief.ball = {true, {1.0, 0.0}, 0.0, 0.0, 0.0};
  compare();
  EXPECT_DOUBLE_EQ(*measures.result().ball.rmse_metres, 1.0);
  EXPECT_EQ(measures.result().ball.nees, std::nullopt);
  belief.ball = {true, {1.0, 0.0}, 1.0, 2.0, 1.0};
  compare();
  EXPECT_EQ(measures.result().ball.coverage_95, std::nullopt);
}

TEST_F(World, TeammatesAreThoseInPlayWithoutOneself) {
  belief.teammates[0].at = {9.0, 9.0};  // its own row is not looked at
  belief.teammates[1].at.x += 3.0;
  belief.teammates[2].at.y += 4.0;
  compare();
  EXPECT_DOUBLE_EQ(*measures.result().teammates.rmse_metres, std::sqrt((9.0 + 16.0) / 2.0));
  compare(0b101);
  compare(0b001);
  EXPECT_DOUBLE_EQ(*measures.result().teammates.rmse_metres, std::sqrt((9.0 + 16.0 + 16.0) / 3.0));
  belief.teammates[1].known = false;
  compare(0b011);
  EXPECT_DOUBLE_EQ(*measures.result().teammates.known_share, 0.75);
}

// Robot 2 is turned about by the mirror: on the other side of the centre.
TEST_F(World, AMirroredRobotIsTwiceItsDistanceFromTheCentreOff) {
  own[1] = {1.2, 0.5};
  belief.self.at = {-1.2, -0.5};
  measures.compare(2, belief, {{}, own, everybody, opponents});
  EXPECT_NEAR(*measures.result().self.rmse_metres, 2.6, 1e-12);
}

TEST_F(World, OpponentsTooManyAndTooFew) {
  belief.opponents.push_back({-4.0, 2.0});
  compare();
  EXPECT_DOUBLE_EQ(*measures.result().ospa_cardinality_metres, ospa_cutoff / 3.0);
  EXPECT_DOUBLE_EQ(*measures.result().ospa_location_metres, 0.0);
  belief.opponents = {{2.0, 0.6}};
  compare();
  const WorldModelMetrics result = measures.result();
  EXPECT_DOUBLE_EQ(*result.ospa_location_metres, 0.3 / 2.0);
  EXPECT_DOUBLE_EQ(*result.ospa_cardinality_metres, (ospa_cutoff / 3.0 + ospa_cutoff / 2.0) / 2.0);
  EXPECT_DOUBLE_EQ(*result.ospa_metres, *result.ospa_location_metres + *result.ospa_cardinality_metres);
  EXPECT_DOUBLE_EQ(*result.opponents_listed, (3.0 + 1.0) / 2.0);
}

// Errors drawn from the very covariance: NEES has mean 2, and the ellipse holds 95 %.
TEST_F(World, TrueCovariancesAreCalibrated) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr int draws = 40000;
  for (int i = 0; i < draws; ++i) {
    const double u = normal(random), v = normal(random);
    // L = [[0.5, 0], [0.2, 0.1]], P = L L'.
    belief.ball = {true, {0.5 * u, 0.2 * u + 0.1 * v}, 0.25, 0.1, 0.05};
    compare();
  }
  const EstimateMetrics ball = measures.result().ball;
  // Five standard errors: NEES has variance 4, coverage 0.95 * 0.05.
  EXPECT_NEAR(*ball.nees, 2.0, 5.0 * 2.0 / std::sqrt(draws));
  EXPECT_NEAR(*ball.coverage_95, 0.95, 5.0 * std::sqrt(0.95 * 0.05 / draws));
}

TEST_F(World, TheBallIsSeenBySomebodyInPlay) {
  measures.looked(2, true);
  for (int i = 0; i < 3; ++i) measures.sample(everybody);
  for (int i = 0; i < 2; ++i) measures.sample(0b101);
  measures.looked(2, false);
  measures.looked(3, true);
  measures.sample(0b100);
  measures.looked(3, false);
  for (int i = 0; i < 2; ++i) measures.sample(everybody);
  EXPECT_DOUBLE_EQ(*measures.result().ball_seen_share, 0.5);
}

}  // namespace
}  // namespace regista::match
