// SPDX-License-Identifier: MIT
#include "config/team_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "small_page.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

// A team that plays a list of these roles in two contexts.
std::string page(const std::string& roles) {
  return small_page("{name: late, priority: 1, plugin: c}, {name: early, plugin: c}", roles);
}

std::vector<std::string> warned(const std::vector<int>& robots, int size) {
  const Node document = parse_text(page(roles_for(robots)), "t.yaml");
  std::vector<std::string> out;
  for (const Warning& each : warnings(read_document<Team>(document), of_size(size), document)) {
    if (each.message.ends_with(" will stand")) out.push_back(to_string(each));
  }
  return out;
}

// Those of a team of two that plays these roles.
std::vector<std::string> missing(const std::string& roles) {
  const Node document = parse_text(page(roles), "t.yaml");
  std::vector<std::string> out;
  for (const Warning& each : warnings(read_document<Team>(document), of_size(2), document))
    out.push_back(to_string(each));
  return out;
}

TEST(TeamWarnings, WhatNobodyDoesIsSaid) {
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
  EXPECT_EQ(missing(list("first, behaviour: press, target: {at: centre}", "second, target: {at: centre}")),
            std::vector<std::string>{})
      << "what a behaviour of another author does is not known";
}

TEST(TeamWarnings, AListThatNoContextPlays) {
  EXPECT_EQ(missing("    - {name: goalkeeper, target: {at: own_goal}}\n    - {name: striker, target: {at: ball}}\n"
                    "  spare: [{name: only, target: {at: [99, 0]}}]\n"),
            std::vector<std::string>{"t.yaml:10:3: warning: roles.spare: no context plays this list: add use: {roles: "
                                     "spare} to one"});
}

TEST(TeamWarnings, AContextBelowOneThatAlwaysHolds) {
  const auto warned_of = [](const std::string& contexts) {
    const Node document =
        parse_text(small_page(contexts,
                              "    - {name: goalkeeper, target: {at: own_goal}}\n    - {name: striker, target: "
                              "{at: ball}}\n"),
                   "t.yaml");
    std::vector<std::string> out;
    for (const Warning& each : warnings(read_document<Team>(document), of_size(2), document))
      out.push_back(to_string(each));
    return out;
  };
  EXPECT_EQ(warned_of("{name: late, priority: 1, plugin: c}, {name: rest, plugin: always}"),
            std::vector<std::string>{});
  EXPECT_EQ(
      warned_of("{name: late, plugin: c}, {name: rest, priority: 1, plugin: always}"),
      std::vector<std::string>{"t.yaml:3:12: warning: contexts.late: never in force, for rest (t.yaml:3:37), which "
                               "comes first, always holds"});
  // Another shared object may call anything so. Any file will do.
  EXPECT_EQ(
      warned_of(fmt::format("{{name: late, plugin: c}}, {{name: rest, priority: 1, plugin: always, file: \"{}\"}}",
                            (project / "README.md").string())),
      std::vector<std::string>{});
}

// What is said of a list of a goalkeeper, a striker and this role. The field is 9 m by 6 m with 0.7 m about it.
std::vector<std::string> of_third(const std::string& role) {
  return missing(
      "    - {name: goalkeeper, robot: 1, target: {at: own_goal}}\n    - {name: striker, target: {at: ball}}\n    - {" +
      role + "}\n");
}

TEST(TeamWarnings, TwoRolesForOneRobot) {
  EXPECT_EQ(of_third("name: libero, robot: 1, target: {at: centre}"),
            std::vector<std::string>{"t.yaml:10:29: warning: roles.usual: goalkeeper and libero are both for robot 1, "
                                     "which takes one role at a time"});
  EXPECT_EQ(of_third("name: libero, robot: 2, target: {at: centre}"), std::vector<std::string>{});
}

TEST(TeamWarnings, ASecondRobotThatTheTeamLacks) {
  EXPECT_EQ(of_third("name: libero, robot: [2, 12], target: {at: centre}"),
            std::vector<std::string>{"t.yaml:10:29: warning: roles.usual.libero: is also for robot 12, a team has 2 "
                                     "robots by the rules spl2023"});
  EXPECT_EQ(of_third("name: libero, robot: [2, 1], target: {at: centre}"), std::vector<std::string>{});
}

TEST(TeamWarnings, TargetsOffTheField) {
  const auto off = [](int column, const char* key, const char* what) {
    return std::vector<std::string>{
        fmt::format("t.yaml:10:{}: warning: roles.usual.r.target.{}: {} off the field, which with its border reaches "
                    "from -5.2 to 5.2 m in x and from -3.7 to 3.7 m in y",
                    column, key, what)};
  };
  EXPECT_EQ(of_third("name: r, target: {at: [-42, 0]}"), off(30, "at", "[-42, 0] is"));
  EXPECT_EQ(of_third("name: r, target: {at: [5, 0], shift: [1, 0]}"), off(30, "at", "[6, 0] is"));
  EXPECT_EQ(of_third("name: r, target: {at: ball, lateral: 30}"), off(45, "lateral", "30 is"));
  EXPECT_EQ(of_third("name: r, target: {at: ball, lateral: -30}"), off(45, "lateral", "-30 is"));
  EXPECT_EQ(of_third("name: r, target: {at: ball, within: [6, 7, 0, 1]}"),
            off(44, "within", "all of the rectangle is"));
  EXPECT_EQ(of_third("name: r, target: {at: centre, without_ball: [0, 4]}"), off(52, "without_ball", "[0, 4] is"));
  // On the border, or brought back, or wherever the ball is.
  for (const char* const target :
       {"{at: [5.2, 3.7]}", "{at: [-42, 0], within: [-4, 4, -3, 3]}", "{at: [6, 0], shift: [-1, 0]}",
        "{at: ball, shift: [90, 0]}", "{on_line: [ball, [-42, 0]], from_goal: 38}"}) {
    EXPECT_EQ(of_third(fmt::format("name: r, target: {}", target)), std::vector<std::string>{}) << target;
  }
}

TEST(TeamWarnings, TargetsOfContextsOffTheField) {
  for (const auto& [written, column] :
       {std::pair{"targets: {striker: {at: [0, 9]}}", 81}, std::pair{"targets.striker: {at: [0, 9]}", 79},
        std::pair{"targets.striker.at: [0, 9]", 77}}) {
    const Node document = parse_text(
        small_page(
            fmt::format("{{name: corner, priority: 1, plugin: c, use: {{{}}}}}, {{name: p, plugin: always}}", written),
            "    - {name: goalkeeper, target: {at: own_goal}}\n    - {name: striker, target: {at: ball}}\n"),
        "t.yaml");
    const std::vector<Warning> found = warnings(read_document<Team>(document), of_size(2), document);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(
        to_string(found[0]),
        fmt::format("t.yaml:3:{}: warning: contexts.corner.use.targets.striker.at: [0, 9] is off the field, which "
                    "with its border reaches from -5.2 to 5.2 m in x and from -3.7 to 3.7 m in y",
                    column));
  }
}

TEST(TeamWarnings, WhoStandsIsSaid) {
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
TEST(TeamWarnings, IsRightForEveryListOfThreeRoles) {
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

TEST(TeamWarnings, ShippedTeamsPlayWithEveryRobotOfSeven) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(project / "configs/teams")) {
    if (!entry.is_regular_file()) continue;
    const Node document = load(entry.path());
    const Team team = read_document<Team>(document);
    EXPECT_TRUE(warnings(team, Rules{}, document).empty()) << entry.path();
  }
}

TEST(TeamWarnings, MoreGroupsThanRobots) {
  const auto list = [](int second, int third) {
    return fmt::format(
        "    - {{name: goalkeeper, group: 0, target: {{at: own_goal}}}}\n"
        "    - {{name: striker, group: {}, target: {{at: ball}}}}\n"
        "    - {{name: libero, group: {}, target: {{at: centre}}}}\n",
        second, third);
  };
  EXPECT_EQ(missing(list(1, 1)), std::vector<std::string>{});
  EXPECT_EQ(missing(list(1, -1)), std::vector<std::string>{});
  EXPECT_EQ(
      missing(list(4, 9)),
      std::vector<std::string>{"t.yaml:10:29: warning: roles.usual.libero: group 9 makes 3 groups for 2 robots: some "
                               "group always goes without"});
}

}  // namespace
}  // namespace regista::config
