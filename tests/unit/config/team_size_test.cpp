// SPDX-License-Identifier: MIT
#include "config/team_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

// A team that plays a list of these roles, and has another one that no context plays.
std::string page(const std::string& roles) {
  return "team: t\n"
         "predictors: {self: {plugin: p}, ball: {plugin: p}, opponents: {plugin: p}, teammates: {plugin: p}}\n"
         "contexts: [{name: late, priority: 1, plugin: c}, {name: early, plugin: c}]\n"
         "assigner: {plugin: a}\n"
         "sender: {plugin: s}\n"
         "roles:\n"
         "  usual:\n" +
         roles + "  spare: [{name: only, target: {at: ball}}]\n";
}

// For these robots, in this order.
std::string roles(const std::vector<int>& robots) {
  std::string out;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    out += fmt::format("    - {{name: r{}, robot: {}, target: {{at: [0, {}]}}}}\n", i, robots[i], i);
  }
  return out;
}

Rules of_size(int size) {
  Rules rules;
  rules.team_size = size;
  return rules;
}

std::string misplaced(const std::vector<int>& robots, int size) {
  const Node document = parse_text(page(roles(robots)), "t.yaml");
  return error_of([&] { check(read_team(document), of_size(size), document); });
}

std::vector<std::string> warned(const std::vector<int>& robots, int size) {
  const Node document = parse_text(page(roles(robots)), "t.yaml");
  std::vector<std::string> out;
  for (const Warning& each : warnings(read_team(document), of_size(size), document)) {
    if (each.message.ends_with(" will stand")) out.push_back(to_string(each));
  }
  return out;
}

// Those of a team of two that plays these roles.
std::vector<std::string> missing(const std::string& roles) {
  const Node document = parse_text(page(roles), "t.yaml");
  std::vector<std::string> out;
  for (const Warning& each : warnings(read_team(document), of_size(2), document)) out.push_back(to_string(each));
  return out;
}

TEST(TeamBehaviours, WhatNobodyDoesIsSaid) {
  const std::string where = "t.yaml:7:3: warning: roles.usual: in contexts late, early ",
                    ball = "no role plays the ball: one has target {at: ball}, or behaviour: play_ball",
                    goal = "no role keeps the goal: one has the name goalkeeper, or behaviour: keep_goal";
  const auto list = [](const char* first, const char* second) {
    return fmt::format("    - {{name: {}}}\n    - {{name: {}}}\n", first, second);
  };
  EXPECT_EQ(missing(list("goalkeeper, target: {at: own_goal}", "striker, target: {at: ball}")),
            std::vector<std::string>{});
  EXPECT_EQ(missing(list("keeper, behaviour: keep_goal, target: {at: own_goal}",
                         "hunter, behaviour: play_ball, target: {at: ball_rest}")),
            std::vector<std::string>{});
  EXPECT_EQ(missing(list("keeper, target: {at: own_goal}", "hunter, target: {at: ball_rest}")),
            (std::vector<std::string>{where + ball, where + goal}));
  EXPECT_EQ(missing(list("goalkeeper, target: {at: own_goal}", "scout, behaviour: search, target: {at: centre}")),
            std::vector<std::string>{});
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

TEST(TeamSize, WhoStandsIsSaid) {
  EXPECT_EQ(warned({0, 0, 0}, 3), std::vector<std::string>{});
  EXPECT_EQ(warned({0, 0, 0, 0}, 3), std::vector<std::string>{});
  EXPECT_EQ(warned({1, 0, 0}, 5),
            std::vector<std::string>{"t.yaml:7:3: warning: roles.usual: roles for 3 of 5 robots in "
                                     "contexts late, early: 2 robots will stand"});
  EXPECT_EQ(warned({1, 0}, 3), std::vector<std::string>{"t.yaml:7:3: warning: roles.usual: roles for 2 of 3 robots in "
                                                        "contexts late, early: 1 robot will stand"});
  EXPECT_EQ(warned({4, 1}, 5), std::vector<std::string>{"t.yaml:7:3: warning: roles.usual: roles for 2 of 5 robots in "
                                                        "contexts late, early: robots 2, 3 and 5 will stand"});
  EXPECT_EQ(warned({2}, 2), std::vector<std::string>{"t.yaml:7:3: warning: roles.usual: role for 1 of 2 robots in "
                                                     "contexts late, early: robot 1 will stand"});
  // As many roles as robots, but one robot cannot play two.
  EXPECT_EQ(warned({1, 1, 0}, 3), std::vector<std::string>{"t.yaml:7:3: warning: roles.usual: roles for 2 of 3 robots "
                                                           "in contexts late, early: 1 robot will stand"});
}

// What is said of n roles must be what is left when as many robots as possible have taken one: by trying it out.
TEST(TeamSize, IsRightForEveryListOfThreeRoles) {
  constexpr int size = 4;
  for (int code = 0; code < 125; ++code) {
    const std::vector<int> robots{code % 5, code / 5 % 5, code / 25};
    int most = 0;
    for (int taken = 0; taken < 125; ++taken) {  // the robot that takes each role; 0: nobody
      const std::vector<int> by{taken % 5, taken / 5 % 5, taken / 25};
      std::set<int> playing;
      bool allowed = true;
      for (std::size_t i = 0; i < 3; ++i) {
        if (by[i] == 0) continue;
        allowed = allowed && (robots[i] == 0 || robots[i] == by[i]) && playing.insert(by[i]).second;
      }
      if (allowed) most = std::max(most, static_cast<int>(playing.size()));
    }
    const std::vector<std::string> told = warned(robots, size);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NE(told.front().find(fmt::format(" for {} of 4 robots", most)), std::string::npos) << told.front();
  }
}

TEST(TeamSize, ShippedTeamsPlayWithEveryRobotOfSeven) {
  for (const auto& entry : std::filesystem::directory_iterator(project / "configs/teams")) {
    const Node document = load(entry.path());
    const Team team = read_team(document);
    EXPECT_EQ(error_of([&] { check(team, Rules{}, document); }), "");
    EXPECT_TRUE(warnings(team, Rules{}, document).empty()) << entry.path();
  }
}

}  // namespace
}  // namespace regista::config
