// SPDX-License-Identifier: MIT
// The pose filter against closed forms and against simulated walks whose truth is known.
#include "algorithm.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <regista/testkit/contract.hpp>

namespace odometry_pose {
namespace {

enum { goal_post = 1, centre = 2, penalty_mark = 3, corner = 4, t_junction = 5 };

// The SPL field of 9 m x 6 m.
std::vector<Landmark> field() {
  std::vector<Landmark> all{{centre, 0.0, 0.0}};
  for (const double x : {-1.0, 1.0}) {
    all.push_back({penalty_mark, x * 3.2, 0.0});
    for (const double y : {-1.0, 1.0}) {
      all.push_back({goal_post, x * 4.5, y * 0.8});
      all.push_back({corner, x * 4.5, y * 3.0});
      all.push_back({t_junction, x * 4.5, y * 1.1});
      all.push_back({t_junction, x * 4.5, y * 2.0});
    }
    all.push_back({t_junction, 0.0, x * 3.0});
  }
  return all;
}

Estimate known(double x, double y, double heading) {
  Estimate pose{x, y, heading, {}};
  pose.covariance = Eigen::Vector3d(0.0025, 0.0025, 0.0025).asDiagonal();
  return pose;
}

Parameters noiseless() {
  Parameters p;
  p.distance_noise = p.turn_noise = p.drift_noise = p.standing_noise = 0.0;
  return p;
}

TEST(Heading, IsNormalised) {
  EXPECT_EQ(normalised(pi), pi);
  EXPECT_EQ(normalised(-pi), pi);
  EXPECT_NEAR(normalised(3.0 * pi), pi, 1e-12);
  EXPECT_NEAR(normalised(7.0), 7.0 - 2.0 * pi, 1e-12);
  EXPECT_NEAR(normalised(-40.0), -40.0 + 12.0 * pi, 1e-12);
}

TEST(Prediction, FollowsAPolygonBackToItsStart) {
  Filter filter(noiseless(), {}, known(1.0, -2.0, 3.0));
  const int sides = 12;
  for (int i = 0; i < sides; ++i) filter.predict(0.1, 0.5, 0.0, 2.0 * pi / sides);
  EXPECT_NEAR(filter.estimate().x, 1.0, 1e-12);
  EXPECT_NEAR(filter.estimate().y, -2.0, 1e-12);
  EXPECT_NEAR(filter.estimate().heading, 3.0, 1e-12);
}

TEST(Prediction, CarriesTheCovarianceByTheDerivativeOfTheMotion) {
  const double dx = 0.4, dy = -0.3, turned = 0.7, heading = 2.1;
  Estimate start{0.3, 0.2, heading, {}};
  start.covariance << 0.04, 0.01, -0.012, 0.01, 0.09, 0.02, -0.012, 0.02, 0.05;
  Filter filter(noiseless(), {}, start);
  filter.predict(0.1, dx, dy, turned);
  const auto moved = [&](double x, double y, double h) {
    return Eigen::Vector3d(x + std::cos(h) * dx - std::sin(h) * dy, y + std::sin(h) * dx + std::cos(h) * dy,
                           h + turned);
  };
  Eigen::Matrix3d derivative;
  const double e = 1e-6;
  derivative.col(0) = (moved(e, 0, heading) - moved(-e, 0, heading)) / (2 * e);
  derivative.col(1) = (moved(0, e, heading) - moved(0, -e, heading)) / (2 * e);
  derivative.col(2) = (moved(0, 0, heading + e) - moved(0, 0, heading - e)) / (2 * e);
  const Eigen::Matrix3d expected = derivative * start.covariance * derivative.transpose();
  EXPECT_LT((filter.estimate().covariance - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Prediction, SpreadsByTheSquareRootOfTheDistance) {
  Parameters p = noiseless();
  p.distance_noise = 0.1;
  Filter once(p, {}, known(0, 0, 0)), often(p, {}, known(0, 0, 0));
  once.predict(10.0, 4.0, 0.0, 0.0);
  for (int i = 0; i < 100; ++i) often.predict(0.1, 0.04, 0.0, 0.0);
  EXPECT_NEAR(once.estimate().covariance(0, 0), 0.0025 + 0.01 * 4.0, 1e-12);
  EXPECT_LT((once.estimate().covariance - often.estimate().covariance).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Velocity, IsThatOfTheBodyInTheFieldFrame) {
  Parameters p = noiseless();
  Filter filter(p, {}, known(0, 0, pi / 2.0));
  for (int i = 0; i < 100; ++i) filter.predict(0.1, 0.02, 0.01, 0.0);
  EXPECT_NEAR(filter.velocity().x(), -0.1, 1e-6);
  EXPECT_NEAR(filter.velocity().y(), 0.2, 1e-6);
  filter.predict(p.velocity_smoothing, 0.0, 0.0, 0.0);  // half of it is forgotten after one time constant in one step
  EXPECT_NEAR(filter.velocity().y(), 0.1, 1e-6);
}

// The textbook's form: h(x) = R' (l - p), innovation in the robot frame.
TEST(Sighting, EqualsTheTextbookUpdateWhereTheSightingIsExact) {
  const Estimate start = known(1.0, 0.5, 0.4);
  Filter filter(Parameters{}, {{centre, 0.0, 0.0}}, start);
  const double c = std::cos(0.4), s = std::sin(0.4);
  Eigen::Matrix2d rotation;
  rotation << c, -s, s, c;
  const Eigen::Vector2d gap(-1.0, -0.5), z = rotation.transpose() * gap;
  Eigen::Matrix2d noise;
  noise << 0.03, 0.01, 0.01, 0.02;
  ASSERT_TRUE(filter.sight(centre, z, noise));
  Eigen::Matrix<double, 2, 3> h;
  h.leftCols<2>() = -rotation.transpose();
  h.col(2) << z.y(), -z.x();
  const Eigen::Matrix2d spread = h * start.covariance * h.transpose() + noise;
  const Eigen::Matrix<double, 3, 2> gain = start.covariance * h.transpose() * spread.inverse();
  const Eigen::Matrix3d expected = start.covariance - gain * spread * gain.transpose();
  EXPECT_LT((filter.estimate().covariance - expected).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(filter.estimate().x, 1.0, 1e-12);
  EXPECT_EQ(filter.age(), 0.0);
}

TEST(Sighting, ThatFitsNothingOrTwoThingsIsLeft) {
  const Eigen::Matrix2d noise = 0.01 * Eigen::Matrix2d::Identity();
  Filter filter(Parameters{}, {{goal_post, 4.5, 0.8}, {goal_post, 4.5, -0.8}, {centre, 0.0, 0.0}}, known(3, 0, 0));
  const Eigen::Matrix3d before = filter.estimate().covariance;
  EXPECT_FALSE(filter.sight(goal_post, {1.5, 0.0}, 0.5 * Eigen::Matrix2d::Identity())) << "midway between the posts";
  EXPECT_FALSE(filter.sight(centre, {2.0, 0.0}, noise)) << "5 m off";
  EXPECT_FALSE(filter.sight(corner, {1.5, 3.0}, noise)) << "there are no corners";
  EXPECT_EQ(filter.estimate().covariance, before);
  EXPECT_TRUE(filter.sight(goal_post, {1.5, 0.75}, noise));
  EXPECT_LT(filter.estimate().covariance.trace(), before.trace());
}

TEST(Doubt, BringsBackAFilterThatIsSureOfAWrongPose) {
  Estimate wrong = known(1.0, 0.0, 0.0);
  Estimate unknown = known(0.0, 0.0, 0.0);
  unknown.covariance = Eigen::Matrix3d::Identity();
  Filter filter(Parameters{}, field(), unknown);
  filter.place(wrong);
  const Eigen::Matrix2d noise = 0.0025 * Eigen::Matrix2d::Identity();
  for (int i = 0; i < 30; ++i) {  // the truth is (0, 0, 0)
    filter.sight(goal_post, {4.5, 0.8}, noise);
    filter.sight(goal_post, {4.5, -0.8}, noise);
  }
  EXPECT_NEAR(filter.estimate().x, 0.0, 0.1);
  EXPECT_NEAR(filter.estimate().heading, 0.0, 0.1);
}

// A robot that walks between random places at 0.2 m/s, turning its head, with the noises the filter is told of.
struct Walk {
  explicit Walk(std::uint64_t seed) : random(seed) {}
  double normal() { return std::normal_distribution<double>()(random); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

  // One decision; `landmarks` empty: a walk in the dark.
  void step(Filter& filter, const Parameters& p, const std::vector<Landmark>& landmarks) {
    const double to_x = target_x - x, to_y = target_y - y;
    if (to_x * to_x + to_y * to_y < 0.04) {
      target_x = uniform(-4.0, 4.0);
      target_y = uniform(-2.5, 2.5);
    }
    // What odometry tells is what was meant; the body's slips add to it, as the filter has it.
    const double turned = std::clamp(normalised(std::atan2(to_y, to_x) - heading), -0.15, 0.15), ahead = 0.02;
    const double creep = p.standing_noise * p.standing_noise * 0.1;
    const double slip = std::sqrt(p.distance_noise * p.distance_noise * ahead + creep);
    const double twist =
        std::sqrt(p.turn_noise * p.turn_noise * std::abs(turned) + p.drift_noise * p.drift_noise * ahead + creep);
    const double c0 = std::cos(heading), s0 = std::sin(heading);
    const double slipped_ahead = ahead + slip * normal();
    const double slipped_left = slip * normal();
    x += c0 * slipped_ahead - s0 * slipped_left;
    y += s0 * slipped_ahead + c0 * slipped_left;
    heading = normalised(heading + turned + twist * normal());
    filter.predict(0.1, ahead, 0.0, turned);

    head = normalised(head + 0.2);
    for (const Landmark& landmark : landmarks) {
      const double gap_x = landmark.x - x, gap_y = landmark.y - y;
      const double distance = std::sqrt(gap_x * gap_x + gap_y * gap_y);
      const double bearing = normalised(std::atan2(gap_y, gap_x) - heading);
      const bool post = landmark.kind == goal_post;
      if (distance > (post ? 8.0 : 3.0) || std::abs(normalised(bearing - head)) > 0.477) continue;
      if (uniform(0.0, 1.0) > (post ? 0.9 : 0.6)) continue;
      const double along = 0.05 * distance, across = 0.02 * distance;
      const double c = std::cos(bearing), s = std::sin(bearing);
      const double a = along * normal(), b = across * normal();
      Eigen::Matrix2d turn;
      turn << c, -s, s, c;
      const Eigen::Vector2d z = turn * Eigen::Vector2d(distance + a, b);
      filter.sight(landmark.kind, z,
                   turn * Eigen::Vector2d(along * along, across * across).asDiagonal() * turn.transpose());
    }
  }

  Eigen::Vector3d error(const Filter& filter) const {
    const Estimate& e = filter.estimate();
    return {e.x - x, e.y - y, normalised(e.heading - heading)};
  }
  // Normalised estimation error squared: chi-square with 3 degrees of freedom when the covariance is honest.
  double nees(const Filter& filter) const {
    const Eigen::Vector3d e = error(filter);
    return e.dot(filter.estimate().covariance.inverse() * e);
  }

  std::mt19937_64 random;
  double x = -1.0, y = 0.0, heading = 0.0, target_x = 3.0, target_y = 1.0, head = 0.0;
};

// Half width of the band that holds the mean of n chi-square values with 3 degrees of freedom at 99.9 %.
double band(int n) { return 3.29 * std::sqrt(2.0 * 3.0 / n); }

Filter placed(Walk& walk, const Parameters& p, const std::vector<Landmark>& landmarks) {
  const double x = walk.x + 0.05 * walk.normal();
  const double y = walk.y + 0.05 * walk.normal();
  const double heading = walk.heading + 0.05 * walk.normal();
  return Filter(p, landmarks, known(x, y, heading));
}

TEST(TenMinutesOnTheField, ErrorIsSmallAndTheCovarianceHonest) {
  const Parameters p;
  const std::vector<Landmark> landmarks = field();
  double error = 0.0, nees = 0.0;
  int steps = 0, samples = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Walk walk(seed);
    Filter filter = placed(walk, p, landmarks);
    for (int i = 1; i <= 6000; ++i) {
      walk.step(filter, p, landmarks);
      error += walk.error(filter).head<2>().norm();
      ++steps;
      if (i % 200 == 0) {  // 20 s apart: hardly correlated
        nees += walk.nees(filter);
        ++samples;
      }
    }
    ASSERT_LT(walk.error(filter).head<2>().norm(), 1.0) << "lost with seed " << seed;
  }
  RecordProperty("mean_error_mm", static_cast<int>(1000.0 * error / steps));
  RecordProperty("mean_nees_1000", static_cast<int>(1000.0 * nees / samples));
  std::printf("mean error %.3f m, mean NEES %.3f (band 3 +- %.3f)\n", error / steps, nees / samples, band(samples));
  EXPECT_LT(error / steps, 0.15);
  EXPECT_NEAR(nees / samples, 3.0, band(samples));
}

TEST(AMinuteInTheDark, TheErrorGrowsAsTheCovarianceSays) {
  const Parameters p;
  const int runs = 400;
  double early = 0.0, late = 0.0, nees = 0.0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Walk walk(seed);
    Filter filter = placed(walk, p, {});
    for (int i = 1; i <= 600; ++i) {
      walk.step(filter, p, {});
      if (i == 60) early += walk.error(filter).head<2>().norm();
    }
    late += walk.error(filter).head<2>().norm();
    nees += walk.nees(filter);
  }
  std::printf("error after 6 s %.3f m, after 60 s %.3f m, mean NEES %.3f (band 3 +- %.3f)\n", early / runs, late / runs,
              nees / runs, band(runs));
  EXPECT_GT(late, 2.0 * early);
  EXPECT_NEAR(nees / runs, 3.0, band(runs));
}

}  // namespace
}  // namespace odometry_pose

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "odometry_pose");
