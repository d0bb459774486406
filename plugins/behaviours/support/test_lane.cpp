// SPDX-License-Identifier: MIT
// Lanes for a pass, against walkers that go step by step, and offers worked out by hand.
#include <gtest/gtest.h>

#include <vector>

#include <regista/testkit/dice.hpp>

#include "../lane.hpp"
#include "../test_situations.hpp"

namespace {

using namespace behaviours;

constexpr LaneSettings settings{.leaves = 1.0};

// A pass along the x axis with 1.2 m/s. An opponent stands still for 0.8 s, in which the ball rolls 0.96 m, and then
// walks 0.25 m/s.
TEST(Lane, RoomIsWhatTheNearestOpponentLeaves) {
  const Situation scene = with_ball(standing(0, 0), {0, 0});
  const auto room = [&](const Vector2d& opponent, double weight = 1.0) {
    const std::vector<Blocker> opponents{{opponent, weight}};
    return room_of_lane(scene, settings, opponents, {3, 0});
  };
  EXPECT_EQ(room_of_lane(scene, settings, {}, {3, 0}), 0.4) << "as much as counts";
  EXPECT_NEAR(room({0.5, 0.3}), 0.3 - 0.2, 1e-12) << "too early for a step";
  EXPECT_NEAR(room({2.0, 0.5}), 0.5 - 0.2 - 0.25 * (2.0 / 1.2 - 0.8), 1e-12);
  EXPECT_NEAR(room({1.0, 0.0}), -0.2 - 0.25 * (1.0 / 1.2 - 0.8), 1e-12) << "in the way";
  EXPECT_EQ(room({-1.0, 0.1}), 0.4) << "behind the ball";
  EXPECT_NEAR(room({0.5, 0.0}, 0.7), -0.2 + 0.3, 1e-12) << "perhaps it is not there";
}

// Truth: the ball in steps of 5 ms, and an opponent that walks straight to the point of its way that is nearest.
TEST(Lane, AnOpponentThatWalksStepByStepStopsThePassWithoutRoom) {
  regista::testkit::Dice dice(11);
  int stopped = 0, passed = 0;
  for (int round = 0; round < 300; ++round) {
    const Vector2d place(dice.real(1, 4), dice.real(-2, 2));
    const Vector2d opponent(dice.real(-1, 4), dice.real(-2, 2));
    const std::vector<Blocker> opponents{{opponent, 1.0}};
    const double room = room_of_lane(with_ball(standing(0, 0), {0, 0}), settings, opponents, place);
    if (std::abs(room) < 0.03) continue;  // too close to call
    const Vector2d nearest = nearest_on_segment({0, 0}, place, opponent);
    bool touched = false;
    for (double time = 0.0; 1.2 * time < place.norm(); time += 0.005) {
      const Vector2d ball = place.normalized() * (1.2 * time);
      const double walked = std::min((nearest - opponent).norm(), 0.25 * std::max(0.0, time - 0.8));
      const Vector2d walker = walked > 0.0 ? Vector2d(opponent + (nearest - opponent).normalized() * walked) : opponent;
      touched = touched || (ball - walker).norm() < 0.2;
    }
    EXPECT_EQ(touched, room < 0.0) << "round " << round;
    ++(touched ? stopped : passed);
  }
  EXPECT_GT(stopped, 20);
  EXPECT_GT(passed, 20);
}

struct LaneTest : testing::Test {
  Lane lane;
  Situation scene = with_ball(standing(0, 0), {0, 0});
  std::vector<Blocker> opponents{{{1.0, 0.0}, 1.0}};
  Vector2d offer(const Vector2d& place, const SpreadSettings& spread = {}, std::span<const Vector2d> others = {}) {
    return lane.offer(scene, settings, spread, opponents, others, place);
  }
};

TEST_F(LaneTest, LeavesTheCoverOfAnOpponent) {
  const Vector2d place = offer({2, 0});
  EXPECT_GT(room_of_lane(scene, settings, opponents, place), room_of_lane(scene, settings, opponents, {2, 0}));
  EXPECT_LE((place - Vector2d(2, 0)).norm(), 1.0 + 1e-9);
  opponents.clear();
  lane.forget();
  EXPECT_EQ(offer({2, 0}), Vector2d(2, 0)) << "nobody is in the way";
}

TEST_F(LaneTest, KeepsToItsOfferWhereAnotherIsAsGood) {
  const Vector2d first = offer({2, 0});
  opponents[0].position.y() += first.y() > 0.0 ? 0.02 : -0.02;  // a little in favour of the other side
  EXPECT_EQ(offer({2, 0}), first);
  lane.forget();
  EXPECT_LT(offer({2, 0}).y() * first.y(), 0.0);
}

TEST_F(LaneTest, OffersNoneWhereThereIsNoPassToGet) {
  EXPECT_EQ(offer({0.9, 0}), Vector2d(0.9, 0)) << "too near";
  EXPECT_EQ(offer({5.1, 0}), Vector2d(5.1, 0)) << "beyond a kick's reach";
  opponents[0].position = {-0.5, 0};
  EXPECT_EQ(offer({-1.2, 0}), Vector2d(-1.2, 0)) << "behind the ball";
  opponents[0].position = {1, 0};
  Situation theirs = in_set_play(scene, SetPlay::kick_in, false), lost = scene;
  lost.ball_trusted = false;
  for (const Situation& each : {theirs, lost}) {
    EXPECT_EQ(lane.offer(each, settings, {}, opponents, {}, {2, 0}), Vector2d(2, 0));
  }
  EXPECT_EQ(lane.offer(scene, {}, {}, opponents, {}, {2, 0}), Vector2d(2, 0)) << "it is not asked to";
}

TEST_F(LaneTest, KeepsApartAndInTheField) {
  regista::testkit::Dice dice(4);
  int moved = 0;
  const SpreadSettings spread{.clear_of_ball = 1.2, .apart = 1.0};
  for (int round = 0; round < 1000; ++round) {
    scene.ball = {dice.real(-4.5, 4.5), dice.real(-3, 3)};
    opponents.assign(3, {});
    for (Blocker& each : opponents) each = {{dice.real(-4, 4), dice.real(-3, 3)}, 1.0};
    const std::vector<Vector2d> others{{dice.real(-4, 4), dice.real(-3, 3)}};
    const Vector2d place(dice.real(-4.5, 4.5), dice.real(-3, 3));
    const Vector2d there = offer(place, spread, others);
    if (there == place) continue;
    ++moved;
    EXPECT_GE((there - others[0]).norm(), std::min(1.0, (place - others[0]).norm()));
    EXPECT_GE((there - scene.ball).norm(), 1.2);
    EXPECT_LE(std::abs(there.x()), 4.5);
    EXPECT_LE(std::abs(there.y()), 3.0);
  }
  EXPECT_GT(moved, 30);
}

}  // namespace
