// SPDX-License-Identifier: MIT
// Whether the filter errs as much as its covariance says, on balls of a simulator of its own (simulator.hpp):
// normalised estimation errors squared (NEES) against chi-square, as in Bar-Shalom, Li, Kirubarajan, "Estimation with
// Applications to Tracking and Navigation" (2001), section 5.4.
#include <gtest/gtest.h>

#include <cstdio>
#include <span>

#include "simulator.hpp"
#include "testing.hpp"

namespace imm_ball {
namespace {

// Sum of n squares of `dimensions` normal errors: 99.9 % of such sums lie within these bounds.
struct ChiSquare {
  double low, high;
  ChiSquare(int n, int dimensions) {
    const double mean = n * dimensions, deviation = std::sqrt(2.0 * mean);
    low = mean - 3.29 * deviation;
    high = mean + 3.29 * deviation;
  }
};

struct Consistency {
  double position = 0.0, state = 0.0;  // sums of normalised squared errors, 2 and 4 dimensions
  int count = 0;
};

Parameters consistent_parameters() {
  Parameters parameters;
  parameters.rolling.resting_noise = 0.02;
  return parameters;
}

// The best hypothesis of runs of `images` images at `period`, one look per run: errors are independent.
template <class World, class ReachOf>
Consistency consistency(const Parameters& parameters, int runs, int images, double period, const World& world,
                        const ReachOf& reach, double ahead = 0.0) {
  Consistency out;
  for (int run = 0; run < runs; ++run) {
    Simulator ball(static_cast<std::uint64_t>(run) + 1);
    world(ball, -1);
    Filter filter(parameters);
    for (int i = 0; i < images; ++i) {
      world(ball, i);
      ball.advance(period);
      filter.predict(period, reach);
      const Vector2d seen = ball.seen(std::hypot(0.03, parameters.least_deviation), parameters.timing_noise);
      const Sighting sighting{seen, 0.03 * 0.03 * Matrix2d::Identity()};
      filter.correct(std::span(&sighting, 1), everywhere);
    }
    if (filter.begin() == filter.end()) continue;
    if (ahead > 0.0) {
      ball.advance(ahead);
      filter.predict(ahead, reach);
    }
    const BallState told = combined(filter.now(*filter.begin()));
    Vector4d error;
    error << ball.position - told.position, ball.velocity - told.velocity;
    out.position += normalised(Vector2d(error.head<2>()), told.position_covariance);
    if (told.velocity_covariance.determinant() > 0.0) out.state += normalised(error, covariance(told));
    ++out.count;
  }
  return out;
}

void report(const char* what, const Consistency& found) {
  std::printf("consistency, %s: NEES of place %.2f (2 expected), of place and velocity %.2f (4 expected), %d runs\n",
              what, found.position / found.count, found.state / found.count, found.count);
}

// Nobody kicks and the noises are those that the filter is told: its covariance must be neither too small nor too
// large.
TEST(Consistency, OfARestingBallThatIsNudged) {
  Parameters parameters = consistent_parameters();
  parameters.unseen_kick_rate = 0.0;
  const Consistency found = consistency(
      parameters, 2000, 60, 0.1, [&](Simulator& ball, int) { ball.nudges = parameters.rolling.resting_noise; },
      out_of_reach);
  report("resting", found);
  const ChiSquare bounds(found.count, 2);
  EXPECT_EQ(found.count, 2000);
  EXPECT_GT(found.position, bounds.low);
  EXPECT_LT(found.position, bounds.high);
}

void roll_on(Simulator& ball, int image, const Parameters& parameters) {
  if (image < 0) ball.velocity << 2.0, -1.0;
  ball.nudges = parameters.rolling.resting_noise;
  ball.pushes = parameters.rolling.acceleration_noise;
  ball.turns = parameters.rolling.direction_noise;
}

TEST(Consistency, OfARollingBallThatIsPushedAbout) {
  Parameters parameters = consistent_parameters();
  parameters.unseen_kick_rate = 0.0;
  parameters.speed_prior = 2.0;
  for (const double ahead : {0.0, 1.0}) {
    const Consistency found = consistency(
        parameters, 2000, 20, 0.1, [&](Simulator& ball, int i) { roll_on(ball, i, parameters); }, out_of_reach, ahead);
    report(ahead == 0.0 ? "rolling" : "rolling, 1 s ahead", found);
    EXPECT_EQ(found.count, 2000);
    EXPECT_GT(found.position, ChiSquare(found.count, 2).low);
    EXPECT_LT(found.position, ChiSquare(found.count, 2).high);
    EXPECT_GT(found.state, ChiSquare(found.count, 4).low);
    EXPECT_LT(found.state, ChiSquare(found.count, 4).high);
  }
}

// As physics has it, without noise, robots always in reach: the filter allows for more than happens, never for less.
TEST(Consistency, OfABallThatRollsAsPhysicsHasItUntilItStands) {
  Parameters parameters;
  parameters.speed_prior = 2.0;
  for (const int images : {5, 10, 20, 40, 60, 80}) {  // it stands after 46
    const Consistency found = consistency(
        parameters, 1000, images, 0.1,
        [](Simulator& ball, int image) {
          if (image < 0) ball.velocity << 1.2, 0.9;
        },
        in_reach);
    report(images < 46 ? "rolling by physics" : "come to rest", found);
    EXPECT_EQ(found.count, 1000);
    EXPECT_LT(found.position, ChiSquare(found.count, 2).high) << images;
  }
}

// Kicked at any time, as often and as hard as the filter is told, at instants and into directions that nobody told,
// sliding at first. That a kick has not been noticed yet is part of what its covariance says: fully so of the place. Of
// the velocity it is a little too sure in the one image in which a kick shows first; that is reported only.
TEST(Consistency, OfABallThatIsKickedNowAndThen) {
  const Parameters parameters;
  for (const double ahead : {0.0, 0.5}) {
    const Consistency found = consistency(
        parameters, 4000, 30, 0.1,
        [&](Simulator& ball, int image) {
          if (image >= 0 && ball.chance(-std::expm1(-0.1 * parameters.kick_rate))) {
            ball.kick_within(0.1, parameters.speed_prior);
          }
        },
        in_reach, ahead);
    report(ahead == 0.0 ? "kicked now and then" : "kicked now and then, 0.5 s ahead", found);
    EXPECT_EQ(found.count, 4000);
    EXPECT_LT(found.position, ChiSquare(found.count, 2).high);
  }
}

// Given that it was kicked, the first images cannot tell yet; a second later all is well again.
TEST(Consistency, OfABallASecondAfterAKick) {
  const Parameters parameters;
  for (const int after : {1, 2, 3, 5, 10, 20}) {
    const Consistency found = consistency(
        parameters, 1000, 20 + after, 0.1,
        [&](Simulator& ball, int image) {
          if (image == 20) ball.kick_within(0.1, parameters.speed_prior);
        },
        in_reach);
    std::printf("%d images after a kick, ", after);
    report("kicked", found);
    EXPECT_EQ(found.count, 1000);
    if (after < 10) continue;
    EXPECT_LT(found.position, ChiSquare(found.count, 2).high) << after;
    EXPECT_LT(found.state, ChiSquare(found.count, 4).high) << after;
  }
}

}  // namespace
}  // namespace imm_ball
