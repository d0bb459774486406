// SPDX-License-Identifier: MIT
// The plugin in scenes: distances or utilities, forbidden pairs, robots that hold a role.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;
constexpr double forbidden = -std::numeric_limits<double>::infinity();

const Loaded& scram_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "scram");
  return plugin;
}

// Robots 1 to 3 at x = 0, 1, 2; tasks at x = 1, 2, 3.
FrameBuilder line() {
  FrameBuilder frame;
  frame.own(2).time(100.0).robot(1).at(0, 0).robot(2).at(1, 0).robot(3).at(2, 0);
  frame.task("striker").at(1, 0).priority(0).task("supporter").at(2, 0).priority(1).task("jolly").at(3, 0).priority(2);
  return frame;
}

TEST(ScramPlugin, WalksAreMeasuredFromTheFrameNotTheUtilities) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(assigner.assign(line().build(), Matrix(3, 3)), (Rows{0, 1, 2}));
  Matrix utilities(3, 3);
  utilities(0, 0) = utilities(1, 1) = utilities(2, 2) = forbidden;
  // Two ways are left: walks of 2, 2 and 1, or of 3, 0 and 0.
  EXPECT_EQ(assigner.assign(line().build(), utilities), (Rows{1, 2, 0}));
}

TEST(ScramPlugin, TheOffsetPlaceCounts) {
  SceneData data = line().build().data();
  data.tasks[0].after[0] = 3.0;
  data.tasks[2].after[0] = 1.0;
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(3, 3)), (Rows{2, 1, 0}));
}

TEST(ScramPlugin, UtilitiesInsteadOfDistances) {
  Matrix utilities(2, 2);
  utilities(0, 0) = 9;
  utilities(0, 1) = 5;
  utilities(1, 0) = 6;
  utilities(1, 1) = 0;
  FrameBuilder frame;
  frame.own(2).robot(1).at(0, 0).robot(2).at(1, 0).task("striker").at(0, 0).task("supporter").at(1, 0);
  for (const int criterion : {0, 1}) {
    Values values(scram_plugin());
    values.set("cost", 1.0).set("criterion", static_cast<double>(criterion));
    Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), values);
    EXPECT_EQ(assigner.assign(frame.build(), utilities), (Rows{1, 0})) << criterion;  // nobody below 5
  }
}

TEST(ScramPlugin, TheLeastImportantTaskStaysOpenUnlessItIsRequired) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  SceneData data = line().build().data();
  data.mine.robots[0].flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 3)), (Rows{0, 1}));
  data.tasks[2].flags |= REGISTA_TASK_REQUIRED;
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 3)), (Rows{0, 2}));
}

// --- Incumbents ------------------------------------------------------------------------------------------------

TEST(ScramPlugin, ClaimsDoNotMatterUnlessAskedFor) {
  Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2));
  SceneData data = line().build().data();
  data.mine.robots[0].role = data.tasks[2].id;
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(3, 3)), (Rows{0, 1, 2}));
}

TEST(ScramPlugin, OfTwoClaimsThatOfTheLowerNumberCounts) {
  // Robots 1 and 2 stand 1 m to either side of the task.
  const auto taken_by = [](std::vector<int> claims, double incumbent) {
    FrameBuilder frame;
    frame.own(2).task("striker").at(0, 0);
    for (const int number : {1, 2, 3}) {
      frame.robot(number).at(number == 1 ? -1.0 : 1.0, number == 3 ? 1.0 : 0.0);
      for (const int claims_it : claims) {
        if (claims_it == number) frame.role("striker");
      }
    }
    Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(2), Values(scram_plugin()).set("incumbent", incumbent));
    const Rows rows = assigner.assign(frame.build(), Matrix(3, 1));
    return static_cast<int>(std::find(rows.begin(), rows.end(), 0) - rows.begin()) + 1;
  };
  EXPECT_EQ(taken_by({}, 0.5), 1);
  EXPECT_EQ(taken_by({2}, 0.5), 2);
  EXPECT_EQ(taken_by({2, 3}, 0.5), 2);
  EXPECT_EQ(taken_by({1, 2}, 0.5), 1);
  EXPECT_EQ(taken_by({3}, 0.3), 1);  // it is 0.41 m farther
  EXPECT_EQ(taken_by({3}, 0.5), 3);
}

// What is to be least, of an assignment of all tasks: the lengths with the longest first, or the longest and the sum
// of squares, in which a distance below 0 counts as 0.
std::vector<double> key_of(std::vector<double> lengths, int criterion) {
  std::sort(lengths.rbegin(), lengths.rend());
  if (criterion == 0) return lengths;
  double sum = 0.0;
  for (double& each : lengths) sum += std::pow(std::max(each, 0.0), 2);
  return {std::max(lengths[0], 0.0), sum};
}

TEST(ScramPlugin, IncumbentsAreSoMuchNearerForEveryOrderOfRobots) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0);
  const std::vector<std::string>& roles = usual_roles();
  int changed = 0;
  for (const int criterion : {0, 1}) {
    for (const double incumbent : {0.0, 0.7, 3.0}) {
      const Values values = Values(scram_plugin()).set("criterion", criterion).set("incumbent", incumbent);
      Instance assigner(scram_plugin(), EnvironmentBuilder{}.own(1), values);
      for (int round = 0; round < 400; ++round) {
        const std::size_t n = 1 + random() % 5;
        FrameBuilder frame;
        frame.own(1);
        std::vector<int> claims(n);
        std::vector<double> robot_x, robot_y, task_x, task_y;
        for (std::size_t i = 0; i < n; ++i) {
          claims[i] = static_cast<int>(random() % (n + 1)) - 1;
          robot_x.push_back(x(random)), robot_y.push_back(y(random));
          task_x.push_back(x(random)), task_y.push_back(y(random));
          frame.robot(static_cast<int>(i + 1)).at(robot_x[i], robot_y[i]).role(claims[i]);
        }
        for (std::size_t j = 0; j < n; ++j) frame.task(roles[j]).at(task_x[j], task_y[j]);
        const auto length = [&](std::size_t i, std::size_t j) {
          const auto holder = std::find(claims.begin(), claims.end(), static_cast<int>(j)) - claims.begin();
          return std::hypot(task_x[j] - robot_x[i], task_y[j] - robot_y[i]) -
                 (holder == static_cast<std::ptrdiff_t>(i) ? incumbent : 0.0);
        };
        const auto key = [&](const Rows& columns) {
          std::vector<double> lengths;
          for (std::size_t i = 0; i < n; ++i) lengths.push_back(length(i, static_cast<std::size_t>(columns[i])));
          return key_of(lengths, criterion);
        };
        Rows columns(n);
        std::iota(columns.begin(), columns.end(), 0);
        std::vector<double> best = key(columns);
        while (std::next_permutation(columns.begin(), columns.end())) best = std::min(best, key(columns));
        const Rows got = assigner.assign(frame.build(), Matrix(static_cast<unsigned>(n), static_cast<unsigned>(n)));
        const std::vector<double> reached = key(got);
        for (std::size_t k = 0; k < best.size(); ++k) ASSERT_NEAR(reached[k], best[k], 1e-6) << "round " << round;
        Instance without(scram_plugin(), EnvironmentBuilder{}.own(1), Values(values).set("incumbent", 0.0));
        changed += without.assign(frame.build(), Matrix(static_cast<unsigned>(n), static_cast<unsigned>(n))) != got;
      }
    }
  }
  EXPECT_GT(changed, 200);
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "scram");

}  // namespace
