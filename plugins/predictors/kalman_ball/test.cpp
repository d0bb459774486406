// SPDX-License-Identifier: MIT
// The rolling ball against closed forms and numerical integration; the filter against simulated scenes. Recordings of
// real balls: tests/integration/recordings.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>

#include <random>
#include <regista/testkit/contract.hpp>
#include <span>
#include <vector>

#include "../test_ball.hpp"
#include "algorithm.hpp"

namespace kalman_ball {
namespace {

using ball::ahead, ball::covariance, ball::everywhere, ball::mean;
using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

BallState rolling_ball() { return ball::correlated({0.9, 0.7}); }

// Advances as a filter does: rolling until it stands.
BallState after(BallState ball, double dt, const RollingModel& model, int steps = 1) {
  bool stands = false;
  for (int i = 0; i < steps; ++i) {
    if (stands) {
      rest(ball, dt / steps, model);
    } else {
      stands = advance_rolling(ball, dt / steps, model);
    }
  }
  return ball;
}

// Each cycle of the simulator keeps 94 % of the speed; the way is a geometric series.
TEST(Rolling, DragLosesTheSameShareOfTheSpeedEachCycle) {
  RollingModel model;
  model.deceleration = 1e-9;
  model.drag = -std::log(0.94) / 0.1;
  const BallState start = rolling_ball(), end = after(start, 1.0, model);
  EXPECT_NEAR((end.velocity - std::pow(0.94, 10) * start.velocity).norm(), 0.0, 1e-6);
  const double way = start.velocity.norm() * (1.0 - std::pow(0.94, 10)) / model.drag;
  EXPECT_NEAR((end.position - start.position).norm(), way, 1e-6);
}

TEST(Rolling, StopsWhereTheSchoolbookSays) {
  const RollingModel model;
  const BallState start = rolling_ball(), end = after(start, 60.0, model);
  const double speed = start.velocity.norm();
  const double way = (speed * speed - model.stop_speed * model.stop_speed) / (2.0 * model.deceleration);
  EXPECT_NEAR((end.position - start.position - way * start.velocity / speed).norm(), 0.0, 1e-12);
  EXPECT_EQ(end.velocity.norm(), 0.0);
}

// On carpet, and as in the 2D simulation league.
class Rolls : public testing::TestWithParam<double> {
 protected:
  Rolls() { model.drag = GetParam(); }
  RollingModel model;
};
INSTANTIATE_TEST_SUITE_P(Drags, Rolls, testing::Values(0.0, 0.02, 0.62));

TEST_P(Rolls, OneStepEqualsManySmallOnes) {
  for (const double dt : {0.1, 1.0, 3.0, 3.31, 20.0}) {  // it stands after 3.3 s
    for (const int steps : {2, 7, 1000}) {
      const BallState once = after(rolling_ball(), dt, model), often = after(rolling_ball(), dt, model, steps);
      EXPECT_LT((mean(once) - mean(often)).cwiseAbs().maxCoeff(), 1e-9) << dt << " s in " << steps;
      EXPECT_LT((covariance(once) - covariance(often)).cwiseAbs().maxCoeff(), 1e-9) << dt << " s in " << steps;
    }
  }
}

TEST_P(Rolls, CovarianceFollowsTheDerivativeOfTheMotion) {
  model.acceleration_noise = model.direction_noise = model.resting_noise = 0.0;
  const double dt = 1.3, e = 1e-6;
  Matrix4d derivative;
  for (int i = 0; i < 4; ++i) {
    BallState plus = rolling_ball(), minus = plus;
    (i < 2 ? plus.position[i] : plus.velocity[i - 2]) += e;
    (i < 2 ? minus.position[i] : minus.velocity[i - 2]) -= e;
    derivative.col(i) = (mean(after(plus, dt, model)) - mean(after(minus, dt, model))) / (2.0 * e);
  }
  const Matrix4d expected = derivative * covariance(rolling_ball()) * derivative.transpose();
  EXPECT_LT((covariance(after(rolling_ball(), dt, model)) - expected).cwiseAbs().maxCoeff(), 1e-8);
}

// Balls whose speed and direction are pushed about at each of many small steps, with the two noises alone.
TEST_P(Rolls, NoisesSpreadTheBallsAsSimulated) {
  if (model.drag > 0.1) model.deceleration = 0.05;  // it must roll to the end
  model.acceleration_noise = 0.05;
  model.direction_noise = 0.08;
  model.resting_noise = 0.0;
  BallState start;
  start.velocity << 1.2, 0.0;
  const double dt = 2.0;
  const int steps = 200, balls = 20000;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Matrix4d sum = Matrix4d::Zero();
  const Vector4d centre = mean(after(start, dt, model));
  for (int i = 0; i < balls; ++i) {
    double x = 0.0, y = 0.0, speed = 1.2, direction = 0.0;
    const double h = dt / steps;
    for (int k = 0; k < steps; ++k) {
      const double slowed = h * (model.deceleration + model.drag * speed);
      x += h * (speed - 0.5 * slowed) * std::cos(direction);
      y += h * (speed - 0.5 * slowed) * std::sin(direction);
      speed += -slowed + std::sqrt(h) * model.acceleration_noise * normal(random);
      direction += std::sqrt(h) * model.direction_noise * normal(random);
    }
    const Vector4d off = Vector4d(x, y, speed * std::cos(direction), speed * std::sin(direction)) - centre;
    sum += off * off.transpose();
  }
  const Matrix4d simulated = sum / balls, told = covariance(after(start, dt, model));
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(told(i, i) / simulated(i, i), 1.0, 0.06) << "variance " << i;
  EXPECT_NEAR(told(0, 2) / simulated(0, 2), 1.0, 0.06);
  EXPECT_NEAR(told(1, 3) / simulated(1, 3), 1.0, 0.06);
}

// A solid ball, 2/5 m r^2, that slides without spin at first: friction slows it and turns it until it rolls. Integrated
// in steps of 10 us, beside one step and beside many.
TEST(KickedBall, SlidesUntilItRollsAsNewtonSays) {
  RollingModel model;
  model.slide_deceleration = 3.5;
  const double kick = 6.0, dt = 1e-5;
  double speed = kick, surface = 0.0, way = 0.0, rolled_at = 0.0;  // surface: of its spin, m/s
  double time = 0.0;
  for (; time < 1.0; time += dt) {
    if (surface < speed) {
      speed -= model.slide_deceleration * dt;
      surface += 2.5 * model.slide_deceleration * dt;
      rolled_at = time;
    } else {
      speed -= model.deceleration * dt;
    }
    way += speed * dt;
  }
  EXPECT_NEAR(time_to_roll(kick, 0.0, model), rolled_at, 1e-3);
  EXPECT_NEAR(time_to_roll(kick - 0.2 * model.slide_deceleration, 0.2, model), rolled_at - 0.2, 1e-3);
  BallState once, often;
  once.velocity << kick, 0.0;
  once.velocity_covariance = 0.01 * Matrix2d::Identity();
  often = once;
  EXPECT_FALSE(advance_kicked(once, 1.0, 0.0, model));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(advance_kicked(often, 0.01, 0.01 * i, model));
  EXPECT_NEAR(once.velocity.x(), speed, 1e-3);
  EXPECT_NEAR(once.position.x(), way, 1e-3);
  EXPECT_LT((once.position - often.position).norm() + (once.velocity - often.velocity).norm(), 1e-9);
  EXPECT_LT((once.position_covariance - often.position_covariance).norm(), 1e-9);
  // One that is not known to have been kicked rolls.
  BallState known, rolls;
  known.velocity << kick, 0.0;
  rolls.velocity << kick, 0.0;
  advance_kicked(known, 1.0, std::numeric_limits<double>::infinity(), model);
  advance_rolling(rolls, 1.0, model);
  EXPECT_EQ(known.position, rolls.position);
}

TEST(Visible, IsASectorLessItsMargin) {
  const View view = ahead();
  EXPECT_TRUE(view.holds({3.0, 0.0}, 0.3));
  EXPECT_FALSE(view.holds({-3.0, 0.0}, 0.3));
  EXPECT_FALSE(view.holds({4.8, 0.0}, 0.3));
  EXPECT_TRUE(view.holds({4.8, 0.0}, 0.1));
  EXPECT_FALSE(view.holds({0.1, 0.0}, 0.3)) << "at its feet";
  const double edge = 3.0 * std::tan(0.477);
  EXPECT_FALSE(view.holds({3.0, edge - 0.1}, 0.3));
  EXPECT_TRUE(view.holds({3.0, edge - 0.5}, 0.3));
  EXPECT_FALSE(view.holds({3.0, -edge - 0.1}, 0.0));
  EXPECT_TRUE(everywhere.holds({-50.0, 30.0}, 0.3));
}

// At 10 Hz.
struct Camera : ball::Camera {
  using ball::Camera::Camera;
  void step(Filter& filter, const std::vector<Vector2d>& balls, const View& view = everywhere) {
    filter.predict(0.1);
    filter.correct(image(balls), view);
  }
};

TEST(RestingBall, IsFoundBetterThanASingleSighting) {
  double squared = 0.0;
  Parameters seldom_touched;
  seldom_touched.touch_rate = 0.1;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Camera camera(seed);
    Filter filter(seldom_touched);
    for (int i = 0; i < 50; ++i) camera.step(filter, {{2.0, 1.0}});
    ASSERT_NE(filter.begin(), filter.end());
    EXPECT_EQ(filter.begin()->kind, Kind::resting) << seed;
    EXPECT_FALSE(filter.velocity_believed(*filter.begin()));
    EXPECT_GT(filter.begin()->weight, 0.8);
    EXPECT_EQ(filter.begin()->age, 0.0);
    squared += (filter.begin()->ball.position - Vector2d(2.0, 1.0)).squaredNorm() / 50.0;
  }
  EXPECT_LT(std::sqrt(squared), 0.03);  // sightings: 0.05 per axis, 0.07 in the plane
}

TEST(RollingBall, IsFollowedOnceFourSightingsToldItsVelocity) {
  const RollingModel model;
  double before = 0.0, at_1s = 0.0, hold = 0.0;
  int believed = 0;
  const int runs = 100;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Camera camera(seed);
    Filter filter;
    BallState truth;
    truth.velocity << 1.2, -0.5;
    for (int i = 1; i <= 10; ++i) {
      advance_rolling(truth, 0.1, model);
      camera.step(filter, {truth.position});
      ASSERT_NE(filter.begin(), filter.end());
      if (i < 4) {
        for (const Hypothesis& each : filter) EXPECT_FALSE(filter.velocity_believed(each));
      }
    }
    Hypothesis best = *filter.begin();
    believed += filter.velocity_believed(best);
    before += (best.ball.velocity - truth.velocity).norm() / runs;
    hold += (best.ball.position - after(truth, 1.0, model).position).norm() / runs;
    filter.advance(best, 1.0);
    at_1s += (best.ball.position - after(truth, 1.0, model).position).norm() / runs;
  }
  std::printf("rolling, 10 sightings: velocity %.3f m/s off, place in 1 s %.3f m off (holding: %.3f)\n", before, at_1s,
              hold);
  EXPECT_EQ(believed, runs);
  EXPECT_LT(before, 0.15);
  EXPECT_LT(at_1s, 0.25 * hold);
}

TEST(KickedBall, IsFoundAgainAndTheOldPlaceForgotten) {
  const RollingModel model;
  int good = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Camera camera(seed);
    Filter filter;
    BallState truth;
    for (int i = 0; i < 30; ++i) camera.step(filter, {truth.position});
    truth.velocity << 1.5, 0.0;
    for (int i = 0; i < 8; ++i) {
      advance_rolling(truth, 0.1, model);
      camera.step(filter, {truth.position});
    }
    ASSERT_NE(filter.begin(), filter.end());
    const Hypothesis& best = *filter.begin();
    good += (best.ball.position - truth.position).norm() < 0.15 && filter.velocity_believed(best) &&
            (best.ball.velocity - truth.velocity).norm() < 0.5;
  }
  EXPECT_GE(good, 45);
}

TEST(FalseSighting, StaysWeakAndDies) {
  Camera camera(3);
  Filter filter;
  for (int i = 0; i < 20; ++i) camera.step(filter, {{2.0, 1.0}});
  camera.step(filter, {{2.0, 1.0}, {-3.0, -1.0}});
  EXPECT_LT((filter.begin()->ball.position - Vector2d(2.0, 1.0)).norm(), 0.1);
  for (int i = 0; i < 3; ++i) camera.step(filter, {{2.0, 1.0}});
  for (const Hypothesis& each : filter) EXPECT_LT((each.ball.position - Vector2d(2.0, 1.0)).norm(), 0.2);

  // Nor does one alone win, while the ball is missed.
  camera.step(filter, {{-3.0, -1.0}});
  EXPECT_LT((filter.begin()->ball.position - Vector2d(2.0, 1.0)).norm(), 0.1);
  for (int i = 0; i < 5; ++i) camera.step(filter, {{-3.0, -1.0}});
  EXPECT_LT((filter.begin()->ball.position - Vector2d(-3.0, -1.0)).norm(), 0.1) << "seen five times it is the ball";
}

double best_weight_after_misses(const Vector2d& ball, int misses) {
  Camera camera(5);
  Filter filter;
  for (int i = 0; i < 20; ++i) camera.step(filter, {ball});
  for (int i = 0; i < misses; ++i) camera.step(filter, {}, ahead());
  return filter.begin() == filter.end() ? 0.0 : filter.begin()->weight;
}

TEST(Miss, CountsOnlyWellInsideTheVisibleArea) {
  EXPECT_LT(best_weight_after_misses({3.0, 0.0}, 20), 0.1);
  for (const Vector2d& unseen : {Vector2d(-3.0, 0.0), Vector2d(3.0, 1.5), Vector2d(5.2, 0.0), Vector2d(0.1, 0.0)}) {
    EXPECT_EQ(best_weight_after_misses(unseen, 15), best_weight_after_misses(unseen, 0)) << unseen.transpose();
  }
}

TEST(Age, CountsFromTheLastSightingOfTheHypothesis) {
  Camera camera(5);
  Filter filter;
  for (int i = 0; i < 10; ++i) camera.step(filter, {{3.0, 0.0}});
  for (int i = 0; i < 7; ++i) camera.step(filter, {}, ahead());
  ASSERT_NE(filter.begin(), filter.end());
  EXPECT_NEAR(filter.begin()->age, 0.7, 1e-12);
}

TEST(Packet, ReplacesTheModelByTheBallRolledForward) {
  Camera camera(5);
  Filter filter;
  for (int i = 0; i < 10; ++i) camera.step(filter, {{3.0, 0.0}, {-2.0, 2.0}});
  filter.replace(rolling_ball(), true, 0.7, 0.3, 1.1);
  ASSERT_EQ(filter.end() - filter.begin(), 1);
  const BallState expected = after(rolling_ball(), 1.1, RollingModel{});
  EXPECT_LT((mean(filter.begin()->ball) - mean(expected)).norm(), 1e-12);
  EXPECT_NEAR(filter.begin()->age, 1.4, 1e-12);
  EXPECT_EQ(filter.begin()->weight, 0.7);

  // Heard late or early, it is the same ball at the same time.
  Filter other;
  other.replace(rolling_ball(), true, 0.7, 0.3, 0.05);
  for (int i = 0; i < 35; ++i) other.predict(0.03);
  EXPECT_LT((mean(other.begin()->ball) - mean(filter.begin()->ball)).norm(), 1e-9);
  EXPECT_LT((covariance(other.begin()->ball) - covariance(filter.begin()->ball)).norm(), 1e-9);

  filter.replace(rolling_ball(), false, 0.7, 0.3, 1.1);
  EXPECT_EQ(filter.begin()->ball.position, rolling_ball().position);
  filter.forget();
  EXPECT_EQ(filter.begin(), filter.end());
}

TEST(Random, SightingsLeaveWeightsThatAreProbabilities) {
  Filter filter;
  Camera camera(12);
  ball::expect_probabilities(filter, [&](const auto& balls, const View& view) { camera.step(filter, balls, view); });
}

// Cameras whose clock trembles by `jitter`: a rolling ball is off along its path by its speed times that.
TEST(TimingNoise, MakesVelocityBetterAndCovarianceHonestWhereTimesTremble) {
  const RollingModel model{.deceleration = 0.32, .acceleration_noise = 0.05};
  const double jitter = 0.004, dt = 1.0 / 70.0, noise = 0.002;
  double off[2] = {0.0, 0.0}, nees = 0.0;
  const int runs = 200;
  for (int modelled = 0; modelled < 2; ++modelled) {
    Parameters parameters;
    parameters.rolling = model;
    parameters.speed_prior = 3.0;
    parameters.timing_noise = modelled == 1 ? jitter : 0.0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      Filter filter(parameters);
      std::mt19937_64 random(seed);
      std::normal_distribution<double> normal;
      BallState truth;
      truth.velocity << 3.0, 1.0;
      for (int i = 0; i < 40; ++i) {
        advance_rolling(truth, dt, model);
        const double late = jitter * normal(random);
        const double x = noise * normal(random);
        const double y = noise * normal(random);
        const Sighting sighting{truth.position + late * truth.velocity + Vector2d(x, y),
                                noise * noise * Matrix2d::Identity()};
        filter.predict(dt);
        filter.correct(std::span(&sighting, 1), everywhere);
      }
      ASSERT_NE(filter.begin(), filter.end());
      const BallState& ball = filter.begin()->ball;
      off[modelled] += (ball.velocity - truth.velocity).norm() / runs;
      const Vector2d error = ball.position - truth.position;
      if (modelled == 1) nees += error.dot(ball.position_covariance.inverse() * error) / runs;
    }
  }
  std::printf("timing noise: velocity %.3f m/s off, %.3f when it is modelled; NEES %.2f\n", off[0], off[1], nees);
  EXPECT_LT(off[1], 0.7 * off[0]);
  EXPECT_GT(nees, 1.0);
  EXPECT_LT(nees, 3.0);
}

// Balls that nobody sees and somebody touches at random times: velocities that jump, at the times of a Poisson process.
TEST(Touches, SpreadWhatIsToldAsSimulated) {
  Parameters parameters;
  parameters.unseen_touch_rate = 1.5;
  parameters.speed_prior = 2.0;
  parameters.rolling.resting_noise = 0.0;
  Filter filter(parameters);
  filter.replace(BallState{}, false, 1.0, 0.0, 0.0);
  const double told_for = 0.8;
  for (int i = 0; i < 8; ++i) filter.predict(told_for / 8.0);
  const BallState told = filter.told(*filter.begin());

  std::mt19937_64 random(3);
  std::normal_distribution<double> jump(0.0, parameters.speed_prior);
  std::exponential_distribution<double> wait(parameters.unseen_touch_rate);
  double position = 0.0, velocity = 0.0, both = 0.0;
  const int balls = 100000;
  for (int i = 0; i < balls; ++i) {
    double x = 0.0, v = 0.0;
    for (double t = wait(random); t < told_for; t += wait(random)) {
      const double dv = jump(random);
      v += dv;
      x += dv * (told_for - t);
    }
    position += x * x / balls;
    velocity += v * v / balls;
    both += x * v / balls;
  }
  EXPECT_NEAR(told.position_covariance(0, 0) / position, 1.0, 0.03);
  EXPECT_NEAR(told.velocity_covariance(0, 0) / velocity, 1.0, 0.03);
  EXPECT_NEAR(told.cross(0, 0) / both, 1.0, 0.03);

  // What was told is the whole uncertainty: it does not grow again from the beginning, but from there.
  filter.replace(told, false, 1.0, 0.0, 0.0);
  EXPECT_EQ(filter.told(*filter.begin()).position_covariance, told.position_covariance);
}

}  // namespace
}  // namespace kalman_ball

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "kalman_ball");
