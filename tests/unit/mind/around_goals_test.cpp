// SPDX-License-Identifier: MIT
// Robots that follow around_goals() from anywhere to anywhere never cross a post or a net.
#include <gtest/gtest.h>

#include <cmath>

#include "mind/body/walking.hpp"

namespace regista::mind {
namespace {

const config::FieldSize field;
constexpr double radius = 0.15;
const double line = field.length / 2.0, post = (field.goal_width + field.post_diameter) / 2.0;

// The disc at `p` touches the side or the back of a goal, or a post.
bool touches_goal(const Vector2d& p) {
  const double depth = std::abs(p.x()) - line, aside = std::abs(std::abs(p.y()) - post);
  if (depth < -radius || depth > field.goal_depth + radius) return false;
  const bool at_side = aside < radius && depth > 0.0;
  const bool at_back = std::abs(p.y()) < post && std::abs(depth - field.goal_depth) < radius;
  const bool at_post = std::hypot(depth, aside) < radius + field.post_diameter / 2.0;
  return at_side || at_back || at_post;
}

TEST(AroundGoals, NoWayLeadsThroughTheSideOfAGoal) {
  int ways = 0;
  for (double x : {-4.95, -4.75, -4.5, -4.2, -3.0, 0.0, 4.6}) {
    for (double y : {-2.0, -1.2, -0.5, 0.0, 0.5, 1.3}) {
      for (double to_x : {-4.9, -4.65, -4.5, -4.1, 0.0, 4.65}) {
        for (double to_y : {-1.5, -1.13, -0.7, -0.3, 0.4, 1.2}) {
          Vector2d at(x, y);
          if (touches_goal(at) || (std::abs(to_x) <= line && touches_goal({to_x, to_y}))) continue;
          ++ways;
          const Vector2d to(to_x, to_y);
          Vector2d next = at;
          for (int i = 0; i < 4000; ++i) {
            next = around_goals(field, radius, at, to);
            const Vector2d step = next - at;
            if (step.norm() < 0.01) break;
            at += std::min(0.01, step.norm()) * step.normalized();
            ASSERT_FALSE(touches_goal(at))
                << x << ' ' << y << " to " << to_x << ' ' << to_y << " at " << at.transpose();
          }
          EXPECT_LT((next - at).norm(), 0.02)
              << x << ' ' << y << " to " << to_x << ' ' << to_y << " ends at " << at.transpose();
          const bool at_side = std::abs(to_x) > line && (std::abs(std::abs(to_y) - post) < 0.4 || std::abs(to_x) > 4.7);
          if (!at_side) {
            EXPECT_LT((at - to).norm(), 0.03) << to.transpose();
          }
        }
      }
    }
  }
  EXPECT_GT(ways, 1000);
}

TEST(AroundGoals, ElsewhereTheWayIsStraight) {
  EXPECT_EQ(around_goals(field, radius, {-4.0, 2.0}, {3.0, -1.0}), Vector2d(3.0, -1.0));
  EXPECT_EQ(around_goals(field, radius, {-4.0, 0.0}, {-4.4, 0.3}), Vector2d(-4.4, 0.3));
}

}  // namespace
}  // namespace regista::mind
