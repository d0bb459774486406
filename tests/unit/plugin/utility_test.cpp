// SPDX-License-Identifier: MIT
#include "plugin/utility.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class UtilityTest : public PuppetTest {
 protected:
  // What ends a call in which the plugin writes `given` to row 2, column 5.
  std::string run(double given) {
    value = given;
    Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room* to, regista_error*) {
      to->values[2 * to->stride + 5] = value;
      return Puppet::ok;
    };
    return message_of([&] { Utility(Puppet::instance()).score(scene.frame, out.room); });
  }

  static inline double value;
  Scene scene{7};
  Matrix out{5, 7, 3.0};
};

TEST_F(UtilityTest, ClearsFirstAndLeavesTheRestOfEachRowAlone) {
  EXPECT_EQ(run(0.5), "");
  for (std::uint32_t i = 0; i < 5; ++i) {
    for (std::uint32_t j = 0; j < 7; ++j) EXPECT_EQ(out(i, j), i == 2 && j == 5 ? 0.5 : 0.0);
    for (std::uint32_t j = 7; j < out.raw.stride; ++j) EXPECT_EQ(out(i, j), Matrix::spare);
  }
}

TEST_F(UtilityTest, RefusesWhatIsNoUtility) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(run(std::numeric_limits<double>::quiet_NaN()), Puppet::failure("score: row 2, column 5 is nan"));
  EXPECT_EQ(run(infinity), Puppet::failure("score: row 2, column 5 is inf"));
  EXPECT_EQ(run(-infinity), Puppet::failure("score: row 2, column 5 is -inf"));
  EXPECT_EQ(run(-0.25), Puppet::failure("score: row 2, column 5 is -0.25; utilities are at least 0"));
  EXPECT_EQ(run(-0.0), "");
  EXPECT_EQ(run(1e12), "");
  EXPECT_EQ(run(1e300), Puppet::failure("score: row 2, column 5 is 1e+300; utilities are at most 1e12"));
}

TEST_F(UtilityTest, IsNotAskedWhenThereIsNothingToScore) {
  Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room*, regista_error*) -> std::int32_t {
    ADD_FAILURE();
    return REGISTA_OK;
  };
  Utility utility(Puppet::instance());
  Matrix no_tasks(5, 0), no_robots(0, 7);
  utility.score(scene.frame, no_tasks.room);
  utility.score(scene.frame, no_robots.room);
}

TEST_F(UtilityTest, ReportsSharedObjectsByTheirFile) {
  const auto run_file = [&](const std::string& name) {
    Utility utility(instance_of(open(name)));
    return message_of([&] { utility.score(scene.frame, out.room); });
  };
  EXPECT_EQ(run_file("returns_nan"), failure("returns_nan", "score: row 2, column 5 is nan"));
  EXPECT_EQ(run_file("throws"), failure("throws", "score: fell in score"));
  EXPECT_EQ(run_file("crosses_the_boundary"),
            failure("crosses_the_boundary", "score: let an exception cross the plugin's boundary: no idea"));
}

}  // namespace
}  // namespace regista::plugin::test
