// SPDX-License-Identifier: MIT
// Holding still, for each subject, against what was measured and said; its covariance against simulated walkers.
#include <gtest/gtest.h>

#include <random>
#include <regista/testkit/contract.hpp>
#include <vector>

#include "algorithm.hpp"

namespace hold_last {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Sighting sighting(double x, double y, double deviation = 0.1) {
  return {{x, y}, deviation * deviation * Matrix2d::Identity()};
}

TEST(Ball, StaysWhereItWasLastMeasured) {
  Memory memory;
  memory.see_the_one(std::vector{sighting(1.0, 0.0)});
  memory.predict(0.1);
  memory.see_the_one(std::vector{sighting(1.5, 0.2)});
  for (int i = 0; i < 30; ++i) memory.predict(0.1);
  ASSERT_EQ(memory.end() - memory.begin(), 1);
  EXPECT_EQ(memory.begin()->position, Vector2d(1.5, 0.2));
  EXPECT_NEAR(memory.begin()->age(), 3.0, 1e-12);
  memory.see_the_one(std::vector{sighting(-3.0, 0.0), sighting(1.4, 0.0), sighting(2.0, 2.0)});
  EXPECT_EQ(memory.begin()->position, Vector2d(1.4, 0.0)) << "of several, the nearest";
}

TEST(Forgetting, ComesWithAgeAndOnlyThen) {
  Memory memory;
  memory.see_the_one(std::vector{sighting(1.0, 0.0)});
  memory.predict(7.9);
  EXPECT_EQ(memory.end() - memory.begin(), 1);
  memory.predict(0.2);
  EXPECT_EQ(memory.begin(), memory.end());
  Held old;
  old.age_then = 7.0;
  old.elapsed = 2.0;
  memory.hear(old);
  EXPECT_EQ(memory.begin(), memory.end()) << "told too late";
}

// The unknown velocity is what the covariance says: walkers with such velocities, seen with such noise.
TEST(Uncertainty, CoversWalkersOfUnknownVelocity) {
  Parameters parameters;
  parameters.speed = 0.25;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const int runs = 4000;
  double sum = 0.0;  // normalised estimation error squared, 2 degrees of freedom
  for (int run = 0; run < runs; ++run) {
    const double vx = 0.25 * normal(random);
    const double vy = 0.25 * normal(random);
    const double seen_x = 0.1 * normal(random);
    const double seen_y = 0.1 * normal(random);
    Memory memory(parameters);
    memory.see_the_one(std::vector{sighting(seen_x, seen_y)});
    for (int i = 0; i < 20; ++i) memory.predict(0.1);
    const Held& held = *memory.begin();
    const double variance = held.covariance(0, 0) + Growth(held, parameters).position;
    sum += (Vector2d(2.0 * vx, 2.0 * vy) - held.position).squaredNorm() / variance;
  }
  // Sum of 2 * 4000 squared normals: mean 8000, deviation sqrt(16000) = 126.5; 99.9 % within 3.29 deviations.
  EXPECT_NEAR(sum, 2.0 * runs, 3.29 * std::sqrt(4.0 * runs));
}

TEST(Opponents, KeepTheirLabelsWhateverTheOrderOfSightings) {
  Memory memory;
  memory.see_many(std::vector{sighting(0.0, 0.0), sighting(0.8, 0.0), sighting(3.0, 1.0)});
  ASSERT_EQ(memory.end() - memory.begin(), 3);
  memory.predict(0.1);
  // The middle one comes nearer to where the first was; nearest pairs first tells them apart.
  memory.see_many(std::vector{sighting(0.6, 0.0), sighting(3.1, 1.0), sighting(-0.1, 0.0)});
  ASSERT_EQ(memory.end() - memory.begin(), 3);
  for (const Held& held : memory) {
    const double x = held.label == 1 ? -0.1 : held.label == 2 ? 0.6 : 3.1;
    EXPECT_EQ(held.position.x(), x) << held.label;
  }
  memory.predict(0.1);
  memory.see_many(std::vector<Sighting>{});
  EXPECT_EQ(memory.end() - memory.begin(), 3) << "a miss is no news";
  memory.see_many(std::vector{sighting(-2.0, 0.0)});
  EXPECT_EQ((memory.end() - 1)->label, 4) << "far from all: another one";
}

TEST(Opponents, MoreThanThereIsRoomForReplaceTheOldest) {
  Memory memory;
  memory.see_many(std::vector{sighting(-100.0, 0.0)});
  memory.predict(0.1);
  std::vector<Sighting> crowd;
  for (int i = 0; i < Memory::capacity; ++i) crowd.push_back(sighting(5.0 * i, 0.0));
  memory.see_many(crowd);
  ASSERT_EQ(memory.end() - memory.begin(), Memory::capacity);
  for (const Held& held : memory) EXPECT_GE(held.position.x(), 0.0);
}

TEST(Teammates, StayAsTheySaidWhateverTheDelay) {
  Parameters parameters;
  parameters.forget_after = std::numeric_limits<double>::infinity();
  Memory late(parameters), early(parameters);
  Held told;
  told.position << 1.0, -2.0;
  told.age_then = 0.2;
  for (const int number : {5, 2, 7}) {
    told.label = number;
    told.elapsed = 0.0;
    early.hear(told);
    told.elapsed = 600.0;
    late.hear(told);
  }
  early.predict(600.0);
  std::vector<int> numbers;
  for (const Held& held : early) numbers.push_back(held.label);
  EXPECT_EQ(numbers, (std::vector{2, 5, 7}));
  EXPECT_EQ(early.begin()->position, Vector2d(1.0, -2.0));
  EXPECT_NEAR(early.begin()->age(), 600.2, 1e-9);
  EXPECT_EQ(early.begin()->age(), late.begin()->age());
  told.label = 5;
  told.position.x() = 3.0;
  told.elapsed = 0.0;
  early.hear(told);
  EXPECT_EQ(early.end() - early.begin(), 3);
  EXPECT_EQ((early.begin() + 1)->position.x(), 3.0);
  EXPECT_EQ(early.begin()->position.x(), 1.0);
}

}  // namespace
}  // namespace hold_last

namespace regista::testkit {
namespace {

TEST(HoldLastPlugin, LeavesSilentTeammatesWhereTheySaidToBeThoughTheyWalk) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "hold_last");
  Instance instance(plugin, EnvironmentBuilder{}.subject(REGISTA_SUBJECT_TEAMMATES), Values(plugin));
  regista_track told{};
  told.label = 4;
  told.flags = REGISTA_TRACK_HAS_TARGET | REGISTA_TRACK_VELOCITY;
  told.x = 1.0;
  told.vx = 0.3;
  told.pose.target[0] = 4.0;
  told.weight = 1.0;
  instance.absorb(std::vector{told}, 1.0);
  instance.predict(2.0, nullptr);
  const std::vector<regista_track> tracks = instance.tracks();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].x, 1.0);
  EXPECT_EQ(tracks[0].vx, 0.0);
  EXPECT_EQ(tracks[0].pose.target[0], 4.0);
  EXPECT_NEAR(tracks[0].covariance[0], 0.36, 1e-12);  // 0.2 m/s for 3 s
  EXPECT_NEAR(tracks[0].age, 3.0, 1e-12);
}

}  // namespace
}  // namespace regista::testkit

REGISTA_PREDICTOR_CONTRACT(REGISTA_PLUGIN_FILE, "hold_last");
