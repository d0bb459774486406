// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

const char* const profiles[] = {"configs/rules/spl2023.yaml", "configs/robots/nao.yaml",
                                "configs/disturbances/none.yaml"};

// Every value of a document by its dotted path.
void collect(const Node& node, const std::string& path, std::vector<std::pair<std::string, std::string>>& leaves) {
  const auto below = [&](const std::string& key) { return path.empty() ? key : path + '.' + key; };
  for (const Node::Entry& entry : node.entries()) collect(entry.value, below(entry.key), leaves);
  for (std::size_t i = 0; i < node.elements().size(); ++i)
    collect(node.elements()[i], below(fmt::format("{}", i)), leaves);
  if (node.kind() == Node::Kind::scalar) leaves.emplace_back(path, node.text());
}

std::vector<std::pair<std::string, std::string>> leaves_of(const Node& document) {
  std::vector<std::pair<std::string, std::string>> leaves;
  collect(document, "", leaves);
  return leaves;
}

Node shown(const Node& document) { return parse_text(show(document), "shown.yaml"); }

// Reads and checks a document of any kind. Returns the kind.
const DocumentKind& checked(const std::filesystem::path& file) {
  const Node document = load(file);
  const DocumentKind& kind = kind_of(document);
  Mistakes first(Mistakes::After::stop);
  kind.with_values(document, first, [](const Map&) {});
  return kind;
}

TEST(Documents, EveryShippedOneIsSound) {
  int files = 0;
  for (const auto& [folder, kind] :
       {std::pair{"configs/rules", DocumentKind::rules}, std::pair{"configs/robots", DocumentKind::robot},
        std::pair{"configs/disturbances", DocumentKind::disturbance}, std::pair{"configs/teams", DocumentKind::team},
        std::pair{"configs/openings", DocumentKind::opening}}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project / folder)) {
      if (!entry.is_regular_file()) continue;
      EXPECT_EQ(error_of([&, wanted = kind] { EXPECT_EQ(checked(entry.path()), wanted); }), "");
      ++files;
    }
  }
  EXPECT_GE(files, 5);
}

TEST(Profiles, FilesAndStructsAgree) {
  for (const char* file : profiles) {
    const Node document = parse(project / file);
    const std::string kind(kind_of(document).name);
    const Node bare = parse_text(kind + ": " + document[kind].text(), "bare.yaml");
    EXPECT_TRUE(same(shown(document), shown(bare))) << show(document) << show(bare);
  }
  EXPECT_EQ(Rules{}.name, read_document<Rules>(project / profiles[0]).name);
  EXPECT_EQ(Robot{}.name, read_document<Robot>(project / profiles[1]).name);
  EXPECT_EQ(Disturbance{}.name, read_document<Disturbance>(project / profiles[2]).name);
}

TEST(Profiles, FilesSayEveryValue) {
  for (const char* file : profiles) {
    const Node document = parse(project / file);
    auto written = leaves_of(document), all = leaves_of(shown(document));
    ASSERT_EQ(written.size(), all.size());
    std::sort(written.begin(), written.end());
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(written[i].first, all[i].first);
  }
}

// Each key is bound to a member of its own: changing a value changes it, and nothing else, in what is shown.
TEST(Profiles, EveryValueCanBeSetAlone) {
  for (const char* file : profiles) {
    const Node document = parse(project / file);
    const auto before = leaves_of(shown(document));
    for (const auto& [path, text] : before) {
      if (text.find_first_not_of("0123456789.e-") != std::string::npos) continue;
      const double value = to_real(Node::scalar(text, false, {}), path);
      // The first that is in range and plays: period and integers want whole steps.
      std::string problem = "none";
      for (const double other : {value * 1.01, value * 0.99, value + 1, value - 1, 0.5, 0.06}) {
        if (other == value) continue;
        try {
          const auto after = leaves_of(shown(override_with(document, {fmt::format("{}={}", path, other)})));
          ASSERT_EQ(after.size(), before.size());
          problem.clear();
          for (std::size_t i = 0; i < after.size(); ++i) {
            EXPECT_EQ(after[i] != before[i], before[i].first == path) << path << " changes " << before[i].first;
          }
          break;
        } catch (const Error& error) {
          problem = error.what();
        }
      }
      EXPECT_EQ(problem, "") << path;
    }
  }
}

TEST(Profiles, DegreesBecomeRadians) {
  const Robot robot =
      read_document<Robot>(parse_text("robot: r\nwalk: {turn_deg: 180}\ncamera: {half_angle_deg: 45}\n", "r.yaml"));
  EXPECT_DOUBLE_EQ(robot.walk.turn, 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(robot.camera.half_angle, 0.78539816339744830962);
}

TEST(Profiles, PublishedFigures) {
  const Rules rules = read_document<Rules>(project / profiles[0]);
  EXPECT_EQ(rules.field.length, 9.0);
  EXPECT_EQ(rules.field.width, 6.0);
  EXPECT_DOUBLE_EQ(rules.field.goal_width / 2 + rules.field.post_diameter / 2, 0.8) << "centres of the posts";
  EXPECT_EQ(rules.messages.budget, 1200);
  EXPECT_EQ(rules.messages.size, 128);
  EXPECT_EQ(rules.team_size, 7);
  const Robot robot = read_document<Robot>(project / profiles[1]);
  ASSERT_EQ(robot.kicks.size(), 3u);
  EXPECT_EQ(robot.kicks[0].name, "fast");
  EXPECT_EQ(robot.kicks[1].maximum_distance, 5.4);
  EXPECT_EQ(robot.kicks[2].name, "in_walk");
}

TEST(Profiles, WhatIsRefused) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      // Keys and types
      {"x: 1\n",
       "t.yaml:1:1: no key says what this is: rules, robot, disturbance, opening, team, predictor_study, tournament, "
       "experiment or tuning, with its name"},
      {"rules: a\nfield:\n  lenght: 9\n",
       "t.yaml:3:3: unknown key \"lenght\" in field; nearest: \"length\"; known: length, width, border_strip, "
       "line_width, "
       "goal_width, goal_depth, post_diameter, goal_area_length, goal_area_width, penalty_area_length, "
       "penalty_area_width, penalty_mark_distance, centre_circle_diameter"},
      {"disturbance: a\nradio:\n  dealy: 1\n",
       "t.yaml:3:3: unknown key \"dealy\" in radio; nearest: \"delay\"; known: loss, delay, jitter, burst, silence"},
      {"disturbance: a\nwind: 1\n", "t.yaml:2:1: unknown key \"wind\"; known: disturbance, radio, camera, incidents"},
      {"disturbance: a\ncamera: {}\ncamera: {}\n", "t.yaml:3:1: duplicate key \"camera\"; first in line 2"},
      {"rules: a\nfield: 9 x 6\n", "t.yaml:2:8: field: \"9 x 6\"; expected a map"},
      {"rules: a\nfield:\n", "t.yaml:2:1: field: nothing; expected a map"},
      {"rules: a\nfield: [9, 6]\n", "t.yaml:2:8: field: a list; expected a map"},
      {"rules: a\nfield: {length: nine}\n", "t.yaml:2:17: field.length: \"nine\" is not a number"},
      {"rules: a\nfield: {length: 010}\n",
       "t.yaml:2:17: field.length: \"010\" begins with zero, which some read as octal; leave the zero out"},
      {"rules: a\nteam_size: 6.5\n", "t.yaml:2:12: team_size: \"6.5\" is not an integer"},
      {"rules: 2023\n", "t.yaml:1:8: rules: \"2023\" is not a name (a letter, then letters, digits, '_' and '-')"},
      {"robot: r\nkicks: {name: a}\n", "t.yaml:2:8: kicks: a map; expected a list"},
      {"robot: r\nkicks: [a]\n", "t.yaml:2:9: kicks.0: \"a\"; expected a map"},
      {"robot: r\nkicks: [{impact: 0.1}]\n", "t.yaml:2:9: missing key \"name\" in kicks.0"},
      {"robot: r\nkicks: []\n", "t.yaml:2:8: kicks: 0 elements; expected 1 to 16"},
      {"robot: r\nkicks: [{name: a}, {name: b}, {name: a}]\n",
       "t.yaml:2:38: kicks: second element named \"a\"; the first is at t.yaml:2:16"},
      // Ranges
      {"rules: a\nfield: {length: 900}\n", "t.yaml:2:17: field.length: \"900\" is outside 0.5 to 200 m"},
      {"rules: a\nteam_size: 0\n", "t.yaml:2:12: team_size: 0 is outside 1 to 22 robots"},
      {"rules: a\ndurations: {half: -600}\n", "t.yaml:2:19: durations.half: \"-600\" is outside 1 to 7200 s"},
      {"rules: a\ndurations: {ready: -1}\n", "t.yaml:2:20: durations.ready: \"-1\" is outside 0 to 600 s"},
      {"rules: a\nmessages: {budget: -1}\n", "t.yaml:2:20: messages.budget: -1 is outside 0 to 1000000 packets"},
      {"rules: a\nmessages: {size: 63}\n", "t.yaml:2:18: messages.size: 63 is outside 64 to 1024 bytes"},
      {"rules: a\nmercy_difference: 99999999999\n",
       "t.yaml:2:19: mercy_difference: 99999999999 is outside 1 to 1000 goals"},
      {"robot: r\nwalk: {turn_deg: 0}\n", "t.yaml:2:18: walk.turn_deg: \"0\" is outside 1 to 3600 deg/s"},
      {"robot: r\nradio: {loss: 1.5}\n", "t.yaml:2:15: radio.loss: \"1.5\" is outside 0 to 1"},
      // What cannot be played
      {"rules: a\nfield: {goal_width: 7}\n",
       "t.yaml:2:21: the goal with its posts (7.2 m) is wider than the field (6 m)"},
      {"rules: a\nfield: {width: 1}\n", "t.yaml:2:16: the goal with its posts (1.7 m) is wider than the field (1 m)"},
      {"rules: a\nball: {diameter: 0.5}\nfield: {goal_width: 0.4}\n",
       "t.yaml:2:18: the ball does not fit into the goal"},
      {"rules: a\nfield: {goal_area_length: 5}\n",
       "t.yaml:2:27: the goal area (5 m long) reaches beyond the halfway line (4.5 m from the goal line)"},
      {"rules: a\nfield: {goal_area_width: 6.5}\n", "t.yaml:2:26: the goal area (6.5 m) is wider than the field (6 m)"},
      {"rules: a\nfield: {penalty_area_length: 5}\n",
       "t.yaml:2:30: the penalty area (5 m long) reaches beyond the halfway line (4.5 m from the goal line)"},
      {"rules: a\nfield: {penalty_area_width: 6.5}\n",
       "t.yaml:2:29: the penalty area (6.5 m) is wider than the field (6 m)"},
      {"rules: a\nfield: {penalty_mark_distance: 5}\n",
       "t.yaml:2:32: the penalty mark (5 m from the goal line) lies beyond the halfway line (4.5 m)"},
      {"rules: a\nfield: {centre_circle_diameter: 7}\n",
       "t.yaml:2:33: field.centre_circle_diameter (7 m) is more than field.width (6 m)"},
      {"rules: a\nset_play_distance: 8\n", "t.yaml:2:20: set_play_distance (8 m) is more than field.width (6 m)"},
      {"robot: r\nkicks: [{name: a, impact: 2, duration: 1.5}]\n",
       "t.yaml:2:27: kick a: the ball is hit 2 s after the beginning, but the kick is over after 1.5 s"},
      {"robot: r\nkicks: [{name: a, minimum_distance: 5}]\n",
       "t.yaml:2:37: kick a: the least distance (5 m) is more than the largest (4.5 m)"},
      {"robot: r\ndecision_period: 0.05\n",
       "t.yaml:2:18: decision_period: 0.05 s is not a whole number of physics steps of 0.02 s"},
      {"robot: r\nbody: {reach: 0.1}\n",
       "t.yaml:2:15: body.reach (0.1 m from the centre) ends inside the body (radius 0.15 m)"},
  };
  for (const auto& [text, expected] : cases) {
    EXPECT_EQ(error_of([given = text] { show(parse_text(given, "t.yaml")); }), expected);
  }
}

TEST(Profiles, OfAnotherKind) {
  const Node robot = parse_text("robot: r\n", "t.yaml");
  EXPECT_EQ(error_of([&] { read_document<Rules>(robot); }),
            "t.yaml:1:1: this is a robot document; expected a rules document");
}

TEST(Profiles, OverridesAreCheckedLikeFiles) {
  const auto file = project / profiles[0];
  EXPECT_EQ(read_document<Rules>(file, {"team_size=5", "field={length: 14, width: 9}"}).field.length, 14.0);
  EXPECT_EQ(error_of([&] { read_document<Rules>(file, {"team_size=0"}); }),
            "--set team_size=0: team_size: 0 is outside 1 to 22 robots");
  EXPECT_EQ(error_of([&] { read_document<Rules>(file, {"messages.bugdet=5"}); }),
            "--set messages.bugdet=5: unknown key \"bugdet\" in messages; nearest: \"budget\"; known: budget, "
            "size, short_games");
  EXPECT_EQ(checked(file), DocumentKind::rules);
}

}  // namespace
}  // namespace regista::config
