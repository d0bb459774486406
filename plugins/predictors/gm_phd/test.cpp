// SPDX-License-Identifier: MIT
// The filter against closed forms, against its published equations written out densely, and against simulated robots
// whose truth is known.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cfloat>
#include <random>
#include <regista/testkit/contract.hpp>
#include <type_traits>
#include <vector>

#include "algorithm.hpp"

namespace gm_phd {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

static_assert(std::is_trivially_copyable_v<Filter>, "no memory but its own: nothing is ever allocated");

const View everywhere{0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 100.0};
const View nowhere{90.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0};
View ahead(double range = 4.0) { return {0.0, 0.0, 1.0, 0.0, std::cos(0.477), std::sin(0.477), range}; }

Sighting at(double x, double y, double deviation = 0.1) {
  return {x, y, deviation * deviation, 0.0, deviation * deviation};
}
const std::vector<Sighting> nothing;

Component robot(double x, double y, double weight = 1.0, double deviation = 0.1) {
  Component c;
  c.x = x;
  c.y = y;
  c.pxx = c.pyy = deviation * deviation;
  c.vxx = c.vyy = 0.04;
  c.weight = weight;
  return c;
}

Vector4d mean(const Component& c) { return {c.x, c.y, c.vx, c.vy}; }
Matrix4d covariance(const Component& c) {
  Matrix4d all;
  all << c.pxx, c.pxy, c.cxx, c.cxy, c.pxy, c.pyy, c.cyx, c.cyy, c.cxx, c.cyx, c.vxx, c.vxy, c.cxy, c.cyy, c.vxy, c.vyy;
  return all;
}
Matrix2d covariance(const Sighting& z) {
  Matrix2d all;
  all << z.xx, z.xy, z.xy, z.yy;
  return all;
}

std::size_t size(const Filter& filter) { return static_cast<std::size_t>(filter.end() - filter.begin()); }
double sum(const Filter& filter) {
  double weight = 0.0;
  for (const Component& each : filter) weight += each.weight;
  return weight;
}

TEST(Motion, OneStepEqualsManySmallOnesAndTheWayIsThatOfADecayingVelocity) {
  Parameters p;
  Filter once(p), often(p);
  Component c = robot(1.0, 2.0);
  c.vx = 0.3;
  c.vy = -0.2;
  c.pxy = 0.002;
  c.cxx = 0.005;
  c.cxy = 0.001;
  c.cyy = -0.003;
  c.vxy = 0.01;
  once.add(c);
  often.add(c);
  once.predict(5.0);
  for (int i = 0; i < 500; ++i) often.predict(0.01);
  EXPECT_LT((mean(*once.begin()) - mean(*often.begin())).norm(), 1e-9);
  EXPECT_LT((covariance(*once.begin()) - covariance(*often.begin())).norm(), 1e-9);
  EXPECT_NEAR(once.begin()->weight, std::pow(0.99, 5.0), 1e-12);
  EXPECT_NEAR(often.begin()->weight, once.begin()->weight, 1e-12);
  EXPECT_NEAR(once.begin()->x, 1.0 + 0.3 * p.persistence * (1.0 - std::exp(-5.0 / p.persistence)), 1e-12);
}

// x' = F x, P' = F P F' + Q with Q from Van Loan's matrix exponential, summed as a series.
TEST(OneRobotWithoutClutter, IsAKalmanFilter) {
  Parameters p;
  p.detection = p.survival = 1.0;
  p.clutter_density = p.birth_density = 0.0;
  p.gate = 1e9;
  const double dt = 0.1, tau = p.persistence;
  Matrix2d drift;
  drift << 0.0, 1.0, 0.0, -1.0 / tau;
  Matrix4d block = Matrix4d::Zero();
  block.topLeftCorner<2, 2>() = -drift * dt;
  block(1, 3) = 2.0 * p.speed * p.speed / tau * dt;
  block.bottomRightCorner<2, 2>() = drift.transpose() * dt;
  Matrix4d series = Matrix4d::Identity(), term = series;
  for (int n = 1; n < 40; ++n) {
    term = term * block / n;
    series += term;
  }
  const Matrix2d f = series.bottomRightCorner<2, 2>().transpose(), q = f * series.topRightCorner<2, 2>();
  Matrix4d transition = Matrix4d::Zero(), noise = Matrix4d::Zero();  // of (x, y, vx, vy)
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int axis = 0; axis < 2; ++axis) {
        transition(2 * i + axis, 2 * j + axis) = f(i, j);
        noise(2 * i + axis, 2 * j + axis) = q(i, j);
      }
    }
  }
  Filter filter(p);
  filter.add(robot(0.5, -0.5));
  Vector4d x = mean(*filter.begin());
  Matrix4d c = covariance(*filter.begin());
  Eigen::Matrix<double, 2, 4> h = Eigen::Matrix<double, 2, 4>::Zero();
  h.leftCols<2>().setIdentity();
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    const double zx = 0.5 + 0.01 * i + 0.1 * normal(random);
    const double zy = -0.5 - 0.02 * i + 0.1 * normal(random);
    const Sighting z{zx, zy, 0.01, 0.004, 0.02};
    filter.predict(dt);
    filter.correct(std::vector{z}, everywhere);
    x = transition * x;
    c = transition * c * transition.transpose() + noise;
    const Matrix2d spread = h * c * h.transpose() + covariance(z);
    const Eigen::Matrix<double, 4, 2> gain = c * h.transpose() * spread.inverse();
    x += gain * (Vector2d(zx, zy) - h * x);
    c -= gain * spread * gain.transpose();
    ASSERT_EQ(size(filter), 1u);
    ASSERT_LT((mean(*filter.begin()) - x).norm(), 1e-9);
    ASSERT_LT((covariance(*filter.begin()) - c).norm(), 1e-9);
    ASSERT_NEAR(filter.begin()->weight, 1.0, 1e-12);
    ASSERT_EQ(filter.begin()->label, 1);
  }
}

// Random mixtures and images; Vo and Ma's equation (25) with Ristic's births, without gate, pruning or merging.
TEST(Correction, HasTheWeightsOfThePublishedEquations) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0), unit(0.05, 1.0);
  Parameters p;
  p.gate = 1e9;
  p.prune_weight = 1e-12;
  for (int round = 0; round < 200; ++round) {
    Filter filter(p);
    std::vector<Component> mixture;
    for (int i = 0; i < 6; ++i) {
      const double x = uniform(random), y = uniform(random);
      const double weight = unit(random);
      mixture.push_back(robot(x, y, weight, 0.3));
      filter.add(mixture.back());
    }
    std::vector<Sighting> image;
    for (int i = 0; i < 4; ++i) {
      const double x = uniform(random), y = uniform(random);
      image.push_back(at(x, y, 0.2));
    }
    double expected = 0.0;
    for (const Component& each : mixture) expected += (1.0 - p.detection) * each.weight;
    for (const Sighting& z : image) {
      double explained = 0.0;
      for (const Component& each : mixture) {
        const Matrix2d spread = covariance(each).topLeftCorner<2, 2>() + covariance(z);
        const Vector2d gap(z.x - each.x, z.y - each.y);
        explained += p.detection * each.weight * std::exp(-0.5 * gap.dot(spread.inverse() * gap)) /
                     std::sqrt((2.0 * M_PI * spread).determinant());
      }
      expected += (explained + p.birth_density) / (explained + p.birth_density + p.clutter_density);
    }
    filter.correct(image, everywhere);
    ASSERT_NEAR(sum(filter), expected, 1e-9);
  }
}

// Before an image is known, the number of robots that is expected after it is the number expected now. Poisson numbers
// of robots at each component, seen or missed, of newcomers and of false sightings.
TEST(SumOfWeights, IsTheExpectedNumberOfRobots) {
  Parameters p;
  p.detection = 0.7;
  p.clutter_density = 0.05;
  p.birth_density = 0.02;
  const std::vector<Component> mixture{robot(0.0, 0.0, 0.8, 0.3), robot(0.4, 0.3, 0.5, 0.2), robot(-1.5, 1.0, 1.2, 0.4),
                                       robot(5.0, 5.0, 0.9, 0.1)};
  const double half = 8.0, area = 4.0 * half * half;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-half, half), unit(0.0, 1.0);
  const auto poisson = [&](double rate) { return std::poisson_distribution<int>(rate)(random); };
  const int rounds = 20000;
  double told = 0.0, squares = 0.0, prior = p.birth_density * area;
  for (const Component& each : mixture) prior += each.weight;
  for (int round = 0; round < rounds; ++round) {
    Filter filter(p);
    std::vector<Sighting> image;
    const auto see = [&](double x, double y) {
      const double a = 0.1 * normal(random);
      const double b = 0.1 * normal(random);
      image.push_back(at(x + a, y + b));
    };
    for (const Component& each : mixture) {
      filter.add(each);
      for (int n = poisson(each.weight); n > 0; --n) {
        const double x = each.x + std::sqrt(each.pxx) * normal(random);
        const double y = each.y + std::sqrt(each.pyy) * normal(random);
        if (unit(random) < p.detection) see(x, y);
      }
    }
    for (int n = poisson((p.clutter_density + p.birth_density) * area); n > 0; --n) {
      const double x = uniform(random), y = uniform(random);
      image.push_back(at(x, y));
    }
    filter.correct(image, everywhere);
    told += sum(filter) / rounds;
    squares += sum(filter) * sum(filter) / rounds;
  }
  const double error = std::sqrt((squares - told * told) / rounds);
  EXPECT_NEAR(told, prior, 4.0 * error);
  EXPECT_LT(error, 0.03);
}

TEST(OutsideTheVisibleArea, WeightsFallByTheSurvivalOnly) {
  Filter filter;
  filter.add(robot(-3.0, 0.0));
  filter.add(robot(3.0, 0.0));
  filter.add(robot(1.0, 3.0, 0.3));
  for (int i = 0; i < 100; ++i) {
    filter.predict(0.1);
    filter.correct(nothing, ahead());
  }
  ASSERT_EQ(size(filter), 2u) << "the one ahead was not there";
  EXPECT_NEAR(filter.begin()[0].weight, std::pow(0.99, 10.0), 1e-9);
  EXPECT_NEAR(filter.begin()[1].weight, 0.3 * std::pow(0.99, 10.0), 1e-9);
  EXPECT_TRUE(filter.told(filter.begin()[0]));
  EXPECT_FALSE(filter.told(filter.begin()[1])) << "it never stood for half a robot";
}

// A robot that is seen although it should be out of view is one robot, however often it is seen.
TEST(OutsideTheVisibleArea, SightingsDoNotPileUp) {
  Filter filter;
  for (int i = 0; i < 200; ++i) {
    filter.predict(0.1);
    filter.correct(std::vector{at(-3.0, 0.0)}, ahead());
  }
  EXPECT_NEAR(sum(filter), 1.0, 0.05);
  EXPECT_EQ(filter.begin()->label, 1);
}

TEST(View, SharesAtTheBordersAreNearThoseOfAGaussian) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  for (const double half_angle : {0.3, 0.477, 1.2, 2.5, 3.2}) {
    const bool all = half_angle > M_PI;
    const View view{0.5, -0.2, 0.6, 0.8, all ? -1.0 : std::cos(half_angle), all ? 0.0 : std::sin(half_angle), 4.0};
    double error = 0.0;
    for (int i = 0; i < 200; ++i) {
      const double x = place(random), y = place(random);
      Component c = robot(x, y, 1.0, 0.0);
      c.pxx = 0.04;
      c.pxy = 0.02;
      c.pyy = 0.05;
      int inside = 0;
      for (int k = 0; k < 1000; ++k) {
        const double a = normal(random), b = normal(random);
        const double px = x + 0.2 * a - 0.5, py = y + 0.1 * a + 0.2 * b + 0.2;
        const double bearing = std::remainder(std::atan2(py, px) - std::atan2(0.8, 0.6), 2.0 * M_PI);
        if (std::hypot(px, py) < 4.0 && std::abs(bearing) < half_angle) ++inside;
      }
      const double share = view.share(c);
      ASSERT_GE(share, 0.0);
      ASSERT_LE(share, 1.0);
      // At the apex both borders are near, and depend on each other.
      if (std::hypot(x - 0.5, y + 0.2) < 1.0) continue;
      ASSERT_NEAR(share, inside / 1000.0, 0.12) << x << " " << y << " " << half_angle;
      error += std::abs(share - inside / 1000.0) / 200;
    }
    EXPECT_LT(error, 0.02) << half_angle;
  }
}

TEST(Merge, KeepsSumMeanAndCovarianceOfTheMixture) {
  Filter filter;
  const Component a = robot(0.0, 0.0, 0.6, 0.3), b = robot(0.3, 0.2, 0.2, 0.4);
  filter.add(a);
  filter.add(b);
  filter.correct(nothing, nowhere);
  ASSERT_EQ(size(filter), 1u);
  const Component& one = *filter.begin();
  const Vector4d middle = 0.75 * mean(a) + 0.25 * mean(b);
  const Matrix4d spread = 0.75 * (covariance(a) + (mean(a) - middle) * (mean(a) - middle).transpose()) +
                          0.25 * (covariance(b) + (mean(b) - middle) * (mean(b) - middle).transpose());
  EXPECT_NEAR(one.weight, 0.8, 1e-12);
  EXPECT_LT((mean(one) - middle).norm(), 1e-12);
  EXPECT_LT((covariance(one) - spread).norm(), 1e-12);
  EXPECT_EQ(one.label, 1);
}

TEST(Merge, ComparesPositionAndVelocityByMahalanobis) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i) {
    Matrix4d root;
    for (int k = 0; k < 16; ++k) root(k / 4, k % 4) = 0.2 * normal(random);
    const Matrix4d all = root * root.transpose() + 1e-3 * Matrix4d::Identity();
    Component b;
    b.pxx = all(0, 0);
    b.pxy = all(0, 1);
    b.pyy = all(1, 1);
    b.cxx = all(0, 2);
    b.cxy = all(0, 3);
    b.cyx = all(1, 2);
    b.cyy = all(1, 3);
    b.vxx = all(2, 2);
    b.vxy = all(2, 3);
    b.vyy = all(3, 3);
    Component a;
    for (double* value : {&a.x, &a.y, &a.vx, &a.vy}) *value = 0.3 * normal(random);
    const double expected = mean(a).dot(all.inverse() * mean(a));
    EXPECT_NEAR(distance(a, b, 1e12), expected, 1e-6 * (1.0 + expected));
    EXPECT_EQ(distance(a, b, 4.0) <= 4.0, expected <= 4.0);
  }
}

// Table II of Vo and Ma: components within a squared distance of 4, two deviations, become one.
TEST(Merge, WithinTwoDeviations) {
  const auto left = [](double deviations) {
    Filter filter;
    filter.add(robot(0.0, 0.0, 0.6, 0.1));
    filter.add(robot(0.1 * deviations, 0.0, 0.3, 0.1));
    filter.correct(nothing, nowhere);
    return size(filter);
  };
  EXPECT_EQ(left(1.99), 1u);
  EXPECT_EQ(left(2.01), 2u);
}

TEST(Merge, LeavesTwoUnseenRobotsTwo) {
  Filter filter;
  filter.correct(std::vector{at(0.0, 0.0), at(0.6, 0.0)}, everywhere);
  filter.correct(std::vector{at(0.0, 0.0), at(0.6, 0.0)}, everywhere);
  for (int i = 0; i < 200; ++i) {
    filter.predict(0.1);
    filter.correct(nothing, nowhere);
  }
  ASSERT_EQ(size(filter), 2u) << "their covariances overlap by now";
  EXPECT_NE(filter.begin()[0].label, filter.begin()[1].label);
  EXPECT_LT(filter.begin()[0].weight, 1.0);
}

TEST(Miss, OfAKnownRobotIsBorneAFewTimes) {
  Filter filter;
  for (int i = 0; i < 10; ++i) filter.correct(std::vector{at(2.0, 0.0)}, ahead());
  const int label = filter.begin()->label;
  filter.correct(nothing, ahead());
  ASSERT_EQ(size(filter), 1u);
  EXPECT_NEAR(filter.begin()->weight, 0.02, 1e-3) << "the published filter trusts its last image";
  EXPECT_TRUE(filter.told(*filter.begin()));
  filter.correct(std::vector{at(2.0, 0.0)}, ahead());
  EXPECT_EQ(filter.begin()->label, label);
  EXPECT_GT(filter.begin()->weight, 0.95);
  for (int i = 0; i < 3; ++i) filter.correct(nothing, ahead());
  EXPECT_EQ(size(filter), 0u);
}

TEST(Labels, StayWithRobotsThatPassEachOther) {
  Filter filter;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  int first = 0, second = 0;
  for (int i = 0; i <= 160; ++i) {  // 0.25 m/s against each other, 0.5 m apart when they meet
    const double x = -2.0 + 0.025 * i;
    std::vector<Sighting> image;
    for (const auto& [tx, ty] : {std::pair(x, 0.25), std::pair(-x, -0.25)}) {
      const double a = 0.05 * normal(random);
      const double b = 0.05 * normal(random);
      image.push_back(at(tx + a, ty + b, 0.05));
    }
    if (i % 2 == 0) std::swap(image[0], image[1]);
    filter.predict(0.1);
    filter.correct(image, everywhere);
    for (const Component& each : filter) {
      if (each.weight < 0.5) continue;
      int& label = each.y > 0.0 ? first : second;
      if (i < 10) {
        label = each.label;
      } else {
        ASSERT_EQ(each.label, label) << i;
      }
    }
  }
  EXPECT_NE(first, second);
  EXPECT_NEAR(sum(filter), 2.0, 0.1);
}

TEST(Labels, GoodOnesOfAPacketAreKeptAndBadOnesReplaced) {
  Filter filter;
  for (const int label : {7, 7, 0, 3}) {
    Component told = robot(static_cast<double>(size(filter)), 0.0);
    told.label = label;
    filter.add(told);
  }
  filter.add(robot(0.0, 0.0, 1e-6));
  ASSERT_EQ(size(filter), 4u);
  EXPECT_EQ(filter.begin()[0].label, 7);
  EXPECT_EQ(filter.begin()[3].label, 3);
  EXPECT_NE(filter.begin()[1].label, 7);
  EXPECT_NE(filter.begin()[1].label, filter.begin()[2].label);
}

// One robot that moves as the model says, seen in two images of three, out of view for ten seconds now and then:
// position and velocity are chi-square with 4 degrees of freedom when the covariance is honest.
TEST(OneTrack, HasAnHonestCovariance) {
  Parameters p;
  const double dt = 0.1;
  double nees = 0.0, place = 0.0;
  int samples = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double x[2] = {1.0, -0.5}, v[2] = {p.speed * normal(random), 0.0};
    v[1] = p.speed * normal(random);
    Filter filter(p);
    for (int i = 1; i <= 600; ++i) {
      constexpr int parts = 20;
      for (int part = 0; part < parts; ++part) {
        const double h = dt / parts;
        for (int k = 0; k < 2; ++k) {
          const double before = v[k];
          v[k] = before * std::exp(-h / p.persistence) +
                 p.speed * std::sqrt(-std::expm1(-2.0 * h / p.persistence)) * normal(random);
          x[k] += 0.5 * h * (before + v[k]);
        }
      }
      filter.predict(dt);
      const bool away = i % 300 >= 200;
      std::vector<Sighting> image;
      if (!away && unit(random) < 0.67) {
        const double a = 0.1 * normal(random);
        const double b = 0.1 * normal(random);
        image.push_back(at(x[0] + a, x[1] + b));
      }
      if (away || !image.empty()) filter.correct(image, away ? nowhere : everywhere);
      if (i % 50 != 49) continue;
      ASSERT_GE(size(filter), 1u);
      const Component& best = *filter.begin();
      const Vector4d error = mean(best) - Vector4d(x[0], x[1], v[0], v[1]);
      nees += error.dot(covariance(best).inverse() * error);
      place += error.head<2>().dot(covariance(best).topLeftCorner<2, 2>().inverse() * error.head<2>());
      ++samples;
    }
  }
  const double band = 3.29 * std::sqrt(2.0 * 4.0 / samples);
  std::printf("mean NEES of position and velocity %.3f (4 +- %.3f), of the position %.3f (2 +- %.3f)\n", nees / samples,
              band, place / samples, band * std::sqrt(0.5));
  EXPECT_NEAR(nees / samples, 4.0, band);
  EXPECT_NEAR(place / samples, 2.0, band * std::sqrt(0.5));
}

TEST(Capacity, IsNeverExceeded) {
  Filter filter;
  for (int round = 0; round < 10; ++round) {
    std::vector<Sighting> many;
    for (int i = 0; i < 60; ++i) many.push_back(at(1.5 * (i % 8) + 0.1 * round, 1.5 * (i / 8) + 13.0 * round));
    filter.predict(0.1);
    filter.correct(many, nowhere);
    ASSERT_LE(size(filter), Filter::capacity);
  }
  EXPECT_EQ(size(filter), Filter::capacity);
  for (std::size_t i = 0; i < size(filter); ++i) {
    for (std::size_t j = 0; j < i; ++j) ASSERT_NE(filter.begin()[i].label, filter.begin()[j].label);
  }
}

// Long silence must not leave numbers so small that the processor stumbles over them.
TEST(Weights, NeverBecomeDenormal) {
  Parameters p;
  Filter filter(p);
  for (int i = 0; i < 20000; ++i) {
    filter.predict(0.1);
    filter.correct(i % 500 == 0 ? std::vector{at(2.0, 0.0), at(-2.0, 0.0)} : nothing, ahead());
    for (const Component& each : filter) {
      ASSERT_GE(each.weight, p.prune_weight);
      for (const double value : {each.vx, each.vy, each.cxy, each.cxx, each.vxy}) {
        ASSERT_TRUE(value == 0.0 || std::abs(value) >= DBL_MIN);
      }
    }
  }
}

}  // namespace
}  // namespace gm_phd

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "gm_phd");
