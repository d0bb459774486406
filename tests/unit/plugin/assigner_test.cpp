// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class AssignerTest : public PuppetTest {
 protected:
  static constexpr std::int32_t none = REGISTA_NO_TASK, unknown = REGISTA_UNKNOWN_TASK;
  // What 5 robots and 7 tasks end in when the plugin writes `given` to its output.
  std::string run(const std::array<std::int32_t, 5>& given) {
    written = given;
    Puppet::assigner.assign = [](void*, const regista_frame*, const regista_matrix*, std::int32_t* to, regista_error*) {
      std::copy(written.begin(), written.end(), to);
      return Puppet::ok;
    };
    return message_of([&] { Assigner(Puppet::instance()).assign(scene.frame, utilities.raw, out); });
  }

  static inline std::array<std::int32_t, 5> written;
  Scene scene{7};
  Matrix utilities{5, 7, 1.0};
  std::array<std::int32_t, 5> out{};
};

TEST_F(AssignerTest, HandsBackWhatThePluginWrote) {
  EXPECT_EQ(run({6, none, 0, unknown, 3}), "");
  EXPECT_EQ(out, (std::array<std::int32_t, 5>{6, none, 0, unknown, 3}));
}

TEST_F(AssignerTest, StartsFromNoTask) {
  out.fill(4);
  Assigner(Puppet::instance()).assign(scene.frame, utilities.raw, out);
  EXPECT_EQ(out, (std::array<std::int32_t, 5>{none, none, none, none, none}));
}

TEST_F(AssignerTest, RefusesATaskGivenTwice) {
  EXPECT_EQ(run({2, 1, 0, 3, 2}), Puppet::failure("assign: column 2 given to rows 0 and 4"));
}

TEST_F(AssignerTest, LetsNegotiatorsGiveATaskTwice) {
  Puppet::assigner.flags = REGISTA_ASSIGNER_NEGOTIATES;
  EXPECT_EQ(run({2, 1, 0, 3, 2}), "");
  EXPECT_TRUE(Assigner(Puppet::instance()).negotiates());
}

TEST_F(AssignerTest, RefusesColumnsThatDoNotExist) {
  EXPECT_EQ(run({0, 9, 1, 2, 3}), Puppet::failure("assign: row 1 got column 9 of 7"));
  EXPECT_EQ(run({0, 7, 1, 2, 3}), Puppet::failure("assign: row 1 got column 7 of 7"));
  EXPECT_EQ(run({0, 1, 2, 3, -3}), Puppet::failure("assign: row 4 got column -3 of 7"));
}

TEST_F(AssignerTest, RefusesForbiddenPairs) {
  utilities(3, 2) = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(run({0, 1, none, 2, 3}), Puppet::failure("assign: row 3 got column 2, which is forbidden to it"));
  EXPECT_EQ(run({0, 1, 2, 3, none}), "");
}

TEST_F(AssignerTest, IsAskedEvenWithoutTasksOrRobots) {
  static int calls;
  calls = 0;
  Puppet::assigner.assign = [](void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error*) {
    ++calls;
    return Puppet::ok;
  };
  Assigner assigner(Puppet::instance());
  Matrix no_tasks(5, 0), no_robots(0, 7);
  assigner.assign(scene.frame, no_tasks.raw, out);
  assigner.assign(scene.frame, no_robots.raw, {});
  EXPECT_EQ(calls, 2);
}

TEST_F(AssignerTest, ReportsSharedObjectsByTheirFile) {
  const auto run_file = [&](const std::string& name) {
    Assigner assigner(instance_of(open(name)));
    return message_of([&] { assigner.assign(scene.frame, utilities.raw, out); });
  };
  EXPECT_EQ(run_file("assigns_twice"), failure("assigns_twice", "assign: column 2 given to rows 0 and 4"));
  EXPECT_EQ(run_file("index_out_of_range"), failure("index_out_of_range", "assign: row 1 got column 9 of 7"));
  EXPECT_EQ(run_file("throws"), failure("throws", "assign: fell in assign"));
}

}  // namespace
}  // namespace regista::plugin::test
