// SPDX-License-Identifier: MIT
// Openings: what is read, what is refused and how, and what holds of those that are shipped.
#include "config/opening.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

constexpr std::string_view scene = R"(opening: two_on_one
summary: Two against one, and "nobody" else
length: 20
ball: {at: [1, 0.5], velocity: [0.5, -0.25]}
home:
  - {at: [-4, 0]}
  - {at: [0.5, 0.5], heading_deg: 90}
away:
  - {at: [4, 0], heading_deg: 180}
  - {at: [1, 2.5]}
)";

Opening read(std::string_view text) { return read_document<Opening>(parse_text(std::string(text), "t.yaml")); }

std::string with(std::string_view old, std::string_view replacement) {
  std::string text(scene);
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), replacement);
}

Rules rules_for(int team_size) {
  Rules rules;
  rules.team_size = team_size;
  return rules;
}

TEST(Opening, IsReadAsWritten) {
  const Opening opening = read(scene);
  EXPECT_EQ(opening.name, "two_on_one");
  EXPECT_EQ(opening.summary, "Two against one, and \"nobody\" else");
  EXPECT_EQ(opening.length, 20.0);
  EXPECT_EQ(opening.ball.at, (std::array{1.0, 0.5}));
  EXPECT_EQ(opening.ball.velocity, (std::array{0.5, -0.25}));
  ASSERT_EQ(opening.home.size(), 2u);
  ASSERT_EQ(opening.away.size(), 2u);
  EXPECT_EQ(opening.home[1].at, (std::array{0.5, 0.5}));
  EXPECT_EQ(opening.away[1].at, (std::array{1.0, 2.5}));
}

TEST(Opening, RobotsWithoutHeadingLookAtTheBall) {
  const Opening opening = read(scene);
  EXPECT_DOUBLE_EQ(heading(opening, opening.home[0]), std::atan2(0.5, 5.0));
  EXPECT_DOUBLE_EQ(heading(opening, opening.home[1]), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(heading(opening, opening.away[0]), std::numbers::pi);
  EXPECT_DOUBLE_EQ(heading(opening, opening.away[1]), -std::numbers::pi / 2.0);
}

TEST(Opening, BallLiesStillUnlessAVelocityIsGiven) {
  EXPECT_EQ(read(with(", velocity: [0.5, -0.25]", "")).ball.velocity, (std::array{0.0, 0.0}));
}

TEST(Opening, IsShownSoThatItReadsAsTheSame) {
  const std::string shown = show(parse_text(std::string(scene), "t.yaml"));
  const Opening before = read(scene), after = read(shown);
  EXPECT_EQ(after.summary, before.summary);
  EXPECT_EQ(after.ball.velocity, before.ball.velocity);
  EXPECT_EQ(after.home[1].heading, before.home[1].heading);
  EXPECT_FALSE(after.home[0].heading) << "a robot that looks at the ball still does when the ball is moved";
  EXPECT_EQ(show(parse_text(shown, "t.yaml")).substr(0, 20), shown.substr(0, 20));
}

TEST(Opening, ValuesAreLaidOver) {
  const Node document = override_with(parse_text(std::string(scene), "t.yaml"), {"length=25", "home.0.at=[-3, 1]"});
  EXPECT_EQ(read_document<Opening>(document).length, 25.0);
  EXPECT_EQ(read_document<Opening>(document).home[0].at, (std::array{-3.0, 1.0}));
}

TEST(Opening, WhatIsRefused) {
  const auto line = [](std::string_view old, std::string_view replacement) {
    return error_of([&] { read(with(old, replacement)); });
  };
  EXPECT_EQ(error_of([] { read("rules: r\n"); }), "t.yaml:1:1: this is a rules document; expected an opening document");
  EXPECT_EQ(line("two_on_one", "2 on 1"),
            "t.yaml:1:10: opening: \"2 on 1\" is not a name (a letter, then letters, digits, '_' and '-')");
  EXPECT_EQ(line("length: 20\n", ""), "t.yaml:1:1: missing key \"length\"");
  EXPECT_EQ(line("20", "0"), "t.yaml:3:9: length: \"0\" is outside 0.1 to 3600 s");
  EXPECT_EQ(line("20", "-5"), "t.yaml:3:9: length: \"-5\" is outside 0.1 to 3600 s");
  EXPECT_EQ(line("20", ".nan"), "t.yaml:3:9: length: \".nan\" is not finite");
  EXPECT_EQ(line("20", "soon"), "t.yaml:3:9: length: \"soon\" is not a number");
  EXPECT_EQ(line("Two against one, and \"nobody\" else", "[]"), "t.yaml:2:10: summary: a list; expected text");
  EXPECT_EQ(line("Two against one, and \"nobody\" else", "\"two\\nlines\""), "t.yaml:2:10: summary: expected one line");
  EXPECT_EQ(line("ball: {at: [1, 0.5], velocity: [0.5, -0.25]}\n", ""), "t.yaml:1:1: missing key \"ball\"");
  EXPECT_EQ(line("at: [1, 0.5], ", ""), "t.yaml:4:7: missing key \"at\" in ball");
  EXPECT_EQ(line("[1, 0.5]", "[1, 0.5, 0]"), "t.yaml:4:12: ball.at: 3 elements; expected a list of 2 numbers");
  EXPECT_EQ(line("[1, 0.5]", "[1, .inf]"), "t.yaml:4:16: ball.at.1: \".inf\" is not finite");
  EXPECT_EQ(line("[0.5, -0.25]", "[50, 0]"), "t.yaml:4:33: ball.velocity.0: \"50\" is outside -20 to 20 m/s");
  EXPECT_EQ(line("{at: [1, 0.5], v", "{position: [1, 0.5], v"),
            "t.yaml:4:8: unknown key \"position\" in ball; known: at, velocity");
  EXPECT_EQ(line("  - {at: [-4, 0]}\n  - {at: [0.5, 0.5], heading_deg: 90}\n", "  []\n"),
            "t.yaml:6:3: home: 0 elements; expected 1 to 22");
  EXPECT_EQ(line("{at: [-4, 0]}", "[-4, 0, 0]"), "t.yaml:6:5: home.0: a list; expected a map");
  EXPECT_EQ(line("[0.5, 0.5]", "[0.5, 500]"), "t.yaml:7:16: home.1.at.1: \"500\" is outside -100 to 100 m");
  EXPECT_EQ(line("heading_deg: 180", "heading_deg: 720"),
            "t.yaml:9:31: away.0.heading_deg: \"720\" is outside -360 to 360 deg");
  EXPECT_EQ(line("heading_deg: 180", "heading: 3.1"),
            "t.yaml:9:18: unknown key \"heading\" in away.0; known: at, heading_deg");
}

struct Wrong {
  std::function<void(Opening&, Rules&, std::array<Robot, 2>&)> make;
  std::string path, reason;
};

TEST(Misfit, NamesWhatDoesNotGoWithRulesAndRobots) {
  const Wrong all[] = {
      {[](Opening&, Rules& rules, auto&) { rules.team_size = 3; }, "home", "home has 2 places, a team has 3 robots"},
      {[](Opening& o, Rules&, auto&) { o.away.pop_back(); }, "away", "away has 1 place, a team has 2 robots"},
      {[](Opening& o, Rules&, auto&) {
         o.ball.at = {4.51, 0.0};
       },
       "ball.at", "the ball at (4.51, 0) is off the field, which ends at x = 4.5 and y = 3 m"},
      {[](Opening& o, Rules&, auto&) {
         o.ball.at = {4.39, -0.8};
       },
       "ball.at", ""},
      {[](Opening& o, Rules&, auto&) {
         o.ball.at = {4.45, -0.75};
       },
       "ball.at", "the ball at (4.45, -0.75) is on a goal post"},
      // A post stands beside the inner width of 1.5 m: its middle is at y = 0.8, and it ends at 0.85.
      {[](Opening& o, Rules&, auto&) {
         o.ball.at = {4.5, 0.89};
       },
       "ball.at", "the ball at (4.5, 0.89) is on a goal post"},
      {[](Opening& o, Rules&, auto&) {
         o.ball.at = {4.5, 0.91};
       },
       "ball.at", ""},
      {[](Opening& o, Rules&, auto&) {
         o.home[0].at = {-5.0, 2.0};
       },
       "home.0.at", ""},
      {[](Opening& o, Rules&, auto&) {
         o.home[0].at = {-5.1, 2.0};
       },
       "home.0.at", "home 1 at (-5.1, 2) is off the carpet, which has room up to x = 5.05 and y = 3.55 m"},
      {[](Opening& o, Rules&, auto&) {
         o.away[1].at = {1.0, 3.6};
       },
       "away.1.at", "away 2 at (1, 3.6) is off the carpet, which has room up to x = 5.05 and y = 3.55 m"},
      {[](Opening& o, Rules&, auto&) {
         o.away[0].at = {4.4, 0.7};
       },
       "away.0.at", "away 1 at (4.4, 0.7) stands in a goal's frame"},
      {[](Opening& o, Rules&, auto&) {
         o.away[0].at = {-4.9, 0.3};
       },
       "away.0.at", "away 1 at (-4.9, 0.3) stands in a goal's frame"},
      {[](Opening& o, Rules&, auto&) {
         o.away[0].at = {-4.7, 0.0};
       },
       "away.0.at", ""},
      {[](Opening& o, Rules&, auto&) {
         o.home[1].at = {0.85, 0.5};
       },
       "home.1.at", "home 2 at (0.85, 0.5) stands on the ball at (1, 0.5): 0.15 m apart, they need 0.2 m"},
      {[](Opening& o, Rules&, auto&) {
         o.away[1].at = {0.5, 0.75};
       },
       "away.1.at", "away 2 at (0.5, 0.75) and home 2 at (0.5, 0.5) overlap: 0.25 m apart, they need 0.3 m"},
      {[](Opening& o, Rules&, auto&) {
         o.away[1].at = {0.5, 0.81};
       },
       "away.1.at", ""},
      // Another field, other bodies.
      {[](Opening&, Rules& rules, auto&) { rules.field.length = 6.0; }, "home.0.at",
       "home 1 at (-4, 0) is off the carpet, which has room up to x = 3.55 and y = 3.55 m"},
      {[](Opening& o, Rules&, auto& robots) {
         o.away[1].at = {0.5, 0.9};
         robots[1].body.radius = 0.3;
       },
       "away.1.at", "away 2 at (0.5, 0.9) and home 2 at (0.5, 0.5) overlap: 0.4 m apart, they need 0.45 m"},
  };
  for (const Wrong& wrong : all) {
    Opening opening = read(scene);
    Rules rules = rules_for(2);
    std::array<Robot, 2> robots;
    ASSERT_FALSE(misfit(opening, rules, robots));
    wrong.make(opening, rules, robots);
    const auto found = misfit(opening, rules, robots);
    EXPECT_EQ(found ? found->reason : "", wrong.reason.empty() ? "" : "opening two_on_one: " + wrong.reason);
    EXPECT_EQ(found ? found->path : wrong.path, wrong.path);
  }
}

TEST(Misfit, LooksAtTheRobotsThatTakePart) {
  Opening opening = read(scene);
  opening.away[1].at = opening.home[1].at;
  EXPECT_TRUE(misfit(opening, rules_for(2), {}));
  EXPECT_FALSE(misfit(opening, rules_for(1), {}));
}

// --- Those that are shipped
// -------------------------------------------------------------------------------------------

std::map<std::string, Opening> shipped() {
  std::map<std::string, Opening> out;
  for (const auto& entry : std::filesystem::directory_iterator(project / "configs/openings")) {
    out.emplace(entry.path().stem().string(), read_document<Opening>(entry.path()));
  }
  return out;
}

// The scene seen from the other side: turned by half a turn about the centre.
std::vector<double> numbers_of(const Opening& opening, bool turned) {
  std::vector<double> out{opening.length};
  const double sign = turned ? -1.0 : 1.0;
  const auto add = [&](const std::array<double, 2>& point) {
    // Adding 0 makes -0 the same number as 0.
    for (const double value : point) out.push_back(sign * value + 0.0);
  };
  add(opening.ball.at);
  add(opening.ball.velocity);
  for (const auto* players : {turned ? &opening.away : &opening.home, turned ? &opening.home : &opening.away}) {
    for (const Opening::Player& player : *players) add(player.at);
  }
  return out;
}

TEST(ShippedOpenings, CanBePlayedByEveryShippedTeam) {
  const auto all = shipped();
  EXPECT_GE(all.size(), 32u);
  const Rules rules;
  for (const auto& [file, opening] : all) {
    EXPECT_EQ(opening.name, file);
    EXPECT_FALSE(opening.summary.empty()) << file;
    EXPECT_GE(opening.length, 20.0) << file;
    EXPECT_LE(opening.length, 60.0) << file;
    EXPECT_EQ(opening.home.size(), 7u) << file;
    EXPECT_EQ(opening.away.size(), 7u) << file;
    const auto found = misfit(opening, rules, {});
    EXPECT_EQ(found ? found->reason : "", "");
  }
}

// RoboCup SPL rule book 2023: at most three robots of a team in its own goal area, and the ball is in play.
TEST(ShippedOpenings, AreLegal) {
  const FieldSize field;
  for (const auto& [file, opening] : shipped()) {
    const auto in_own_goal_area = [&](const std::vector<Opening::Player>& players, double goal) {
      return std::ranges::count_if(players, [&](const Opening::Player& player) {
        return goal * player.at[0] >= field.length / 2.0 - field.goal_area_length &&
               std::fabs(player.at[1]) <= field.goal_area_width / 2.0;
      });
    };
    EXPECT_LE(in_own_goal_area(opening.home, -1.0), 3) << file;
    EXPECT_LE(in_own_goal_area(opening.away, 1.0), 3) << file;
  }
}

TEST(ShippedOpenings, AreAllDifferentEvenWithSidesSwapped) {
  std::map<std::vector<double>, std::string> seen;
  for (const auto& [file, opening] : shipped()) {
    const auto [same, is_new] = seen.emplace(numbers_of(opening, false), file);
    EXPECT_TRUE(is_new) << file << " is " << same->second;
    const auto reflected = seen.find(numbers_of(opening, true));
    EXPECT_TRUE(reflected == seen.end() || reflected->second == file) << file << " reflects " << reflected->second;
  }
}

TEST(ShippedOpenings, EvenOnesAreTheirOwnReflectionAndOthersAreNot) {
  int even = 0, uneven = 0;
  for (const auto& [file, opening] : shipped()) {
    const bool says_even = file.starts_with("even_");
    EXPECT_EQ(numbers_of(opening, false) == numbers_of(opening, true), says_even) << file;
    ++(says_even ? even : uneven);
    if (!says_even) continue;
    for (std::size_t i = 0; i < opening.home.size(); ++i) {
      const double apart = heading(opening, opening.home[i]) - heading(opening, opening.away[i]);
      EXPECT_NEAR(std::fabs(std::remainder(apart, 2.0 * std::numbers::pi)), std::numbers::pi, 1e-9) << file;
    }
  }
  EXPECT_GE(even, 6);
  EXPECT_GE(uneven, 24);
}

}  // namespace
}  // namespace regista::config
