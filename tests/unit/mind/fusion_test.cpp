// SPDX-License-Identifier: MIT
// Fusion against the textbook: fast covariance intersection (Niehsen 2002) computed source by source with dense
// matrices, its bounds by numeric minimisation, consistency whatever the correlation; opponents against brute force.
#include "mind/world/fusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regista/testkit/dice.hpp>
#include <set>
#include <tuple>

namespace regista::mind {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double least_variance = 1e-6;  // fusion.cpp adds it to every diagonal

using testkit::Dice;

// Box and Muller (1958).
double normal(Dice& dice) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - dice.real(0.0, 1.0)));
  return radius * std::cos(dice.real(-pi, pi));
}

template <class List>
void shuffle(List& list, Dice& dice) {
  std::shuffle(list.begin(), list.end(), std::mt19937_64(dice.bits()));
}

// Symmetric positive definite with eigenvalues of the order of scale^2.
Matrix random_covariance(Dice& dice, double scale) {
  Matrix root(4, 4);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) root(i, j) = scale * normal(dice);
  }
  return root * root.transpose() + 0.05 * scale * scale * Matrix::Identity(4, 4);
}

// An estimate together with its track.
struct Told {
  regista_track track{};
  int source = 0;
};

// Where an entry of the covariance of a motion stands, as abi.h packs it; of a track the first three are of the place.
constexpr int packed[4][4] = {{0, 1, 3, 4}, {1, 2, 5, 6}, {3, 5, 7, 8}, {4, 6, 8, 9}};

double& entry(regista_track& track, int i, int j) {
  const int k = packed[i][j];
  return k < 3 ? track.covariance[k] : track.motion[k - 3];
}

std::vector<Estimate> views(const std::vector<Told>& told) {
  std::vector<Estimate> out;
  for (const Told& each : told) out.push_back({&each.track, each.source});
  return out;
}

Told estimate(const Vector& state, const Matrix& covariance, int source, double weight = 1.0, double age = 0.0) {
  Told out;
  out.source = source;
  out.track.x = state[0];
  out.track.y = state[1];
  out.track.vx = state[2];
  out.track.vy = state[3];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) entry(out.track, i, j) = covariance(i, j);
  }
  out.track.weight = weight;
  out.track.age = age;
  return out;
}

struct Fused {
  Vector mean = Vector::Zero(4);
  Matrix covariance = Matrix::Zero(4, 4);
};

// Niehsen: w_i = (1 / tr P_i) / sum (1 / tr P_j), traces of the position here; P^-1 = sum w_i P_i^-1.
Fused textbook(const std::vector<Told>& estimates) {
  double sum = 0.0;
  std::vector<double> shares;
  std::vector<Matrix> covariances;
  std::vector<Vector> states;
  for (Told each : estimates) {
    Matrix p(4, 4);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) p(i, j) = entry(each.track, i, j);
    }
    covariances.push_back(p + least_variance * Matrix::Identity(4, 4));
    states.push_back(Vector{{each.track.x, each.track.y, each.track.vx, each.track.vy}});
    shares.push_back(each.track.weight / (covariances.back()(0, 0) + covariances.back()(1, 1)));
    sum += shares.back();
  }
  Matrix information = Matrix::Zero(4, 4);
  Vector weighted = Vector::Zero(4);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Eigen::FullPivLU<Matrix> lu(covariances[i]);
    information += shares[i] / sum * lu.inverse();
    weighted += shares[i] / sum * lu.solve(states[i]);
  }
  Fused out;
  const Eigen::FullPivLU<Matrix> lu(information);
  out.covariance = lu.inverse();
  out.mean = lu.solve(weighted);
  return out;
}

Fused read(const regista_ball& ball) {
  Fused out;
  out.mean << ball.position[0], ball.position[1], ball.velocity[0], ball.velocity[1];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) out.covariance(i, j) = ball.covariance[packed[i][j]];
  }
  return out;
}

// Estimates so near each other that none contradicts the best.
std::vector<Told> agreeing(Dice& dice, int count) {
  std::vector<Told> out;
  const Vector truth{{dice.real(-4, 4), dice.real(-3, 3), dice.real(-1, 1), dice.real(-1, 1)}};
  for (int i = 0; i < count; ++i) {
    const Matrix covariance = random_covariance(dice, dice.real(0.2, 0.6));
    Vector state = truth;
    for (int k = 0; k < 4; ++k) state[k] += 0.05 * normal(dice);
    out.push_back(estimate(state, covariance, i));
  }
  return out;
}

TEST(BallFusion, NothingKnownIsNotKnown) {
  const regista_ball ball = fuse_ball({});
  EXPECT_EQ(ball.flags, 0u);
  Dice dice(1);
  std::vector<Told> one{estimate(Vector::Zero(4), random_covariance(dice, 0.1), 1, 0.0)};
  EXPECT_EQ(fuse_ball(views(one)).flags, 0u) << "weight 0";
}

TEST(BallFusion, IsFastCovarianceIntersection) {
  Dice dice(2);
  for (int round = 0; round < 500; ++round) {
    std::vector<Told> estimates = agreeing(dice, dice.integer(1, 7));
    for (Told& each : estimates) each.track.weight = dice.real(0.3, 1.0);
    const Fused expected = textbook(estimates), got = read(fuse_ball(views(estimates)));
    EXPECT_LT((got.mean - expected.mean).norm(), 1e-9) << round;
    EXPECT_LT((got.covariance - expected.covariance).norm(), 1e-9 * expected.covariance.norm()) << round;
    EXPECT_EQ(got.covariance, got.covariance.transpose());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix>(got.covariance).eigenvalues().minCoeff(), 0.0);
  }
}

// Two sources by hand: isotropic variances 1 and 3 (position), at 0 and 4. w = 3/4, 1/4; information 3/4 + 1/12 = 5/6;
// mean = (4 / 12) / (5 / 6) = 0.4; variance 1.2.
TEST(BallFusion, TwoSourcesByHand) {
  const Matrix one = Matrix::Identity(4, 4), three = 3.0 * Matrix::Identity(4, 4);
  const std::vector<Told> estimates{estimate(Vector::Zero(4), one, 1), estimate(Vector{{4, 0, 0, 0}}, three, 2)};
  const regista_ball ball = fuse_ball(views(estimates));
  EXPECT_NEAR(ball.position[0], 0.4, 1e-5);
  EXPECT_NEAR(ball.covariance[0], 1.2, 1e-5);
  EXPECT_NEAR(ball.covariance[2], 1.2, 1e-5);
  EXPECT_NEAR(ball.covariance[1], 0.0, 1e-12);
}

// The closed-form weights are one choice of omega: never better than the best omega found by search.
TEST(BallFusion, NeverClaimsMoreThanTheBestIntersection) {
  Dice dice(3);
  for (int round = 0; round < 20; ++round) {
    const std::vector<Told> estimates = agreeing(dice, 2);
    const Matrix p0 = textbook({estimates[0]}).covariance, p1 = textbook({estimates[1]}).covariance;
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 200; ++k) {
      const double omega = k * 5e-3;
      const Matrix information = omega * p0.inverse() + (1.0 - omega) * p1.inverse();
      best = std::min(best, information.inverse().determinant());
    }
    EXPECT_GE(read(fuse_ball(views(estimates))).covariance.determinant(), best * (1.0 - 1e-4));
  }
}

// Fully correlated errors, e_2 = L_2 L_1^-1 Q e_1: the claimed covariance still covers the true one.
TEST(BallFusion, IsConsistentUnderFullCorrelation) {
  Dice dice(4);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Told> estimates = agreeing(dice, 2);
    const Matrix p1 = textbook({estimates[0]}).covariance, p2 = textbook({estimates[1]}).covariance;
    const Matrix l1 = p1.llt().matrixL(), l2 = p2.llt().matrixL();
    Matrix random(4, 4);
    for (int i = 0; i < 16; ++i) random(i / 4, i % 4) = normal(dice);
    const Matrix rotation = Eigen::HouseholderQR<Matrix>(random).householderQ();
    const Matrix cross = l1 * rotation.transpose() * l2.transpose();  // E e_1 e_2^T
    const double t1 = p1(0, 0) + p1(1, 1), t2 = p2(0, 0) + p2(1, 1);
    const double w1 = (1 / t1) / (1 / t1 + 1 / t2), w2 = 1.0 - w1;
    const Matrix claimed = read(fuse_ball(views(estimates))).covariance;
    const Matrix k1 = claimed * w1 * p1.inverse(), k2 = claimed * w2 * p2.inverse();
    const Matrix truth = k1 * p1 * k1.transpose() + k2 * p2 * k2.transpose() + k1 * cross * k2.transpose() +
                         k2 * cross.transpose() * k1.transpose();
    const double least = Eigen::SelfAdjointEigenSolver<Matrix>(claimed - truth).eigenvalues().minCoeff();
    EXPECT_GT(least, -1e-9 * claimed.norm());
  }
}

TEST(BallFusion, DoesNotDependOnTheOrder) {
  Dice dice(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<Told> estimates = agreeing(dice, 5);
    const Fused before = read(fuse_ball(views(estimates)));
    shuffle(estimates, dice);
    const Fused after = read(fuse_ball(views(estimates)));
    EXPECT_LT((before.mean - after.mean).norm(), 1e-9);
    EXPECT_LT((before.covariance - after.covariance).norm(), 1e-9);
  }
}

TEST(BallFusion, LeavesOutWhatContradictsTheMostCertain) {
  const Matrix sharp = 0.01 * Matrix::Identity(4, 4), blurred = 0.04 * Matrix::Identity(4, 4);
  // Deviation of the difference: sqrt(0.05) = 0.2236; the gate of 99 % is at sqrt(9.21) = 3.035 of it: 0.6786 m.
  const auto fused_x = [&](double x) {
    const std::vector<Told> both{estimate(Vector{{x, 0, 0, 0}}, blurred, 2, 1.0, 0.0),
                                 estimate(Vector::Zero(4), sharp, 1, 1.0, 0.0)};
    return fuse_ball(views(both)).position[0];
  };
  EXPECT_GT(fused_x(0.67), 0.0);
  EXPECT_EQ(fused_x(0.69), 0.0);
}

TEST(BallFusion, AgeIsThatOfTheYoungestThatWasFused) {
  const Matrix sharp = 0.01 * Matrix::Identity(4, 4), blurred = 0.02 * Matrix::Identity(4, 4);
  const Told far = estimate(Vector{{3, 0, 0, 0}}, blurred, 3, 1.0, 0.0);
  const std::vector<Told> agreed{estimate(Vector::Zero(4), sharp, 1, 1.0, 0.2),
                                 estimate(Vector{{0.05, 0, 0, 0}}, blurred, 2, 1.0, 0.1)};
  EXPECT_DOUBLE_EQ(fuse_ball(views(agreed)).age, 0.1);
  const std::vector<Told> contradicted{far, estimate(Vector::Zero(4), sharp, 1, 1.0, 0.01)};
  EXPECT_DOUBLE_EQ(fuse_ball(views(contradicted)).age, 0.01) << "the far one is less certain and contradicts";
}

TEST(BallFusion, UnwatchedEstimatesLoseToFreshOnes) {
  const Matrix sharp = 0.0001 * Matrix::Identity(4, 4), blurred = 0.04 * Matrix::Identity(4, 4);
  const std::vector<Told> estimates{estimate(Vector::Zero(4), sharp, 1, 1.0, 3.0),
                                    estimate(Vector{{4, 0, 0, 0}}, blurred, 2, 1.0, 0.0)};
  EXPECT_DOUBLE_EQ(fuse_ball(views(estimates)).position[0], 4.0);
}

// A ball that nobody watches is pushed about: 0.3 m per second of its age, per axis. So an estimate of some age is
// worth what a fresh one of so much larger a covariance is, alone, in its weight among others, and in what it
// contradicts.
TEST(BallFusion, AgeCountsAsUncertaintyOfThePosition) {
  const Told alone = estimate(Vector::Zero(4), 0.01 * Matrix::Identity(4, 4), 1, 1.0, 2.0);
  const regista_ball ball = fuse_ball(views({alone}));
  EXPECT_NEAR(ball.covariance[0], 0.01 + 0.6 * 0.6 + least_variance, 1e-12);
  EXPECT_NEAR(ball.covariance[2], 0.01 + 0.6 * 0.6 + least_variance, 1e-12);
  EXPECT_NEAR(ball.covariance[7], 0.01 + least_variance, 1e-12) << "of the velocity";

  Dice dice(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<Told> old = agreeing(dice, 2 + round % 4), fresh;
    for (Told& each : old) {
      each.track.x += dice.real(-1.5, 1.5);  // some contradict
      const double age = dice.real(0.0, 3.0);
      Told grown = each;
      grown.track.covariance[0] += 0.09 * age * age;
      grown.track.covariance[2] += 0.09 * age * age;
      fresh.push_back(grown);
      each.track.age = age;
    }
    const Fused aged = read(fuse_ball(views(old))), expected = read(fuse_ball(views(fresh)));
    EXPECT_LT((aged.mean - expected.mean).norm(), 1e-9) << "round " << round;
    EXPECT_LT((aged.covariance - expected.covariance).norm(), 1e-9) << "round " << round;
  }
}

// --- Opponents -----------------------------------------------------------------------------------------------------

Told opponent(double x, double y, double variance, int source, int label, double weight = 0.9, double age = 0.0) {
  Told out;
  out.source = source;
  out.track.label = label;
  out.track.x = x;
  out.track.y = y;
  out.track.covariance[0] = out.track.covariance[2] = variance;
  out.track.weight = weight;
  out.track.age = age;
  return out;
}

std::vector<regista_opponent> fused(const std::vector<Told>& estimates, std::size_t most = 7) {
  std::map<int, std::vector<regista_track>> by_source;
  for (const Told& each : estimates) by_source[each.source].push_back(each.track);
  OpponentFusion fusion;
  std::vector<regista_opponent> out;
  for (const auto& [source, tracks] : by_source) {
    fusion.add(tracks, source);
    fusion.write(most, out);  // what has been written changes nothing of what is added later
  }
  return out;
}

TEST(OpponentFusion, NothingIsNobody) { EXPECT_TRUE(fused({}).empty()); }

// Variances 0.02 and 0.06 at 0 and 0.8: traces 0.04 and 0.12, squared Mahalanobis distance 0.64 / 0.08 = 8. Weights 3/4
// and 1/4, information 625 + 69.44 per m^4, mean 0.8 * 69.44 / 694.4 = 0.08, variance 0.024. Missing: 0.5 * 0.2.
TEST(OpponentFusion, MergesTwoSourcesByHand) {
  const auto out = fused({opponent(0, 2, 0.02, 1, 1, 0.5, 3.0), opponent(0.8, 2, 0.06, 2, 1, 0.8, 1.0)});
  ASSERT_EQ(out.size(), 1u);
  EXPECT_NEAR(out[0].position[0], 0.08, 1e-12);
  EXPECT_NEAR(out[0].position[1], 2.0, 1e-12);
  EXPECT_NEAR(out[0].covariance[0], 0.024, 1e-12);
  EXPECT_NEAR(out[0].covariance[2], 0.024, 1e-12);
  EXPECT_NEAR(out[0].weight, 0.9, 1e-12);
  EXPECT_DOUBLE_EQ(out[0].age, 1.0);
}

// 9.21 * 0.02 = 0.429^2; and 2 m, however little is known.
TEST(OpponentFusion, MergesWhatTheCovariancesAllow) {
  EXPECT_EQ(fused({opponent(0, 0, 0.01, 1, 1), opponent(0.42, 0, 0.01, 2, 1)}).size(), 1u);
  EXPECT_EQ(fused({opponent(0, 0, 0.01, 1, 1), opponent(0.44, 0, 0.01, 2, 1)}).size(), 2u);
  EXPECT_EQ(fused({opponent(0, 0, 0.01, 1, 1), opponent(1.99, 0, 4.0, 2, 1)}).size(), 1u);
  EXPECT_EQ(fused({opponent(0, 0, 0.01, 1, 1), opponent(2.01, 0, 4.0, 2, 1)}).size(), 2u);
}

// The second source's first estimate could be the robot at 0, too; but its second one is nearer.
TEST(OpponentFusion, TheNearestPairComesFirst) {
  const auto out = fused({opponent(0, 0, 0.01, 1, 1), opponent(1.2, 0, 0.5, 2, 1), opponent(0.3, 0, 0.5, 2, 2)});
  ASSERT_EQ(out.size(), 2u);
  EXPECT_LT(out[0].position[0], 0.01);
  EXPECT_DOUBLE_EQ(out[1].position[0], 1.2);
}

// Where three are known and two can play, an old place with a larger weight gives way to a fresh one.
TEST(OpponentFusion, TheLeastSurePlaceGivesWay) {
  const auto out =
      fused({opponent(0, 0, 0.01, 1, 1, 0.9), opponent(3, 0, 3.0, 1, 2, 0.99), opponent(6, 0, 0.01, 1, 3, 0.8)}, 2);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_DOUBLE_EQ(out[0].position[0], 0.0);
  EXPECT_DOUBLE_EQ(out[1].position[0], 6.0);
}

TEST(OpponentFusion, NeverMergesTwoTracksOfOneSource) {
  EXPECT_EQ(fused({opponent(0, 0, 0.04, 1, 1), opponent(0.1, 0, 0.04, 1, 2)}).size(), 2u);
  // The third joins the nearer of the two.
  const auto out = fused({opponent(0, 0, 0.04, 1, 1), opponent(0.5, 0, 0.04, 1, 2), opponent(0.4, 0, 0.04, 2, 1)});
  ASSERT_EQ(out.size(), 2u);
  std::set<double> xs{out[0].position[0], out[1].position[0]};
  EXPECT_DOUBLE_EQ(*xs.begin(), 0.0);
  EXPECT_NEAR(*xs.rbegin(), 0.45, 1e-12);
}

TEST(OpponentFusion, KeepsTheLikeliest) {
  std::vector<Told> many;
  for (int i = 0; i < 12; ++i) many.push_back(opponent(2.0 * i, 0, 0.04, 1, i, 0.05 + 0.07 * i));
  const auto out = fused(many, 5);
  ASSERT_EQ(out.size(), 5u);
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_DOUBLE_EQ(out[i].position[0], 2.0 * (11.0 - static_cast<double>(i)));
  }
}

TEST(OpponentFusion, LabelsAreUniqueHoweverFarPredictorsCount) {
  std::vector<Told> many;
  for (int source = 0; source <= 11; ++source) {
    for (int k = 0; k < 2; ++k) {
      const int label = k == 0 ? 1000 * (11 - source) + 1 : 100000 + source;
      many.push_back(opponent(3.0 * source, 10.0 * k, 0.04, source, label));
    }
  }
  const auto out = fused(many, 100);
  std::set<int> labels;
  for (const auto& each : out) labels.insert(each.label);
  EXPECT_EQ(out.size(), 24u);
  EXPECT_EQ(labels.size(), out.size());
}

// Opponents far apart, each seen by a random subset of robots: clusters are known beforehand, means computed directly,
// and no order of the estimates changes them.
// Probability of an opponent within 1 m of the place; not where weights were clamped.
double likelihood(const regista_opponent& each) {
  return each.weight * (1.0 - std::exp(-1.0 / (2.0 * each.covariance[0])));
}

TEST(OpponentFusion, RandomSetsAgainstBruteForce) {
  Dice dice(6);
  for (int round = 0; round < 200; ++round) {
    struct Expected {
      double x = 0, y = 0, i1 = 0, i2 = 0, missing = 1, age = 1e9;
    };
    std::vector<Told> estimates;
    std::map<std::pair<long, long>, Expected> expected;
    const int opponents = dice.integer(1, 7);
    for (int k = 0; k < opponents; ++k) {
      const double cx = 3.0 * k - 9.0, cy = dice.real(-3, 3);
      Expected truth;
      for (int source = 0; source <= 7; ++source) {
        if (dice.integer(0, 1) == 0) continue;
        const double x = cx + dice.real(-0.1, 0.1), y = cy + dice.real(-0.1, 0.1), variance = dice.real(0.01, 0.3);
        const double weight = dice.real(0.05, 0.95), age = dice.real(0, 4), information = 1.0 / (2.0 * variance);
        estimates.push_back(opponent(x, y, variance, source, k, weight, age));
        truth.x += information * information * x;
        truth.y += information * information * y;
        truth.i1 += information;
        truth.i2 += information * information;
        truth.missing *= 1.0 - weight;
        truth.age = std::min(truth.age, age);
      }
      if (truth.i1 > 0.0) expected[{k, 0}] = truth;
    }
    shuffle(estimates, dice);
    const auto out = fused(estimates);
    ASSERT_EQ(out.size(), expected.size());
    for (const regista_opponent& each : out) {
      const long k = std::lround((each.position[0] + 9.0) / 3.0);
      const auto found = expected.find({k, 0});
      ASSERT_NE(found, expected.end());
      const Expected& truth = found->second;
      EXPECT_NEAR(each.position[0], truth.x / truth.i2, 1e-9);
      EXPECT_NEAR(each.position[1], truth.y / truth.i2, 1e-9);
      EXPECT_NEAR(each.covariance[0], 0.5 * truth.i1 / truth.i2, 1e-9);
      EXPECT_NEAR(each.weight, std::clamp(1.0 - truth.missing, 1e-3, 1.0), 1e-12);
      EXPECT_DOUBLE_EQ(each.age, truth.age);
    }
    for (std::size_t i = 1; i < out.size(); ++i) EXPECT_GE(likelihood(out[i - 1]), likelihood(out[i]));
  }
}

// The same by brute force: all pairs of a source's tracks and the clusters, sorted by distance, ties by place.
std::vector<regista_opponent> fused_by_sorting(const std::map<int, std::vector<regista_track>>& by_source) {
  struct Group {
    double x = 0, y = 0, i1 = 0, i2 = 0;
  };
  std::vector<Group> groups;
  const auto join = [](Group& group, const regista_track& track) {
    const double information = 1.0 / (track.covariance[0] + track.covariance[2]);
    group.x += information * information * track.x;
    group.y += information * information * track.y;
    group.i1 += information;
    group.i2 += information * information;
  };
  for (const auto& [source, tracks] : by_source) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      for (std::size_t j = 0; j < groups.size(); ++j) {
        const Group& group = groups[j];
        const double dx = group.x / group.i2 - tracks[i].x, dy = group.y / group.i2 - tracks[i].y;
        const double distance =
            (dx * dx + dy * dy) / (0.5 * (tracks[i].covariance[0] + tracks[i].covariance[2] + group.i1 / group.i2));
        if (dx * dx + dy * dy <= 4.0 && distance <= 9.21) pairs.emplace_back(distance, i, j);
      }
    }
    std::ranges::sort(pairs);
    std::set<std::size_t> placed, taken;
    for (const auto& [distance, i, j] : pairs) {
      if (placed.count(i) != 0 || !taken.insert(j).second) continue;
      placed.insert(i);
      join(groups[j], tracks[i]);
    }
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      if (placed.count(i) == 0) join(groups.emplace_back(), tracks[i]);
    }
  }
  std::vector<regista_opponent> out(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    out[i].position[0] = groups[i].x / groups[i].i2;
    out[i].position[1] = groups[i].y / groups[i].i2;
  }
  return out;
}

// In dense crowds many tracks want the same cluster, and the loser takes the next nearest one.
TEST(OpponentFusion, CrowdsAgainstBruteForce) {
  Dice dice(8);
  for (int round = 0; round < 300; ++round) {
    std::vector<Told> estimates;
    std::map<int, std::vector<regista_track>> by_source;
    for (int i = dice.integer(0, 40); i > 0; --i) {
      const int source = dice.integer(0, 7);
      estimates.push_back(
          opponent(dice.real(-2, 2), dice.real(-2, 2), dice.real(0.01, 0.5), source, i, dice.real(0.01, 0.9)));
      by_source[source].push_back(estimates.back().track);
    }
    auto out = fused(estimates, 1000), expected = fused_by_sorting(by_source);
    ASSERT_EQ(out.size(), expected.size()) << round;
    EXPECT_EQ(fused(estimates, 7).size(), std::min<std::size_t>(7, out.size()));
    for (auto* list : {&out, &expected})
      std::ranges::sort(*list, {}, [](const auto& each) { return each.position[0]; });
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_NEAR(out[i].position[0], expected[i].position[0], 1e-9) << round;
      EXPECT_NEAR(out[i].position[1], expected[i].position[1], 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace regista::mind
