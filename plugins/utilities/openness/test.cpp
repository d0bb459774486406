// SPDX-License-Identifier: MIT
// Distances by hand, lines against points sampled along them, and what must not change a score.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using openness::Point;
using openness::Settings;

constexpr Point goal{4.5, 0.0};
constexpr Settings target_only{1.0, 0.0, 0.0, 1.5, 0.75}, pass_only{0.0, 1.0, 0.0, 1.5, 0.75},
    shot_only{0.0, 0.0, 1.0, 1.5, 0.75};

double one(const Point& target, const std::vector<Point>& opponents, const std::optional<Point>& ball,
           const Settings& settings) {
  double out = -1.0;
  openness::score({{&target.x, 1}, {&target.y, 1}}, {opponents, opponents, ball, goal}, settings, {&out, 1});
  return out;
}

TEST(Openness, ClosedForms) {
  EXPECT_DOUBLE_EQ(one({0, 0}, {{0.6, 0.8}, {2, 2}}, Point{0, 0}, target_only), 1.0 / 1.5);
  EXPECT_DOUBLE_EQ(one({0, 0}, {{0, 0}}, Point{0, 0}, target_only), 0.0);
  EXPECT_DOUBLE_EQ(one({0, 0}, {{1.5, 0}}, Point{0, 0}, target_only), 1.0);
  EXPECT_DOUBLE_EQ(one({2, 0}, {{1, 0.3}}, Point{0, 0}, pass_only), 0.4);            // beside the line
  EXPECT_DOUBLE_EQ(one({2, 0}, {{2.3, 0.4}}, Point{0, 0}, pass_only), 0.5 / 0.75);   // beyond its end
  EXPECT_DOUBLE_EQ(one({2, 0}, {{-0.3, 0.4}}, Point{0, 0}, pass_only), 0.5 / 0.75);  // behind its beginning
  EXPECT_DOUBLE_EQ(one({2, 0}, {{1, 0}}, Point{0, 0}, pass_only), 0.0);
  EXPECT_DOUBLE_EQ(one({0, 0}, {{3, -0.3}}, Point{0, 0}, shot_only), 0.4);
  EXPECT_DOUBLE_EQ(one({0, 0}, {{-1, 0}}, Point{0, 0}, shot_only), 1.0);
  // All three: 1 m from the target, 0.3 m from the pass, far from the shot.
  const Settings settings{1.0, 0.5, 0.5, 1.5, 0.75};
  const double nearest = std::hypot(1.0, 0.3) / 1.5;
  EXPECT_DOUBLE_EQ(one({2, 0}, {{1, 0.3}}, Point{0, 0}, settings), 0.5 * nearest + 0.25 * 0.4 + 0.25);
}

TEST(Openness, WhatIsNotThereDoesNotMatter) {
  EXPECT_EQ(one({1, 1}, {}, Point{0, 0}, {}), 1.0);
  EXPECT_EQ(one({1, 1}, {}, std::nullopt, {}), 1.0);
  EXPECT_EQ(one({1, 1}, {{1, 1}}, Point{0, 0}, {0.0, 0.0, 0.0, 1.5, 0.75}), 1.0);
  EXPECT_EQ(one({1, 1}, {{1, 1}}, std::nullopt, pass_only), 1.0);
  // Without a ball the other shares fill the whole.
  EXPECT_DOUBLE_EQ(one({0, 0}, {{-0.75, 0}}, std::nullopt, {1.0, 1.0, 0.0, 1.5, 0.75}), 0.5);
}

TEST(Openness, ATargetAtTheBallOrInTheGoalIsALineOfNoLength) {
  EXPECT_DOUBLE_EQ(one({1, 1}, {{1.3, 1.4}}, Point{1, 1}, pass_only), 0.5 / 0.75);
  EXPECT_DOUBLE_EQ(one(goal, {{4.2, 0.4}}, Point{1, 1}, shot_only), 0.5 / 0.75);
}

// Against the nearest of 2001 points along each line; mirrored in y to the last bit; an opponent more never helps.
TEST(Openness, AgainstSampledLines) {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0);
  for (int round = 0; round < 300; ++round) {
    const Point target{x(random), y(random)}, ball{x(random), y(random)};
    std::vector<Point> opponents, mirror;
    for (int k = 0; k < 1 + round % 11; ++k) {
      opponents.push_back({x(random), y(random)});
      mirror.push_back({opponents.back().x, -opponents.back().y});
    }
    const auto sampled = [&](const Point& from, const Point& to, double clearance) {
      double least = 1e9;
      for (int step = 0; step <= 2000; ++step) {
        const double s = step / 2000.0, px = from.x + s * (to.x - from.x), py = from.y + s * (to.y - from.y);
        for (const Point& o : opponents) least = std::min(least, std::hypot(o.x - px, o.y - py));
      }
      return std::min(1.0, least / clearance);
    };
    EXPECT_NEAR(one(target, opponents, ball, target_only), sampled(target, target, 1.5), 1e-12);
    EXPECT_NEAR(one(target, opponents, ball, pass_only), sampled(ball, target, 0.75), 5e-3);
    EXPECT_LE(one(target, opponents, ball, pass_only), sampled(ball, target, 0.75) + 1e-12);
    EXPECT_NEAR(one(target, opponents, ball, shot_only), sampled(target, goal, 0.75), 5e-3);
    EXPECT_LE(one(target, opponents, ball, shot_only), sampled(target, goal, 0.75) + 1e-12);
    const double all = one(target, opponents, ball, {});
    EXPECT_EQ(one({target.x, -target.y}, mirror, Point{ball.x, -ball.y}, {}), all) << "not mirrored";
    EXPECT_NEAR(all,
                (one(target, opponents, ball, target_only) + one(target, opponents, ball, pass_only) +
                 0.5 * one(target, opponents, ball, shot_only)) /
                    2.5,
                1e-14);
    opponents.push_back({x(random), y(random)});
    EXPECT_LE(one(target, opponents, ball, {}), all);
  }
}

TEST(Openness, ARowIsItsEntries) {
  std::mt19937 random(16);
  std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
  const std::vector<Point> opponents{{0.5, 0.2}, {-1, 1}, {2, -1}};
  for (const std::size_t columns : {13u, 1u, 2u, 7u, 12u}) {
    std::vector<double> x(columns), y(columns), out(columns, -1.0);
    for (std::size_t j = 0; j < columns; ++j) {
      x[j] = anywhere(random);
      y[j] = anywhere(random);
    }
    openness::score({x, y}, {opponents, opponents, Point{0.1, 0.2}, goal}, {}, out);
    for (std::size_t j = 0; j < columns; ++j) EXPECT_EQ(out[j], one({x[j], y[j]}, opponents, Point{0.1, 0.2}, {}));
  }
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

FrameBuilder frame() {
  return FrameBuilder{}
      .own(2)
      .robot(2)
      .at(0, 0)
      .robot(4)
      .at(-2, 0)
      .robot(5)
      .penalised()
      .ball(0, 0)
      .task("striker")
      .at(0, 0)
      .task("supporter")
      .at(9, 9)
      .after(0, 2);
}

TEST(OpennessPlugin, AColumnHasOneValue) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "openness");
  Instance utility(plugin, EnvironmentBuilder{},
                   Values(plugin).set("target_share", 1).set("pass_share", 0).set("shot_share", 0));
  const Matrix out = utility.score(FrameBuilder(frame()).opponent(0, 1.25).opponent(0, 0).weight(0.3).build());
  ASSERT_EQ(out.rows(), 2u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_DOUBLE_EQ(out(i, 0), 1.25 / 1.5);
    EXPECT_DOUBLE_EQ(out(i, 1), 0.5);
  }
  const Matrix common = utility.score(FrameBuilder(frame())
                                          .knowledge(REGISTA_COMMON)
                                          .opponent(0, 1.25)
                                          .common([](WorldBuilder& world) { world.no_opponents(); })
                                          .build());
  EXPECT_EQ(common(0, 0), 1.0);
}

TEST(OpennessPlugin, TheGoalkeeperDoesNotCloseTheShot) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "openness");
  Instance utility(plugin, EnvironmentBuilder{},
                   Values(plugin).set("target_share", 0).set("pass_share", 0).set("shot_share", 1));
  const auto of = [&](double x, double y) { return utility.score(FrameBuilder(frame()).opponent(x, y).build())(0, 0); };
  EXPECT_EQ(of(4.3, 0.0), 1.0);
  EXPECT_EQ(of(3.91, 0.0), 1.0);  // the goal area is 0.6 m deep
  EXPECT_NEAR(of(3.89, 0.0), 0.0, 1e-15);
}

REGISTA_UTILITY_CONTRACT(REGISTA_PLUGIN_FILE, "openness", {.order_of_opponents_is_irrelevant = true});

}  // namespace
