// SPDX-License-Identifier: MIT
// The rules of token passing where nothing is lost: what one robot does, and what a team comes to.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "test_team.hpp"

namespace {

using namespace token_passing;

// --- One token ---------------------------------------------------------------------------------------------------

TEST(Tokens, WhoIsAbleEnoughKeepsWhatItMade) {
  Team team(5, 1, {}, 1);
  team.tasks = make_tasks({{1000, 1000, 1000, 1000, 700}});
  only_seen_by(team, only(5), 0);
  team.settings.stagger = 0.0;
  team.play(2.0);
  EXPECT_EQ(one_holder(team, 0), 5);
  EXPECT_EQ(team.does(5), 0);
  EXPECT_EQ(team.passes, 0);
  EXPECT_EQ(team.newest(0)->creator, 5);
}

TEST(Tokens, ElseTheBestPredictedTeammateGetsIt) {
  Team team(5, 1, {}, 1);
  team.tasks = make_tasks({{750, 990, 800, 990, 699}});
  team.settings.stagger = 0.0;
  only_seen_by(team, only(5), 0);
  team.step();
  EXPECT_EQ(team.newest(0)->holder, 2);  // of equal ones the lower number
  EXPECT_EQ(team.newest(0)->visited, only(5));
}

TEST(Tokens, AtThresholdZeroTheCreatorKeeps) {
  std::mt19937 random(1);
  for (int round = 0; round < 1000; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    Settings settings;
    settings.threshold = 0;
    settings.foresight = random() % 2 == 0;
    Team team(robots, 1, settings, static_cast<std::uint32_t>(round));
    team.tasks = random_tasks(robots, 1, random);
    team.play(3.0);
    ASSERT_EQ(one_holder(team, 0), 1);
    ASSERT_EQ(team.does(1), 0);
    ASSERT_EQ(team.passes, 0);
  }
}

// Nobody is able enough until the threshold has fallen to the best capability.
TEST(Tokens, TheThresholdFallsUntilSomebodyKeeps) {
  std::mt19937 random(2);
  for (const bool foresight : {true, false}) {
    for (int round = 0; round < 500; ++round) {
      const int robots = 3 + static_cast<int>(random() % 9);
      Settings settings;
      settings.foresight = foresight;
      Team team(robots, 1, settings, static_cast<std::uint32_t>(round));
      team.tasks = random_tasks(robots, 1, random);
      for (std::int32_t& each : team.tasks.capability[0]) each /= 2;
      team.play(0.2 * robots * (settings.rounds() + 1) + 1.0);
      const auto& able = team.tasks.capability[0];
      const std::int32_t best = *std::ranges::max_element(able);
      const int keeper = one_holder(team, 0);
      ASSERT_GE(keeper, 1);
      ASSERT_EQ(team.does(keeper), 0);
      const int reached = settings.threshold_of(settings.round_of(best));
      ASSERT_GE(able[static_cast<std::size_t>(keeper - 1)], reached) << "another one reaches the threshold " << reached;
    }
  }
}

// Without foresight and with nobody able: every robot is visited once in every round.
TEST(Tokens, ARoundVisitsEveryRobotAtMostOnce) {
  std::mt19937 random(3);
  int full_rounds = 0;
  for (int round = 0; round < 300; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9), tasks = 1 + static_cast<int>(random() % 4);
    Settings settings;
    settings.foresight = false;
    settings.takeover = static_cast<Takeover>(random() % 3);
    settings.rest = 1000.0;
    Team team(robots, tasks, settings, static_cast<std::uint32_t>(round));
    team.tasks = random_tasks(robots, tasks, random);
    for (auto& row : team.tasks.capability) {
      for (std::int32_t& each : row) each /= 1 + static_cast<int>(random() % 10);
    }
    using Round = std::tuple<int, int, int, int>;  // token, generation, creator, round
    std::map<Round, std::vector<int>> visits;
    for (int tick = 0; tick < 150; ++tick) {
      team.step();
      for (int id = 0; id < tasks; ++id) {
        const Token* token = team.newest(id);
        if (token == nullptr || token->kept) continue;
        auto& holders = visits[{id, token->generation, token->creator, token->round}];
        if (holders.empty() || holders.back() != token->holder) holders.push_back(token->holder);
      }
    }
    for (const auto& [key, holders] : visits) {
      const std::set<int> different(holders.begin(), holders.end());
      // The one that begins the round may get the token back at its end.
      ASSERT_LE(holders.size(), different.size() + 1) << "team " << round;
      ASSERT_LE(holders.size(), static_cast<std::size_t>(robots) + 1) << "team " << round;  // so many passes + 1
      full_rounds += different.size() + 1 >= static_cast<std::size_t>(robots);              // and the one that began it
    }
  }
  EXPECT_GT(full_rounds, 100);
}

TEST(Tokens, OfTwoCreatorsTheLowerNumberIsLeft) {
  std::mt19937 random(4);
  int both = 0;
  for (int round = 0; round < 2000; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    Settings settings;
    settings.stagger = 0.0;
    Team team(robots, 1, settings, static_cast<std::uint32_t>(round));
    team.radio.most_delay = 0.4;
    team.tasks = make_tasks({std::vector<std::int32_t>(static_cast<std::size_t>(robots), 900)});
    Robots creators = 0;
    while (std::popcount(creators) < 2)
      creators |= only(1 + static_cast<int>(random() % static_cast<unsigned>(robots)));
    only_seen_by(team, creators, 0);
    team.step();
    both += team.holders(0).size() == 2;
    team.play(1.5);
    ASSERT_EQ(one_holder(team, 0), 1 + std::countr_zero(creators));
    for (int number = 1; number <= robots; ++number) {
      ASSERT_EQ(team.robot(number).token(0)->holder, 1 + std::countr_zero(creators));
    }
  }
  EXPECT_EQ(both, 2000);
}

TEST(Tokens, ATaskForTwoRobotsHasTwoTokens) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    Team team(robots, 4, {}, static_cast<std::uint32_t>(round));
    team.tasks = random_tasks(robots, 1, random);
    team.tasks.ids = {1, 3};
    team.tasks.importance = {0, 0};
    team.tasks.capability.push_back(team.tasks.capability[0]);
    team.play(6.0);
    ASSERT_EQ(team.doers(1).size(), 1u);
    ASSERT_EQ(team.doers(3).size(), 1u);
    ASSERT_NE(team.doers(1), team.doers(3));
  }
}

// --- Changes -----------------------------------------------------------------------------------------------------

TEST(Tokens, ATaskIsGivenUpBelowTheThresholdIfAnotherOneIsAbler) {
  Team team(3, 1, {}, 1);
  team.tasks = make_tasks({{800, 100, 100}});
  team.play(2.0);
  EXPECT_EQ(team.does(1), 0);
  team.tasks = make_tasks({{600, 1000, 100}});  // as much below as it may be
  team.play(2.0);
  EXPECT_EQ(team.does(1), 0);
  team.tasks = make_tasks({{599, 1000, 100}});
  team.play(2.0);
  EXPECT_EQ(team.does(2), 0);
  team.tasks = make_tasks({{100, 350, 100}});  // nobody is better: it keeps the task at a lower threshold
  team.play(2.0);
  EXPECT_EQ(team.does(2), 0);
  EXPECT_EQ(team.newest(0)->round, 4);
  team.tasks = make_tasks({{100, 650, 100}});  // the threshold rises with it
  team.play(2.0);
  EXPECT_EQ(team.newest(0)->round, 1);
}

TEST(Tokens, AMoreImportantTaskDisplacesALessImportantOne) {
  for (const Takeover takeover : {Takeover::never, Takeover::last, Takeover::always}) {
    Settings settings;
    settings.takeover = takeover;
    Team team(3, 4, settings, 1);
    team.tasks.ids = {0, 1, 2};
    team.tasks.importance = {1, 2, 3};
    team.tasks.capability.assign(3, {900, 900, 900});
    team.play(2.0);
    // All are busy; robot 1 makes the token.
    team.tasks.ids.insert(team.tasks.ids.begin(), 3);
    team.tasks.importance.insert(team.tasks.importance.begin(), 0);
    team.tasks.capability.insert(team.tasks.capability.begin(), {100, 200, 950});
    team.play(3.0);
    const bool never = takeover == Takeover::never;
    EXPECT_EQ(team.doers(3).size(), never ? 0u : 1u);
    EXPECT_EQ(team.doers(2).size(), never ? 1u : 0u) << "the least important one is open";
    for (const int id : {0, 1}) EXPECT_EQ(team.doers(id).size(), 1u);
    for (const int id : {0, 1, 2, 3}) EXPECT_GE(one_holder(team, id), 1);
    if (takeover == Takeover::always) {
      EXPECT_EQ(team.does(3), 3) << "the ablest, although it had a task";
    }
  }
}

TEST(Tokens, ATaskThatIsGoneIsDoneAndBeginsANewGenerationWhenItIsBack) {
  Settings settings;
  settings.gone_after = 1.0;
  Team team(4, 1, settings, 1);
  const Tasks all = make_tasks({{100, 100, 900, 100}});
  team.tasks = all;
  team.play(2.0);
  EXPECT_EQ(team.does(3), 0);
  team.tasks = {};
  team.play(0.5);
  EXPECT_EQ(team.does(3), Robot::none);
  team.tasks = all;  // soon back: the token has kept its holder
  team.play(0.2);
  EXPECT_EQ(team.does(3), 0);
  EXPECT_EQ(team.newest(0)->generation, 1);
  team.tasks = {};
  team.play(2.0);
  for (int number = 1; number <= 4; ++number) EXPECT_TRUE(team.robot(number).token(0)->done);
  EXPECT_TRUE(team.robot(3).told().empty());
  team.tasks = all;
  team.play(2.0);
  EXPECT_EQ(team.does(3), 0);
  EXPECT_EQ(team.newest(0)->generation, 2);
}

TEST(Tokens, WhoDoesNotKnowTheTaskPassesItOn) {
  Team team(4, 1, {}, 1);
  team.tasks = make_tasks({{100, 900, 100, 500}});
  only_seen_by(team, ~only(2), 0);
  team.play(10.0);
  EXPECT_EQ(team.does(4), 0);
  only_seen_by(team, 0, 0);  // nobody knows it any more
  team.play(10.0);
  EXPECT_TRUE(team.newest(0)->done);
}

// Robot 2 held it, and says that it is done.
TEST(Tokens, WhoSaysThatAPerceivedTaskIsDoneIsNotAskedAtOnce) {
  Settings settings;
  settings.gone_after = 1.0;
  settings.rest = 5.0;
  Team team(4, 1, settings, 1);
  const Tasks for_2 = make_tasks({{100, 900, 100, 500}});
  team.tasks = for_2;
  team.play(2.0);
  EXPECT_EQ(team.does(2), 0);
  only_seen_by(team, ~only(2), 0);
  team.play(1.3);
  EXPECT_EQ(team.does(4), 0);
  EXPECT_EQ(team.newest(0)->generation, 2);
  // All lose it: nobody who says so is to blame.
  team.seen_by = nullptr;
  team.tasks = {};
  team.play(1.5);
  EXPECT_TRUE(team.newest(0)->done);
  team.tasks = make_tasks({{100, 500, 100, 900}});
  team.play(0.5);
  EXPECT_EQ(team.does(4), 0);
}

TEST(Tokens, TheLowestRobotMakesTheTokenOfOneThatLeftAnew) {
  std::mt19937 random(6);
  for (int round = 0; round < 500; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    Team team(robots, 1, {}, static_cast<std::uint32_t>(round));
    team.tasks = random_tasks(robots, 1, random);
    team.play(3.0);
    const int holder = one_holder(team, 0);
    ASSERT_GE(holder, 1);
    const int generation = team.newest(0)->generation;
    team.members &= ~only(holder);
    team.step();
    ASSERT_EQ(team.newest(0)->creator, holder == 1 ? 2 : 1);
    ASSERT_EQ(team.newest(0)->generation, generation + 1);
    team.play(3.0);
    const int next = one_holder(team, 0);
    ASSERT_GE(next, 1);
    ASSERT_NE(next, holder);
    ASSERT_EQ(team.doers(0), std::vector<int>{next});
    team.members |= only(holder);  // who returns has forgotten, and does not claim it
    team.play(6.0);
    ASSERT_EQ(one_holder(team, 0), next);
    ASSERT_EQ(team.newest(0)->generation, generation + 1);
  }
}

TEST(Tokens, WhoReturnsHasForgottenWhatItHeld) {
  Team team(3, 1, {}, 1);
  team.tasks = make_tasks({{900, -1, -1}});  // nobody else may
  team.play(2.0);
  ASSERT_EQ(team.does(1), 0);
  team.members &= ~only(1);
  team.play(3.0);
  EXPECT_EQ(team.newest(0)->generation, 1);  // nobody could take it
  team.members |= only(1);
  team.play(1.0);
  EXPECT_EQ(team.does(1), Robot::none);  // it listens
  team.play(1.5);
  EXPECT_EQ(team.does(1), 0);
  EXPECT_EQ(team.newest(0)->generation, 2);
}

TEST(Tokens, APacketThatWasOvertakenIsDropped) {
  Robot robot;
  robot.reserve(3, 2);
  Told first, second;
  first.id = 0;
  second.id = 1;
  first.token = second.token = {.generation = 1, .creator = 2, .holder = 2, .kept = true};
  robot.hear(1, 2, std::vector{first}, 5.0, 5.1, false);
  robot.hear(1, 2, std::vector{second}, 4.9, 5.2, false);
  EXPECT_NE(robot.token(0), nullptr);
  EXPECT_EQ(robot.token(1), nullptr);
  robot.hear(1, 3, std::vector{second}, 4.9, 5.2, false);  // of another robot it is the newest
  EXPECT_NE(robot.token(1), nullptr);
}

TEST(Tokens, SilenceLosesAToken) {
  Settings settings;
  settings.silence = 5.0;
  Team team(4, 1, settings, 1);
  team.tasks = make_tasks({{100, 100, 900, 100}});
  team.play(2.0);
  ASSERT_EQ(team.does(3), 0);
  // It still plays for all that the others know, but is not heard.
  team.radio_off = only(3);
  team.play(4.5);
  EXPECT_EQ(team.newest(0)->generation, 1);
  team.play(1.0);
  EXPECT_EQ(team.newest(0)->generation, 2);
  EXPECT_EQ(team.newest(0)->creator, 1);
}

TEST(Tokens, WhoIsCutOffTakesNothingAwayThatItWouldNotDo) {
  Team team(4, 3, {}, 1);
  team.tasks = make_tasks({{900, 100, 100, 100}, {100, 900, 100, 100}, {100, 100, 900, 100}});
  team.play(3.0);
  team.deaf = only(1);  // does the most important one, and gives up all others; they give it up
  team.play(40.0);
  EXPECT_EQ(team.does(1), 0);
  EXPECT_EQ(team.does(2), 1);
  EXPECT_EQ(team.does(3), 2);
  EXPECT_EQ(team.does(4), 0);  // whoever had none
  for (const int id : {1, 2}) EXPECT_EQ(team.robot(1).token(id)->generation, 1);
  team.deaf = 0;
  team.play(5.0);
  EXPECT_EQ(team.does(1), Robot::none);
  for (const int id : {0, 1, 2}) EXPECT_EQ(team.doers(id).size(), 1u);
}

// --- A whole team ------------------------------------------------------------------------------------------------

// As many tokens as tasks, each with one holder: at every moment at most one after the first exchange, none for no
// longer than a packet needs.
TEST(Tokens, AreConserved) {
  std::mt19937 random(7);
  for (int round = 0; round < 700; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9), tasks = 1 + static_cast<int>(random() % 13);
    Settings settings;
    settings.foresight = random() % 4 != 0;
    settings.takeover = static_cast<Takeover>(random() % 3);
    Team team(robots, tasks, settings, static_cast<std::uint32_t>(round));
    const bool some_forbidden = random() % 2 == 0;
    team.tasks = random_tasks(robots, tasks, random, some_forbidden);
    std::vector<int> nowhere(static_cast<std::size_t>(tasks), 0);
    std::vector<Token> before(static_cast<std::size_t>(tasks));
    const auto watch = [&](int ticks, int from) {
      for (int tick = 0; tick < ticks; ++tick) {
        team.step();
        for (int id = 0; tick >= from && id < tasks; ++id) {
          const std::vector<int> holders = team.holders(id);
          ASSERT_LE(holders.size(), 1u) << "team " << round;
          // A token that is passed on as soon as it arrives is seen at no robot; then it moves at every tick.
          const auto i = static_cast<std::size_t>(id);
          const bool moves = !(*team.newest(id) == before[i]);
          before[i] = *team.newest(id);
          nowhere[i] = holders.empty() && !moves ? nowhere[i] + 1 : 0;
          ASSERT_LE(nowhere[i], 1) << "team " << round << " token " << id;
        }
      }
    };
    watch(60, 1);
    if (some_forbidden) continue;
    for (int id = 0; settings.foresight && id < tasks; ++id) ASSERT_GE(one_holder(team, id), 1) << "team " << round;
    if (settings.foresight) {
      int doing = 0;
      for (int number = 1; number <= robots; ++number) doing += team.does(number) != Robot::none;
      ASSERT_EQ(doing, std::min(robots, tasks)) << "team " << round;
    }
    if (!settings.foresight || tasks > robots - 1) continue;
    // One leaves: its tokens are made anew. It returns: nothing is doubled.
    const int left = 1 + static_cast<int>(random() % static_cast<unsigned>(robots));
    team.members &= ~only(left);
    watch(40, 1);
    for (int id = 0; id < tasks; ++id) ASSERT_EQ(team.doers(id).size(), 1u) << "team " << round;
    team.members |= only(left);
    watch(40, 1);
    for (int id = 0; id < tasks; ++id) ASSERT_EQ(team.doers(id).size(), 1u) << "team " << round;
  }
}

// Where robot 1 makes all tokens, and all believe the same, its passes are an assignment that can be said in a few
// lines: task by task, at the highest threshold at which it or a free teammate is able enough; it comes first.
TEST(Tokens, OneCreatorAssignsAsTheRulesSay) {
  std::mt19937 random(8);
  for (int round = 0; round < 1000; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9), tasks = 1 + static_cast<int>(random() % 13);
    Settings settings;
    settings.takeover = Takeover::never;
    settings.threshold = static_cast<int>(random() % 11) * 100;
    settings.step = 70 + static_cast<int>(random() % 3) * 100;
    Team team(robots, tasks, settings, static_cast<std::uint32_t>(round));
    team.tasks = random_tasks(robots, tasks, random, true);
    team.play(1.0);
    std::vector<int> does(static_cast<std::size_t>(robots), Robot::none);
    for (int id = 0; id < tasks; ++id) {
      const auto& able = team.tasks.capability[static_cast<std::size_t>(id)];
      int taker = 0;
      for (int threshold = settings.threshold;; threshold -= settings.step) {
        const int least = std::max(threshold, 0);
        for (int number = 1; number <= robots; ++number) {
          const std::size_t i = static_cast<std::size_t>(number - 1);
          if (does[i] != Robot::none || able[i] < least) continue;
          if (taker == 0 || (taker != 1 && able[i] > able[static_cast<std::size_t>(taker - 1)])) taker = number;
        }
        if (taker != 0 || threshold <= 0) break;
      }
      if (taker != 0) does[static_cast<std::size_t>(taker - 1)] = id;
    }
    for (int number = 1; number <= robots; ++number) {
      ASSERT_EQ(team.does(number), does[static_cast<std::size_t>(number - 1)]) << "team " << round;
    }
  }
}

}  // namespace
