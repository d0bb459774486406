// SPDX-License-Identifier: MIT
// The plugin in scenes: which poses count, what silence and losses do, and that a team with one table has one result.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "statement.hpp"

namespace {

using namespace regista::testkit;
using b_human::Statement;
using Rows = std::vector<std::int32_t>;

const Loaded& b_human_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "b_human");
  return plugin;
}

int role(const char* name) { return detail::role_row(usual_roles(), name); }

// A statement of a robot that has the tasks of `scene()`.
std::vector<std::uint8_t> statement(double x, double y, const char* task = nullptr, double ball_x = 0.0,
                                    double ball_age = -1.0, double ball_y = 0.0) {
  Statement said;
  said.x = b_human::millimetres(x);
  said.y = b_human::millimetres(y);
  if (ball_age >= 0.0) {
    said.ball_age = b_human::age_byte(ball_age);
    said.ball_x = b_human::millimetres(ball_x);
    said.ball_y = b_human::millimetres(ball_y);
  }
  if (task != nullptr) said.task = role(task);
  for (const char* each : {"striker", "supporter", "jolly"}) said.add_task(role(each));
  std::vector<std::uint8_t> bytes;
  b_human::write(said, usual_roles().size(), bytes);
  return bytes;
}

// Two tasks that robots 2 and 3 can do; nobody sees a ball.
FrameBuilder scene(double time = 10.0) {
  FrameBuilder frame;
  frame.own(2).time(time).no_ball().robot(2).at(0, 0).robot(3).at(3, 0);
  frame.task("supporter").at(0, 0).task("jolly").at(3, 0);
  return frame;
}

TEST(BHumanPlugin, WhatWasSentCountsNotWhatIsBelieved) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  EXPECT_EQ(assigner.assign(scene().build(), Matrix(2, 2)), (Rows{0, 1}));
  assigner.receive(3, statement(-1, 0), 9.9, 10.0);
  assigner.transmitted(assigner.host().offers.front().handle);  // robot 2 at (0, 0)
  SceneData data = scene(10.1).build().data();
  data.mine.robots[1].pose[0] = -2.0;  // has walked on since
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 2)), (Rows{1, 0}));
}

TEST(BHumanPlugin, BasePointsAreThosePlacesBeforeTheOffset) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  SceneData data = scene().build().data();
  data.tasks[0].after[0] = 3.0;
  data.tasks[1].after[0] = 0.0;
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 2)), (Rows{0, 1}));
}

// Where robot 3 said to be decides who walks where.
TEST(BHumanPlugin, TheNewestStatementCounts) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto result = [&](double time) { return assigner.assign(scene(time).build(), Matrix(2, 2)); };
  assigner.receive(3, statement(-1, 0), 9.0, 10.0);
  EXPECT_EQ(result(10.0), (Rows{1, 0}));
  assigner.receive(3, statement(3, 0), 8.0, 10.0);  // overtaken
  EXPECT_EQ(result(10.1), (Rows{1, 0}));
  assigner.receive(3, statement(3, 0), 9.0, 10.0);  // not newer
  EXPECT_EQ(result(10.2), (Rows{1, 0}));
  assigner.receive(2, statement(3, 0), 9.5, 10.0);  // claims to be oneself
  assigner.receive(8, statement(3, 0), 9.5, 10.0);  // no such robot
  assigner.receive(0, statement(3, 0), 9.5, 10.0);
  assigner.receive(-1, statement(3, 0), 9.5, 10.0);
  assigner.receive(3, std::vector<std::uint8_t>(3), 9.5, 10.0);
  EXPECT_EQ(result(10.3), (Rows{1, 0}));
  assigner.receive(3, statement(3, 0), 9.6, 10.0);
  EXPECT_EQ(result(10.4), (Rows{0, 1}));
  assigner.receive(3, statement(-1, 0), 9.7, 10.0);
  assigner.reset(1);
  EXPECT_EQ(result(10.5), (Rows{0, 1}));
}

// Both stand at the jolly's place, and robot 3 holds it: by 25 s of silence the lower number has it.
TEST(BHumanPlugin, AClaimLapses) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  assigner.receive(3, statement(1, 0, "jolly"), 10.0, 10.0);
  const auto result = [&](double time) {
    SceneData data = scene(time).build().data();
    data.mine.robots[1].pose[0] = 1.0;
    data.tasks.pop_back();
    data.tasks[0].id = role("jolly");
    return assigner.assign(Scene(data), Matrix(2, 1));
  };
  EXPECT_EQ(result(10.0), (Rows{-1, 0}));
  EXPECT_EQ(result(34.9), (Rows{-1, 0}));
  EXPECT_EQ(result(35.1), (Rows{0, -1}));
}

// An offer that did not leave changes nothing; what left holds until the next one leaves.
TEST(BHumanPlugin, WhatWasDroppedWasNotSaid) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto result = [&](double time, double x) {
    SceneData data = scene(time).build().data();
    data.mine.robots[1].pose[0] = x;
    data.mine.robots[2].pose[0] = 2.0;  // robot 3
    return assigner.assign(Scene(data), Matrix(2, 2));
  };
  const auto newest = [&] { return assigner.host().offers.back().handle; };
  EXPECT_EQ(result(10.0, 0.0), (Rows{0, 1}));
  assigner.transmitted(newest());  // as supporter at 0
  EXPECT_EQ(result(10.1, 9.0), (Rows{0, 1}));
  assigner.dropped(newest());
  EXPECT_EQ(result(10.2, 9.0), (Rows{0, 1}));
  assigner.transmitted(newest());  // as supporter at 9
  EXPECT_EQ(result(10.3, 0.0), (Rows{1, 0}));
}

TEST(BHumanPlugin, OneStatementIsPendingAlways) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  for (int tick = 0; tick < 20; ++tick) assigner.assign(scene(10.0 + 0.1 * tick).build(), Matrix(2, 2));
  int waiting = 0;
  for (const auto& each : assigner.host().offers) waiting += each.waits() ? 1 : 0;
  EXPECT_EQ(waiting, 1);
  EXPECT_EQ(assigner.host().offers.back().bytes.size(), b_human::statement_bytes(usual_roles().size()));
  EXPECT_EQ(assigner.describe(assigner.host().offers.back().bytes),
            "at (0.00, 0.00), has seen no ball of late, does supporter");
  EXPECT_EQ(assigner.describe(statement(1.2, -0.4, "jolly", 0.1, 0.3)),
            "at (1.20, -0.40), ball (0.10, 0.00) seen 0.3 s ago, does jolly");
  EXPECT_EQ(assigner.describe({}), "no statement of this team");
}

// --- The active player -----------------------------------------------------------------------------------------------

// Robots 2 and 3 see a ball at (0, 0); robot 2 stands 2.6 m from it, robot 3 as the statement says.
struct Duel {
  Instance assigner{b_human_plugin(), EnvironmentBuilder{}.own(2)};
  FrameBuilder frame;
  Duel() {
    frame.own(2).ball(0, 0).robot(2).at(-2.6, 0).robot(3).at(-2.0, 0);
    frame.task("striker").at(0, 0).required().task("supporter").at(-2, 0);
  }
  int striker(double time) {
    const Rows rows = assigner.assign(frame.time(time).build(), Matrix(2, 2));
    return rows[0] == 0 ? 2 : rows[1] == 0 ? 3 : 0;
  }
};

TEST(BHumanPlugin, LeastTimeToTheBall) {
  Duel duel;
  EXPECT_EQ(duel.striker(10.0), 2);  // robot 3 has said nothing
  duel.assigner.receive(3, statement(-2, 0, nullptr, 0.0, 0.2), 10.0, 10.1);
  EXPECT_EQ(duel.striker(10.1), 3);
  duel.assigner.receive(3, statement(-2, 0, nullptr, 0.0, 1.4), 10.2, 10.3);  // its ball is too old to become
  EXPECT_EQ(duel.striker(10.3), 2);
  duel.assigner.receive(3, statement(-2, 0, "striker", 0.0, 1.4), 10.4, 10.5);  // but not to stay: 7.7 + 2 - 1 s
  EXPECT_EQ(duel.striker(10.5), 3);
  duel.assigner.receive(3, statement(-2, 0, "striker", 0.0, 5.4), 10.6, 10.7);
  EXPECT_EQ(duel.striker(10.7), 2);
  duel.assigner.receive(3, statement(-2, 0), 10.8, 10.9);  // it sees none
  EXPECT_EQ(duel.striker(10.9), 2);
}

// Another ball when its packet is heard: it is ignored, though it is nearer. Both play: overlap by design.
TEST(BHumanPlugin, AGhostBallMakesTwoOfThem) {
  Duel duel;
  duel.assigner.receive(3, statement(-2, 0, "striker", -2.0, 0.0), 10.0, 10.1);
  EXPECT_EQ(duel.striker(10.1), 2);
  duel.assigner.receive(3, statement(-2, 0, "striker", -0.7, 0.0), 10.2, 10.3);
  EXPECT_EQ(duel.striker(10.3), 3);
  duel.frame.ball(3, 0);  // kicked since: no reason to ignore who said where it was
  EXPECT_EQ(duel.striker(10.4), 3);
}

// Robot 3 said to walk to the ball at 0.4 m/s: after 7 s it is believed 1.4 m on.
TEST(BHumanPlugin, TeammatesWalkOnAtHalfTheirSpeed) {
  Duel duel;
  Statement said = *b_human::read(statement(-4, 0, nullptr, 0.0, 0.2), usual_roles().size());
  said.speed = 40;
  std::vector<std::uint8_t> bytes;
  b_human::write(said, usual_roles().size(), bytes);
  duel.assigner.receive(3, bytes, 10.0, 10.1);
  EXPECT_EQ(duel.striker(20.0), 2);  // without a target it stands
  duel.frame.robot(3).target(0, 0);
  EXPECT_EQ(duel.striker(10.2), 2);
  EXPECT_EQ(duel.striker(16.9), 2);
  EXPECT_EQ(duel.striker(17.1), 3);  // nearer than 2.6 m
}

// A robot that lies, and one that sees nothing itself.
TEST(BHumanPlugin, TheOwnStateCounts) {
  Duel duel;
  duel.assigner.receive(3, statement(-2, 0, nullptr, 0.0, 0.2), 10.0, 10.1);
  duel.frame.robot(3).fallen(4.0);
  EXPECT_EQ(duel.striker(10.1), 2);
  duel.frame.ball_age(2.0);  // the last that this robot saw was at 10.1
  EXPECT_EQ(duel.striker(11.0), 2);
  EXPECT_EQ(duel.striker(11.2), 3);
}

TEST(BHumanPlugin, WithoutAnActivePlayerItsTaskIsGivenLikeOthers) {
  Duel duel;
  duel.frame.no_ball();
  EXPECT_EQ(duel.striker(10.0), 3);  // walks of 2 and 0.6 instead of 2.6 and 0
  duel.frame.ball(0, 0);
  Values values(b_human_plugin());
  values.set("active_role", "");
  Instance without(b_human_plugin(), EnvironmentBuilder{}.own(2), values);
  EXPECT_EQ(without.assign(duel.frame.build(), Matrix(2, 2)), (Rows{1, 0}));
}

TEST(BHumanPlugin, AForbiddenRobotIsNoActivePlayer) {
  Duel duel;
  duel.assigner.receive(3, statement(-2, 0, nullptr, 0.0, 0.2), 10.0, 10.1);
  Matrix utilities(2, 2);
  utilities(1, 0) = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(duel.assigner.assign(duel.frame.time(10.1).build(), utilities), (Rows{0, 1}));
}

// --- A team ----------------------------------------------------------------------------------------------------------

// Every robot has its own errors in what it believes of the others, and all have heard all: one table, one result. The
// next packets say what was assigned, and nobody changes any more.
TEST(BHumanPlugin, OneTableOneResult) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> x(-4.0, 4.0), y(-2.5, 2.5), error(-0.5, 0.5);
  for (int round = 0; round < 60; ++round) {
    const int robots = 3 + static_cast<int>(random() % 9);
    std::vector<std::unique_ptr<Instance>> team;
    std::vector<std::pair<double, double>> pose, place;
    for (int n = 1; n <= robots; ++n) {
      team.push_back(std::make_unique<Instance>(b_human_plugin(),
                                                EnvironmentBuilder{}.team_size(static_cast<unsigned>(robots)).own(n)));
      pose.emplace_back(x(random), y(random));
      place.emplace_back(x(random), y(random));
    }
    const auto view = [&](int own, double time) {
      FrameBuilder frame;
      frame.team_size(robots).own(own).time(time).no_ball();
      for (int n = 1; n <= robots; ++n) {
        const auto& [px, py] = pose[static_cast<std::size_t>(n - 1)];
        const double e = n == own ? 0.0 : 1.0;
        frame.robot(n).at(px + e * error(random), py + e * error(random));
      }
      for (int j = 0; j < robots; ++j) {
        const auto& [tx, ty] = place[static_cast<std::size_t>(j)];
        frame.task(j).at(tx, ty);
      }
      return frame.build();
    };
    const Matrix none(static_cast<std::uint32_t>(robots), static_cast<std::uint32_t>(robots));
    Rows first;
    for (double time = 10.0; time < 13.0; time += 1.0) {
      std::vector<std::vector<std::uint8_t>> heard;
      for (int n = 1; n <= robots; ++n) {
        Instance& each = *team[static_cast<std::size_t>(n - 1)];
        const Rows rows = each.assign(view(n, time), none);
        if (time > 10.5) {
          if (first.empty()) first = rows;
          ASSERT_EQ(rows, first) << round << ' ' << n;
        }
        heard.push_back(each.host().offers.back().bytes);
        each.transmitted(each.host().offers.back().handle);
      }
      for (int sender = 1; sender <= robots; ++sender) {
        for (int n = 1; n <= robots; ++n) {
          if (n == sender) continue;
          team[static_cast<std::size_t>(n - 1)]->receive(sender, heard[static_cast<std::size_t>(sender - 1)], time,
                                                         time + 0.1);
        }
      }
    }
  }
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "b_human");

}  // namespace
