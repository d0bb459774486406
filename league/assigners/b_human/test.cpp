// SPDX-License-Identifier: MIT
// The rules alone: the active player in scenes with known answers, positions against all permutations, lists of tasks
// through their bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "active_player.hpp"
#include "extrapolation.hpp"
#include "positions.hpp"
#include "statement.hpp"

namespace {

using namespace b_human;
constexpr double pi = std::numbers::pi;

Candidate at(double x, double y, double heading = 0.0) {
  Candidate out;
  out.pose = {x, y, heading};
  out.knows_ball = true;
  return out;
}

// --- The time to the ball: each part alone -------------------------------------------------------------------------

TEST(ActivePlayer, TimeOfEachPart) {
  const ActiveRule rule;
  EXPECT_EQ(time_to_ball(at(0, 0), {2.6, 0}, rule), 10000);          // 0.26 m/s ahead
  EXPECT_EQ(time_to_ball(at(0, 0), {0, 2.2}, rule), 10000 + 900);    // 0.22 m/s aside, a turn of 90 degrees
  EXPECT_EQ(time_to_ball(at(0, 0), {0, -2.2}, rule), 10000 + 900);   // to either side
  EXPECT_EQ(time_to_ball(at(0, 0), {-2.6, 0}, rule), 10000 + 1800);  // behind
  EXPECT_EQ(time_to_ball(at(0, 0, pi), {-2.6, 0}, rule), 10000);     // the robot frame counts
  EXPECT_EQ(time_to_ball(at(1, 1, 0.3), {1, 1}, rule), 0);           // there
  EXPECT_EQ(time_to_ball(at(0, 0), {2.6, 2.2}, rule),
            std::llround(1000 * (10 * std::sqrt(2.0) + std::atan2(2.2, 2.6) / (100 * pi / 180))));
  Candidate robot = at(0, 0);
  robot.until_up = 3.0;
  EXPECT_EQ(time_to_ball(robot, {2.6, 0}, rule), 13000);
  robot.until_up = 8.0;
  EXPECT_EQ(time_to_ball(robot, {2.6, 0}, rule), 15000);  // up to 5 s
  robot.until_up = 0.0;
  robot.is_active = true;
  EXPECT_EQ(time_to_ball(robot, {2.6, 0}, rule), 9000);
  robot.ball_age = 2.0;
  EXPECT_EQ(time_to_ball(robot, {2.6, 0}, rule), 11000);  // blind
}

std::optional<std::size_t> chosen(const std::vector<Candidate>& all, const Point& ball = {0, 0}) {
  return active_player(all, ball, ActiveRule{});
}

TEST(ActivePlayer, TheHolderKeepsItUnlessAnotherIsMoreThanASecondFaster) {
  std::vector<Candidate> two{at(-2.6, 0), at(-2.6 + 0.9 * 0.26, 0)};
  EXPECT_EQ(chosen(two), 1u);
  two[0].is_active = true;
  EXPECT_EQ(chosen(two), 0u);
  two[1].pose.x = -2.6 + 1.1 * 0.26;
  EXPECT_EQ(chosen(two), 1u);
  two[1].pose.x = -2.6 + 1.0 * 0.26;  // equal: the lower number
  EXPECT_EQ(chosen(two), 0u);
}

TEST(ActivePlayer, AFreshBallMakesItAnOlderOneKeepsIt) {
  std::vector<Candidate> one{at(-1, 0)};
  for (const auto& [age, becomes, stays] :
       {std::tuple{0.0, true, true}, {1.0, true, true}, {1.1, false, true}, {5.0, false, true}, {5.1, false, false}}) {
    one[0].ball_age = age;
    one[0].is_active = false;
    EXPECT_EQ(chosen(one).has_value(), becomes) << age;
    one[0].is_active = true;
    EXPECT_EQ(chosen(one).has_value(), stays) << age;
  }
  one[0] = at(-1, 0);
  one[0].knows_ball = false;
  EXPECT_FALSE(chosen(one));
  EXPECT_FALSE(chosen({}));
}

TEST(ActivePlayer, WhoSeesAnotherBallIsIgnored) {
  const ActiveRule rule;
  EXPECT_DOUBLE_EQ(ball_may_be_off(0.0, rule), 0.78);
  EXPECT_DOUBLE_EQ(ball_may_be_off(2.5, rule), 0.78);
  EXPECT_DOUBLE_EQ(ball_may_be_off(5.0, rule), 1.165);
  EXPECT_DOUBLE_EQ(ball_may_be_off(7.5, rule), 1.55);
  EXPECT_DOUBLE_EQ(ball_may_be_off(20.0, rule), 1.55);
  EXPECT_FALSE(is_another_ball({-1, 0}, {0, 0}, {0.77, 0}, rule));
  EXPECT_TRUE(is_another_ball({-1, 0}, {0, 0}, {0.79, 0}, rule));
  EXPECT_FALSE(is_another_ball({-8, 0}, {0, 0}, {1.54, 0}, rule));
  EXPECT_TRUE(is_another_ball({-8, 0}, {0, 0}, {1.56, 0}, rule));
  std::vector<Candidate> two{at(-3, 0), at(-1, 0)};
  EXPECT_EQ(chosen(two), 1u);
  two[1].ball_is_off = true;
  EXPECT_EQ(chosen(two), 0u);
}

// Against a search that knows nothing but the published numbers; and other numbers of the same robots give the same
// one.
TEST(ActivePlayer, IsTheLeastOfRandomTeams) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-4.0, 4.0), angle(-pi, pi), age(0.0, 7.0);
  int with = 0;
  for (int round = 0; round < 10000; ++round) {
    std::vector<Candidate> team(1 + random() % 7);
    for (Candidate& each : team) {
      each = at(place(random), place(random), angle(random));
      each.ball_age = random() % 2 == 0 ? 0.0 : age(random);
      each.is_active = random() % 4 == 0;
      each.ball_is_off = random() % 5 == 0;
      each.until_up = random() % 6 == 0 ? age(random) : 0.0;
    }
    const Point ball{place(random), place(random)};
    int best = -1;
    double least = 1e9;
    for (std::size_t i = 0; i < team.size(); ++i) {
      const Candidate& c = team[i];
      if (c.ball_is_off || c.ball_age > (c.is_active ? 5.0 : 1.0)) continue;
      const double way = std::hypot(ball.x - c.pose.x, ball.y - c.pose.y);
      const double bearing = std::remainder(std::atan2(ball.y - c.pose.y, ball.x - c.pose.x) - c.pose.heading, 2 * pi);
      const double time = std::hypot(way * std::cos(bearing) / 0.26, way * std::sin(bearing) / 0.22) +
                          std::abs(bearing) * 180 / pi / 100 + std::min(c.until_up, 5.0) +
                          (c.ball_age > 1.0 ? 2.0 : 0.0) - (c.is_active ? 1.0 : 0.0);
      if (time < least - 2e-3) best = static_cast<int>(i);
      if (std::abs(time - least) < 2e-3) best = -2;  // too near to each other to say
      least = std::min(least, time);
    }
    const auto found = chosen(team, ball);
    if (best == -2) continue;
    ASSERT_EQ(found ? static_cast<int>(*found) : -1, best) << round;
    if (!found) continue;
    ++with;
    std::vector<Candidate> turned(team.rbegin(), team.rend());
    ASSERT_EQ(chosen(turned, ball), team.size() - 1 - *found);
  }
  EXPECT_GT(with, 5000);
}

TEST(Extrapolation, HalfTheSpeedAndNotBeyond) {
  const auto along = [](double age) { return walked_on({1, 1}, {4, 5}, 0.2, age); };  // 5 m
  EXPECT_DOUBLE_EQ(along(10).x, 1 + 0.6);
  EXPECT_DOUBLE_EQ(along(10).y, 1 + 0.8);
  EXPECT_EQ(along(0).x, 1);
  for (const double age : {50.0, 51.0, 1e9}) {
    EXPECT_EQ(along(age).x, 4);
    EXPECT_EQ(along(age).y, 5);
  }
  EXPECT_EQ(walked_on({1, 1}, {1, 1}, 0.2, 5).x, 1);
  EXPECT_EQ(walked_on({1, 1}, {4, 5}, 0.0, 5).y, 1);
}

// --- Positions -----------------------------------------------------------------------------------------------------

struct Problem {
  std::vector<Member> members;
  std::vector<TaskList> has;  // who has no bit has all of `tasks`
  std::vector<Position> tasks;
  std::vector<std::uint32_t> order;

  void robot(std::int32_t x, std::int32_t y, std::int32_t task = -1) {
    members.push_back({x, y, task, nullptr});
    has.emplace_back();
  }
  void task(std::int32_t id, double x, double y) { tasks.push_back({id, {x, y}}); }
  std::vector<std::int32_t> solve(std::int32_t bonus = 1000) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (std::ranges::all_of(has[i].bits, [](auto byte) { return byte == 0; })) {
        for (const Position& position : tasks) has[i].add(position.id);
      }
      members[i].has = &has[i];
    }
    order.resize(tasks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::int32_t> out(members.size(), -1);
    Positions positions;
    positions.reserve(members.size(), tasks.size());
    positions.assign(
        members, tasks, [](auto, auto) { return true; }, bonus, order, order, out);
    return out;
  }
};

TEST(Positions, OneMetreForTheHolder) {
  const auto taker = [](std::int32_t nearer_by, std::int32_t holder) {
    Problem p;
    p.robot(2000, 0, holder == 0 ? 5 : -1);
    p.robot(2000 - nearer_by, 0, holder == 1 ? 5 : -1);
    p.task(5, 0, 0);
    return p.solve()[0] == 0 ? 0 : 1;
  };
  EXPECT_EQ(taker(1, -1), 1);
  EXPECT_EQ(taker(999, 0), 0);
  EXPECT_EQ(taker(1000, 0), 0);  // equal: the lower number
  EXPECT_EQ(taker(1001, 0), 1);
  EXPECT_EQ(taker(-999, 1), 1);
  EXPECT_EQ(taker(-1000, 1), 0);
}

TEST(Positions, OfSeveralHoldersTheLowestCounts) {
  Problem p;
  p.robot(2500, 0);
  p.robot(2000, 0, 5);
  p.robot(1500, 0, 5);
  p.task(5, 0, 0);
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{-1, 0, -1}));
  p.members[1].claims = -1;
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{-1, -1, 0}));
}

// Against all permutations.
TEST(Positions, TheLongestWalkIsShortestThenTheNext) {
  std::mt19937 random(17);
  std::uniform_int_distribution<int> place(-4000, 4000), few(-3, 3);
  for (int round = 0; round < 3000; ++round) {
    const bool grid = round % 3 == 0;  // many ties
    const auto somewhere = [&] { return grid ? 1000 * few(random) : place(random); };
    Problem p;
    const std::size_t n = 1 + random() % 6, m = 1 + random() % 6;
    for (std::size_t i = 0; i < n; ++i) {
      p.robot(somewhere(), somewhere(), random() % 2 == 0 ? -1 : static_cast<int>(3 * (random() % m)));
    }
    for (std::size_t j = 0; j < m; ++j) p.task(static_cast<int>(3 * j), somewhere() / 1000.0, somewhere() / 1000.0);
    const std::vector<std::int32_t> found = p.solve();
    // All ways to give the first min(n, m) tasks to robots; of equal ones the first, robots of task 0 ascending.
    const std::size_t taken = std::min(n, m);
    std::vector<std::size_t> robot(n);
    std::iota(robot.begin(), robot.end(), 0u);
    std::vector<long> best;
    std::vector<std::size_t> best_robot;
    do {
      std::vector<long> walks;
      for (std::size_t j = 0; j < taken; ++j) {
        const Member& s = p.members[robot[j]];
        long walk = std::lround(std::hypot(s.x - 1000 * p.tasks[j].base.x, s.y - 1000 * p.tasks[j].base.y));
        const auto holder =
            std::ranges::find_if(p.members, [&](const Member& each) { return each.claims == p.tasks[j].id; });
        if (holder == p.members.begin() + static_cast<std::ptrdiff_t>(robot[j])) walk -= 1000;
        walks.push_back(walk);
      }
      std::ranges::sort(walks, std::greater{});
      const std::vector<std::size_t> first(robot.begin(), robot.begin() + static_cast<std::ptrdiff_t>(taken));
      if (best.empty() || walks < best || (walks == best && first < best_robot)) {
        best = walks;
        best_robot = first;
      }
    } while (std::ranges::next_permutation(robot).found);
    std::vector<std::int32_t> wanted(n, -1);
    for (std::size_t j = 0; j < taken; ++j) wanted[best_robot[j]] = static_cast<std::int32_t>(j);
    ASSERT_EQ(found, wanted) << round;
  }
}

// Robot 1 does not know task 7 and says so; robot 2 says to do task 9, which is not here.
TEST(Positions, TeammatesWithOtherTasks) {
  Problem p;
  p.robot(0, 0);
  p.robot(1000, 0);
  p.task(7, 1, 0);
  p.task(8, 3, 0);
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{0, 1}));
  p.has[1] = {};
  p.has[1].add(8);
  p.members[0].x = 2900;
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{0, 1}));
  p.has[1].add(9);
  p.members[1].claims = 9;
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{0, -1}));
  p.has[1] = {};  // none of these: it will follow
  p.has[1].add(9);
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{1, 0}));
  p.has[1] = {};
  p.has[1].add(8);
  p.members[1].claims = 8;
  EXPECT_EQ(p.solve(), (std::vector<std::int32_t>{0, 1}));
}

// Of whom no list was heard anything is believed, whatever it says to do.
TEST(Positions, TeammatesWithoutAList) {
  for (const std::int32_t claims : {-1, 7, 8, 9}) {
    const std::vector<Position> tasks{{7, {1, 0}}, {8, {3, 0}}};
    const std::vector<Member> members{{2900, 0, -1, nullptr}, {1000, 0, claims, nullptr}};
    const std::vector<std::uint32_t> order{0, 1};
    std::vector<std::int32_t> out(2, -1);
    Positions positions;
    positions.reserve(2, 2);
    positions.assign(
        members, tasks, [](auto, auto) { return true; }, 100, order, order, out);
    EXPECT_EQ(out, (std::vector<std::int32_t>{1, 0})) << claims;
  }
}

// --- Lists of tasks --------------------------------------------------------------------------------------------------

TEST(TaskLists, ComeBackFromTheirBytes) {
  std::mt19937 random(3);
  std::vector<std::uint8_t> bytes;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t roles = 1 + random() % most_roles;
    TaskList tasks;
    std::vector<bool> in(roles);
    for (std::size_t k = 0; k < roles; ++k) {
      if (random() % 3 != 0) continue;
      tasks.add(static_cast<std::int32_t>(k));
      in[k] = true;
    }
    write(tasks, roles, bytes);
    ASSERT_EQ(bytes.size(), (roles + 7) / 8);
    ASSERT_EQ(bytes.size(), statement_bytes(roles));
    const auto back = read(bytes, roles);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->bits, tasks.bits);
    for (std::size_t k = 0; k < roles; ++k) ASSERT_EQ(back->has(static_cast<std::int32_t>(k)), in[k]);
    bytes.push_back(0);
    ASSERT_FALSE(read(bytes, roles));
    bytes.resize(bytes.size() - 2);
    ASSERT_FALSE(read(bytes, roles));
  }
}

TEST(TaskLists, ABitForEachRole) {
  EXPECT_EQ(statement_bytes(1), 1u);
  EXPECT_EQ(statement_bytes(8), 1u);
  EXPECT_EQ(statement_bytes(9), 2u);
  TaskList tasks;
  for (const std::int32_t id : {0, 3, 17}) tasks.add(id);
  std::vector<std::uint8_t> bytes;
  write(tasks, 19, bytes);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x09, 0x00, 0x02}));
}

TEST(TaskLists, RolesThatDoNotExistAreNoList) {
  std::vector<std::uint8_t> bytes;
  write(TaskList{}, 19, bytes);
  EXPECT_TRUE(read(bytes, 19));
  bytes.back() = 0x04;  // bit of role 18
  EXPECT_TRUE(read(bytes, 19));
  bytes.back() = 0x08;  // bit of role 19
  EXPECT_FALSE(read(bytes, 19));
  EXPECT_FALSE(read({}, 19));
  TaskList tasks;
  for (const std::int32_t id : {-1, 254, 255, 256, 100000}) {
    tasks.add(id);
    EXPECT_FALSE(tasks.has(id));
  }
  EXPECT_EQ(tasks.bits, TaskList{}.bits);
}

TEST(TaskLists, Rounding) {
  EXPECT_EQ(millimetres(1.2345), 1235);
  EXPECT_EQ(millimetres(-1e6), -32767);
  EXPECT_EQ(whole_hundredths(0.1 + 0.2 + 0.7 + 1e-12), 1.0);
  EXPECT_EQ(whole_hundredths(0.346), 0.35);
}

}  // namespace
