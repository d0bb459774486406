// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

using testing::Each, testing::IsEmpty;

class UtilityTest : public PuppetTest {
 protected:
  // What ends a call in which the plugin writes `given` to row 2, column 5.
  std::string run(double given) {
    value = given;
    Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room* to, regista_error*) {
      to->values[2 * to->stride + 5] = value;
      return Puppet::ok;
    };
    Utility utility(Puppet::instance());
    return message_of([&] {
      const std::span<const double> answer = utility.score(scene.frame, 5, 7);
      out.assign(answer.begin(), answer.end());
    });
  }

  static inline double value;
  Scene scene{7};
  std::vector<double> out;
};

TEST_F(UtilityTest, IsZeroWhereNothingIsWritten) {
  Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room* to, regista_error*) {
    static int calls = 0;
    if (++calls == 1)
      std::fill_n(to->values, 5 * 7, 3.0);
    else
      to->values[2 * to->stride + 5] = 0.5;
    return Puppet::ok;
  };
  Utility utility(Puppet::instance());
  EXPECT_THAT(utility.score(scene.frame, 5, 7), Each(3.0));
  const std::span<const double> answer = utility.score(scene.frame, 5, 7);
  ASSERT_EQ(answer.size(), 35u);
  for (std::size_t i = 0; i < answer.size(); ++i) EXPECT_EQ(answer[i], i == 2 * 7 + 5 ? 0.5 : 0.0) << i;
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
  EXPECT_THAT(utility.score(scene.frame, 5, 0), IsEmpty());
  EXPECT_THAT(utility.score(scene.frame, 0, 7), IsEmpty());
}

TEST_F(UtilityTest, ReportsSharedObjectsByTheirFile) {
  const auto run_file = [&](const std::string& name) {
    Utility utility(instance_of(open(name)));
    return message_of([&] { utility.score(scene.frame, 5, 7); });
  };
  EXPECT_EQ(run_file("returns_nan"), failure("returns_nan", "score: row 2, column 5 is nan"));
  EXPECT_EQ(run_file("throws"), failure("throws", "score: fell in score"));
  EXPECT_EQ(run_file("crosses_the_boundary"),
            failure("crosses_the_boundary", "score: let an exception cross the plugin's boundary: no idea"));
}

}  // namespace
}  // namespace regista::plugin::test
