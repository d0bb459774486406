// SPDX-License-Identifier: MIT
#include "study/prediction/evaluation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>

namespace regista::study {
namespace {

// 70 samples a second for three seconds.
std::vector<Sample> ball(const std::function<Eigen::Vector2d(double)>& place) {
  std::vector<Sample> out;
  for (int i = 0; i < 210; ++i) {
    const double t = i / 70.0;
    const Eigen::Vector2d at = place(t);
    out.push_back({t, ball_object, at.x(), at.y()});
  }
  return out;
}

// The touched samples, as times; the first and the last have too few neighbours to tell.
std::vector<double> touched(const std::vector<Sample>& samples) {
  const std::vector<bool> free = untouched(samples, 0.1);
  std::vector<double> out;
  for (std::size_t i = 2; i + 2 < samples.size(); ++i) {
    if (!free[i]) out.push_back(samples[i].time);
  }
  return out;
}

TEST(Touches, RollingAndSlidingAreNone) {
  EXPECT_TRUE(touched(ball([](double) { return Eigen::Vector2d(1.0, 2.0); })).empty()) << "at rest";
  EXPECT_TRUE(touched(ball([](double t) { return Eigen::Vector2d(2.0 * t - 0.15 * t * t, 0.0); })).empty())
      << "rolling";
  EXPECT_TRUE(touched(ball([](double t) {
                return Eigen::Vector2d(0.0, t < 1.5 ? 5.0 * t - 1.5 * t * t : 4.125 + 0.5 * (t - 1.5));
              })).empty())
      << "sliding, then rolling with what is left";
}

TEST(Touches, AKickATurnAndACatchAreFoundWhereTheyHappen) {
  const auto near = [](const std::vector<double>& times) {
    return !times.empty() && std::ranges::all_of(times, [](double t) { return std::abs(t - 1.5) < 0.1; });
  };
  EXPECT_TRUE(near(touched(ball([](double t) { return Eigen::Vector2d(t < 1.5 ? 0.0 : 3.0 * (t - 1.5), 0.0); }))));
  EXPECT_TRUE(near(touched(
      ball([](double t) { return Eigen::Vector2d(t < 1.5 ? 2.0 * t : 3.0, t < 1.5 ? 0.0 : 2.0 * (t - 1.5)); }))));
  EXPECT_TRUE(near(touched(ball([](double t) { return Eigen::Vector2d(2.0 * std::min(t, 1.5), 0.0); }))));
}

TEST(Touches, AGapTellsNothing) {
  std::vector<Sample> samples = ball([](double t) { return Eigen::Vector2d(t, 0.0); });
  std::erase_if(samples, [](const Sample& each) { return each.time > 1.0 && each.time < 1.4; });
  const std::vector<double> times = touched(samples);
  EXPECT_FALSE(times.empty());
  for (const double t : times) EXPECT_TRUE(t > 0.9 && t < 1.5) << t;
}

}  // namespace
}  // namespace regista::study
