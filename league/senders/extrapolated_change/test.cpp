// SPDX-License-Identifier: MIT
// The rules alone: what teammates extrapolate and notice, the line, and each cause by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "algorithm.hpp"

namespace {

using namespace extrapolated_change;
constexpr double pi = std::numbers::pi;

// --- Extrapolation ---------------------------------------------------------------------------------------------------

TEST(Extrapolation, HalfTheSpeedAndNotBeyond) {
  const Walk walk{{1, 1}, {4, 5}, 0.2};  // 5 m
  EXPECT_DOUBLE_EQ(extrapolate(walk, 10).x, 1.6);
  EXPECT_DOUBLE_EQ(extrapolate(walk, 10).y, 1.8);
  EXPECT_EQ(extrapolate(walk, 0).x, 1.0);
  for (const double age : {50.0, 50.1, 1e9}) {
    EXPECT_EQ(extrapolate(walk, age).x, 4.0);
    EXPECT_EQ(extrapolate(walk, age).y, 5.0);
  }
  EXPECT_EQ(extrapolate({{1, 1}, {1, 1}, 0.2}, 9).y, 1.0);
  EXPECT_EQ(extrapolate({{1, 1}, {4, 5}, 0.0}, 9).x, 1.0);
}

TEST(Extrapolation, AnotherDirectionOrAnotherSize) {
  const Sense sense;
  const auto differs = [&](double far, double ahead, double aside) {
    return looks_different({0, 0}, {far, 0}, {far + ahead, aside}, sense);
  };
  EXPECT_TRUE(differs(3.0, 0.0, 0.35));   // 6.7 degrees
  EXPECT_FALSE(differs(5.0, 0.0, 0.35));  // 4.0 degrees
  EXPECT_TRUE(differs(1.0, 0.35, 0.0));   // 0.45 m look 24.2 and 18.4 degrees wide
  EXPECT_FALSE(differs(3.0, 0.35, 0.0));  // 8.5 and 7.7
  EXPECT_TRUE(differs(1.0, -2.0, 0.0));   // behind instead of ahead
  const double limit = 5.0 * pi / 180.0;
  EXPECT_FALSE(looks_different({0, 0}, {4, 0}, {4 * std::cos(limit - 1e-6), 4 * std::sin(limit - 1e-6)}, sense));
  EXPECT_TRUE(looks_different({0, 0}, {4, 0}, {4 * std::cos(limit + 1e-6), 4 * std::sin(limit + 1e-6)}, sense));
}

TEST(Extrapolation, SomeTeammateMustNotice) {
  const Sense sense;
  const std::vector<Point> far{{-9, 0}, {9, 0.2}}, one_near{{-9, 0}, {0.2, 3}};
  EXPECT_FALSE(matters({0, 0}, {0.4, 0}, far, sense));
  EXPECT_TRUE(matters({0, 0}, {0.4, 0}, one_near, sense));
  EXPECT_FALSE(matters({0, 0}, {0.3, 0}, one_near, sense));  // not farther than 0.3 m
  EXPECT_TRUE(matters({0, 0}, {0.31, 0}, {}, sense));        // nobody is known to hear
  EXPECT_FALSE(matters({0, 0}, {0.29, 0}, {}, sense));
}

// --- The line --------------------------------------------------------------------------------------------------------

TEST(Spending, TheNumbersOfTheRelease) {
  const Allowance a;
  EXPECT_EQ(a.whole(), 1220.0);
  EXPECT_EQ(a.line(1.0), 1200.0);
  EXPECT_EQ(a.line(0.5), 615.0);
  EXPECT_EQ(a.line(0.0), 30.0);
  EXPECT_NEAR(2.0 * a.even_interval(), 2.085, 0.0005);
  EXPECT_DOUBLE_EQ(share_left(a, {1, 600}), 1215.0 / 1220.0);
  EXPECT_DOUBLE_EQ(share_left(a, {1, 0}), 615.0 / 1220.0);
  EXPECT_DOUBLE_EQ(share_left(a, {2, 600}), 605.0 / 1220.0);
  EXPECT_DOUBLE_EQ(share_left(a, {2, 0}), 5.0 / 1220.0);
  EXPECT_DOUBLE_EQ(share_left(a, {3, 0}), 5.0 / 1220.0);  // extra time
  EXPECT_EQ(half_reserve(a, 1), 615.0);
  EXPECT_EQ(half_reserve(a, 2), 30.0);
  EXPECT_EQ(half_reserve(a, 3), 30.0);
}

TEST(Spending, FreeAboveTheLine) {
  const Allowance a;
  const auto may = [&](double left, double silent) {
    return may_spend(a, {.left = left,
                         .line = 900,
                         .line_before = 900,
                         .reserve = 615,
                         .half_left = 300,
                         .silent = silent,
                         .robots = 7,
                         .turn = 0});
  };
  EXPECT_TRUE(may(901, 0.0));
  EXPECT_FALSE(may(900, 0.0));
  EXPECT_FALSE(may(900, 2.08));
  EXPECT_TRUE(may(900, 2.09));
}

TEST(Spending, BelowTheLineTheLongestOfThreeSilences) {
  const Allowance a;
  const auto silence = [&](Purse purse) {
    for (purse.silent = 0.0; purse.silent < 1000.0; purse.silent += 0.001) {
      if (may_spend(a, purse)) return purse.silent;
    }
    return 1e9;
  };
  const Purse p{.left = 890,
                .line = 900,
                .line_before = 900,
                .reserve = 615,
                .half_left = 300,
                .silent = 0,
                .robots = 7,
                .turn = 0};
  EXPECT_NEAR(silence(p), 2.0855, 0.002);
  Purse deep = p;
  deep.line_before = 950;  // 60 below
  EXPECT_NEAR(silence(deep), 2 * 2.0855, 0.002);
  Purse poor = p;
  poor.left = 625;
  poor.line_before = 640;
  EXPECT_NEAR(silence(poor), 300.0 / 10.0, 0.002);
  poor.left = 615;  // nothing above the half's reserve
  EXPECT_EQ(silence(poor), 1e9);
  Purse turn = p;
  turn.turn = 0.3;
  EXPECT_NEAR(silence(turn), 2.3855, 0.002);
  Purse last = p;  // above the line, but not a packet for each robot
  last.left = 621;
  last.line = last.line_before = 600;
  EXPECT_NEAR(silence(last), 300.0 / 6.0, 0.002);
}

// --- Each cause alone -----------------------------------------------------------------------------------------------

// A robot that stands, sees the ball where everybody knows it, and has nothing to tell. Ten decisions a second.
struct Quiet {
  Settings settings;
  Sender sender;
  Situation now;
  std::vector<Point> mates{{-2, 0}, {0, 2}};
  double last = 0.0;

  Quiet() {
    now.time = 10.0;
    now.number = 3;
    now.upright = true;
    now.role = 4;
    now.told_role = 4;
    now.pass_target = 0;
    now.knows_ball = now.team_knows_ball = true;
    now.ball_age = 0.0;
    now.team_ball_age = 1.0;
    now.ball = now.ball_rests = now.team_ball_rests = {2, 0};
    now.purse.left = 1200;
    now.purse.line = 1000;
    now.purse.reserve = 30;
    step();  // the first packet
  }
  std::optional<Cause> step() {
    now.time += 0.1;
    now.mates = mates;
    now.since_own = now.time - last;
    const auto cause = sender.decide(settings, now);
    if (cause) last = now.time;
    return cause;
  }
  void rest(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.1) ASSERT_EQ(step(), std::nullopt);
  }
  // s until it sends from now on, and why.
  std::pair<double, std::optional<Cause>> until(double most = 60.0) {
    const double began = now.time;
    while (now.time < began + most) {
      if (const auto cause = step()) return {now.time - began - 0.1, cause};  // the first step counts as 0
    }
    return {most, std::nullopt};
  }
};

TEST(Causes, TheFirstPacketThenNothing) {
  Sender fresh;
  Situation now;
  now.purse.left = 1200;
  now.purse.line = 1000;
  now.since_own = 5.0;
  EXPECT_EQ(fresh.decide({}, now), Cause::first);
  Quiet quiet;
  quiet.rest(600.0);
}

struct Change {
  const char* name;
  std::function<void(Quiet&)> make;
  Cause cause;
  bool lasts;  // it must last as long as the distance of the ball says
};

const std::vector<Change>& changes() {
  static const std::vector<Change> all{
      {"falls", [](Quiet& q) { q.now.upright = false; }, Cause::upright, true},
      {"a pass", [](Quiet& q) { q.now.pass_target = 2; }, Cause::pass_target, true},
      {"another role", [](Quiet& q) { q.now.role = 5; }, Cause::role, true},
      {"no role", [](Quiet& q) { q.now.role = -1; }, Cause::role, true},
      {"the ball vanished", [](Quiet& q) { q.now.ball_age = 3.1; }, Cause::ball_seen, true},
      {"moved to the side",
       [](Quiet& q) {
         q.now.place.x += 0.35;
         q.now.ball.x += 0.35;
       },
       Cause::pose, true},
      {"news of the ball are old", [](Quiet& q) { q.now.team_ball_age = 10.6; }, Cause::ball_is_old, true},
      {"the team knows no ball", [](Quiet& q) { q.now.team_knows_ball = false; }, Cause::ball_is_old, true},
      {"an urgent offer", [](Quiet& q) { q.now.urgent_offer = true; }, Cause::offer, false},
      {"a whistle", [](Quiet& q) { q.now.heard_whistle = true; }, Cause::whistle, false},
  };
  return all;
}

TEST(Causes, EachAloneAfterItsTime) {
  for (const Change& change : changes()) {
    for (const auto& [away, lasts] : {std::pair{0.5, 0.3}, {1.0, 0.3}, {2.0, 0.75}, {3.0, 1.2}, {8.0, 1.2}}) {
      Quiet quiet;
      quiet.now.ball = {away, 0};
      quiet.rest(20.0);
      change.make(quiet);
      const auto [time, cause] = quiet.until();
      EXPECT_EQ(cause, change.cause) << change.name;
      const double wanted = change.lasts ? std::ceil(lasts * 10.0 - 1e-6) / 10.0 : 0.0;
      EXPECT_NEAR(time, wanted, 1e-6) << change.name << ' ' << away;
    }
  }
}

TEST(Causes, WhatPassesCostsNothing) {
  for (const Change& change : changes()) {
    if (!change.lasts) continue;
    Quiet quiet;
    quiet.rest(20.0);
    const Situation before = quiet.now;
    for (int round = 0; round < 20; ++round) {
      change.make(quiet);
      quiet.rest(0.7);  // 0.75 s with the ball 2 m away
      const double time = quiet.now.time;
      quiet.now = before;
      quiet.now.time = time;
      quiet.rest(0.1);
    }
  }
}

TEST(Causes, ANewActiveRoleIsToldAfterATenth) {
  Quiet quiet;
  quiet.rest(20.0);
  quiet.now.role = 1;
  quiet.now.role_is_active = true;
  const auto [time, cause] = quiet.until();
  EXPECT_EQ(cause, Cause::role);
  EXPECT_NEAR(time, 0.1, 1e-6);
}

// It is told when it is another one than at the last packet, nobody too; whom it was meant for in between is forgotten.
TEST(Causes, APassIsToldWhenItsTargetChanges) {
  Quiet quiet;
  for (const int target : {2, 5, 0, 1, 0}) {
    quiet.rest(20.0);
    quiet.now.pass_target = target;
    EXPECT_EQ(quiet.until().second, Cause::pass_target) << target;
  }
  quiet.rest(20.0);
  quiet.now.pass_target = 2;
  quiet.rest(0.5);
  quiet.now.pass_target = 0;
  quiet.rest(20.0);
  quiet.now.pass_target.reset();  // the host does not tell
  quiet.rest(20.0);
}

// Another packet tells it, too.
TEST(Causes, APassThatWasToldIsNoNews) {
  Quiet quiet;
  quiet.rest(20.0);
  quiet.now.pass_target = 2;
  quiet.now.urgent_offer = true;
  EXPECT_EQ(quiet.step(), Cause::offer);
  quiet.now.urgent_offer = false;
  quiet.rest(20.0);
}

TEST(Causes, ABallThatIsElsewhere) {
  // As it was told, but not where the team has it: no cause. Where the team has it, but not as told: no cause.
  for (const bool off_told : {false, true}) {
    for (const bool off_team : {false, true}) {
      Quiet quiet;
      quiet.rest(20.0);
      if (off_told) quiet.now.ball_rests = {2, 0.6};
      quiet.now.team_ball_rests = quiet.now.ball_rests;
      if (off_team) quiet.now.team_ball_rests.y += 0.4;
      const auto [time, cause] = quiet.until();
      if (off_told && off_team) {
        EXPECT_EQ(cause, Cause::ball);
        EXPECT_NEAR(time, 0.3 + 0.8, 1e-6);  // off the team's for 0.3 s, then 0.75 s
      } else {
        EXPECT_EQ(cause, std::nullopt);
      }
    }
  }
  Quiet unseen;  // not in sight, so it cannot be told
  unseen.rest(20.0);
  unseen.now.ball_rests = {2, 0.6};
  unseen.now.ball_age = 0.6;
  EXPECT_EQ(unseen.until().second, std::nullopt);
}

TEST(Causes, ABallThatAppears) {
  Quiet quiet;
  quiet.now.ball_age = 4.0;
  EXPECT_EQ(quiet.until().second, Cause::ball_seen);
  quiet.rest(20.0);
  quiet.now.ball_age = 2.9;
  EXPECT_EQ(quiet.until().second, Cause::ball_seen);
  quiet.rest(20.0);
}

TEST(Causes, OldNewsDependOnTheNumber) {
  for (const int number : {1, 3, 7}) {
    for (const double off : {-0.1, 0.1}) {
      Quiet quiet;
      quiet.now.number = number;
      quiet.rest(5.0);
      quiet.now.team_ball_age = 9.0 + 0.5 * number + off;
      EXPECT_EQ(quiet.until().second.has_value(), off > 0.0) << number;
    }
  }
}

TEST(Causes, AMoveThatNobodyNotices) {
  Quiet quiet;
  quiet.mates = {{-9, 0}, {-8, 1}};
  quiet.rest(20.0);
  quiet.now.place.x += 0.4;
  EXPECT_EQ(quiet.until().second, std::nullopt);
  quiet.mates.push_back({0.2, 2.0});
  EXPECT_EQ(quiet.until().second, Cause::pose);
}

TEST(Causes, NothingWhilePoorlyLocalised) {
  for (const Change& change : changes()) {
    Quiet quiet;
    quiet.rest(20.0);
    quiet.now.pose_deviation = 0.51;
    change.make(quiet);
    EXPECT_EQ(quiet.until(10.0).second, std::nullopt) << change.name;
  }
}

TEST(Causes, ASecondBetweenTwoPackets) {
  Quiet quiet;
  quiet.rest(20.0);
  quiet.now.urgent_offer = true;
  double last = -10.0;
  int packets = 0;
  for (int tick = 0; tick < 200; ++tick) {
    if (!quiet.step()) continue;
    ++packets;
    if (packets > 1) {
      EXPECT_NEAR(quiet.now.time - last, 1.0, 1e-6);
    }
    last = quiet.now.time;
  }
  EXPECT_EQ(packets, 20);
}

TEST(Causes, OnlyAWhistleGoesBelowTheReserve) {
  for (const Change& change : changes()) {
    for (const double left : {30.0, 16.0, 15.0, 0.0}) {
      Quiet quiet;
      quiet.rest(20.0);
      quiet.now.purse.left = left;
      quiet.now.purse.silent = 1e6;
      change.make(quiet);
      EXPECT_EQ(quiet.until(3.9).second.has_value(), change.cause == Cause::whistle && left > 15.0)
          << change.name << ' ' << left;
    }
  }
}

TEST(Causes, AWhistleIsOldAfterFourSeconds) {
  for (const double later : {3.8, 4.2}) {
    Quiet quiet;
    quiet.rest(20.0);
    quiet.now.purse.left = 10;
    quiet.now.heard_whistle = true;
    quiet.step();
    quiet.now.heard_whistle = false;
    for (double t = 0.1; t < later - 0.05; t += 0.1) quiet.step();
    quiet.now.purse.left = 1200;
    EXPECT_EQ(quiet.step().has_value(), later < 4.0);
  }
}

TEST(Causes, BeforeTheKickOffOnlyIfAskedTo) {
  Quiet quiet;
  quiet.rest(20.0);
  quiet.now.playing = false;
  quiet.now.role = 7;
  EXPECT_EQ(quiet.until(10.0).second, std::nullopt);
}

// --- Motion ----------------------------------------------------------------------------------------------------------

// A robot that walks just as its teammates extrapolate tells of no pose; one that walks otherwise tells only when it is
// off, computed here anew.
TEST(Motion, OnlyWhoIsNotWhereItIsBelievedTells) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> x(-4.0, 4.0), y(-2.5, 2.5), speed(0.05, 0.25);
  int of_exact = 0, of_others = 0;
  for (int round = 0; round < 60; ++round) {
    const bool exact = round % 2 == 0;
    Quiet quiet;
    for (Point& mate : quiet.mates) mate = {x(random), y(random)};
    Point start = quiet.now.place, target = quiet.now.told_target = {x(random), y(random)};
    double said = 0.0, since = quiet.now.time;
    quiet.now.speed = speed(random);
    int held = 0;
    for (int tick = 0; tick < 600; ++tick) {
      if (!exact && random() % 50 == 0) target = {x(random), y(random)};
      const double time = quiet.now.time + 0.1 - since;
      if (exact) {
        const double way = std::hypot(target.x - start.x, target.y - start.y);
        const double part = way > 0.0 ? std::min(1.0, 0.5 * said * time / way) : 0.0;
        quiet.now.place = {start.x + part * (target.x - start.x), start.y + part * (target.y - start.y)};
      } else {
        const double dx = target.x - quiet.now.place.x, dy = target.y - quiet.now.place.y, way = std::hypot(dx, dy);
        const double step = std::min(way, 0.1 * quiet.now.speed);
        if (way > 0.0) quiet.now.place = {quiet.now.place.x + step * dx / way, quiet.now.place.y + step * dy / way};
      }
      const auto believed = quiet.sender.believed(quiet.now.time + 0.1);
      const auto cause = quiet.step();
      ASSERT_TRUE(believed);
      const Point& is = quiet.now.place;
      bool noticed = false;
      for (const Point& m : quiet.mates) {
        const double turn = std::remainder(
            std::atan2(is.y - m.y, is.x - m.x) - std::atan2(believed->y - m.y, believed->x - m.x), 2.0 * pi);
        const double wide = std::atan2(0.45, std::hypot(is.x - m.x, is.y - m.y)) -
                            std::atan2(0.45, std::hypot(believed->x - m.x, believed->y - m.y));
        noticed = noticed || std::max(std::abs(turn), std::abs(wide)) > 5.0 * pi / 180.0;
      }
      const bool off = noticed && std::hypot(is.x - believed->x, is.y - believed->y) > 0.3;
      held = off ? held + 1 : 0;
      if (cause) {
        ASSERT_EQ(cause, Cause::pose);
        ASSERT_GE(held, 4);  // 0.3 s at least
        ++(exact ? of_exact : of_others);
        held = 0;
        start = is;
        said = quiet.now.speed;
        since = quiet.now.time;
        quiet.now.told_target = target;
      } else {
        ASSERT_LE(held, 14);  // 1.2 s at most, or 1 s since the last packet
      }
      if (exact && said == 0.0 && tick == 50) {  // a new packet, so that it walks
        quiet.now.role = 9;
        for (int left = 100; !quiet.step(); --left) ASSERT_GT(left, 0);
        quiet.now.told_role = 9;
        start = quiet.now.place;
        said = quiet.now.speed;
        since = quiet.now.time;
      }
    }
  }
  EXPECT_EQ(of_exact, 0);
  EXPECT_GT(of_others, 200);
}

}  // namespace
