// SPDX-License-Identifier: MIT
// Claims among whole teams: who wins, what a lost word does, what becomes of a striker that loses the ball, leaves or
// falls silent. And the dealing by its definition, and words as bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "claims.hpp"
#include "dealing.hpp"
#include "own_eyes.hpp"
#include "word.hpp"

namespace {

using hulks::Claims, hulks::nobody, hulks::Now, hulks::Part, hulks::Settings, hulks::Word;

// A team that decides ten times a second, each robot in its turn. News are sent at once, the striker's claim every
// 2 s; a word arrives a tick later, if `arrives` says so.
struct Team {
  struct Robot {
    Claims claims;
    std::uint32_t reach = 5000;
    bool sees = true, trusts = true, plays = true;
    int last_sent = -1000;
    int sent = 0;
  };
  struct Flying {
    int tick, sender, receiver;
    Word word;
    double sent;
  };
  std::vector<Robot> robots;
  std::deque<Flying> air;
  Settings settings;
  bool playing = true;
  int tick = 0;
  std::function<bool(int sender, int receiver)> arrives = [](int, int) { return true; };

  explicit Team(std::size_t size) : robots(size) {
    for (Robot& each : robots) each.claims.reserve(static_cast<int>(size));
  }
  Robot& robot(int number) { return robots[static_cast<std::size_t>(number - 1)]; }
  int highest() const {
    for (std::size_t i = robots.size(); i > 0; --i) {
      if (robots[i - 1].plays && robots[i - 1].reach != hulks::never) return static_cast<int>(i);
    }
    return nobody;
  }
  void step(int ticks = 1) {
    for (; ticks > 0; --ticks, ++tick) {
      for (; !air.empty() && air.front().tick <= tick; air.pop_front()) {
        const Flying& each = air.front();
        robot(each.receiver).claims.hear(each.sender, each.word, each.sent, 0.1 * tick);
      }
      for (int number = 1; number <= static_cast<int>(robots.size()); ++number) decide(number);
    }
  }
  void decide(int number) {
    Robot& self = robot(number);
    Now now{0.1 * tick, number,      playing,  self.plays, self.plays ? self.reach : hulks::never,
            self.sees,  self.trusts, highest()};
    self.claims.decide(settings, now, [this](int other) { return robot(other).plays; });
    const bool is_striker = self.claims.part() == Part::striker;
    if (!self.plays || !(self.claims.has_news() || (is_striker && tick - self.last_sent >= 20))) return;
    const Word word = is_striker ? Word{true, self.reach, 3} : Word{};
    self.claims.has_told();
    self.last_sent = tick;
    ++self.sent;
    for (int other = 1; other <= static_cast<int>(robots.size()); ++other) {
      if (other != number && arrives(number, other)) air.push_back({tick + 1, number, other, word, 0.1 * tick});
    }
  }
  std::vector<int> strikers() const {
    std::vector<int> out;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (robots[i].claims.part() == Part::striker) out.push_back(static_cast<int>(i) + 1);
    }
    return out;
  }
  // Whom each robot takes for the striker.
  std::set<int> believed() {
    std::set<int> out;
    for (int number = 1; number <= static_cast<int>(robots.size()); ++number) {
      if (!robot(number).plays) continue;
      const int striker = robot(number).claims.striker(number);
      out.insert(striker == nobody ? highest() : striker);
    }
    return out;
  }
  int nearest() const {
    int best = nobody;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (!robots[i].plays || robots[i].reach >= Claims::viable) continue;
      if (best == nobody || robots[i].reach < robots[static_cast<std::size_t>(best - 1)].reach) {
        best = static_cast<int>(i) + 1;
      }
    }
    return best;
  }
};

using Numbers = std::vector<int>;

TEST(Claims, TheLeastTimeWinsWhenNothingIsLost) {
  std::mt19937 random(5);
  for (int round = 0; round < 10000; ++round) {
    Team team(1 + random() % 11);
    for (Team::Robot& each : team.robots) {
      each.reach = random() % 20 == 0 ? hulks::never : static_cast<std::uint32_t>(1000 * (random() % 12));
      each.sees = random() % 3 != 0;
    }
    const int best = team.nearest();
    team.step(25);
    if (best == nobody) {
      ASSERT_EQ(team.strikers(), Numbers{});
      continue;
    }
    ASSERT_EQ(team.strikers(), Numbers{best}) << round;
    ASSERT_EQ(team.believed(), std::set<int>{best}) << round;
    for (int number = 1; number <= static_cast<int>(team.robots.size()); ++number) {
      if (number == best) continue;
      ASSERT_EQ(team.robot(number).claims.claimed_task(), 3) << round;
    }
  }
}

// Nobody moves: the first word is that of the highest number, and each claims once at most, with less time.
TEST(Claims, EachClaimsOnceAtMost) {
  std::mt19937 random(6);
  for (int round = 0; round < 2000; ++round) {
    Team team(7);
    for (Team::Robot& each : team.robots) each.reach = static_cast<std::uint32_t>(random() % 60000);
    team.step(19);
    for (const Team::Robot& each : team.robots) ASSERT_LE(each.sent, 1);
  }
}

TEST(Claims, OneStrikerOfAWholeMatchSpeaks600Times) {
  Team team(7);
  team.robot(7).reach = 10;
  team.step(12000);
  EXPECT_EQ(team.strikers(), Numbers{7});
  EXPECT_EQ(team.robot(7).sent, 600);
  for (int number = 1; number < 7; ++number) EXPECT_EQ(team.robot(number).sent, 0);
}

// As published: both are strikers until the nearer one says its claim again.
TEST(Claims, ALostClaimLeavesTwoStrikersUntilItIsSaidAgain) {
  Team team(7);
  team.robot(7).reach = 3000;
  team.robot(4).reach = 2000;
  bool lost = true;
  team.arrives = [&](int sender, int receiver) { return !(lost && sender == 4 && receiver == 7); };
  team.step(3);
  EXPECT_EQ(team.strikers(), (Numbers{4, 7}));
  EXPECT_EQ(team.believed(), (std::set<int>{4, 7}));
  lost = false;
  team.step(18);  // robot 4 claimed at 0.1 s and says it again at 2.1 s
  EXPECT_EQ(team.strikers(), (Numbers{4, 7}));
  team.step(3);
  EXPECT_EQ(team.strikers(), Numbers{4});
}

TEST(Claims, TheNearestIsFoundThroughAnyLoss) {
  std::mt19937 random(7);
  for (const double loss : {0.3, 0.6}) {
    std::bernoulli_distribution lost(loss);
    for (int round = 0; round < 100; ++round) {
      Team team(7);
      for (Team::Robot& each : team.robots) each.reach = static_cast<std::uint32_t>(1000 * (random() % 8));
      for (Team::Robot& each : team.robots) each.sees = false;  // nobody claims for having heard nothing
      team.arrives = [&](int, int) { return !lost(random); };
      team.settings.lapse = 1000.0;  // or a claim falls now and then, of which twelve in a row are lost
      team.step(800);
      ASSERT_EQ(team.strikers(), Numbers{team.nearest()});
      ASSERT_EQ(team.believed(), std::set<int>{team.nearest()});
    }
  }
}

TEST(Claims, WhoHasLostTheBallSaysSoAndWhoSeesItClaims) {
  Team team(5);
  for (Team::Robot& each : team.robots) each.sees = false;
  team.robot(5).reach = 1000;
  team.step(10);
  ASSERT_EQ(team.strikers(), Numbers{5});
  for (Team::Robot& each : team.robots) each.trusts = false;
  team.step(5);
  EXPECT_EQ(team.robot(5).claims.part(), Part::loser);
  EXPECT_EQ(team.robot(5).sent, 2);  // its claim, and that it has lost the ball
  EXPECT_EQ(team.strikers(), Numbers{});
  EXPECT_EQ(team.believed(), std::set<int>{5});  // it keeps the place
  team.step(20);
  EXPECT_EQ(team.robot(5).sent, 2);
  team.robot(2).sees = team.robot(2).trusts = true;
  team.robot(2).reach = 9000;
  team.robot(5).reach = 20000;
  team.step(3);
  EXPECT_EQ(team.strikers(), Numbers{2});
  EXPECT_EQ(team.robot(5).claims.part(), Part::follower);
}

TEST(Claims, ALoserThatSeesTheBallAgainIsStriker) {
  Team team(3);
  team.robot(3).reach = 1000;
  for (Team::Robot& each : team.robots) each.sees = false;
  team.step(5);
  team.robot(3).trusts = false;
  team.step(5);
  ASSERT_EQ(team.robot(3).claims.part(), Part::loser);
  team.robot(3).sees = team.robot(3).trusts = true;
  team.step(3);
  EXPECT_EQ(team.strikers(), Numbers{3});
}

TEST(Claims, AfterTheTimeOutWhoSeesTheBallClaims) {
  Team team(3);
  team.robot(3).reach = 1000;
  team.robot(1).reach = 9000;
  team.robot(1).sees = false;
  team.step(10);
  team.arrives = [](int sender, int) { return sender != 3; };
  team.step(20);
  EXPECT_EQ(team.strikers(), Numbers{3});
  team.step(20);
  EXPECT_EQ(team.strikers(), (Numbers{2, 3}));  // robot 2 hears nothing of robot 3, which is nearer and stays
  EXPECT_EQ(team.robot(1).claims.striker(1), 2);
  EXPECT_EQ(team.robot(1).sent, 0);
}

TEST(Claims, AfterTheWhistleRobotsWaitForTheFirstWord) {
  Team team(3);
  team.playing = false;
  team.step(100);
  EXPECT_EQ(team.strikers(), Numbers{});
  EXPECT_EQ(team.believed(), std::set<int>{3});
  for (const Team::Robot& each : team.robots) EXPECT_EQ(each.sent, 0);
  team.robot(3).trusts = team.robot(3).sees = false;
  team.robot(3).reach = 9000;
  team.playing = true;
  team.step(30);
  EXPECT_EQ(team.strikers(), Numbers{});
  team.step(10);  // and then whoever sees the ball, of whom the nearest and lowest is left
  EXPECT_EQ(team.strikers(), Numbers{1});
  EXPECT_EQ(team.believed(), std::set<int>{1});
  team.playing = false;
  team.step(1);
  EXPECT_EQ(team.believed(), std::set<int>{3});
}

TEST(Claims, WhenTheStrikerLeavesTheHighestNumberIsItUntilSomebodyNearerClaims) {
  Team team(7);
  for (Team::Robot& each : team.robots) each.sees = false;
  team.robot(2).reach = 100;
  team.robot(5).reach = 2000;
  team.step(10);
  ASSERT_EQ(team.strikers(), Numbers{2});
  team.robot(2).plays = false;
  team.step(1);
  EXPECT_EQ(team.strikers(), Numbers{7});
  team.step(5);
  EXPECT_EQ(team.strikers(), Numbers{5});
  team.robot(2).plays = true;
  team.step(25);
  EXPECT_EQ(team.strikers(), Numbers{2});  // it has heard robot 5's claim
  EXPECT_EQ(team.believed(), std::set<int>{2});
}

TEST(Claims, AClaimLapsesWhenItsRobotIsSilent) {
  Team team(4);
  for (Team::Robot& each : team.robots) each.sees = false;
  team.robot(2).reach = 100;
  team.robot(4).reach = 4000;
  team.step(10);
  team.arrives = [](int sender, int) { return sender != 2; };
  team.step(240);
  EXPECT_EQ(team.believed(), std::set<int>{2});
  EXPECT_EQ(team.strikers(), Numbers{2});
  team.step(20);
  EXPECT_EQ(team.strikers(), (Numbers{2, 4}));
}

TEST(Claims, OvertakenAndRepeatedWordsCountForNothing) {
  const auto everybody = [](int) { return true; };
  Claims claims;
  claims.reserve(7);
  Now now{10.0, 3, true, true, 9000, false, true, 7};
  claims.hear(5, {true, 4000, 1}, 9.5, 9.6);
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.striker(3), 5);
  claims.hear(5, {}, 9.3, 9.9);  // an older "lost"
  now.sees_ball = true;
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.part(), Part::follower);
  claims.hear(6, {true, 100, 1}, 9.2, 9.9);  // sent before the claim that is followed
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.striker(3), 5);
  for (const int sender : {0, -1, 8, 1000}) claims.hear(sender, {true, 0, 1}, 99.0, 99.0);
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.striker(3), 5);
  now.reach = 100;
  claims.hear(5, {true, 4000, 1}, 9.5, 9.6);  // a copy
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.part(), Part::follower);
  claims.hear(5, {true, 4000, 1}, 9.9, 10.0);
  claims.decide({}, now, everybody);
  EXPECT_EQ(claims.part(), Part::striker);
  EXPECT_TRUE(claims.has_news());
}

TEST(Claims, WhoCannotBeStrikerIsNone) {
  Team team(3);
  for (Team::Robot& each : team.robots) each.reach = hulks::never;
  team.robot(1).reach = Claims::viable;  // 20 minutes away
  team.step(100);
  EXPECT_EQ(team.strikers(), Numbers{});
  for (const Team::Robot& each : team.robots) EXPECT_EQ(each.sent, 0);
}

// --- Dealing -----------------------------------------------------------------------------------------------------

TEST(Dealing, KeeperFirstAndTheStrikersTaskOut) {
  std::vector<std::uint32_t> order{4, 1, 0, 3, 2};
  const auto left = hulks::order_of_dealing(order, 0, 1);
  EXPECT_EQ(std::vector<std::uint32_t>(left.begin(), left.end()), (std::vector<std::uint32_t>{0, 4, 3, 2}));
  order = {4, 1, 0};
  const auto all = hulks::order_of_dealing(order, -1, -1);
  EXPECT_EQ(std::vector<std::uint32_t>(all.begin(), all.end()), (std::vector<std::uint32_t>{4, 1, 0}));
}

// A row gets nothing that was to be had before by a lower one, and nothing less important than it could have.
TEST(Dealing, DefinitionHoldsOnRandomProblems) {
  std::mt19937 random(8);
  for (int round = 0; round < 10000; ++round) {
    const std::size_t rows = random() % 9, columns = random() % 9;
    std::vector<double> values(rows * columns);
    for (double& each : values) each = random() % 3 == 0 ? hulks::forbidden : 0.0;
    std::vector<std::uint32_t> order;
    for (std::uint32_t j = 0; j < columns; ++j) order.push_back(j);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::int32_t> out(rows, -1);
    std::vector<bool> fixed(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      if (random() % 5 != 0) continue;
      fixed[i] = true;
      out[i] = -2;
      if (!order.empty() && random() % 2 == 0) {
        out[i] = static_cast<std::int32_t>(order.back());
        order.pop_back();
      }
    }
    const std::vector<std::int32_t> before = out;
    hulks::deal({values.data(), rows, columns, columns}, order, out);
    std::vector<bool> free(columns, true);
    for (std::size_t i = 0; i < rows; ++i) {
      if (fixed[i]) {
        ASSERT_EQ(out[i], before[i]);
        continue;
      }
      std::int32_t first = -1;
      for (const std::uint32_t column : order) {
        if (first < 0 && free[column] && values[i * columns + column] == 0.0) first = static_cast<std::int32_t>(column);
      }
      ASSERT_EQ(out[i], first);
      if (first >= 0) free[static_cast<std::size_t>(first)] = false;
    }
  }
}

// --- Own eyes ----------------------------------------------------------------------------------------------------

TEST(OwnEyes, TheHostTells) {
  hulks::OwnEyes eyes;
  eyes.look(10.0, false, 10.0, std::nullopt);  // what looks like an own sighting is none
  EXPECT_FALSE(eyes.saw_within(3.0, 10.0));
  eyes.look(10.1, true, 10.1, 10.1);
  EXPECT_TRUE(eyes.saw_within(3.0, 13.0));
  EXPECT_FALSE(eyes.saw_within(3.0, 13.2));
  eyes.forget();
  EXPECT_FALSE(eyes.saw_within(3.0, 10.1));
}

TEST(OwnEyes, ElseWhatIsNewerThanAllThatWasToldIsAnOwnSighting) {
  hulks::OwnEyes eyes;
  const auto sees = [&](double now, std::optional<double> mine, std::optional<double> common) {
    eyes.look(now, std::nullopt, mine, common);
    return eyes.saw_within(1.0, now);
  };
  EXPECT_FALSE(sees(10.0, std::nullopt, std::nullopt));
  EXPECT_FALSE(sees(10.0, 10.0, 9.8));  // packets round ages
  EXPECT_TRUE(sees(10.0, 10.0, 9.6));
  EXPECT_TRUE(sees(11.0, 11.0, 11.0));
  EXPECT_FALSE(sees(11.1, 11.0, 11.0));
  EXPECT_TRUE(sees(12.0, 11.5, std::nullopt));
}

// --- Words -------------------------------------------------------------------------------------------------------

TEST(Words, AreFourBytesAndKeepWhatIsWritten) {
  std::mt19937 random(9);
  for (std::size_t roles = 1; roles <= 64; ++roles) {
    EXPECT_LE(hulks::word_bytes(roles), 4u);
    for (int round = 0; round < 100; ++round) {
      const Word word{true, static_cast<std::uint32_t>(random() % (hulks::never + 1)),
                      static_cast<int>(random() % roles)};
      std::vector<std::uint8_t> bytes;
      hulks::write(word, roles, bytes);
      ASSERT_EQ(bytes.size(), hulks::word_bytes(roles));
      const auto read = hulks::read(bytes, roles);
      ASSERT_TRUE(read && read->claims);
      ASSERT_EQ(read->time, word.time);
      ASSERT_EQ(read->task, word.task);
      hulks::write({}, roles, bytes);
      ASSERT_TRUE(hulks::read(bytes, roles) && !hulks::read(bytes, roles)->claims);
    }
  }
}

TEST(Words, WhatIsNoWordIsIgnored) {
  std::mt19937 random(10);
  std::vector<std::uint8_t> bytes;
  hulks::write({true, 5000, 11}, 19, bytes);
  EXPECT_FALSE(hulks::read(bytes, 11));  // a task that does not exist
  EXPECT_FALSE(hulks::read({}, 19));
  EXPECT_FALSE(hulks::read(std::vector<std::uint8_t>(3), 19));
  EXPECT_FALSE(hulks::read(std::vector<std::uint8_t>(5), 19));
  EXPECT_FALSE(hulks::read(std::vector<std::uint8_t>{2, 0, 0, 0}, 19));  // a lost ball with a time
  for (int round = 0; round < 10000; ++round) {
    bytes.resize(random() % 7);
    for (std::uint8_t& each : bytes) each = static_cast<std::uint8_t>(random());
    const auto word = hulks::read(bytes, 19);
    if (word && word->claims) {
      ASSERT_LT(word->task, 19);
    }
  }
}

}  // namespace
