// SPDX-License-Identifier: MIT
// The rule for silent teammates against the schoolbook and against itself in other steps; the plugin by packets.
#include <gtest/gtest.h>

#include <algorithm>
#include <regista/testkit/contract.hpp>

#include "algorithm.hpp"

namespace dead_reckoning {
namespace {

using Eigen::Vector2d;

Packet walking() {
  Packet packet;
  packet.position << 1.0, 1.0;
  packet.heading = 0.5;
  packet.speed = 0.2;
  packet.has_target = true;
  packet.target << 4.0, 5.0;  // 5 m away: 50 s at 0.1 m/s
  packet.covariance << 0.02, 0.01, 0.01, 0.03;
  packet.heading_variance = 0.05;
  packet.age = 0.3;
  return packet;
}

TEST(SilentTeammate, WalksToItsTargetAtHalfTheSentSpeed) {
  const Estimate now = Teammate(3, walking(), 10.0, {}).now();
  EXPECT_NEAR((now.position - Vector2d(1.6, 1.8)).norm(), 0.0, 1e-12);  // 1 m on the way
  EXPECT_NEAR((now.velocity - Vector2d(0.06, 0.08)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(now.age, 10.3, 1e-12);
}

TEST(SilentTeammate, StandsAtItsTargetWithoutOvershoot) {
  for (const double ago : {50.0 + 1e-9, 60.0, 1e4}) {
    const Estimate now = Teammate(3, walking(), ago, {}).now();
    EXPECT_EQ(now.position, walking().target);
    EXPECT_EQ(now.velocity, Vector2d::Zero());
  }
  const Estimate almost = Teammate(3, walking(), 50.0 - 1e-9, {}).now();
  EXPECT_LT((almost.position - walking().target).norm(), 1e-8);
}

TEST(SilentTeammate, StandsWithoutATargetOrAtIt) {
  Packet standing = walking();
  standing.has_target = false;
  EXPECT_EQ(Teammate(3, standing, 20.0, {}).now().position, standing.position);
  Packet arrived = walking();
  arrived.target = arrived.position;
  EXPECT_EQ(Teammate(3, arrived, 20.0, {}).now().position, arrived.position);
  Packet still = walking();
  still.speed = 0.0;
  EXPECT_EQ(Teammate(3, still, 20.0, {}).now().position, still.position);
}

TEST(SilentTeammate, WhoseSpeedWasNotToldWalksAsRobotsDo) {
  Packet packet = walking();
  packet.speed = -1.0;
  Parameters parameters;
  parameters.walk_speed = 0.3;
  EXPECT_NEAR(Teammate(3, packet, 0.0, parameters).now().velocity.norm(), 0.15, 1e-12);
}

TEST(Uncertainty, GrowsWithTheSilenceAsTheErrorOfTheVelocityHasIt) {
  Parameters parameters;
  parameters.position_noise = 0.1;
  parameters.heading_noise = 0.2;
  const Estimate now = Teammate(3, walking(), 4.0, parameters).now();
  EXPECT_NEAR(now.position_covariance(0, 0), 0.02 + 0.16, 1e-12);
  EXPECT_NEAR(now.position_covariance(1, 1), 0.03 + 0.16, 1e-12);
  EXPECT_NEAR(now.cross, 0.04, 1e-12);
  EXPECT_NEAR(now.heading_variance, 0.05 + 0.64, 1e-12);
}

TEST(Team, IsTheSameWhateverTheStepsAndTheDelay) {
  Team late(7, {}), early(7, {}), often(7, {});
  late.hear(4, walking(), 61.0);
  early.hear(4, walking(), 0.0);
  often.hear(4, walking(), 1.0);
  early.predict(61.0);
  for (int i = 0; i < 6000; ++i) {
    often.predict(0.01);
    if (i == 2999) {  // on the way
      Team fresh(7, {});
      fresh.hear(4, walking(), 31.0);
      EXPECT_LT((fresh.begin()->now().position - often.begin()->now().position).norm(), 1e-9);
      EXPECT_LT((fresh.begin()->now().position_covariance - often.begin()->now().position_covariance).norm(), 1e-9);
    }
  }
  EXPECT_EQ(late.begin()->now().position, early.begin()->now().position);
  EXPECT_EQ(late.begin()->now().position, often.begin()->now().position);
  EXPECT_NEAR(often.begin()->now().age, 61.3, 1e-9);
}

TEST(Team, AnswersByNumberAndReplacesOnlyWhoSpoke) {
  Team team(7, {});
  for (const int number : {5, 2, 7}) team.hear(number, walking(), 0.0);
  team.predict(3.0);
  Packet news = walking();
  news.position << -1.0, 0.0;
  news.age = 0.0;
  team.hear(5, news, 0.5);
  std::vector<int> numbers;
  std::vector<double> ages;
  for (const Teammate& mate : team) {
    numbers.push_back(mate.number());
    ages.push_back(mate.now().age);
  }
  EXPECT_EQ(numbers, (std::vector{2, 5, 7}));
  EXPECT_NEAR(ages[0], 3.3, 1e-12);
  EXPECT_NEAR(ages[1], 0.5, 1e-12);
  EXPECT_NEAR(ages[2], 3.3, 1e-12);
  team.reset();
  EXPECT_EQ(team.begin(), team.end());
}

}  // namespace
}  // namespace dead_reckoning

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "dead_reckoning");
