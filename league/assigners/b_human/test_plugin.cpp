// SPDX-License-Identifier: MIT
// The plugin in scenes: which poses count, what silence and losses do, and that a team with one table has one result.
// What was said the host tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "statement.hpp"

namespace {

using namespace regista::testkit;
using b_human::TaskList;
using Rows = std::vector<std::int32_t>;

const Loaded& b_human_plugin() {
  static const Loaded plugin(REGISTA_PLUGIN_FILE, "b_human");
  return plugin;
}

int role(const char* name) { return detail::role_row(usual_roles(), name); }

using Names = std::initializer_list<const char*>;

std::vector<std::uint8_t> list(Names names) {
  TaskList tasks;
  for (const char* each : names) tasks.add(role(each));
  std::vector<std::uint8_t> bytes;
  b_human::write(tasks, usual_roles().size(), bytes);
  return bytes;
}

// The core of a packet. Without an age no ball.
regista_told_packet packet(double time, double x, double y, const char* task = nullptr, double ball_x = 0.0,
                           double ball_age = -1.0) {
  regista_told_packet out{};
  out.size = sizeof out;
  out.time_sent = time;
  out.pose[0] = out.target[0] = x;
  out.pose[1] = out.target[1] = y;
  out.role = task == nullptr ? -1 : role(task);
  if (ball_age >= 0.0) {
    out.flags = REGISTA_TOLD_BALL;
    out.ball[0] = ball_x;
    out.ball_age = ball_age;
  }
  return out;
}

// The host tells of this packet from now on.
void tell(Instance& robot, int sender, const regista_told_packet& said) {
  auto& told = robot.host().told;
  told.resize(std::max<std::size_t>(told.size(), static_cast<std::size_t>(sender)));
  told[static_cast<std::size_t>(sender - 1)] = said;
}

// A packet of a teammate with its list of tasks arrives.
void hear(Instance& robot, int sender, const regista_told_packet& said,
          Names names = {"striker", "supporter", "jolly"}) {
  tell(robot, sender, said);
  robot.receive(sender, list(names), said.time_sent, said.time_sent + 0.1);
}

std::uint64_t newest_offer(Instance& robot) { return robot.host().offers.back().handle; }

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
  hear(assigner, 3, packet(9.9, -1, 0));
  tell(assigner, 2, packet(10.0, 0, 0));
  SceneData data = scene(10.1).build().data();
  data.mine.robots[1].pose[0] = -2.0;  // has walked on since
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 2)), (Rows{1, 0}));
  // Without an own packet it stands where it is.
  assigner.host().told[1].reset();
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 2)), (Rows{0, 1}));
}

TEST(BHumanPlugin, BasePointsAreThosePlacesBeforeTheOffset) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  SceneData data = scene().build().data();
  data.tasks[0].after[0] = 3.0;
  data.tasks[1].after[0] = 0.0;
  EXPECT_EQ(assigner.assign(Scene(data), Matrix(2, 2)), (Rows{0, 1}));
}

TEST(BHumanPlugin, TheNewestPacketCounts) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto result = [&](double time) { return assigner.assign(scene(time).build(), Matrix(2, 2)); };
  hear(assigner, 3, packet(9.0, -1, 0));
  EXPECT_EQ(result(10.0), (Rows{1, 0}));
  hear(assigner, 3, packet(9.6, 3, 0));
  EXPECT_EQ(result(10.1), (Rows{0, 1}));
  hear(assigner, 3, packet(9.7, -1, 0));
  EXPECT_EQ(result(10.2), (Rows{1, 0}));
  assigner.reset(1);
  assigner.host().told.clear();
  EXPECT_EQ(result(10.3), (Rows{0, 1}));
}

// Which tasks robot 3 has decides who walks where.
TEST(BHumanPlugin, TheNewestListCounts) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto supporter = list({"supporter"}), jolly = list({"jolly"});
  const auto result = [&](double time) { return assigner.assign(scene(time).build(), Matrix(2, 2)); };
  assigner.receive(3, supporter, 9.0, 10.0);
  EXPECT_EQ(result(10.0), (Rows{1, 0}));
  assigner.receive(3, jolly, 8.0, 10.0);  // overtaken
  EXPECT_EQ(result(10.1), (Rows{1, 0}));
  assigner.receive(3, jolly, 9.0, 10.0);  // not newer
  EXPECT_EQ(result(10.2), (Rows{1, 0}));
  assigner.receive(2, supporter, 9.5, 10.0);  // claims to be oneself
  assigner.receive(8, jolly, 9.5, 10.0);      // no such robot
  assigner.receive(0, jolly, 9.5, 10.0);
  assigner.receive(-1, jolly, 9.5, 10.0);
  assigner.receive(3, std::vector<std::uint8_t>(jolly.size() + 1), 9.5, 10.0);
  assigner.receive(3, std::vector<std::uint8_t>(jolly.size(), 255), 9.5, 10.0);  // roles that do not exist
  assigner.receive(3, {}, 9.5, 10.0);
  EXPECT_EQ(result(10.3), (Rows{1, 0}));
  assigner.receive(3, jolly, 9.6, 10.0);
  EXPECT_EQ(result(10.4), (Rows{0, 1}));
  assigner.receive(3, supporter, 9.7, 10.0);
  assigner.reset(1);
  EXPECT_EQ(result(10.5), (Rows{0, 1}));
}

// A packet that has no list of ours, or lost it, tells where its sender is; the list stays, also where there is none.
TEST(BHumanPlugin, APacketWithoutAListLeavesTheOlderOne) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto result = [&](double time) { return assigner.assign(scene(time).build(), Matrix(2, 2)); };
  tell(assigner, 3, packet(9.0, -1, 0));
  EXPECT_EQ(result(9.1), (Rows{1, 0}));
  hear(assigner, 3, packet(9.2, -1, 0), {"jolly"});
  EXPECT_EQ(result(9.3), (Rows{0, 1}));
  tell(assigner, 3, packet(9.4, -1.5, 0));
  EXPECT_EQ(result(9.5), (Rows{0, 1}));
  hear(assigner, 3, packet(9.6, -1.5, 0), {"supporter", "jolly"});
  EXPECT_EQ(result(9.7), (Rows{1, 0}));
}

// What robot 3 says is lost for robot 2: the older table stays in force there, and the two differ until the next
// packet.
TEST(BHumanPlugin, ALostPacketLeavesTheOlderTable) {
  Instance hears(b_human_plugin(), EnvironmentBuilder{}.own(2)), sends(b_human_plugin(), EnvironmentBuilder{}.own(3));
  const auto result = [](Instance& robot, int own, double time) {
    return robot.assign(scene(time).own(own).build(), Matrix(2, 2));
  };
  for (Instance* each : {&hears, &sends}) {
    tell(*each, 2, packet(9.8, 0, 0));
    tell(*each, 3, packet(9.9, -1, 0));
  }
  EXPECT_EQ(result(hears, 2, 10.0), (Rows{1, 0}));
  EXPECT_EQ(result(sends, 3, 10.0), (Rows{1, 0}));
  const regista_told_packet lost = packet(10.0, 3, 0);
  sends.transmitted(newest_offer(sends));
  tell(sends, 3, lost);
  for (int tick = 1; tick <= 100; ++tick) {
    ASSERT_EQ(result(hears, 2, 10.0 + 0.1 * tick), (Rows{1, 0})) << tick;
    ASSERT_EQ(result(sends, 3, 10.0 + 0.1 * tick), (Rows{0, 1})) << tick;
  }
  for (Instance* each : {&hears, &sends}) tell(*each, 3, packet(20.0, 3, 0));
  EXPECT_EQ(result(hears, 2, 20.1), (Rows{0, 1}));
  EXPECT_EQ(result(sends, 3, 20.1), (Rows{0, 1}));
}

// Both stand at the jolly's place, and robot 3 holds it: by 25 s of silence the lower number has it.
TEST(BHumanPlugin, AClaimLapses) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  hear(assigner, 3, packet(10.0, 1, 0, "jolly"));
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

// An offer that did not leave changes nothing: the own list, too, is the one that left last. It knows the supporter's
// task alone at first.
TEST(BHumanPlugin, WhatWasDroppedWasNotSaid) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  const auto result = [&](double time, bool all) {
    SceneData data = scene(time).build().data();
    data.mine.robots[1].pose[0] = 3.0;
    data.mine.robots[2].pose[0] = 0.0;
    if (!all) data.tasks.pop_back();
    return assigner.assign(Scene(data), Matrix(2, all ? 2 : 1));
  };
  const auto newest = [&] { return newest_offer(assigner); };
  EXPECT_EQ(result(10.0, false), (Rows{-1, 0}));
  assigner.transmitted(newest());  // has the supporter's task
  EXPECT_EQ(result(10.1, true), (Rows{0, 1}));
  assigner.dropped(newest());
  EXPECT_EQ(result(10.2, true), (Rows{0, 1}));
  assigner.transmitted(newest());  // has both
  EXPECT_EQ(result(10.3, true), (Rows{1, 0}));
}

TEST(BHumanPlugin, OneListIsPendingAlways) {
  Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2));
  for (int tick = 0; tick < 20; ++tick) assigner.assign(scene(10.0 + 0.1 * tick).build(), Matrix(2, 2));
  int waiting = 0;
  for (const auto& each : assigner.host().offers) waiting += each.waits() ? 1 : 0;
  EXPECT_EQ(waiting, 1);
  const std::vector<std::uint8_t>& bytes = assigner.host().offers.back().bytes;
  EXPECT_EQ(bytes.size(), (usual_roles().size() + 7) / 8);
  EXPECT_EQ(bytes, list({"supporter", "jolly"}));
  EXPECT_EQ(assigner.describe(bytes), "has the tasks supporter, jolly");
  EXPECT_EQ(assigner.describe(list({"striker"})), "has the tasks striker");
  EXPECT_EQ(assigner.describe(list({})), "has no tasks");
  EXPECT_EQ(assigner.describe({}), "no list of tasks of this team");
}

TEST(BHumanPlugin, AByteForEightRoles) {
  for (const std::size_t roles : {1u, 7u, 8u, 9u, 16u, 27u}) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < roles; ++k) names.push_back("role_" + std::to_string(k));
    Instance assigner(b_human_plugin(), EnvironmentBuilder{}.own(2).roles(names));
    FrameBuilder frame;
    frame.own(2).roles(names).no_ball().robot(2).at(0, 0).task(static_cast<int>(roles) - 1).at(1, 0);
    assigner.assign(frame.build(), Matrix(1, 1));
    EXPECT_EQ(assigner.host().offers.back().bytes.size(), (roles + 7) / 8) << roles;
  }
}

TEST(BHumanPlugin, AHostThatTellsNothingCannotHaveIt) {
  regista_descriptor alone = b_human_plugin().descriptor();
  alone.create = [](const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
    regista_host without = *host;
    without.extension = [](void*, const char*) -> const void* { return nullptr; };
    return b_human_plugin().descriptor().create(environment, &without, values, error);
  };
  try {
    Instance assigner(Loaded(alone), EnvironmentBuilder{}.own(2));
    FAIL() << "it was created";
  } catch (const CallFailed& failure) {
    EXPECT_EQ(std::string(failure.what()), "create: needs a host with the extension regista.told/0");
  }
}

// --- The active player -----------------------------------------------------------------------------------------------

// Robots 2 and 3 see a ball at (0, 0); robot 2 stands 2.6 m from it, robot 3 as its packets say.
struct Duel {
  Instance assigner{b_human_plugin(), EnvironmentBuilder{}.own(2)};
  FrameBuilder frame;
  Duel() {
    frame.own(2).ball(0, 0).robot(2).at(-2.6, 0).robot(3).at(-2.0, 0);
    frame.task("striker").at(0, 0).required().task("supporter").at(-2, 0);
    assigner.host().sees_ball = true;
  }
  int striker(double time) {
    const Rows rows = assigner.assign(frame.time(time).build(), Matrix(2, 2));
    return rows[0] == 0 ? 2 : rows[1] == 0 ? 3 : 0;
  }
};

TEST(BHumanPlugin, LeastTimeToTheBall) {
  Duel duel;
  EXPECT_EQ(duel.striker(10.0), 2);  // robot 3 has said nothing
  hear(duel.assigner, 3, packet(10.0, -2, 0, nullptr, 0.0, 0.2));
  EXPECT_EQ(duel.striker(10.1), 3);
  hear(duel.assigner, 3, packet(10.2, -2, 0, nullptr, 0.0, 1.4));  // its ball is too old to become
  EXPECT_EQ(duel.striker(10.3), 2);
  hear(duel.assigner, 3, packet(10.4, -2, 0, "striker", 0.0, 1.4));  // but not to stay: 7.7 + 2 - 1 s
  EXPECT_EQ(duel.striker(10.5), 3);
  hear(duel.assigner, 3, packet(10.6, -2, 0, "striker", 0.0, 5.4));
  EXPECT_EQ(duel.striker(10.7), 2);
  hear(duel.assigner, 3, packet(10.8, -2, 0));  // it sees none
  EXPECT_EQ(duel.striker(10.9), 2);
}

// Another ball when its packet is heard: it is ignored, though it is nearer. Both play: overlap by design.
TEST(BHumanPlugin, AGhostBallMakesTwoOfThem) {
  Duel duel;
  hear(duel.assigner, 3, packet(10.0, -2, 0, "striker", -2.0, 0.0));
  EXPECT_EQ(duel.striker(10.1), 2);
  hear(duel.assigner, 3, packet(10.2, -2, 0, "striker", -0.7, 0.0));
  EXPECT_EQ(duel.striker(10.3), 3);
  duel.frame.ball(3, 0);  // kicked since: no reason to ignore who said where it was
  EXPECT_EQ(duel.striker(10.4), 3);
}

// Robot 3 said to walk to the ball at 0.4 m/s: after 7 s it is believed 1.4 m on.
TEST(BHumanPlugin, TeammatesWalkOnAtHalfTheirSpeed) {
  Duel duel;
  regista_told_packet said = packet(10.0, -4, 0, nullptr, 0.0, 0.2);
  said.velocity[0] = 0.32;
  said.velocity[1] = -0.24;
  hear(duel.assigner, 3, said);
  EXPECT_EQ(duel.striker(20.0), 2);  // where it said to stay
  said.target[0] = 0.0;
  tell(duel.assigner, 3, said);
  duel.frame.robot(3).target(-4, 0);  // what is believed does not count
  EXPECT_EQ(duel.striker(10.2), 2);
  EXPECT_EQ(duel.striker(16.9), 2);
  EXPECT_EQ(duel.striker(17.1), 3);  // nearer than 2.6 m
}

// A robot that lies, and one that sees nothing itself.
TEST(BHumanPlugin, TheOwnStateCounts) {
  Duel duel;
  hear(duel.assigner, 3, packet(10.0, -2, 0, nullptr, 0.0, 0.2));
  duel.frame.robot(3).fallen(4.0);
  EXPECT_EQ(duel.striker(10.1), 2);
  duel.frame.ball_age(2.0);
  duel.assigner.host().sees_ball = false;  // the last that this robot saw was at 10.1
  EXPECT_EQ(duel.striker(11.0), 2);
  EXPECT_EQ(duel.striker(11.1), 2);  // 1 s
  EXPECT_EQ(duel.striker(11.2), 3);
}

// The ball that robot 3 has just told of is new, and not of the own eyes.
TEST(BHumanPlugin, OnlyTheOwnEyesSee) {
  for (const bool sees : {true, false}) {
    Duel duel;
    duel.assigner.host().sees_ball = sees;
    duel.frame.ball_age(sees ? 0.2 : 0.0);
    hear(duel.assigner, 3, packet(10.0, -3, 0, nullptr, 0.0, 0.0));
    EXPECT_EQ(duel.striker(10.1), sees ? 2 : 3);
  }
}

TEST(BHumanPlugin, WithoutAnActivePlayerItsTaskIsGivenLikeOthers) {
  Duel duel;
  duel.frame.no_ball();
  EXPECT_EQ(duel.striker(10.0), 3);  // walks of 2 and 0.6 instead of 2.6 and 0
  duel.frame.ball(0, 0);
  Values values(b_human_plugin());
  values.set("active_role", "");
  Instance without(b_human_plugin(), EnvironmentBuilder{}.own(2), values);
  without.host().sees_ball = true;
  EXPECT_EQ(without.assign(duel.frame.build(), Matrix(2, 2)), (Rows{1, 0}));
}

TEST(BHumanPlugin, AForbiddenRobotIsNoActivePlayer) {
  Duel duel;
  hear(duel.assigner, 3, packet(10.0, -2, 0, nullptr, 0.0, 0.2));
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
      std::vector<regista_told_packet> said;
      std::vector<std::vector<std::uint8_t>> lists;
      for (int n = 1; n <= robots; ++n) {
        Instance& each = *team[static_cast<std::size_t>(n - 1)];
        const Rows rows = each.assign(view(n, time), none);
        if (time > 10.5) {
          if (first.empty()) first = rows;
          ASSERT_EQ(rows, first) << round << ' ' << n;
        }
        const auto& [px, py] = pose[static_cast<std::size_t>(n - 1)];
        said.push_back(packet(time, px, py));
        said.back().role = rows[static_cast<std::size_t>(n - 1)];  // ids are columns here
        lists.push_back(each.host().offers.back().bytes);
        each.transmitted(newest_offer(each));
      }
      for (int sender = 1; sender <= robots; ++sender) {
        const auto k = static_cast<std::size_t>(sender - 1);
        for (int n = 1; n <= robots; ++n) {
          Instance& each = *team[static_cast<std::size_t>(n - 1)];
          tell(each, sender, said[k]);
          if (n != sender) each.receive(sender, lists[k], time, time + 0.1);
        }
      }
    }
  }
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "b_human");

}  // namespace
