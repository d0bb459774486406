// SPDX-License-Identifier: MIT
#include "config/team.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

const std::filesystem::path fixture = project / "tests/fixtures/config/team.yaml";

TEST(Team, ReadsEveryKeyOfThePage) {
  const Team team = read_document<Team>(fixture);
  EXPECT_EQ(team.name, "example");
  EXPECT_EQ(team.file, fixture.string());
  EXPECT_EQ(team.ball.plugin, "kalman_ball");
  EXPECT_EQ(team.ball.params["deceleration"].text(), "0.32");
  EXPECT_EQ(to_string(team.ball.where), fixture.string() + ":5:14");
  EXPECT_FALSE(team.self.params);
  EXPECT_EQ(team.forget_teammate_after, 20.0);

  ASSERT_EQ(team.role_lists.size(), 2u);
  const std::vector<Role>& roles = team.role_lists[0].roles;
  ASSERT_EQ(roles.size(), 5u);
  EXPECT_EQ(team.role_lists[0].name, "playing");
  const Role &keeper = roles[0], &striker = roles[1], &supporter = roles[2], &defender = roles[3], &jolly = roles[4];

  EXPECT_EQ(keeper.robots, std::vector{1});
  EXPECT_EQ(keeper.least_in_play, 1);
  EXPECT_FALSE(keeper.offset);
  EXPECT_EQ(keeper.behaviour, "keep_goal");
  ASSERT_TRUE(keeper.target.on_line && !keeper.target.at && !keeper.target.on_circle);
  EXPECT_EQ(keeper.target.on_line->from.anchor, Anchor::ball);
  EXPECT_EQ(keeper.target.on_line->to.anchor, Anchor::own_goal);
  EXPECT_EQ(keeper.target.on_line->distance_from_to, 0.4);

  EXPECT_TRUE(striker.required);
  EXPECT_TRUE(striker.offset);
  EXPECT_EQ(striker.behaviour, "play_ball");
  EXPECT_EQ(striker.target.at->anchor, Anchor::ball);

  EXPECT_EQ(supporter.behaviour, "support");
  EXPECT_EQ(supporter.target.shift, (std::array{-1.0, 0.0}));
  EXPECT_EQ(*supporter.target.within, (std::array{-4.0, 3.5, -2.5, 2.5}));

  EXPECT_EQ(defender.group, 2);
  const TargetRule::OnCircle& circle = *defender.target.on_circle;
  EXPECT_EQ(circle.towards.anchor, Anchor::own_left_post);
  EXPECT_EQ(circle.centre.anchor, Anchor::own_goal);
  EXPECT_EQ(circle.least_radius, 0.8);
  EXPECT_EQ(circle.largest_radius, 1.3);
  EXPECT_EQ(circle.least_distance, 1.0);
  EXPECT_EQ(circle.largest_distance, 8.0);
  ASSERT_TRUE(defender.target.without_ball);
  EXPECT_EQ(defender.target.without_ball->anchor, Anchor::point);
  EXPECT_EQ(defender.target.without_ball->point, (std::array{-3.0, 1.0}));
  EXPECT_EQ(to_string(defender.where), fixture.string() + ":22:7");

  EXPECT_EQ(*jolly.target.lateral, 0.8);
  EXPECT_EQ(jolly.target.facing.anchor, Anchor::opponent_goal);
  EXPECT_EQ(jolly.behaviour, "support") << "moved away from the ball";
  EXPECT_EQ(team.role_lists[1].roles[1].behaviour, "search");
}

TEST(Team, EveryContextHasItsOwnValues) {
  const Team team = read_document<Team>(fixture);
  ASSERT_EQ(team.contexts.size(), 2u);
  const Context &search = team.contexts[0], &playing = team.contexts[1];
  EXPECT_EQ(search.name, "search") << "the highest priority first";
  EXPECT_EQ(search.priority, 50);
  EXPECT_EQ(search.use.plugin, "ball_lost");
  EXPECT_EQ(search.use.params["after"].text(), "4.5");
  EXPECT_EQ(search.role_list, 1);
  EXPECT_EQ(search.positioner.plugin, "");
  EXPECT_EQ(search.tasks.keep, TaskRules::Keep::all);
  EXPECT_EQ(search.tasks.offset_at_most, 0.4);
  EXPECT_EQ(search.terms[0].weight, 0.5);
  EXPECT_EQ(search.sender.params["period"].text(), "4");
  EXPECT_EQ(search.sender.params["reserve"].text(), "30");
  EXPECT_EQ(to_string(search.sender.params["period"].where()), fixture.string() + ":14:51");

  EXPECT_EQ(playing.role_list, 0);
  EXPECT_EQ(playing.positioner.plugin, "voronoi");
  EXPECT_EQ(playing.tasks.keep, TaskRules::Keep::nearest_to_waypoints);
  EXPECT_TRUE(playing.tasks.walk_along_edges);
  EXPECT_EQ(playing.tasks.hysteresis, 0.2);
  EXPECT_EQ(playing.utility_knowledge, Knowledge::common);
  ASSERT_EQ(playing.terms.size(), 3u);
  EXPECT_EQ(playing.terms[0].name, "distance");
  EXPECT_EQ(playing.terms[0].weight, 0.7);
  EXPECT_EQ(*playing.terms[0].tune, (std::array{0.0, 1.0}));
  EXPECT_EQ(playing.terms[1].use.params["for_robots"].text(), "all");
  EXPECT_FALSE(playing.terms[2].tune);
  EXPECT_EQ(playing.assigner.plugin, "greedy");
  EXPECT_FALSE(playing.sender.params["period"]);
}

TEST(Team, OverridesReachEverything) {
  const Team team = read_document<Team>(
      fixture,
      {"contexts.search.priority=-1", "contexts.search.use.roles=playing", "contexts.search.use.sender.params.period=7",
       "roles.playing.striker.robot=9", "utility.terms.extra={plugin: more, weight: 0.3}", "utility.terms.waypoint=~",
       "positioner.plugin=formation", "roles.playing.jolly=~", "roles.searching.1.target.at=centre"});
  EXPECT_EQ(team.contexts[1].name, "search");
  EXPECT_EQ(team.contexts[1].role_list, 0);
  EXPECT_EQ(team.contexts[1].sender.params["period"].text(), "7");
  EXPECT_EQ(team.role_lists[0].roles[1].robots, std::vector{9});
  EXPECT_EQ(team.role_lists[0].roles.size(), 4u);
  EXPECT_EQ(team.role_lists[1].roles[1].target.at->anchor, Anchor::centre);
  ASSERT_EQ(team.contexts[0].terms.size(), 3u);
  EXPECT_EQ(team.contexts[0].terms[2].name, "extra");
  EXPECT_EQ(team.contexts[0].positioner.plugin, "formation");
  EXPECT_FALSE(team.contexts[0].positioner.params);
}

using TeamFiles = InFolder;

TEST_F(TeamFiles, PinnedPluginsAreFoundBesideTheFileThatNamesThem) {
  const std::string base = content_of(fixture);
  write("base/team.yaml", base);
  write("base/plugins/greedy.so", "x");
  write("other.so", "x");
  write("base/pinned.yaml", "extends: team.yaml\nassigner: {file: plugins/greedy.so}\n");
  write("top.yaml", "extends: base/pinned.yaml\nteam: top\n");
  const Team team = read_document<Team>("top.yaml", {"sender.file=other.so"});
  EXPECT_EQ(team.contexts[0].assigner.file, (folder_ / "base/plugins/greedy.so").string());
  EXPECT_EQ(team.contexts[0].sender.file, (folder_ / "other.so").string()) << "relative to the current folder";
  EXPECT_EQ(team.contexts[0].terms[0].use.file, "");
  // What is shown names them absolutely, so it can be kept anywhere.
  EXPECT_EQ(read_document<Team>(parse_text(show(load("top.yaml")), "elsewhere/shown.yaml")).contexts[0].assigner.file,
            team.contexts[0].assigner.file);
  EXPECT_EQ(error_of([] { read_document<Team>("top.yaml", {"sender.file=othr.so"}); }),
            "--set sender.file=othr.so: sender.file: othr.so: no such file; nearest: \"other.so\"");
  EXPECT_EQ(error_of([] { read_document<Team>("top.yaml", {"sender.file=base"}); }),
            "--set sender.file=base: sender.file: base: is not a regular file");
  EXPECT_EQ(error_of([] { read_document<Team>("top.yaml", {"sender.file=~"}); }),
            "--set sender.file=~: nothing to remove: unknown key \"file\"; known: plugin, params");
}

// The smallest page; each case replaces one line of it by others.
const char* const page =
    "team: t\n"                                                                                             // 1
    "predictors: {self: {plugin: a}, ball: {plugin: b}, opponents: {plugin: c}, teammates: {plugin: d}}\n"  // 2
    "contexts: [{name: playing, plugin: always}]\n"                                                         // 3
    "assigner: {plugin: greedy}\n"                                                                          // 4
    "sender: {plugin: event_based}\n"                                                                       // 5
    "roles: {playing: [{name: striker, target: {at: ball}}]}\n";                                            // 6

TEST(Team, TheSmallestPage) {
  const Team team = read_document<Team>(parse_text(page, "t.yaml"));
  EXPECT_EQ(team.contexts[0].positioner.plugin, "");
  EXPECT_TRUE(team.contexts[0].terms.empty());
  EXPECT_EQ(team.forget_teammate_after, 25.0);
}

TEST(Team, ABehaviourIsThePluginOfItsNameUnlessThePageSaysIt) {
  const std::string with_behaviours =
      std::string(page).substr(0, std::string_view(page).find("roles:")) +
      "roles: {playing: [{name: s, behaviour: press, target: {at: ball}}, {name: t, behaviour: dance, target: {at: "
      "centre}}, {name: u, target: {at: ball}}]}\n"
      "behaviours: {press: {plugin: hunt, params: {near: 2}}, play_ball: {params: {goal_bonus: 5}}}\n"
      "behaviour_without_role: dance\n";
  const Team team = read_document<Team>(parse_text(with_behaviours, "t.yaml"));
  const std::vector<Role>& roles = team.role_lists[0].roles;
  const auto meant = [&](std::size_t i) { return team.behaviour_named(roles[i].behaviour, roles[i].behaviour_where); };
  EXPECT_EQ(meant(0).plugin, "hunt");
  EXPECT_TRUE(meant(0).params["near"]);
  EXPECT_EQ(meant(1).plugin, "dance");
  EXPECT_EQ(to_string(meant(1).where), "t.yaml:6:89");
  EXPECT_EQ(meant(2).plugin, "play_ball") << "the name is the plugin";
  EXPECT_TRUE(meant(2).params["goal_bonus"]);
  EXPECT_EQ(team.behaviour_without_role, "dance");
}

// The target of a context takes the place of the role's own, all of it; other contexts do not know it.
TEST(Team, AContextMovesRoles) {
  const std::string text =
      "team: t\n"
      "predictors: {self: {plugin: a}, ball: {plugin: b}, opponents: {plugin: c}, teammates: {plugin: d}}\n"
      "contexts:\n"
      "  - {name: corner, priority: 2, plugin: a, use: {roles: other, targets: {wing: {at: [3, 0], lateral: -1}}}}\n"
      "  - {name: short, priority: 1, plugin: a, use: {targets.wing: {at: ball}, targets.striker.at: own_goal}}\n"
      "  - {name: playing, plugin: always}\n"
      "assigner: {plugin: greedy}\nsender: {plugin: event_based}\n"
      "roles:\n"
      "  playing: [{name: striker, target: {at: ball}}, {name: wing, target: {at: ball, shift: [1, 0]}}]\n"
      "  other: [{name: keeper, target: {at: own_goal}}, {name: wing, target: {at: ball, shift: [1, 0]}}]\n";
  const Team team = read_document<Team>(parse_text(text, "t.yaml"));
  const auto target = [&](std::size_t context, std::size_t place) {
    const Context& each = team.contexts[context];
    return each.target_of(place, team.role_lists[static_cast<std::size_t>(each.role_list)].roles[place]);
  };
  EXPECT_EQ(target(0, 0).at->anchor, Anchor::own_goal);
  EXPECT_EQ(target(0, 1).at->point[0], 3.0);
  EXPECT_EQ(*target(0, 1).lateral, -1.0);
  EXPECT_EQ(target(0, 1).shift[0], 0.0) << "nothing is left of its own target";
  EXPECT_EQ(target(1, 0).at->anchor, Anchor::own_goal);
  EXPECT_EQ(target(1, 1).shift[0], 0.0);
  EXPECT_EQ(target(2, 0).at->anchor, Anchor::ball);
  EXPECT_EQ(target(2, 1).shift[0], 1.0);
  EXPECT_EQ(team.role_lists[0].roles[0].behaviour, "play_ball") << "how a role acts follows from its own target";
}

// One mistake, one line: which roles there are is not known without the list.
TEST(Team, OfAnUnknownListNoRoleIsRefused) {
  const std::string text = std::string(page).replace(
      std::string_view(page).find("contexts:"), std::string_view("contexts: [{name: playing, plugin: always}]").size(),
      "contexts: [{name: p, plugin: a, use: {roles: nosuch, targets: {keeper: {at: ball}}}}]");
  Mistakes mistakes(Mistakes::After::go_on);
  read_document<Team>(parse_text(text, "t.yaml"), mistakes);
  const std::vector<Error> found = mistakes.in_order("t.yaml");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].message(), "unknown list of roles \"nosuch\"; known: playing");
}

TEST(Team, WhatIsRefused) {
  struct Case {
    int line;  // of the page, that is replaced; 0: added
    std::string_view text, expected;
  };
  const std::string places =
      "known: ball, ball_rest, own_goal, opponent_goal, own_left_post, own_right_post, centre, own_penalty_mark, "
      "opponent_penalty_mark";
  const std::string near_own =
      "t.yaml:6:50: roles.playing.0.target.at: unknown place \"own_gaol\"; nearest: \"own_goal\"; " + places;
  const std::string near_moved =
      "t.yaml:3:63: contexts.0.use.targets.striker.at: unknown place \"bal\"; nearest: \"ball\"; " + places;
  const Case cases[] = {
      // Keys
      {4, "", "t.yaml:1:1: missing key \"assigner\""},
      {5, "", "t.yaml:1:1: missing key \"sender\""},
      {2, "predictors: {self: {plugin: a}}", "t.yaml:2:13: missing key \"ball\" in predictors"},
      {4, "assigner: {params: {}}", "t.yaml:4:11: missing key \"plugin\" in assigner"},
      {4, "assigner: greedy", "t.yaml:4:11: assigner: \"greedy\"; expected {plugin: greedy}"},
      {4, "assigner: {plugin: greedy, param: {}}",
       "t.yaml:4:28: unknown key \"param\" in assigner; nearest: \"params\"; known: plugin, file, params"},
      {4, "assigner: {plugin: greedy, params: [1]}", "t.yaml:4:36: assigner.params: a list; expected a map"},
      {4, "asigner: {plugin: greedy}",
       "t.yaml:4:1: unknown key \"asigner\"; nearest: \"assigner\"; known: team, title, predictors, contexts, "
       "positioner, "
       "tasks, "
       "utility, assigner, sender, roles, behaviours, behaviour_without_role, teammates_forgotten_after"},
      {0, "teammates_forgotten_after: 0", "t.yaml:7:28: teammates_forgotten_after: \"0\" is outside 0.1 to 3600 s"},
      {0, "tasks: {keep: nearest}",
       "t.yaml:7:15: tasks.keep: unknown value \"nearest\"; known: all, nearest_to_waypoints"},
      {0, "tasks: {knowledge: shared}", "t.yaml:7:20: tasks.knowledge: unknown value \"shared\"; known: mine, common"},
      {0, "tasks: {along_edges: yes}", "t.yaml:7:22: tasks.along_edges: \"yes\" is neither true nor false; write true"},
      {0, "tasks: {offset: 0.5}", "t.yaml:7:17: tasks.offset: \"0.5\"; expected a map"},
      {0, "tasks: {offset: {at_most: -1}}", "t.yaml:7:27: tasks.offset.at_most: \"-1\" is outside 0 to 20 m"},
      // Contexts
      {3, "contexts: []", "t.yaml:3:11: contexts: 0 elements; expected 1 to 64"},
      {3, "contexts: [{plugin: always}]", "t.yaml:3:12: missing key \"name\" in contexts.0"},
      {3, "contexts: [{name: p}]", "t.yaml:3:12: missing key \"plugin\" in contexts.0"},
      {3, "contexts: [{name: p, plugin: a}, {name: p, plugin: b, priority: 1}]",
       "t.yaml:3:41: contexts: second element named \"p\"; the first is at t.yaml:3:19"},
      {3, "contexts: [{name: p, plugin: a}, {name: q, plugin: b, priority: 0}]",
       "t.yaml:3:65: contexts p and q have the same priority 0"},
      {3, "contexts: [{name: p, plugin: a}, {name: q, plugin: b}]",
       "t.yaml:3:34: contexts p and q have the same priority 0"},
      {3, "contexts: [{name: p, plugin: a, priority: high}]",
       "t.yaml:3:43: contexts.0.priority: \"high\" is not an integer"},
      // use
      {3, "contexts: [{name: p, plugin: a, use: {roles: playin}}]",
       "t.yaml:3:46: unknown list of roles \"playin\"; nearest: \"playing\"; known: playing"},
      {3, "contexts: [{name: p, plugin: a, use: {roles: [a]}}]",
       "t.yaml:3:46: contexts.0.use.roles: expected the name of a list of roles"},
      {3, "contexts: [{name: p, plugin: a, use: {roles.playing: [a]}}]",
       "t.yaml:3:39: contexts.0.use: roles takes the name of a list and has no parts"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {strker: {at: ball}}}}]",
       "t.yaml:3:49: unknown role \"strker\" in playing; nearest: \"striker\"; known: striker"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {striker: {at: bal}}}}]", near_moved},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {striker: {at: ball, within: [1, 0, 0, 1]}}}}]",
       "t.yaml:3:77: contexts.0.use.targets.striker.within: expected [least x, largest x, least y, largest y], in "
       "order"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {striker: {shift: [1, 0]}}}}]",
       "t.yaml:3:58: contexts.0.use.targets.striker: expected one of at, on_line, on_circle"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {striker: ~}}}]",
       "t.yaml:3:58: contexts.0.use.targets.striker: nothing; expected a map"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: {}}}]",
       "t.yaml:3:48: contexts.0.use.targets: 0 elements; expected 1 to 64"},
      {3, "contexts: [{name: p, plugin: a, use: {targets: striker}}]",
       "t.yaml:3:48: contexts.0.use.targets: \"striker\"; expected a map"},
      {3, "contexts: [{name: p, plugin: a, use: {sendr.params.x: 1}}]",
       "t.yaml:3:39: unknown key \"sendr\" in contexts.0.use; nearest: \"sender\"; known: roles, targets, positioner, "
       "tasks, utility, assigner, sender"},
      {3, "contexts: [{name: p, plugin: a, use: {predictors.self.plugin: x}}]",
       "t.yaml:3:39: unknown key \"predictors\" in contexts.0.use; known: roles, targets, positioner, tasks, "
       "utility, assigner, sender"},
      {3, "contexts: [{name: p, plugin: a, use: {sender.parms.x: 1}}]",
       "t.yaml:3:39: unknown key \"parms\" in sender; nearest: \"params\"; known: plugin, file, params"},
      {3, "contexts: [{name: p, plugin: a, use: {sender.plugin.x: 1}}]",
       "t.yaml:3:39: sender.plugin is \"event_based\", which has no parts"},
      {3, "contexts: [{name: p, plugin: a, use: {sender: ~}}]", "t.yaml:1:1: missing key \"sender\""},
      {3, "contexts: [{name: p, plugin: a, use: {positioner: ~}}]",
       "t.yaml:3:39: nothing to remove: unknown key \"positioner\"; known: assigner, sender"},
      {3, "contexts: [{name: p, plugin: a, use: {tasks.offset.at_most: x}}]",
       "t.yaml:3:61: tasks.offset.at_most: \"x\" is not a number"},
      {3, "contexts: [{name: p, plugin: a, use: roles}]", "t.yaml:3:38: contexts.0.use: \"roles\"; expected a map"},
      // Keys and values that run together
      {4, "assigner {plugin: greedy}", "t.yaml:4:1: ':' is missing after assigner"},
      {4, "assigner: {plugin:greedy}", "t.yaml:4:12: \"plugin:greedy\": a space is missing after plugin:"},
      {1, "team: Nao Devils",
       "t.yaml:1:7: team: \"Nao Devils\" is not a name (a letter, then letters, digits, '_' and '-'); a name for "
       "people is a "
       "value of the key title"},
      // Roles
      {6, "", "t.yaml:1:1: missing key \"roles\""},
      {6, "roles: {}", "t.yaml:6:8: roles: 0 elements; expected 1 to 64"},
      {6, "roles: {playing: []}", "t.yaml:6:18: roles.playing: 0 elements; expected 1 to 64"},
      {6, "roles: {a.b: [{name: s, target: {at: ball}}]}",
       "t.yaml:6:9: roles: \"a.b\" is not a name (a letter, then letters, digits, '_' and '-')"},
      {6, "roles: {playing: [{name: s, target: {at: ball}}, {name: s, target: {at: ball}}]}",
       "t.yaml:6:57: roles.playing: second element named \"s\"; the first is at t.yaml:6:26"},
      {6, "roles: {playing: [{name: s}]}", "t.yaml:6:19: missing key \"target\" in roles.playing.0"},
      {6, "roles: {playing: [{name: s, behaviour: 2nd, target: {at: ball}}]}",
       "t.yaml:6:40: roles.playing.0.behaviour: \"2nd\" is not a name (a letter, then letters, digits, '_' and '-')"},
      {6, "roles: {playing: [{name: s, robot: -1, target: {at: ball}}]}",
       "t.yaml:6:36: roles.playing.0.robot: -1 is outside 0 to 99"},
      // Targets
      {6, "roles: {playing: [{name: s, target: {}}]}",
       "t.yaml:6:37: roles.playing.0.target: expected one of at, on_line, on_circle"},
      {6, "roles: {playing: [{name: s, target: {shift: [1, 0]}}]}",
       "t.yaml:6:37: roles.playing.0.target: expected one of at, on_line, on_circle"},
      {6, "roles: {playing: [{name: s, target: {at: ball, on_line: [ball, centre]}}]}",
       "t.yaml:6:57: roles.playing.0.target: expected exactly one of at, on_line, on_circle"},
      {6, "roles: {playing: [{name: striker, target: {  at: own_gaol}}]}", near_own},
      {6, "roles: {playing: [{name: s, target: {at: {x: 1}}}]}",
       "t.yaml:6:42: roles.playing.0.target.at: a map; expected the name of a place or [x, y]"},
      {6, "roles: {playing: [{name: s, target: {at: [1]}}]}",
       "t.yaml:6:42: roles.playing.0.target.at: 1 elements; expected the name of a place or [x, y]"},
      {6, "roles: {playing: [{name: s, target: {at: [1, .inf]}}]}",
       "t.yaml:6:46: roles.playing.0.target.at.1: \".inf\" is not finite"},
      {6, "roles: {playing: [{name: s, target: {at: [1, 1000]}}]}",
       "t.yaml:6:46: roles.playing.0.target.at.1: \"1000\" is outside -100 to 100 m"},
      {6, "roles: {playing: [{name: s, target: {at: ball, from_goal: 1}}]}",
       "t.yaml:6:59: roles.playing.0.target.from_goal: makes sense only with on_line"},
      {6, "roles: {playing: [{name: s, target: {on_line: [ball]}}]}",
       "t.yaml:6:47: roles.playing.0.target.on_line: a list; expected a list of two places"},
      {6, "roles: {playing: [{name: s, target: {on_line: [ball, ball]}}]}",
       "t.yaml:6:47: roles.playing.0.target.on_line: both ends are the same place"},
      {6, "roles: {playing: [{name: s, target: {on_circle: {from: ball, towards: centre}}}]}",
       "t.yaml:6:49: missing key \"centre\" in roles.playing.0.target.on_circle"},
      {6, "roles: {playing: [{name: s, target: {on_circle: {from: ball, towards: ball, centre: centre}}}]}",
       "t.yaml:6:49: roles.playing.0.target.on_circle: from and towards are the same place"},
      {6,
       "roles: {playing: [{name: s, target: {on_circle: {from: ball, towards: own_goal, centre: centre, radius: [2, "
       "1]}}}]}",
       "t.yaml:6:105: roles.playing.0.target.on_circle.radius: 2 is more than 1"},
      {6, "roles: {playing: [{name: s, target: {at: ball, within: [1, -1, 0, 2]}}]}",
       "t.yaml:6:56: roles.playing.0.target.within: expected [least x, largest x, least y, largest y], in order"},
      {6, "roles: {playing: [{name: s, target: {at: ball, within: [1, 2]}}]}",
       "t.yaml:6:56: roles.playing.0.target.within: 2 elements; expected a list of 4 numbers"},
      {6, "roles: {playing: [{name: s, target: {at: ball, shift: 1}}]}",
       "t.yaml:6:55: roles.playing.0.target.shift: \"1\"; expected a list of 2 numbers"},
      {6, "roles: {playing: [{name: s, target: {at: ball, lateral: -101}}]}",
       "t.yaml:6:57: roles.playing.0.target.lateral: \"-101\" is outside -100 to 100 m"},
      // Utility
      {0, "utility: {terms: {d: {plugin: x, weight: -1}}}",
       "t.yaml:7:42: utility.terms.d.weight: \"-1\" is outside 0 to 1000000"},
      {0, "utility: {terms: {d: {plugin: x, weight: .nan}}}",
       "t.yaml:7:42: utility.terms.d.weight: \".nan\" is not finite"},
      {0, "utility: {terms: {d: {plugin: x, tune: [1, 0]}}}", "t.yaml:7:40: utility.terms.d.tune: 1 is more than 0"},
      {0, "utility: {terms: {d: {weight: 1}}}", "t.yaml:7:22: missing key \"plugin\" in utility.terms.d"},
      {0, "utility: {terms: {distance: {plugin: distance, weight: 1}, distnace: {weight: 1}}}",
       "t.yaml:7:60: unknown name \"distnace\" in utility.terms; nearest: \"distance\"; known: distance"},
      {0, "utility: {terms: [a]}", "t.yaml:7:18: utility.terms: a list; expected a map"},
      {0, "utility: {terms: {d: {plugin: x}, d: {plugin: y}}}", "t.yaml:7:35: duplicate key \"d\"; first in line 7"},
  };
  std::vector<std::string> lines;
  std::istringstream stream(page);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  for (const Case& each : cases) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text += (static_cast<int>(i) + 1 == each.line ? std::string(each.text) : lines[i]) + '\n';
    }
    if (each.line == 0) text += std::string(each.text) + '\n';
    EXPECT_EQ(error_of([&] { read_document<Team>(parse_text(text, "t.yaml")); }), each.expected) << each.text;
  }
}

// What is laid over a team is named where it stands, with what is in its way.
std::string page_with_keeper(const std::string& keeper) {
  return "team: base\n"
         "predictors: {self: {plugin: p}, ball: {plugin: p}, opponents: {plugin: p}, teammates: {plugin: p}}\n"
         "contexts: [{name: always, plugin: c}]\n"
         "assigner: {plugin: a}\n"
         "sender: {plugin: s}\n"
         "roles: {playing: [{name: keeper, target: {at: own_goal}" +
         keeper + "}]}\n";
}

TEST_F(TeamFiles, RobotsOfARole) {
  const auto robots = [this](const std::string& value) {
    write("t.yaml", page_with_keeper(", robot: " + value));
    return read_document<Team>("t.yaml").role_lists[0].roles[0].robots;
  };
  EXPECT_EQ(robots("0"), std::vector<int>{});
  EXPECT_EQ(robots("3"), std::vector{3});
  EXPECT_EQ(robots("[3, 1, 2]"), (std::vector{3, 1, 2})) << "in order of preference";
  const auto refused = [&](const std::string& value) { return error_of([&] { robots(value); }); };
  const std::string place = "t.yaml:6:65: roles.playing.0.robot";
  EXPECT_EQ(refused("[]"), place + ": an empty list; 0 is any robot");
  EXPECT_EQ(refused("100"), place + ": 100 is outside 0 to 99");
  EXPECT_EQ(refused("[1, 2, 1]"), "t.yaml:6:72: roles.playing.0.robot.2: robot 1 is given twice");
  EXPECT_EQ(refused("[1, any]"), "t.yaml:6:69: roles.playing.0.robot.1: \"any\" is not an integer");
}

TEST_F(TeamFiles, ATitleIsForPeopleAndOfOneTeam) {
  const auto title = [](const Overrides& overrides = {}) { return read_document<Team>("over.yaml", overrides).title; };
  write("base.yaml", page_with_keeper("") + "title: \"Nao Devils\"\n");
  write("over.yaml", "extends: base.yaml\n");
  EXPECT_EQ(title(), "Nao Devils") << "the same team";
  write("over.yaml", "extends: base.yaml\nteam: mine\n");
  EXPECT_EQ(title(), "mine") << "another team";
  write("over.yaml", "extends: base.yaml\nteam: mine\ntitle: B-Human, Bremen\n");
  EXPECT_EQ(title(), "B-Human, Bremen");
}

TEST_F(TeamFiles, WhatAPageLaysOverAnotherIsRefusedWhereItStands) {
  write("base.yaml",
        "team: base\n"
        "predictors: {self: {plugin: p}, ball: {plugin: p}, opponents: {plugin: p}, teammates: {plugin: p}}\n"
        "contexts: [{name: always, plugin: c}]\n"
        "assigner: {plugin: a}\n"
        "sender: {plugin: s}\n"
        "roles:\n"
        "  playing:\n"
        "    - {name: wing, target: {at: ball}}\n"
        "  under_siege:\n"
        "    - {name: wing, target: {on_line: [ball, centre]}}\n");
  const auto refused = [this](const std::string& roles, const Overrides& overrides = {}) {
    write("over.yaml", "extends: base.yaml\nroles:\n" + roles);
    return error_of([&] { read_document<Team>("over.yaml", overrides); });
  };
  const std::string one = "roles.playing.0.target: expected exactly one of at, on_line, on_circle; ";
  EXPECT_EQ(refused("  playing: {wing: {target: {on_line: [ball, centre]}}}\n"),
            "over.yaml:3:38: " + one + "at is there already (base.yaml:8:29), and at: ~ takes it away");
  EXPECT_EQ(refused("  playing: {wing: {target: {at: ~, on_line: [ball, centre]}}}\n"), "");
  EXPECT_EQ(refused("  under_siege: {wing: {target: {at: ball}}}\n"),
            "over.yaml:3:37: roles.under_siege.0.target: expected exactly one of at, on_line, on_circle; on_line is "
            "there already (base.yaml:10:29), and on_line: ~ takes it away");
  EXPECT_EQ(refused("  playing: {}\n", {"roles.playing.wing.target.on_line=[ball,centre]"}),
            "--set roles.playing.wing.target.on_line=[ball,centre]: " + one +
                "at is there already (base.yaml:8:29), and at: ~ takes it away");
  EXPECT_EQ(refused("  under_seige: {wing: {robot: 2}}\n"),
            "over.yaml:3:3: unknown list \"under_seige\" in roles; nearest: \"under_siege\"; known: playing, "
            "under_siege; a map changes a list of the page that this one extends, a new one is a list");
}

}  // namespace
}  // namespace regista::config
