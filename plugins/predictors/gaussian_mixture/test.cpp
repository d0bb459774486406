// SPDX-License-Identifier: MIT
// The mixture against closed forms, single scenes, and a simulated game whose truth is known, scored by OSPA.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cfloat>
#include <random>
#include <regista/testkit/contract.hpp>
#include <regista/testkit/ospa.hpp>
#include <set>
#include <vector>

#include "algorithm.hpp"

namespace gaussian_mixture {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using regista::testkit::ospa;
using regista::testkit::PlanePoint;

const View everywhere{{0.0, 0.0}, {1.0, 0.0}, -1.0, 0.0, 100.0};
View ahead() { return {{0.0, 0.0}, {1.0, 0.0}, std::cos(0.477), std::sin(0.477), 4.0}; }
const std::vector<Sighting> nothing;

Sighting at(double x, double y, double deviation = 0.1) {
  return {{x, y}, deviation * deviation * Matrix2d::Identity()};
}

std::size_t size(const Mixture& mixture) { return static_cast<std::size_t>(mixture.end() - mixture.begin()); }

Matrix4d covariance(const Component& c) {
  Matrix4d all;
  all << c.state.position_covariance, c.state.cross, c.state.cross.transpose(), c.state.velocity_covariance;
  return all;
}

TEST(Motion, OneStepEqualsManySmallOnes) {
  Mixture once, often;
  Component told;
  told.state.position << 1.0, 2.0;
  told.state.velocity << 0.3, -0.2;
  told.state.position_covariance << 0.1, 0.02, 0.02, 0.2;
  told.state.cross << 0.01, 0.0, 0.005, 0.02;
  told.state.velocity_covariance << 0.04, 0.01, 0.01, 0.03;
  told.weight = 0.9;
  once.add(told);
  often.add(told);
  once.predict(5.0);
  for (int i = 0; i < 500; ++i) often.predict(0.01);
  EXPECT_LT((once.begin()->state.position - often.begin()->state.position).norm(), 1e-9);
  EXPECT_LT((once.begin()->state.velocity - often.begin()->state.velocity).norm(), 1e-9);
  EXPECT_LT((covariance(*once.begin()) - covariance(*often.begin())).norm(), 1e-9);
}

// Robots that walk as the model says, from a standing velocity distribution.
TEST(Motion, SpreadsAsSimulatedRobotsDo) {
  const Parameters p;
  Mixture mixture(p);
  Component told;
  told.state.velocity_covariance.diagonal().setConstant(p.speed * p.speed);
  told.weight = 0.9;
  mixture.add(told);
  const double time = 4.0, dt = 0.01;
  mixture.predict(time);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  double pp = 0.0, pv = 0.0, vv = 0.0;
  const int robots = 20000;
  for (int i = 0; i < robots; ++i) {
    double x = 0.0, v = p.speed * normal(random);
    for (int k = 0; k < 400; ++k) {
      x += dt * v;
      v += -dt / p.persistence * v + p.speed * std::sqrt(2.0 * dt / p.persistence) * normal(random);
    }
    pp += x * x / robots;
    pv += x * v / robots;
    vv += v * v / robots;
  }
  EXPECT_NEAR(mixture.begin()->state.position_covariance(0, 0) / pp, 1.0, 0.05);
  EXPECT_NEAR(mixture.begin()->state.cross(0, 0) / pv, 1.0, 0.08);
  EXPECT_NEAR(mixture.begin()->state.velocity_covariance(0, 0) / vv, 1.0, 0.05);
}

TEST(Match, UpdatesTheNearestAndKeepsItsLabel) {
  Mixture mixture;
  mixture.correct(std::vector{at(2.0, 0.0), at(2.0, 2.0)}, everywhere);
  ASSERT_EQ(size(mixture), 2u);
  const int first = mixture.begin()->label, second = mixture.begin()[1].label;
  EXPECT_NE(first, second);
  for (int i = 1; i <= 50; ++i) {
    mixture.predict(0.1);
    mixture.correct(std::vector{at(2.0, 2.0), at(2.0 + 0.02 * i, 0.0, 0.05)}, everywhere);
  }
  ASSERT_EQ(size(mixture), 2u);
  EXPECT_EQ(mixture.begin()->label, first);
  EXPECT_EQ(mixture.begin()[1].label, second);
  EXPECT_NEAR(mixture.begin()->state.position.x(), 3.0, 0.1);
  EXPECT_NEAR(mixture.begin()->state.velocity.x(), 0.2, 0.07);
  EXPECT_TRUE(mixture.velocity_believed(*mixture.begin()));
  EXPECT_GT(mixture.begin()->weight, 0.9);
  EXPECT_EQ(mixture.begin()->age, 0.0);
}

TEST(Match, IsTheKalmanUpdate) {
  Mixture mixture;
  Component told;
  told.state.position_covariance << 0.1, 0.02, 0.02, 0.2;
  told.state.cross << 0.01, 0.0, 0.005, 0.02;
  told.state.velocity_covariance << 0.04, 0.01, 0.01, 0.03;
  told.weight = 0.9;
  mixture.add(told);
  const Sighting sighting = at(0.2, -0.1, 0.2);
  mixture.correct(std::vector{sighting}, everywhere);
  Eigen::Matrix<double, 2, 4> h = Eigen::Matrix<double, 2, 4>::Zero();
  h.leftCols<2>().setIdentity();
  const Matrix4d before = covariance(told);
  const Matrix2d spread = h * before * h.transpose() + sighting.covariance;
  const Eigen::Matrix<double, 4, 2> gain = before * h.transpose() * spread.inverse();
  const Eigen::Vector4d expected = gain * sighting.position;
  EXPECT_LT((covariance(*mixture.begin()) - (before - gain * spread * gain.transpose())).norm(), 1e-12);
  EXPECT_LT((mixture.begin()->state.position - expected.head<2>()).norm(), 1e-12);
  EXPECT_LT((mixture.begin()->state.velocity - expected.tail<2>()).norm(), 1e-12);
}

TEST(Miss, LowersTheWeightInViewAndOnlyThere) {
  Mixture mixture;
  const std::vector both{at(3.0, 0.0), at(-3.0, 0.0)};
  for (int i = 0; i < 20; ++i) mixture.correct(both, everywhere);
  ASSERT_EQ(size(mixture), 2u);
  const double before = mixture.begin()[1].weight;
  mixture.correct(nothing, ahead());
  EXPECT_LT(mixture.begin()[0].weight, before);
  EXPECT_EQ(mixture.begin()[1].weight, before);
  for (int i = 0; i < 15; ++i) mixture.correct(nothing, ahead());
  ASSERT_EQ(size(mixture), 1u);
  EXPECT_EQ(mixture.begin()->state.position, Vector2d(-3.0, 0.0));
  EXPECT_EQ(mixture.begin()->weight, before);
  mixture.predict(59.9);
  EXPECT_EQ(size(mixture), 1u);
  mixture.predict(0.2);
  EXPECT_EQ(size(mixture), 0u) << "unseen for longer than 60 s";
}

// Whether a robot that was often seen at `place` loses weight by an image `ahead` that shows none, or only `seen`.
bool is_missed(const Vector2d& place, const std::vector<Sighting>& others = {}, const std::vector<Sighting>& seen = {},
               double deviation = 0.1) {
  Mixture mixture;
  std::vector<Sighting> all{at(place.x(), place.y(), deviation)};
  all.insert(all.end(), others.begin(), others.end());
  for (int i = 0; i < 5; ++i) mixture.correct(all, everywhere);
  const double before = mixture.begin()->weight;
  mixture.correct(seen, ahead());
  return mixture.begin()->weight < before;
}

TEST(Miss, NeedsThatTheRobotWasSurelyInView) {
  const double half = 0.477;
  EXPECT_TRUE(is_missed({3.0, 0.0}));
  EXPECT_TRUE(is_missed({3.9, 0.0}));
  EXPECT_FALSE(is_missed({3.97, 0.0})) << "the range ends within its deviation, 0.1 m by five sightings";
  EXPECT_TRUE(is_missed(3.0 * Vector2d(std::cos(half - 0.05), std::sin(half - 0.05))));
  for (const double side : {-1.0, 1.0})
    EXPECT_FALSE(is_missed(3.0 * Vector2d(std::cos(half - 0.01), side * std::sin(half - 0.01))));
  EXPECT_FALSE(is_missed({3.0, 0.0}, {}, {}, 5.0)) << "it may be anywhere";
}

TEST(Miss, IsNotOfAHiddenRobot) {
  const std::vector before{at(1.5, 0.05)}, beside{at(1.5, 0.4)}, behind{at(3.5, 0.0)};
  EXPECT_FALSE(is_missed({3.0, 0.0}, before, before));
  EXPECT_TRUE(is_missed({3.0, 0.0}, beside, beside));
  EXPECT_TRUE(is_missed({3.0, 0.0}, behind, behind));
}

// The rim of the sector and the shadow of a body against samples of the disc and of the line of sight.
TEST(View, HoldsADiscWhoseEveryPointIsInside) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double half = 1.5 * std::abs(uniform(random)), heading = 3.0 * uniform(random),
                 radius = 0.5 + 0.5 * uniform(random);
    const View view{{uniform(random), uniform(random)},
                    {std::cos(heading), std::sin(heading)},
                    std::cos(half),
                    std::sin(half),
                    4.0};
    const Vector2d centre(5.0 * uniform(random), 5.0 * uniform(random));
    bool all = true;
    for (int k = 0; k < 360 && all; ++k) {
      const double angle = k * 3.14159265358979 / 180.0;
      all = view.holds(centre + 0.99 * radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    const bool holds = view.holds(centre, radius), holds_more = view.holds(centre, 0.98 * radius);
    EXPECT_LE(holds, all);
    EXPECT_LE(all, holds_more);
    inside += holds;
  }
  EXPECT_GT(inside, 1000);
}

TEST(Merge, KeepsMeanAndCovarianceOfTheMixtureAndTheOlderLabel) {
  Mixture mixture;
  Component a, b;
  a.state.position << 0.0, 0.0;
  b.state.position << 0.16, 0.0;
  a.state.position_covariance = 0.1 * Matrix2d::Identity();
  b.state.position_covariance = 0.3 * Matrix2d::Identity();
  a.weight = 0.6;
  b.weight = 0.2;
  a.label = 9;
  b.label = 4;
  b.age = 1.0;
  mixture.add(a);
  mixture.add(b);
  mixture.correct(nothing, {{50.0, 50.0}, {1.0, 0.0}, 0.0, 1.0, 1.0});
  ASSERT_EQ(size(mixture), 1u);
  const Component& one = *mixture.begin();
  EXPECT_NEAR(one.state.position.x(), 0.25 * 0.16, 1e-12);
  EXPECT_NEAR(one.state.position_covariance(0, 0), 0.75 * 0.1 + 0.25 * 0.3 + 0.75 * 0.25 * 0.16 * 0.16, 1e-12);
  EXPECT_NEAR(one.state.position_covariance(1, 1), 0.75 * 0.1 + 0.25 * 0.3, 1e-12);
  EXPECT_NEAR(one.weight, 1.0 - 0.4 * 0.8, 1e-12);
  EXPECT_EQ(one.label, 4);
  EXPECT_EQ(one.age, 0.0);
}

TEST(Merge, LeavesTwoRobotsApart) {
  Mixture mixture;
  for (int i = 0; i < 10; ++i) {
    mixture.predict(0.1);
    mixture.correct(std::vector{at(2.0, 0.0), at(2.0, 0.8)}, everywhere);
  }
  EXPECT_EQ(size(mixture), 2u);
  mixture.correct(std::vector{at(2.0, 0.0)}, everywhere);
  EXPECT_EQ(size(mixture), 2u) << "this image shows one of them";
  Mixture twice;
  twice.correct(std::vector{at(2.0, 0.0), at(2.0, 0.15)}, everywhere);
  EXPECT_EQ(size(twice), 2u) << "a camera sees a robot once";
}

TEST(Absorb, KeepsGoodLabelsAndReplacesBadOnes) {
  Mixture mixture;
  Component told;
  told.weight = 0.9;
  for (const int label : {7, 7, 0, 3}) {
    told.label = label;
    told.state.position.x() += 2.0;
    mixture.add(told);
  }
  told.weight = 1e-5;
  mixture.add(told);
  std::set<int> labels;
  for (const Component& each : mixture) labels.insert(each.label);
  ASSERT_EQ(size(mixture), 4u);
  EXPECT_EQ(labels.size(), 4u);
  EXPECT_EQ(mixture.begin()->label, 7);
  EXPECT_EQ(mixture.begin()[3].label, 3);
}

// What stood in a place before is no component that has a label.
TEST(Reset, LabelsBeginAgain) {
  Mixture mixture;
  const auto labels = [&] {
    std::vector<int> out;
    mixture.correct(std::vector{at(0.0, 0.0), at(3.0, 0.0), at(0.0, 3.0)}, everywhere);
    for (const Component& each : mixture) out.push_back(each.label);
    return out;
  };
  const std::vector<int> first = labels();
  mixture.reset();
  EXPECT_EQ(labels(), first);
}

TEST(Capacity, IsNeverExceededAndTheWeakGiveWay) {
  Mixture mixture;
  std::vector<Sighting> many;
  for (int i = 0; i < 40; ++i) many.push_back(at(1.5 * (i % 8), 1.5 * (i / 8)));
  mixture.correct(many, everywhere);
  EXPECT_EQ(size(mixture), static_cast<std::size_t>(Mixture::capacity));
}

// Long silence must not leave numbers so small that the processor stumbles over them.
TEST(Weights, NeverBecomeDenormal) {
  Parameters p;
  p.forget_after = 1e9;
  Mixture mixture(p);
  for (int i = 0; i < 20000; ++i) {
    mixture.predict(0.1);
    mixture.correct(i % 500 == 0 ? std::vector{at(2.0, 0.0)} : std::vector<Sighting>{}, ahead());
    for (const Component& each : mixture) {
      ASSERT_GE(each.weight, p.prune_weight);
      for (const double value :
           {each.state.velocity.x(), each.state.velocity.y(), each.state.cross(0, 1), each.state.cross(0, 0)}) {
        ASSERT_TRUE(value == 0.0 || std::abs(value) >= DBL_MIN);
      }
    }
  }
}

// Five opponents wander at walking speed; a robot in the middle turns its head and sees some of them, some falsely.
TEST(Game, IsTrackedMuchBetterThanItIsSeen) {
  std::mt19937_64 random(42);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  struct Robot {
    Vector2d position, target;
  };
  std::vector<Robot> robots;
  const Vector2d starts[] = {{3.0, 0.0}, {1.5, 2.0}, {-2.0, -1.5}, {-1.0, 1.5}, {2.0, -2.0}};
  for (const Vector2d& start : starts) robots.push_back({start, start});
  Mixture mixture;
  const double half = 0.477, range = 4.0, step = 0.1;
  double tracked = 0.0, seen_only = 0.0;
  int scored = 0;
  std::size_t components = 0;
  for (int i = 0; i < 3000; ++i) {
    for (Robot& robot : robots) {
      Vector2d way = robot.target - robot.position;
      if (way.norm() < 0.05) {  // somewhere near, where nobody else stands or goes
        const double x = robot.position.x() + 3.0 * uniform(random) - 1.5;
        const double y = robot.position.y() + 3.0 * uniform(random) - 1.5;
        const bool free = std::none_of(robots.begin(), robots.end(), [&](const Robot& other) {
          return &other != &robot &&
                 ((other.position - Vector2d(x, y)).norm() < 1.3 || (other.target - Vector2d(x, y)).norm() < 1.3);
        });
        if (std::hypot(x, y) < 3.8 && std::abs(y) < 3.0 && free) robot.target << x, y;
        continue;
      }
      robot.position += std::min(0.2 * step, way.norm()) * way.normalized();
    }
    const double heading = 0.15 * i;  // 1.5 rad/s
    const Vector2d axis(std::cos(heading), std::sin(heading));
    const View view{{0.0, 0.0}, axis, std::cos(half), std::sin(half), range};
    std::vector<Sighting> sightings;
    std::vector<PlanePoint> seen, truth, told;
    const auto sight = [&](const Vector2d& place) {
      const double distance = place.norm();
      const Vector2d out = place / distance, across(-out.y(), out.x());
      const double a = 0.05 * distance * normal(random);
      const double b = 0.02 * distance * normal(random);
      sightings.push_back(
          {place + a * out + b * across,
           distance * distance * (0.0025 * out * out.transpose() + 0.0004 * across * across.transpose())});
      seen.push_back({sightings.back().position.x(), sightings.back().position.y()});
    };
    for (const Robot& robot : robots) {
      truth.push_back({robot.position.x(), robot.position.y()});
      if (view.holds(robot.position) && uniform(random) < 0.6) sight(robot.position);
    }
    if (uniform(random) < 0.005) sight(3.0 * axis);
    mixture.predict(step);
    mixture.correct(sightings, view);
    for (const Component& each : mixture) {
      if (each.weight > 0.5) told.push_back({each.state.position.x(), each.state.position.y()});
      components = std::max(components, size(mixture));
    }
    if (i < 200) continue;
    tracked += ospa(told, truth, 1.0);
    seen_only += ospa(seen, truth, 1.0);
    ++scored;
  }
  std::printf("mean OSPA (cut-off 1 m): mixture %.3f m, sightings alone %.3f m; at most %zu components\n",
              tracked / scored, seen_only / scored, components);
  EXPECT_LT(tracked / scored, 0.5);
  EXPECT_LT(tracked, 0.6 * seen_only);
}

}  // namespace
}  // namespace gaussian_mixture

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "gaussian_mixture");
