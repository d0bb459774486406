// SPDX-License-Identifier: MIT
// Whole teams of negotiators: what they play at rest against every permutation, and that no two play one role where no
// packet is lost; what becomes of silence, loss, absence and double roles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "negotiator.hpp"

namespace {

using namespace role_exchange;
using Roles = std::vector<std::int32_t>;

Settings plain() {
  Settings settings;
  settings.keep_bonus = settings.dead_band = 0.0;
  return settings;
}

// A team, its utilities in steps (robots x tasks), and what each robot wrongly believes of those of the others.
class Team {
 public:
  Team(std::size_t robots, std::size_t tasks, const Settings& settings = plain())
      : robots_(robots), tasks_(tasks), members_(robots), ids_(tasks), columns_(tasks), truth(robots * tasks, 0.0) {
    std::iota(members_.begin(), members_.end(), 1);
    std::iota(ids_.begin(), ids_.end(), 0);
    std::iota(columns_.begin(), columns_.end(), 0u);
    minds_.resize(robots);
    for (std::size_t k = 0; k < robots; ++k) minds_[k].reserve(settings, static_cast<int>(k) + 1, robots, tasks);
    claims_.assign(robots, no_role);
    claimed_.assign(robots, -100.0);
  }

  Negotiator& mind(std::size_t robot) { return minds_[robot]; }
  void leave(std::int32_t number) { std::erase(members_, number); }
  void come_back(std::int32_t number) {
    members_.push_back(number);
    std::ranges::sort(members_);
  }
  void claim(std::size_t robot, std::int32_t role) {
    claims_[robot] = role;
    claimed_[robot] = time;
  }

  void decide(std::size_t robot) {
    std::vector<double> values;
    for (const std::int32_t number : members_) {
      for (std::size_t task = 0; task < tasks_; ++task) {
        const auto other = static_cast<std::size_t>(number - 1);
        const double steps = other == robot || !believes_wrongly
                                 ? truth[other * tasks_ + task]
                                 : static_cast<double>((7 * other + 13 * task + 29 * robot) % 256);
        values.push_back(steps / 255.0);
      }
    }
    minds_[robot].decide({.time = time,
                          .members = members_,
                          .tasks = ids_,
                          .choice = columns_,
                          .order = columns_,
                          .utilities = {values.data(), members_.size(), tasks_, tasks_},
                          .claims = claims_,
                          .claimed = claimed_,
                          .begins = false,
                          .own_role = no_role});
  }
  void decide() {
    for (std::size_t robot = 0; robot < robots_; ++robot) decide(robot);
  }
  // One packet, and all decide.
  template <class Arrives>
  void speak(std::size_t robot, const Arrives& arrives) {
    time += 0.1;
    decide(robot);
    if (!minds_[robot].speaks()) return;
    const std::vector<std::uint8_t> bytes(minds_[robot].message().begin(), minds_[robot].message().end());
    minds_[robot].sent(bytes);
    for (std::size_t other = 0; other < robots_; ++other) {
      if (other != robot && arrives()) minds_[other].hear(static_cast<int>(robot) + 1, bytes, time);
    }
    decide();
  }
  void speak(std::size_t robot) {
    speak(robot, [] { return true; });
  }

  Roles roles() const {
    Roles out;
    for (const Negotiator& mind : minds_) out.push_back(mind.role());
    return out;
  }
  // Of the truth, with the lowest robots for ties.
  Roles best() const {
    BestPermutation solver;
    std::vector<double> values;
    for (const std::int32_t number : members_) {
      for (std::size_t task = 0; task < tasks_; ++task) {
        values.push_back(truth[static_cast<std::size_t>(number - 1) * tasks_ + task]);
      }
    }
    Roles rows(members_.size()), out(robots_, no_role);
    solver.find({values.data(), members_.size(), tasks_, tasks_}, columns_, columns_, rows);
    for (std::size_t row = 0; row < rows.size(); ++row) out[static_cast<std::size_t>(members_[row] - 1)] = rows[row];
    return out;
  }

 private:
  std::size_t robots_, tasks_;
  std::vector<std::int32_t> members_, ids_, claims_;
  std::vector<std::uint32_t> columns_;
  std::vector<double> claimed_;
  std::vector<Negotiator> minds_;

 public:
  std::vector<double> truth;
  double time = 0.0;
  bool believes_wrongly = false;
};

int doubles(const Roles& roles) {
  int count = 0;
  for (std::size_t a = 0; a < roles.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) count += roles[a] != no_role && roles[a] == roles[b] ? 1 : 0;
  }
  return count;
}

// A packet of each in any order, `rounds` times; `each` after every packet.
template <class Arrives, class Each>
void talk(Team& team, std::size_t robots, int rounds, std::mt19937& random, const Arrives& arrives, const Each& each) {
  std::vector<std::size_t> order(robots);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t robot : order) {
      team.speak(robot, arrives);
      each();
    }
  }
}

constexpr auto always = [] { return true; };

// The team begins in agreement, then all utilities change at once, again and again. With fewer tasks than robots some
// role may be free for a moment, and two take it, for that needs nobody's consent: until they have told.
TEST(RoleExchangeTeam, WithoutLossNoRoleIsDoubleAndRestIsTheBestPermutation) {
  std::mt19937 random(31);
  int changed = 0;
  for (int round = 0; round < 400; ++round) {
    const std::size_t robots = 3 + random() % 5;
    const std::size_t tasks = round % 4 == 0 ? robots - 1 : round % 4 == 1 ? robots + 2 : robots;
    Team team(robots, tasks);
    const auto redraw = [&] {
      for (double& each : team.truth) each = static_cast<double>(random() % 256);
    };
    redraw();
    team.decide();
    ASSERT_EQ(team.roles(), team.best());  // all believe the same: nothing has to be said
    talk(team, robots, 1, random, always, [] {});
    team.believes_wrongly = true;
    for (int change = 0; change < 3; ++change) {
      redraw();
      const Roles before = team.roles();
      talk(team, robots, 3, random, always, [&] {
        if (tasks >= robots) {
          ASSERT_EQ(doubles(team.roles()), 0) << "round " << round << ", change " << change;
        }
      });
      ASSERT_EQ(team.roles(), team.best()) << "round " << round << ", change " << change;
      changed += before != team.roles() ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 1000);
}

// Strangers at first, half of the packets lost; once all are heard again, they rest at the best permutation.
TEST(RoleExchangeTeam, RecoversFromLoss) {
  std::mt19937 random(32);
  for (int round = 0; round < 300; ++round) {
    const std::size_t robots = 3 + random() % 5;
    Team team(robots, robots);
    team.believes_wrongly = true;
    for (double& each : team.truth) each = static_cast<double>(random() % 256);
    const auto coin = [&] { return random() % 2 == 0; };
    talk(team, robots, 4, random, coin, [] {});
    talk(team, robots, 5, random, always, [] {});
    ASSERT_EQ(team.roles(), team.best()) << "round " << round;
  }
}

TEST(RoleExchangeTeam, OthersTakeOverFromOneWhoLeavesAndGiveBack) {
  std::mt19937 random(33);
  for (int round = 0; round < 200; ++round) {
    const std::size_t robots = 4 + random() % 4;
    Team team(robots, robots);
    for (double& each : team.truth) each = static_cast<double>(random() % 256);
    talk(team, robots, 2, random, always, [] {});
    const auto left = static_cast<std::int32_t>(1 + random() % robots);
    team.leave(left);
    talk(team, robots, 3, random, always, [] {});
    ASSERT_EQ(team.roles(), team.best());
    ASSERT_EQ(team.roles()[static_cast<std::size_t>(left - 1)], no_role);
    team.come_back(left);
    talk(team, robots, 4, random, always, [] {});
    ASSERT_EQ(team.roles(), team.best());
  }
}

// Three robots with the roles 0, 1, 2 that have told so; then each would do the next one's better.
Team circle() {
  Team team(3, 3);
  for (const std::size_t k : {0u, 1u, 2u}) team.truth[k * 3 + k] = 100.0;
  team.decide();
  for (const std::size_t k : {0u, 1u, 2u}) team.speak(k);
  for (const std::size_t k : {0u, 1u, 2u}) team.truth[k * 3 + (k + 1) % 3] = 200.0;
  return team;
}

TEST(RoleExchangeTeam, ACircleOfThreeTurnsWhenTheLastHasWished) {
  Team team = circle();
  team.believes_wrongly = true;  // they learn of the others' utilities from packets alone
  // The first to speak knows of no better one than its own, and stays; the others wish when two or three have told.
  for (const std::size_t k : {0u, 1u, 2u}) {
    team.speak(k);
    EXPECT_EQ(team.roles(), (Roles{0, 1, 2}));
  }
  EXPECT_TRUE(team.mind(0).completes_change());
  team.speak(0);
  EXPECT_EQ(team.roles(), (Roles{1, 2, 0}));
}

TEST(RoleExchangeTeam, WhatWasSaidBinds) {
  Team team(2, 2);
  team.truth = {100, 0, 0, 100};
  team.decide();
  team.speak(0);
  team.speak(1);
  EXPECT_EQ(team.roles(), (Roles{0, 1}));
  team.truth = {0, 200, 200, 0};
  team.speak(0);
  EXPECT_EQ(team.mind(0).wish(), 1);  // said; nobody else has wished yet
  EXPECT_EQ(team.roles(), (Roles{0, 1}));
  EXPECT_TRUE(team.mind(1).completes_change());
  team.truth[0] = 255;  // robot 1 has another mind by now, and has not said so
  team.truth[1] = 0;
  team.speak(1);
  EXPECT_EQ(team.roles(), (Roles{1, 0}));
  EXPECT_EQ(doubles(team.roles()), 0);
}

TEST(RoleExchangeTeam, WhoseWishIsNotKnownStays) {
  Team team(2, 2);
  team.believes_wrongly = false;
  team.truth = {200, 0, 100, 0};
  team.claim(1, 0);  // robot 2 claims role 0 by other ways, and says nothing
  team.decide(0);
  EXPECT_EQ(team.mind(0).wish(), 0);
  EXPECT_EQ(team.mind(0).role(), no_role);  // role 1 is robot 2's by the permutation
  team.time = 4.9;
  team.decide(0);
  EXPECT_EQ(team.mind(0).role(), no_role);
  team.time = 5.0;
  team.decide(0);
  EXPECT_EQ(team.mind(0).role(), 1);  // patience is over
}

TEST(RoleExchangeTeam, AHolderUnheardForTwentyFiveSecondsHoldsNothing) {
  Team team(2, 2);
  team.truth = {0, 50, 100, 0};
  team.decide();
  team.speak(0);
  team.speak(1);
  EXPECT_EQ(team.roles(), (Roles{1, 0}));
  const double heard = team.time;
  team.truth = {255, 0, 100, 0};
  team.time = heard + 24.9;
  team.decide(0);
  EXPECT_EQ(team.mind(0).role(), 1);
  EXPECT_EQ(team.mind(0).wish(), 0);
  team.time = heard + 25.1;
  team.decide(0);
  EXPECT_EQ(team.mind(0).role(), 0);
}

std::vector<std::uint8_t> statement(std::int32_t role, std::int32_t wish, std::vector<std::int16_t> utilities) {
  std::vector<std::uint8_t> bytes;
  write_statement({role, wish, std::move(utilities)}, bytes);
  return bytes;
}

TEST(RoleExchangeTeam, TheLowerUtilityYieldsADoubleRole) {
  for (const std::int16_t other : std::array<std::int16_t, 3>{199, 200, 201}) {
    Team team(2, 2);
    team.truth = {200, 20, 0, 0};
    team.decide();
    team.speak(0);
    ASSERT_EQ(team.mind(0).role(), 0);
    team.mind(0).hear(2, statement(0, 0, {other, 150}), team.time);
    team.truth[0] = other > 200 ? 255 : 180;  // what it was when it was told counts
    team.decide(0);
    EXPECT_EQ(team.mind(0).role(), other > 200 ? no_role : 0) << other;  // equal: the lower number keeps it
  }
}

TEST(RoleExchangeTeam, OnlyTheNewestStatementCounts) {
  Team team(2, 2);
  team.truth = {100, 100, 0, 0};
  team.mind(0).hear(2, statement(0, 0, {255, 0}), 5.0);
  team.mind(0).hear(2, statement(1, 1, {0, 255}), 4.0);  // was overtaken
  team.mind(0).hear(2, statement(1, 1, {0, 255}), 5.0);  // the same packet again
  team.mind(0).hear(0, statement(1, 1, {0, 255}), 6.0);  // nobody's
  team.mind(0).hear(3, statement(1, 1, {0, 255}), 6.0);
  team.mind(0).hear(1, statement(1, 1, {0, 255}), 6.0);  // the own
  team.time = 6.0;
  team.decide(0);
  EXPECT_EQ(team.mind(0).role(), 1);
}

TEST(RoleExchangeTeam, TheBonusKeepsRolesAndTheDeadBandWishes) {
  Settings settings = plain();
  settings.keep_bonus = 20.0 / 255.0;
  settings.dead_band = 10.0 / 255.0;
  Team team(2, 2, settings);
  team.truth = {100, 100, 100, 100};
  team.decide();
  for (const std::size_t k : {0u, 1u}) team.speak(k);
  EXPECT_EQ(team.roles(), (Roles{0, 1}));
  team.truth = {100, 135, 100, 100};  // 35 better by the exchange; two bonuses are 40
  for (const std::size_t k : {0u, 1u, 0u, 1u}) team.speak(k);
  EXPECT_EQ(team.roles(), (Roles{0, 1}));
  team.truth[1] = 144;  // 9 more: within the band, told as before
  for (const std::size_t k : {0u, 1u, 0u, 1u}) team.speak(k);
  EXPECT_EQ(team.roles(), (Roles{0, 1}));
  team.truth[1] = 146;
  for (const std::size_t k : {0u, 1u, 0u, 1u}) team.speak(k);
  EXPECT_EQ(team.roles(), (Roles{1, 0}));
}

}  // namespace
