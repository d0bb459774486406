// SPDX-License-Identifier: MIT
// The modes against brute force and the schoolbook; the filter in simulated scenes; the plugin by the robots that it is
// told of. A recording of real balls: tests/integration/recordings. Whether the covariance is right:
// test_consistency.cpp.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <regista/testkit/contract.hpp>
#include <span>
#include <vector>

#include "testing.hpp"

namespace imm_ball {
namespace {

BallState some_ball(double speed) { return ball::correlated({speed * 0.8, speed * 0.6}); }

Modes some_modes() {
  Modes modes;
  modes.state = {some_ball(0.0), some_ball(1.0), some_ball(2.0)};
  modes.state[resting].cross.setZero();
  modes.state[resting].velocity_covariance.setZero();
  modes.state[kicked].position << 0.7, -0.9;
  modes.probability = {0.2, 0.5, 0.3};
  return modes;
}

TEST(Mixture, HasTheMomentsOfItsParts) {
  const Modes modes = some_modes();
  Vector4d centre = Vector4d::Zero();
  Matrix4d spread = Matrix4d::Zero();
  for (std::size_t m = 0; m < 3; ++m) centre += modes.probability[m] * mean(modes.state[m]);
  for (std::size_t m = 0; m < 3; ++m) {
    const Vector4d off = mean(modes.state[m]) - centre;
    spread += modes.probability[m] * (covariance(modes.state[m]) + off * off.transpose());
  }
  EXPECT_LT((mean(combined(modes)) - centre).norm(), 1e-12);
  EXPECT_LT((covariance(combined(modes)) - spread).norm(), 1e-12);
}

// A sighting whose errors are large one way and small the other, against the textbook's filter with 4 x 4 matrices.
TEST(Sighting, UpdatesEveryModeAsTheTextbookDoes) {
  Motion motion;
  Modes modes = some_modes();
  Sighting sighting;
  sighting.position << 0.75, -0.95;
  sighting.covariance << 0.05, 0.03, 0.03, 0.02;
  const Fit fit = compare(modes, sighting, motion);
  const Modes before = modes;
  take(modes, sighting, fit);
  Eigen::Matrix<double, 2, 4> sees = Eigen::Matrix<double, 2, 4>::Zero();
  sees(0, 0) = sees(1, 1) = 1.0;
  double total = 0.0;
  std::array<double, 3> likelihood{};
  for (std::size_t m = 0; m < 3; ++m) {
    const Vector4d x = mean(before.state[m]);
    const Matrix4d p = covariance(before.state[m]);
    const Matrix2d blur = motion.timing_noise * motion.timing_noise *
                          (x.tail<2>() * x.tail<2>().transpose() + p.bottomRightCorner<2, 2>());
    const Matrix2d s = sees * p * sees.transpose() + sighting.covariance + blur;
    const Eigen::Matrix<double, 4, 2> gain = p * sees.transpose() * s.inverse();
    const Vector2d innovation = sighting.position - sees * x;
    EXPECT_LT((mean(modes.state[m]) - (x + gain * innovation)).norm(), 1e-12) << m;
    EXPECT_LT((covariance(modes.state[m]) - (p - gain * sees * p)).norm(), 1e-12) << m;
    likelihood[m] = before.probability[m] * std::exp(-0.5 * normalised(innovation, s)) /
                    (6.283185307179586 * std::sqrt(s.determinant()));
    total += likelihood[m];
  }
  for (std::size_t m = 0; m < 3; ++m) EXPECT_NEAR(modes.probability[m], likelihood[m] / total, 1e-12) << m;
}

TEST(StandingShare, IsTheMeanOverTheVelocities) {
  RollingModel model;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double speed : {0.0, 0.1, 0.3}) {
    BallState ball = some_ball(speed);
    ball.velocity_covariance *= 0.2;
    const Matrix2d root = ball.velocity_covariance.llt().matrixL();
    double sum = 0.0;
    const int draws = 200000;
    for (int i = 0; i < draws; ++i) {
      const double a = normal(random);
      const double b = normal(random);
      const Vector2d velocity = ball.velocity + root * Vector2d(a, b);
      sum += std::exp(-0.5 * velocity.squaredNorm() / (model.stop_speed * model.stop_speed));
    }
    EXPECT_NEAR(standing_share(ball, model), sum / draws, 0.004) << speed;
  }
}

TEST(Kick, AddsTheSpreadOfKicksAtAnyInstant) {
  Motion motion;
  motion.kick_speed = 1.5;
  BallState told;
  add_kick(told, 0.4, motion);
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> instant(0.0, 0.4);
  double pp = 0.0, pv = 0.0, vv = 0.0;
  const int draws = 200000;
  for (int i = 0; i < draws; ++i) {
    const double v = 1.5 * normal(random);
    const double p = v * instant(random);
    pp += p * p / draws;
    pv += p * v / draws;
    vv += v * v / draws;
  }
  EXPECT_NEAR(told.position_covariance(0, 0) / pp, 1.0, 0.02);
  EXPECT_NEAR(told.cross(1, 1) / pv, 1.0, 0.02);
  EXPECT_NEAR(told.velocity_covariance(0, 0) / vv, 1.0, 0.02);
}

TEST(Carried, ProbabilitiesSumToOneAndKicksComeAtTheirRate) {
  const Motion motion;
  Modes confirmed = some_modes();
  confirmed.probability = {0.1, 0.2, 0.7};
  EXPECT_NEAR(carried(confirmed, 0.1, 0.5, motion).probability[kicked],
              0.3 * (1.0 - std::exp(-0.5)) + 0.7 * std::exp(-0.1 / motion.kick_duration()), 1e-12);
  for (const double dt : {0.0, 1e-3, 0.1, 1.0, 100.0}) {
    for (const double kicks : {0.0, 0.01, 0.5, 20.0}) {
      const Modes to = carried(some_modes(), dt, kicks, motion);
      EXPECT_NEAR(to.probability[0] + to.probability[1] + to.probability[2], 1.0, 1e-12);
      EXPECT_NEAR(to.probability[kicked], 0.7 * (1.0 - std::exp(-kicks)) + 0.3, 1e-12) << "not confirmed yet";
      for (const BallState& each : to.state) {
        EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix4d>(covariance(each)).eigenvalues().minCoeff(), -1e-9);
      }
    }
  }
}

TEST(Packet, GivesTheSameBallWhateverTheDelayAndTheSteps) {
  const BallState told = some_ball(1.5);
  Filter late, early, often;
  late.replace(told, true, 0.7, 0.3, 2.0);
  early.replace(told, true, 0.7, 0.3, 0.0);
  early.predict(2.0, out_of_reach);
  often.replace(told, true, 0.7, 0.3, 0.5);
  for (int i = 0; i < 150; ++i) often.predict(0.01, out_of_reach);
  const BallState ball = combined(late.now(*late.begin()));
  for (const Filter* other : {&early, &often}) {
    EXPECT_LT((mean(combined(other->now(*other->begin()))) - mean(ball)).norm(), 1e-9);
    EXPECT_LT((covariance(combined(other->now(*other->begin()))) - covariance(ball)).norm(), 1e-9);
    EXPECT_NEAR(other->begin()->age, 2.3, 1e-9);
  }
  // The schoolbook: v t - a t^2 / 2.
  EXPECT_LT((ball.position - told.position - Vector2d(0.8, 0.6) * (1.5 * 2.0 - 0.5 * 0.32 * 4.0)).norm(), 1e-9);

  Filter standing;
  standing.replace(told, false, 0.7, 0.3, 5.0);
  EXPECT_EQ(combined(standing.now(*standing.begin())).position, told.position);
  standing.forget();
  EXPECT_EQ(standing.begin(), standing.end());
}

// --- Behaviour ---

struct Camera : ball::Camera {
  using ball::Camera::Camera;
  void step(Filter& filter, const std::vector<Vector2d>& balls, const View& view = everywhere,
            Reach reach = Reach::nobody) {
    filter.predict(0.1, [reach](const Whereabouts&) { return reach; });
    filter.correct(image(balls), view);
  }
};

TEST(RestingBall, IsFoundBetterThanASingleSightingAndStands) {
  double squared = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Camera camera(seed);
    Filter filter;
    for (int i = 0; i < 50; ++i) camera.step(filter, {{2.0, 1.0}});
    ASSERT_NE(filter.begin(), filter.end());
    EXPECT_GT(filter.begin()->modes.probability[resting], 0.8) << seed;
    EXPECT_GT(filter.begin()->weight, 0.8);
    squared += (combined(filter.begin()->modes).position - Vector2d(2.0, 1.0)).squaredNorm() / 100.0;
  }
  EXPECT_LT(std::sqrt(squared), 0.03);  // sightings: 0.05 per axis, 0.07 in the plane
}

TEST(KickedBall, IsNoticedWithinThreeImages) {
  int noticed = 0;
  double off = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Camera camera(seed);
    Filter filter;
    for (int i = 0; i < 30; ++i) camera.step(filter, {{0.0, 0.0}}, everywhere, Reach::somebody);
    for (int i = 1; i <= 3; ++i) camera.step(filter, {{0.15 * i, 0.0}}, everywhere, Reach::somebody);
    noticed += filter.begin()->modes.probability[resting] < 0.01;
    off += (combined(filter.begin()->modes).velocity - Vector2d(1.5, 0.0)).norm() / 100.0;
    EXPECT_EQ(filter.begin()->label, 1) << "it is still the same ball";
  }
  EXPECT_GE(noticed, 99);
  EXPECT_LT(off, 0.4);
}

TEST(FalseSighting, MovesNothingAndDies) {
  Camera camera(3);
  Filter filter;
  for (int i = 0; i < 20; ++i) camera.step(filter, {{2.0, 1.0}});
  camera.step(filter, {{2.0, 1.0}, {-3.0, -1.0}});
  EXPECT_LT((combined(filter.begin()->modes).position - Vector2d(2.0, 1.0)).norm(), 0.1);
  for (int i = 0; i < 3; ++i) camera.step(filter, {{2.0, 1.0}});
  EXPECT_EQ(filter.end() - filter.begin(), 1);

  // Nor does one alone win, while the ball is missed.
  camera.step(filter, {{-3.0, -1.0}});
  EXPECT_LT((combined(filter.begin()->modes).position - Vector2d(2.0, 1.0)).norm(), 0.1);
  for (int i = 0; i < 5; ++i) camera.step(filter, {{-3.0, -1.0}});
  EXPECT_LT((combined(filter.begin()->modes).position - Vector2d(-3.0, -1.0)).norm(), 0.1) << "seen five times";
}

TEST(Miss, CountsOnlyWellInsideTheVisibleArea) {
  const auto weight = [](const Vector2d& ball, int misses) {
    Camera camera(5);
    Filter filter;
    for (int i = 0; i < 20; ++i) camera.step(filter, {ball});
    for (int i = 0; i < misses; ++i) camera.step(filter, {}, ahead());
    return filter.begin() == filter.end() ? 0.0 : filter.begin()->weight;
  };
  EXPECT_EQ(weight({3.0, 0.0}, 20), 0.0) << "lost";
  for (const Vector2d& unseen : {Vector2d(-3.0, 0.0), Vector2d(3.0, 1.5), Vector2d(5.2, 0.0), Vector2d(0.1, 0.0)}) {
    EXPECT_EQ(weight(unseen, 15), weight(unseen, 0)) << unseen.transpose();
  }
}

TEST(Random, SightingsLeaveWeightsThatAreProbabilities) {
  Filter filter;
  Camera camera(12);
  ball::expect_probabilities(filter, [&](const auto& balls, const View& view) { camera.step(filter, balls, view); });
}

TEST(Time, OfOneImage) {
  Camera camera(1);
  Filter filter;
  std::vector<Sighting> images;
  for (int i = 0; i < 1000; ++i) images.push_back({{1e-3 * i, 0.0}, 1e-4 * Matrix2d::Identity()});
  double best = 1.0;
  for (int round = 0; round < 50; ++round) {
    filter.reset();
    const auto start = std::chrono::steady_clock::now();
    for (const Sighting& image : images) {
      filter.predict(0.01, in_reach);
      filter.correct(std::span(&image, 1), everywhere);
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count() / 1000.0);
  }
  std::printf("predict and correct: %.0f ns\n", 1e9 * best);
  EXPECT_EQ(filter.end() - filter.begin(), 1);
}

}  // namespace
}  // namespace imm_ball

namespace regista::testkit {
namespace {

// Variance of the place of a resting ball, half a second after it was last seen.
double unwatched_variance(const Scene* last, bool observer) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "imm_ball");
  Instance instance(plugin, EnvironmentBuilder{}.own(2).subject(REGISTA_SUBJECT_BALL),
                    Values(plugin).set("kick_rate", 1.0));
  const regista_motion stands{};
  regista_measurement seen{};
  seen.kind = REGISTA_MEASURED_BALL;
  seen.covariance[0] = seen.covariance[2] = 0.0025;
  for (int i = 0; i < 30; ++i) {
    instance.predict(0.1, &stands);
    instance.correct(std::vector{seen}, {-2.0, 0.0, 0.0, 0.9, 8.0, 8.0});
  }
  instance.predict(0.5, observer ? &stands : nullptr, last == nullptr ? nullptr : &last->raw());
  return instance.tracks().front().covariance[0];
}

TEST(ImmBallPlugin, ExpectsKicksFromRobotsInReach) {
  const auto scene = [](double opponent, double in_common) {
    return FrameBuilder{}
        .own(2)
        .robot(2)
        .at(-2, 0)
        .opponent(opponent, 0.0)
        .ball(0, 0)
        .common([in_common](WorldBuilder& world) { world.robot(2).at(in_common, 0); })
        .build();
  };
  const Scene near = scene(0.3, -2.0), far = scene(3.0, -2.0), near_for_all = scene(3.0, 0.3);
  // Half a second of one kick a second against 0.02 kicks a second, each of 1 m/s, at any instant: k v^2 t^2 / 3.
  const double more = (std::exp(-0.01) - std::exp(-0.5)) * 0.25 / 3.0;
  EXPECT_NEAR(unwatched_variance(&near, true) - unwatched_variance(&far, true), more, 0.1 * more);
  EXPECT_EQ(unwatched_variance(&far, true), unwatched_variance(nullptr, true)) << "none is foretold without a frame";
  EXPECT_EQ(unwatched_variance(&near_for_all, true), unwatched_variance(&far, true)) << "the own eyes count";
  EXPECT_EQ(unwatched_variance(&near_for_all, false), unwatched_variance(&near, true)) << "teammates: what all know";
}

}  // namespace
}  // namespace regista::testkit

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "imm_ball");
