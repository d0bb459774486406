// SPDX-License-Identifier: MIT
// Mistakes are planted in sound documents, each in a line of its own. What a reader that stops at the first one says of
// each alone is the truth; the reader that goes on must say exactly that of all together, in the order of the lines.
#include "config/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/team_check.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

// A line and what takes its place.
struct Planted {
  std::string sound, mistaken;
};

std::string with(std::string text, const Planted& planted) {
  const std::size_t at = text.find(planted.sound);
  EXPECT_NE(at, std::string::npos) << planted.sound;
  return at == std::string::npos ? text : text.replace(at, planted.sound.size(), planted.mistaken);
}

void read_any(const Node& document, Mistakes& mistakes) {
  const DocumentKind& kind = kind_of(document);
  kind.with_values(document, mistakes, [](const Map&) {});
  if (kind == DocumentKind::opening) check(read_document<Opening>(document, mistakes), Rules{}, {}, document, mistakes);
  if (kind == DocumentKind::team) check(read_document<Team>(document, mistakes), Rules{}, document, mistakes);
}

std::vector<std::string> all_of(const std::string& text) {
  Mistakes mistakes(Mistakes::After::go_on);
  read_any(parse_text(text, "page.yaml"), mistakes);
  std::vector<std::string> out;
  for (const Error& each : mistakes.in_order("page.yaml")) out.emplace_back(each.what());
  EXPECT_EQ(out.size(), mistakes.total());
  return out;
}

std::string first_of(const std::string& text) {
  return error_of([&] {
    Mistakes first(Mistakes::After::stop);
    read_any(parse_text(text, "page.yaml"), first);
  });
}

void expect_all(const std::string& sound, const std::vector<Planted>& planted) {
  ASSERT_EQ(first_of(sound), "");
  std::string text = sound;
  std::vector<std::string> alone;
  for (const Planted& each : planted) {
    alone.push_back(first_of(with(sound, each)));
    EXPECT_NE(alone.back(), "") << each.mistaken;
    EXPECT_EQ(all_of(with(sound, each)), std::vector{alone.back()}) << "one mistake is one line";
    text = with(text, each);
  }
  EXPECT_EQ(all_of(text), alone);
}

constexpr auto team = R"(team: example
predictors:
  self:      {plugin: odometry}
  ball:      {plugin: kalman_ball, params: {noise: 1}}
  opponents: {plugin: kalman_robots}
  teammates: {plugin: packet}
contexts:
  - {name: search, priority: 2, plugin: ball_lost, use: {roles: searching}}
  - {name: free, priority: 1, plugin: ball_seen, use: {tasks.keep: all}}
  - {name: playing, priority: 0, plugin: always}
tasks:
  hysteresis: 0.3
  offset: {at_most: 0.5}
roles:
  playing:
    - {name: keeper, robot: 1, target: {at: own_goal}}
    - {name: striker, required: true, target: {at: ball}}
    - {name: left, group: 1, target: {at: [1, 2]}}
    - {name: right, target: {on_line: [ball, own_goal], from_goal: 1}}
    - {name: back, target: {at: ball, within: [-4, 0, -2, 2]}}
    - {name: round, target: {on_circle: {from: ball, towards: own_goal, centre: own_goal, radius: [1, 2]}}}
  searching:
    - {name: looker, behaviour: search, target: {at: [0, 0]}}
utility:
  terms:
    near: {plugin: nearness, weight: 1}
    far: {plugin: nearness, weight: 1}
assigner: {plugin: hungarian}
sender: {plugin: event_based}
teammates_forgotten_after: 20
)";

TEST(Mistakes, OfATeamAreAllTold) {
  expect_all(team, {{"team: example", "team: 2nd"},
                    {"self:      {plugin: odometry}", "self:      {plugin: 3}"},
                    {"params: {noise: 1}", "params: 5"},
                    {"opponents: {plugin: kalman_robots}", "oponents: {plugin: kalman_robots}"},
                    {"  teammates: {plugin: packet}", "  teammates: {id: packet, plugin: packet}"},
                    {"use: {roles: searching}", "use: {roles: serching}"},
                    {"use: {tasks.keep: all}", "use: {tasks.keep: al}"},
                    {"priority: 0, plugin: always", "priority: 2, plugin: always"},
                    {"hysteresis: 0.3", "hysteresis: -1"},
                    {"{at_most: 0.5}", "{at_most: half}"},
                    {"keeper, robot: 1", "keeper, robot: 99"},
                    {"required: true", "required: yes"},
                    {"group: 1, target: {at: [1, 2]}", "group: 1, target: {at: [1, two]}"},
                    {"{on_line: [ball, own_goal], from_goal: 1}", "{at: ball, from_goal: 1}"},
                    {"within: [-4, 0, -2, 2]", "within: [4, 0, -2, 2]"},
                    {"radius: [1, 2]", "radius: [3, 2]"},
                    {"behaviour: search", "behaviour: 2nd"},
                    {"near: {plugin: nearness, weight: 1}", "near: {plugin: nearness, weight: heavy}"},
                    {"far: {plugin: nearness, weight: 1}", "far: {weight: 1}"},
                    {"sender: {plugin: event_based}", "sendr: {plugin: event_based}"},
                    {"after: 20", "after: 0"}});
}

TEST(Mistakes, OfRulesAreAllTold) {
  expect_all(content_of(project / "configs/rules/spl2023.yaml"), {{"team_size: 7", "team_size: 23"},
                                                                  {"width: 6.0", "width: sixty"},
                                                                  {"border_strip: 0.7", "boarder_strip: 0.7"},
                                                                  {"goal_area_length: 0.6", "goal_area_length: 5"},
                                                                  {"diameter: 0.10", "diameter: 0x1"},
                                                                  {"halves: 2", "halves: 2.5"},
                                                                  {"budget: 1200", "budget: -1"},
                                                                  {"mercy_difference: 10", "mercy_difference: ten"}});
}

TEST(Mistakes, OfADisturbanceAreAllTold) {
  expect_all(R"(disturbance: much
radio: {loss: 0.1}
incidents:
  - {name: late, kind: radio_delay, at: 5, delay: 1}
  - {name: ghost, kind: ghost_ball, at: [5, 10], x: 1, y: 1}
  - {name: slow, kind: slow_robot, per_hour: 3, speed: 0.5}
  - {name: biased, kind: pose_bias, robots: [1, 2], at: 1, x: 1}
  - {name: gone, kind: crash, at: 3}
)",
             {{"loss: 0.1", "loss: 2"},
              {"at: 5, delay: 1", "at: 5"},
              {"x: 1, y: 1", "x: 1"},
              {"per_hour: 3, speed: 0.5", "per_hour: 3, at: 2, speed: 0.5"},
              {"robots: [1, 2]", "robots: [1, 1]"},
              {"kind: crash, at: 3", "kind: crash, at: 3, x: 1"}});
}

TEST(Mistakes, OfAnOpeningAreAllTold) {
  std::string page = "opening: scene\nlength: 30\nball: {at: [0, 0]}\nhome:\n";
  for (int i = 1; i <= 7; ++i) page += fmt::format("  - {{at: [-{}, {}.5]}}\n", i > 4 ? 4 : i, i > 4 ? i - 5 : 0);
  page += "away:\n";
  for (int i = 1; i <= 7; ++i) page += fmt::format("  - {{at: [{}, {}.75]}}\n", i > 4 ? 4 : i, i > 4 ? i - 5 : 0);
  page.replace(page.find("[-4, 0.5]"), 9, "[-4, -1.5]");
  page.replace(page.find("[4, 0.75]"), 9, "[4, -1.5]");
  expect_all(page, {{"length: 30", "length: 0"},
                    {"[-1, 0.5]", "[-1, 0.5], heading_deg: 400"},
                    {"[-2, 0.5]", "[-2, 50.5]"},
                    {"[-3, 0.5]", "[-20, 0.5]"},
                    {"[1, 0.75]", "[1, x]"},
                    {"[2, 0.75]", "[3.01, 0.75]"},
                    {"[4, 2.75]", "[4, 2.75], number: 7"}});
}

TEST(Mistakes, OfAnExperimentAreAllTold) {
  const std::string file = (project / "configs/teams/paper.yaml").string();
  expect_all(fmt::format(R"(experiment: which
team: {0}
opponent: {0}
matches: 10
arms:
  - {{name: a}}
  - {{name: b}}
sweep:
  path: tasks.hysteresis
  values: [0, 1, 2]
primary:
  measure: goals
  compare: [[a, b]]
confidence: 0.9
)",
                         file),
             {{"opponent: " + file, "opponent: nobody.yaml"},
              {"matches: 10", "matches: 11"},
              {"{name: b}", "{name: a}"},
              {"values: [0, 1, 2]", "values: [0, 1, 0.0]"},
              {"compare: [[a, b]]", "compare: [[a, a]]"},
              {"confidence: 0.9", "confidence: 1.9"}});
}

// What is wrong in one place leaves much without a meaning.
TEST(Mistakes, WhatFollowsFromOneIsNotTold) {
  for (const Planted& each : std::vector<Planted>{
           {"assigner: {plugin: hungarian}", "asigner: {plugin: hungarian}"},  // not missing besides, in each context
           {"roles:\n", "rolls:\n"},                                           // no list of any name
           {"  searching:", "  2nd:"},                                         // none of the name that is used
           {"tasks:\n", "tasks: all\nextra:\n"},
       }) {
    const std::size_t wrong = each.mistaken.find("extra") == std::string::npos ? 1 : 2;
    const std::vector<std::string> told = all_of(with(team, each));
    EXPECT_EQ(told.size(), wrong) << each.mistaken << '\n' << testing::PrintToString(told);
  }
  // The kind of an incident is unknown: so is which values it takes.
  EXPECT_EQ(all_of("disturbance: d\nincidents: [{kind: nap, at: 1, x: 1, delay: 3}]\n").size(), 1u);
  // The length of the field is not known.
  EXPECT_EQ(all_of("rules: r\nfield: {length: long, penalty_area_length: 50, penalty_mark_distance: 9}\n").size(), 1u);
}

TEST(Mistakes, OfOtherFilesComeLast) {
  Mistakes mistakes(Mistakes::After::go_on);
  for (const Location& where :
       std::vector<Location>{{"b", 1, 1}, {"a", 9, 1}, {"own", 7, 2}, {"own", 7, 1}, {"own", 0, 0}}) {
    mistakes.add(Error(where, "wrong"), "");
    mistakes.add(Error(where, "wrong"), "");  // said before
  }
  std::vector<std::string> told;
  for (const Error& each : mistakes.in_order("own")) told.push_back(to_string(each.where()));
  EXPECT_EQ(told, (std::vector<std::string>{"own", "own:7:1", "own:7:2", "a:9:1", "b:1:1"}));
  EXPECT_EQ(mistakes.total(), 5u);
}

TEST(Mistakes, OfALargePageAreCountedButNotAllKept) {
  std::string page = "rules: r\n";
  constexpr std::size_t count = 12'000;
  for (std::size_t i = 0; i < count; ++i) page += fmt::format("key_{}: 1\n", i);
  Mistakes mistakes(Mistakes::After::go_on);
  EXPECT_LT(seconds_of([&] { read_document<Rules>(parse_text(page, "page.yaml"), mistakes); }), 5.0);
  EXPECT_EQ(mistakes.total(), count);
  EXPECT_EQ(mistakes.in_order("page.yaml").size(), 10'000u);
}

TEST(Mistakes, PathsInsideAndAroundAreDoubtful) {
  Mistakes mistakes(Mistakes::After::go_on);
  mistakes.doubt("field.length");
  EXPECT_TRUE(mistakes.doubtful("field.length"));
  EXPECT_TRUE(mistakes.doubtful("field.length.0"));
  EXPECT_TRUE(mistakes.doubtful("field"));
  EXPECT_FALSE(mistakes.mistaken("field"));
  EXPECT_FALSE(mistakes.doubtful("field.length_of_it"));
  EXPECT_FALSE(mistakes.doubtful("fiel"));
}

}  // namespace
}  // namespace regista::config
