// SPDX-License-Identifier: MIT
// Teams on random connected networks in which all speak to their neighbours at once, round by round: they end at the
// greedy assignment, in as many rounds as the paper promises, and that is worth half of the best at least.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "test_problems.hpp"

namespace {

using namespace consensus_bundle;
using namespace consensus_bundle::test;

struct Network {
  std::vector<std::vector<char>> linked;
  std::size_t diameter = 1;
};

Network random_network(Random& random, std::size_t robots) {
  Network out{std::vector<std::vector<char>>(robots, std::vector<char>(robots, 0)), 1};
  const auto link = [&](std::size_t a, std::size_t b) { out.linked[a][b] = out.linked[b][a] = a != b ? 1 : 0; };
  for (std::size_t k = 1; k < robots; ++k) link(k, below(random, k));
  for (std::size_t more = below(random, robots + 1); more > 0; --more)
    link(below(random, robots), below(random, robots));
  std::vector<std::vector<std::size_t>> far(robots, std::vector<std::size_t>(robots, robots));
  for (std::size_t a = 0; a < robots; ++a) {
    for (std::size_t b = 0; b < robots; ++b) {
      if (a == b) far[a][b] = 0;
      if (out.linked[a][b] != 0) far[a][b] = 1;
    }
  }
  for (std::size_t k = 0; k < robots; ++k) {
    for (std::size_t a = 0; a < robots; ++a) {
      for (std::size_t b = 0; b < robots; ++b) far[a][b] = std::min(far[a][b], far[a][k] + far[k][b]);
    }
  }
  for (const auto& row : far) out.diameter = std::max(out.diameter, std::ranges::max(row));
  return out;
}

enum class Way { published, rebuilt };

// Round after round, all decide and speak, then all hear.
void play_round(std::vector<Consensus>& team, const Problem& problem, const Network& network, Way way,
                std::int64_t round) {
  for (std::size_t k = 0; k < team.size(); ++k) {
    const auto gain = [&](auto path, std::uint32_t task) { return problem.gain(k, path, task); };
    way == Way::published ? team[k].extend(problem.limit, gain) : team[k].rebuild(problem.limit, gain);
  }
  std::vector<Told> packets;
  for (std::size_t k = 0; k < team.size(); ++k) packets.push_back(packet_of(team[k], static_cast<int>(k) + 1, round));
  for (std::size_t k = 0; k < team.size(); ++k) {
    for (std::size_t other = 0; other < team.size(); ++other) {
      if (network.linked[k][other] != 0) team[k].hear(packets[other]);
    }
  }
}

struct Tally {
  int problems = 0, greedy = 0, late = 0;
};

Tally play(Gains gains, Way way, std::size_t limit, int problems, unsigned seed) {
  Random random(seed);
  Tally out;
  for (; out.problems < problems; ++out.problems) {
    const Problem problem = random_problem(random, gains, limit);
    const Network network = random_network(random, problem.robots);
    const auto bundles = greedy(problem);
    std::vector<Consensus> team = team_for(problem);
    const std::size_t promised = std::min(problem.tasks, problem.robots * limit) * network.diameter;
    std::size_t settled = 1;  // first round from which on all say the same
    for (std::size_t round = 1; round <= promised + 8; ++round) {
      play_round(team, problem, network, way, static_cast<std::int64_t>(round));
      if (!all_say(team, bundles)) settled = round + 1;
    }
    if (settled <= promised + 8) ++out.greedy;
    if (settled > promised && settled <= promised + 8) ++out.late;
  }
  return out;
}

TEST(Networks, OneTaskEachEndsAtTheGreedyAssignmentInTime) {
  for (const Way way : {Way::published, Way::rebuilt}) {
    const Tally tally = play(Gains::additive, way, 1, 4000, 21);
    EXPECT_EQ(tally.greedy, tally.problems);
    EXPECT_EQ(tally.late, 0);
  }
}

TEST(Networks, BundlesEndAtTheGreedyAssignmentInTime) {
  for (const std::size_t limit : {2u, 3u, 4u}) {
    for (const Gains gains : {Gains::additive, Gains::covering}) {
      const Tally tally = play(gains, Way::rebuilt, limit, 1500, 22);
      EXPECT_EQ(tally.greedy, tally.problems) << limit;
      EXPECT_EQ(tally.late, 0) << limit;
    }
    const Tally published = play(Gains::additive, Way::published, limit, 1500, 23);
    EXPECT_EQ(published.greedy, published.problems) << limit;
    EXPECT_EQ(published.late, 0) << limit;
  }
}

// What a robot may not have: gains that grow. Its bids fall along the bundle all the same, so that the team settles.
TEST(Networks, GainsThatGrowAreCutAndTheTeamSettles) {
  for (const std::size_t limit : {2u, 4u}) {
    const Tally tally = play(Gains::growing, Way::rebuilt, limit, 1500, 26);
    EXPECT_EQ(tally.greedy, tally.problems) << limit;  // of these some a few rounds late
  }
}

// Where it matters which tasks a robot has, who only adds to the bundle may keep a task that it took while a better one
// looked taken. If this fails, the remark at the head of consensus.hpp is out of date.
TEST(Networks, WhoOnlyAddsMayEndBesideTheGreedyAssignment) {
  const Tally published = play(Gains::covering, Way::published, 2, 6000, 24);
  EXPECT_LT(published.greedy, published.problems);
  EXPECT_GT(published.greedy, published.problems * 99 / 100);
  const Tally rebuilt = play(Gains::covering, Way::rebuilt, 2, 6000, 24);
  EXPECT_EQ(rebuilt.greedy, rebuilt.problems);
}

// The best worth of what is left, robot by robot and set of tasks by set of tasks.
std::uint64_t best_worth(const Problem& problem) {
  const std::size_t sets = std::size_t{1} << problem.tasks;
  std::vector<std::uint64_t> best(sets, 0);  // of the robots so far, by the tasks that they may have
  for (std::size_t robot = 0; robot < problem.robots; ++robot) {
    std::vector<std::uint64_t> own(sets, 0);  // with additive gains the order in which tasks are added does not matter
    for (std::size_t set = 1; set < sets; ++set) {
      std::vector<std::uint32_t> path;
      std::uint64_t sum = 0;
      bool can = true;
      for (std::uint32_t task = 0; task < problem.tasks; ++task) {
        if ((set >> task & 1u) == 0) continue;
        const std::uint32_t gain = problem.gain(robot, path, task).value;
        can = can && gain > 0;
        sum += gain;
        path.push_back(task);
      }
      if (can && path.size() <= problem.limit) own[set] = sum;
    }
    std::vector<std::uint64_t> with(best);
    for (std::size_t set = 1; set < sets; ++set) {
      for (std::size_t part = set; part != 0; part = (part - 1) & set) {
        with[set] = std::max(with[set], best[set & ~part] + own[part]);
      }
    }
    best = with;
  }
  return best.back();
}

TEST(Networks, HalfOfTheBestAtLeast) {
  Random random(25);
  double least = 1.0;
  for (int k = 0; k < 2000; ++k) {
    Problem problem = random_problem(random, Gains::additive, 1 + below(random, 3), 4, 5);
    for (auto& row : problem.alone) {
      for (std::uint32_t& each : row) each = below(random, 3) == 0 ? 1 : each;  // one robot alone can do much of it
    }
    const Network network = random_network(random, problem.robots);
    std::vector<Consensus> team = team_for(problem);
    for (std::int64_t round = 1; round <= 40; ++round) play_round(team, problem, network, Way::published, round);
    std::vector<std::vector<std::uint32_t>> bundles;
    for (const Consensus& each : team) bundles.emplace_back(each.bundle().begin(), each.bundle().end());
    ASSERT_TRUE(all_say(team, bundles));  // nobody has what another has
    const std::uint64_t got = worth(problem, bundles), best = best_worth(problem);
    ASSERT_LE(got, best);
    ASSERT_GE(2 * got, best);
    if (best > 0) least = std::min(least, static_cast<double>(got) / static_cast<double>(best));
  }
  EXPECT_LT(least, 0.8);  // greedy is not always best, and this saw it
}

TEST(Networks, TenOfEighteen) {
  Problem problem{Gains::additive, 2, 2, 1, {{10, 9}, {9, 0}}, {{1, 1}, {1, 1}}};
  EXPECT_EQ(best_worth(problem), 18u);
  Network network{{{0, 1}, {1, 0}}, 1};
  std::vector<Consensus> team = team_for(problem);
  for (std::int64_t round = 1; round <= 2; ++round) play_round(team, problem, network, Way::published, round);
  const std::vector<std::vector<std::uint32_t>> bundles{{0}, {}};
  EXPECT_TRUE(all_say(team, bundles));
  EXPECT_EQ(worth(problem, bundles), 10u);
}

}  // namespace
