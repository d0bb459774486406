// SPDX-License-Identifier: MIT
#include "config/disturbance.hpp"

#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

Disturbance read(const std::string& incidents) {
  return read_document<Disturbance>(parse_text("disturbance: d\nincidents:\n" + incidents, "t.yaml"));
}

TEST(Disturbance, WhomAndWhen) {
  const Disturbance d = read(R"(
  - {name: a, kind: crash, at: 30}
  - {kind: crash, robots: any, at: [10, 20.5], for: 60}
  - {kind: mirror_flip, robots: [5, 2], per_hour: 12}
  - {kind: slow_robot, robots: 3, at: 0, speed: 0.5}
)");
  ASSERT_EQ(d.incidents.size(), 4u);
  using Choice = Incident::Whom::Choice;
  EXPECT_EQ(d.incidents[0].robots.choice, Choice::all);
  EXPECT_EQ(d.incidents[0].at, std::vector<double>{30.0});
  EXPECT_FALSE(d.incidents[0].duration);
  EXPECT_EQ(d.incidents[1].robots.choice, Choice::any);
  EXPECT_EQ(d.incidents[1].at, (std::vector{10.0, 20.5}));
  EXPECT_EQ(d.incidents[1].duration, 60.0);
  EXPECT_EQ(d.incidents[2].robots.numbers, (std::vector{2, 5}));
  EXPECT_EQ(d.incidents[2].per_hour, 12.0);
  EXPECT_EQ(d.incidents[3].robots.numbers, std::vector{3});
  EXPECT_EQ(path_of(d, 0), "incidents.a");
  EXPECT_EQ(path_of(d, 1), "incidents.1");
}

// A test loads this with every kind in it, and what is shown reads back as the same.
TEST(Disturbance, EveryKindReadsBackTheSame) {
  std::string all;
  for (const std::string& kind : incident_kinds()) {
    all += "  - {kind: " + kind + ", robots: [1, 3], at: [1, 2]";
    if (kind == "pose_bias") all += ", x: 0.5, heading_deg: -10";
    if (kind == "ghost_ball") all += ", x: 1, y: 2";
    if (kind == "radio_delay") all += ", delay: 1";
    if (kind == "radio_jitter") all += ", jitter: 1";
    if (kind == "burst_loss") all += ", mean_bad: 3, loss: 0.9";
    if (kind == "slow_robot") all += ", speed: 0.25";
    all += "}\n";
  }
  const Node document = parse_text("disturbance: d\nincidents:\n" + all, "t.yaml");
  const std::string shown = show(document);
  EXPECT_EQ(show(parse_text(shown, "t.yaml")).size(),
            show(parse_text(show(parse_text(shown, "t.yaml")), "t.yaml")).size());
  const Disturbance before = read_document<Disturbance>(document),
                    after = read_document<Disturbance>(parse_text(shown, "shown.yaml"));
  ASSERT_EQ(after.incidents.size(), incident_kinds().size());
  for (std::size_t i = 0; i < after.incidents.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(after.incidents[i].kind), i);
    EXPECT_EQ(after.incidents[i].robots.numbers, before.incidents[i].robots.numbers);
    EXPECT_EQ(after.incidents[i].at, before.incidents[i].at);
    EXPECT_EQ(after.incidents[i].heading, before.incidents[i].heading);
    EXPECT_EQ(after.incidents[i].speed, before.incidents[i].speed);
    EXPECT_EQ(after.incidents[i].mean_bad, before.incidents[i].mean_bad);
    EXPECT_EQ(after.incidents[i].mean_good, before.incidents[i].mean_good);
  }
}

TEST(Disturbance, PathsReachAnIncident) {
  const Node document =
      parse_text("disturbance: d\nincidents: [{name: late, kind: radio_delay, delay: 1, at: 0}]\n", "t.yaml");
  const Disturbance d =
      read_document<Disturbance>(override_with(document, {"incidents.late.delay=2.5", "incidents.0.at=[3, 4]"}));
  EXPECT_EQ(d.incidents[0].delay, 2.5);
  EXPECT_EQ(d.incidents[0].at, (std::vector{3.0, 4.0}));
  EXPECT_EQ(error_of([&] { read_document<Disturbance>(override_with(document, {"incidents.late.robots=0"})); }),
            "--set incidents.late.robots=0: incidents.0.robots: 0 is outside 1 to 22 robots");
}

TEST(Disturbance, WhatIsRefused) {
  const std::pair<std::string, std::string> cases[] = {
      {"  - {at: 1}\n", "t.yaml:3:5: missing key \"kind\" in incidents.0"},
      {"  - {kind: crush, at: 1}\n",
       "t.yaml:3:12: incidents.0.kind: unknown value \"crush\"; nearest: \"crash\"; known: pose_bias, mirror_flip, "
       "ghost_ball, blind_camera, radio_delay, radio_jitter, burst_loss, radio_silence, crash, slow_robot"},
      {"  - {kind: crash}\n", "t.yaml:3:5: incidents.0: expected one of at, per_hour"},
      {"  - {kind: crash, at: 1, per_hour: 2}\n", "t.yaml:3:36: incidents.0: expected exactly one of at, per_hour"},
      {"  - {kind: crash, at: -1}\n", "t.yaml:3:23: incidents.0.at: \"-1\" is outside 0 to 1000000 s"},
      {"  - {kind: crash, at: [2, 1]}\n", "t.yaml:3:27: incidents.0.at: the moments are not in their order"},
      {"  - {kind: crash, at: [1, 2, 2]}\n", "t.yaml:3:30: incidents.0.at: the moments are not in their order"},
      {"  - {kind: crash, at: []}\n", "t.yaml:3:23: incidents.0.at: an empty list; leave the incident out"},
      {"  - {kind: crash, at: 1, for: -5}\n", "t.yaml:3:31: incidents.0.for: \"-5\" is outside 0 to 1000000 s"},
      {"  - {kind: crash, at: 1, robots: some}\n",
       "t.yaml:3:34: incidents.0.robots: \"some\"; expected all, any, a number or a list of numbers"},
      {"  - {kind: crash, at: 1, robots: [2, 2]}\n", "t.yaml:3:38: incidents.0.robots: 2 is given twice"},
      {"  - {kind: crash, at: 1, speed: 0.5}\n",
       "t.yaml:3:33: incidents.0.speed: makes no sense for crash, whose values are: none of its own"},
      {"  - {name: bias, kind: pose_bias, at: 1, delay: 1}\n",
       "t.yaml:3:49: incidents.bias.delay: makes no sense for pose_bias, whose values are: x, y, heading_deg"},
      {"  - {kind: slow_robot, at: 1}\n", "t.yaml:3:5: missing key \"speed\" in incidents.0"},
      {"  - {kind: slow_robot, at: 1, speed: 2}\n", "t.yaml:3:38: incidents.0.speed: \"2\" is outside 0 to 1"},
      {"  - {kind: pose_bias, at: 1}\n", "t.yaml:3:5: incidents.0: by how much? expected x, y, heading_deg"},
      {"  - {kind: ghost_ball, at: 1, x: 1}\n",
       "t.yaml:3:5: incidents.0: expected x and y, or neither for a place drawn at random"},
  };
  for (const auto& [incidents, expected] : cases) EXPECT_EQ(error_of([&, text = incidents] { read(text); }), expected);
}

TEST(Disturbance, AsManyGhostBallsAsCanStrikeARobot) {
  const auto refused = [](int of_robot_2, int of_anybody) {
    std::string page = "disturbance: d\nincidents:\n";
    for (int i = 0; i < of_robot_2; ++i) page += "  - {kind: ghost_ball, robots: 2, at: 1}\n";
    for (int i = 0; i < of_anybody; ++i) page += "  - {kind: ghost_ball, robots: any, at: 1}\n";
    const Node document = parse_text(page, "t.yaml");
    return error_of([&] { check(read_document<Disturbance>(document), Rules{}, document); });
  };
  EXPECT_EQ(refused(8, 0), "");
  EXPECT_EQ(refused(3, 5), "");
  EXPECT_EQ(refused(9, 0),
            "t.yaml:11:5: disturbance d: incidents.8 is one more than the 8 ghost balls that can strike robot 2");
  EXPECT_EQ(refused(3, 6),
            "t.yaml:11:5: disturbance d: incidents.8 is one more than the 8 ghost balls that can strike robot 2");
}

TEST(Disturbance, RobotsThatATeamDoesNotHave) {
  const Node document = parse_text("disturbance: d\nincidents: [{kind: crash, robots: [2, 6], at: 1}]\n", "t.yaml");
  const Disturbance d = read_document<Disturbance>(document);
  Rules rules;
  check(d, rules, document);
  rules.team_size = 5;
  EXPECT_EQ(error_of([&] { check(d, rules, document); }),
            "t.yaml:2:35: disturbance d: incidents.0 strikes robot 6, a team has 5 robots");
}

}  // namespace
}  // namespace regista::config
