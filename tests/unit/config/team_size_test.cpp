// SPDX-License-Identifier: MIT
#include "config/team_check.hpp"

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "small_page.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

std::string misplaced(const std::vector<int>& robots, int size) {
  const Node document = parse_text(small_page("{name: late, plugin: c}", roles_for(robots)), "t.yaml");
  return error_of([&] { check(read_document<Team>(document), of_size(size), document); });
}

TEST(TeamSize, RolesAreForRobotsThatATeamHas) {
  EXPECT_EQ(misplaced({1, 0, 7}, 7), "");
  EXPECT_EQ(misplaced({1, 0, 99}, 7),
            "t.yaml:10:25: roles.usual.2.robot: the role r2 is for robot 99, a team has 7 robots by the rules spl2023");
  EXPECT_EQ(misplaced({1, 0, 7}, 5),
            "t.yaml:10:25: roles.usual.2.robot: the role r2 is for robot 7, a team has 5 robots by the rules spl2023");
  EXPECT_EQ(misplaced({2}, 1),
            "t.yaml:8:25: roles.usual.0.robot: the role r0 is for robot 2, a team has 1 robot by the rules spl2023");
  EXPECT_EQ(misplaced({22}, 22), "");
}

}  // namespace
}  // namespace regista::config
