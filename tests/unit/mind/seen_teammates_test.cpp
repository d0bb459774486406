// SPDX-License-Identifier: MIT
// Who is it that the eyes see, and how much better is the place known then.
#include "mind/world/fusion.hpp"

#include <gtest/gtest.h>

#include <random>

namespace regista::mind {
namespace {

regista_robot robot(int number, double x, double y, double deviation) {
  regista_robot out{};
  out.number = number;
  out.flags = REGISTA_ROBOT_ACTIVE | REGISTA_ROBOT_KNOWN;
  out.pose[0] = x;
  out.pose[1] = y;
  out.covariance[0] = out.covariance[2] = deviation * deviation;
  return out;
}

regista_track seen(double x, double y, double deviation, double weight = 0.9) {
  regista_track out{};
  out.x = x;
  out.y = y;
  out.covariance[0] = out.covariance[2] = deviation * deviation;
  out.weight = weight;
  return out;
}

std::vector<int> numbers(const std::vector<regista_track>& tracks, const std::vector<regista_robot>& robots, int own) {
  std::vector<SeenTeammate> pairs;
  match_teammates(tracks, robots, own, pairs);
  std::vector<int> out(tracks.size(), 0);
  for (const SeenTeammate& each : pairs) out[static_cast<std::size_t>(each.track - tracks.data())] = each.number;
  return out;
}

TEST(SeenTeammates, TheNearestByTheirUncertainty) {
  // The second robot is farther away, but may have walked so far since its packet.
  const std::vector robots{robot(1, 0, 0, 0.05), robot(2, 3, 0, 0.8), robot(3, -3, 0, 0.3)};
  EXPECT_EQ(numbers({seen(1.4, 0, 0.1)}, robots, 3), (std::vector{2}));
}

TEST(SeenTeammates, EachOnceAndNeverOneself) {
  const std::vector robots{robot(1, 0, 0, 0.5), robot(2, 1.5, 0, 0.1), robot(3, 3, 0, 0.5)};
  EXPECT_EQ(numbers({seen(0.1, 0, 0.1), seen(3.1, 0, 0.1), seen(1.5, 0, 0.1)}, robots, 2), (std::vector{1, 3, 0}));
  EXPECT_EQ(numbers({seen(0.1, 0, 0.1), seen(0.2, 0, 0.1)}, robots, 2), (std::vector{1, 0}));
}

TEST(SeenTeammates, WhoFitsTwoIsNobody) {
  const std::vector robots{robot(1, 0, 0, 0.5), robot(2, 1, 0, 0.5)};
  EXPECT_EQ(numbers({seen(0.5, 0, 0.1)}, robots, 3), (std::vector{0}));
}

TEST(SeenTeammates, NotWhomTheCameraSawLongAgo) {
  const std::vector robots{robot(1, 0, 0, 0.3)};
  std::vector tracks{seen(0.1, 0, 0.1)};
  tracks[0].age = 4.9;
  EXPECT_EQ(numbers(tracks, robots, 2), (std::vector{1}));
  tracks[0].age = 5.1;
  EXPECT_EQ(numbers(tracks, robots, 2), (std::vector{0}));
}

TEST(SeenTeammates, NotWhoIsUnlikelyOrOutOfPlayOrFarAway) {
  std::vector robots{robot(1, 0, 0, 0.3)};
  EXPECT_EQ(numbers({seen(0.1, 0, 0.1, 0.4)}, robots, 2), (std::vector{0}));
  EXPECT_EQ(numbers({seen(2.0, 0, 0.1)}, robots, 2), (std::vector{0}));
  robots[0].flags = REGISTA_ROBOT_KNOWN;
  EXPECT_EQ(numbers({seen(0.1, 0, 0.1)}, robots, 2), (std::vector{0}));
}

// Of two independent Gaussian guesses the sharpened place has the least variance, and knows which.
TEST(SeenTeammates, SharpenedPlaceIsTrueToItsCovariance) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  const int runs = 20000;
  double squared = 0.0, promised = 0.0;
  for (int i = 0; i < runs; ++i) {
    regista_robot told = robot(1, 0.6 * normal(engine), 0.6 * normal(engine), 0.6);
    sharpen(told, seen(0.3 * normal(engine), 0.3 * normal(engine), 0.3));
    squared += (told.pose[0] * told.pose[0] + told.pose[1] * told.pose[1]) / runs;
    promised = told.covariance[0] + told.covariance[2];
  }
  EXPECT_NEAR(promised, 2.0 / (1.0 / 0.36 + 1.0 / 0.09), 1e-12);
  EXPECT_NEAR(squared / promised, 1.0, 0.03);
}

}  // namespace
}  // namespace regista::mind
