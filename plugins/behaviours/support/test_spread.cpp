// SPDX-License-Identifier: MIT
// Targets that keep clear of the ball and of each other, worked out by hand and over random scenes.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/dice.hpp>

#include "../lane.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

constexpr SpreadSettings wide{.clear_of_ball = 1.2, .apart = 1.0, .moved_at_most = 1.2};

TEST(Spread, WithoutItTargetsStayWhereTheyAre) {
  const std::vector<Vector2d> others{{0, 0}};
  EXPECT_EQ(spread(with_ball(standing(0, 0), {0, 0}), {}, {0.1, 0}, others), Vector2d(0.1, 0));
}

TEST(Spread, NobodyStandsAtTheBallWithoutPlayingIt) {
  const Situation scene = with_ball(standing(0, 0), {1, 0});
  EXPECT_NEAR((spread(scene, wide, {0.4, 0}, {}) - Vector2d(-0.2, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(spread(scene, wide, {-0.3, 0}, {}), Vector2d(-0.3, 0));
  Situation lost = scene;
  lost.ball_trusted = false;
  EXPECT_EQ(spread(lost, wide, {0.4, 0}, {}), Vector2d(0.4, 0));
}

TEST(Spread, GivesWayToMoreImportantTasks) {
  const std::vector<Vector2d> others{{0, 1}};
  const Vector2d place = spread(standing(0, 0), wide, {0, 0.5}, others);
  EXPECT_NEAR(place.x(), 0.0, 1e-12);
  EXPECT_NEAR(place.y(), 0.0, 1e-12);
}

TEST(Spread, MovesNoTargetFartherThanItMay) {
  SpreadSettings little = wide;
  little.moved_at_most = 0.3;
  EXPECT_NEAR((spread(with_ball(standing(0, 0), {1, 0}), little, {0.8, 0}, {}) - Vector2d(0.5, 0)).norm(), 0.0, 1e-12);
}

TEST(Spread, StaysInTheFieldAndMovesApart) {
  regista::testkit::Dice dice(9);
  double before = 0.0, after = 0.0;
  for (int round = 0; round < 300; ++round) {
    const Vector2d ball(dice.real(-4.5, 4.5), dice.real(-3, 3));
    const Situation scene = with_ball(standing(0, 0), ball);
    std::vector<Vector2d> targets, placed;
    for (int i = 0; i < 6; ++i) targets.emplace_back(dice.real(-1, 1), dice.real(-1, 1));
    for (const Vector2d& target : targets) {
      const Vector2d place = spread(scene, wide, target, placed);
      EXPECT_LE(std::abs(place.x()), 4.5);
      EXPECT_LE(std::abs(place.y()), 3.0);
      EXPECT_LE((place - target).norm(), wide.moved_at_most + 1e-9);
      placed.push_back(place);
    }
    const auto least = [](const std::vector<Vector2d>& places) {
      double out = 1e9;
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) out = std::min(out, (places[i] - places[j]).norm());
      }
      return out;
    };
    before += least(targets);
    after += least(placed);
  }
  EXPECT_GT(after, 2.0 * before);
}

}  // namespace
