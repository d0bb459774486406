// SPDX-License-Identifier: MIT
// What tests of auctions share: random problems, the best that any assignment could reach, and a team of participants
// over a radio that loses, delays, repeats and reorders, and that not all robots can hear.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "participant.hpp"
#include "price_table.hpp"

namespace auction_test {

using auction::Bid, auction::may_not;

inline unsigned below(std::mt19937& random, unsigned end) { return static_cast<unsigned>(random() % end); }

// Robots take at most one task of each group and `most` in all.
struct Problem {
  std::size_t robots = 0, tasks = 0, most = 1;
  std::vector<std::int32_t> values;  // robots x tasks, or may_not
  std::vector<std::int32_t> groups;  // of tasks
  std::int32_t largest = 0;
  std::int32_t value(std::size_t robot, std::size_t task) const { return values[robot * tasks + task]; }
};

// forbidden: share of pairs that must not be, in tenths.
inline Problem random_problem(std::mt19937& random, std::size_t most_robots, std::size_t most_tasks,
                              std::int32_t largest, unsigned forbidden, std::size_t groups = 1, std::size_t most = 1) {
  Problem out;
  out.robots = 1 + random() % most_robots;
  out.tasks = 1 + random() % most_tasks;
  out.most = most;
  out.largest = largest;
  for (std::size_t k = 0; k < out.robots * out.tasks; ++k) {
    const bool may = random() % 10 >= forbidden;
    out.values.push_back(may ? static_cast<std::int32_t>(random() % static_cast<unsigned>(largest + 1)) : may_not);
  }
  for (std::size_t task = 0; task < out.tasks; ++task) {
    out.groups.push_back(static_cast<std::int32_t>(random() % groups));
  }
  return out;
}

// Returns the largest sum of values that any allocation has: a flow of greatest value, found by successive longest
// paths. A robot is a node that lets `most` tasks through, a pair of robot and group lets one through, and so does a
// task. The search ends where no path adds value. counts: the robots that take part; empty: all.
inline std::int64_t best_sum(const Problem& problem, const std::vector<char>& counts = {}) {
  struct Edge {
    std::size_t to;
    int room;
    std::int64_t gain;
  };
  std::vector<Edge> edges;  // k and k ^ 1 are each other's reverse
  std::vector<std::vector<std::size_t>> of(2);
  const auto node = [&] {
    of.emplace_back();
    return of.size() - 1;
  };
  const auto connect = [&](std::size_t from, std::size_t to, int room, std::int64_t gain) {
    of[from].push_back(edges.size());
    edges.push_back({to, room, gain});
    of[to].push_back(edges.size());
    edges.push_back({from, 0, -gain});
  };
  constexpr std::size_t source = 0, sink = 1;
  std::vector<std::size_t> task_nodes;
  for (std::size_t task = 0; task < problem.tasks; ++task) {
    task_nodes.push_back(node());
    connect(task_nodes.back(), sink, 1, 0);
  }
  const std::set<std::int32_t> groups(problem.groups.begin(), problem.groups.end());
  for (std::size_t robot = 0; robot < problem.robots; ++robot) {
    if (!counts.empty() && !counts[robot]) continue;
    const std::size_t self = node();
    connect(source, self, static_cast<int>(problem.most), 0);
    for (const std::int32_t group : groups) {
      const std::size_t one = node();
      connect(self, one, 1, 0);
      for (std::size_t task = 0; task < problem.tasks; ++task) {
        if (problem.groups[task] != group || problem.value(robot, task) == may_not) continue;
        connect(one, task_nodes[task], 1, problem.value(robot, task));
      }
    }
  }
  constexpr std::int64_t unreached = std::numeric_limits<std::int64_t>::min() / 2;
  std::int64_t sum = 0;
  while (true) {
    std::vector<std::int64_t> gain(of.size(), unreached);
    std::vector<std::size_t> by(of.size(), 0);
    gain[source] = 0;
    for (bool better = true; better;) {
      better = false;
      for (std::size_t from = 0; from < of.size(); ++from) {
        if (gain[from] == unreached) continue;
        for (const std::size_t k : of[from]) {
          if (edges[k].room == 0 || gain[from] + edges[k].gain <= gain[edges[k].to]) continue;
          gain[edges[k].to] = gain[from] + edges[k].gain;
          by[edges[k].to] = k;
          better = true;
        }
      }
    }
    if (gain[sink] <= 0) return sum;
    sum += gain[sink];
    for (std::size_t at = sink; at != source; at = edges[by[at] ^ 1].to) {
      --edges[by[at]].room;
      ++edges[by[at] ^ 1].room;
    }
  }
}

struct Radio {
  unsigned loss = 0;         // percent, of each packet on each link
  unsigned longest_gap = 1;  // rounds: of so many packets in a row on a link one arrives at least
  unsigned delay = 0;        // rounds, at most; later packets may overtake
  unsigned repeats = 0;      // percent of packets that arrive twice
  std::vector<char> hears;   // receiver x sender; empty: all hear all
};

template <class Rule>
class Team {
 public:
  Team(const Problem& problem, const Rule& rule, std::uint32_t epsilon, const Radio& radio, unsigned seed)
      : problem_(problem),
        rule_(rule),
        radio_(radio),
        random_(seed),
        format_(auction::Format::fitting(static_cast<std::int32_t>(problem.robots), problem.tasks,
                                         static_cast<std::uint32_t>(problem.largest) + epsilon, false, 200)),
        is_active_(problem.robots + 1, 1),
        is_listed_(problem.tasks, 1),
        lost_(problem.robots * problem.robots, 0),
        told_(problem.robots) {
    for (std::size_t task = 0; task < problem.tasks; ++task) tasks_.push_back(static_cast<std::uint32_t>(task));
    for (std::size_t robot = 0; robot < problem.robots; ++robot) {
      members.emplace_back().setup(static_cast<std::int32_t>(robot + 1), problem.robots, problem.tasks);
      told_[robot].assign(problem.tasks, Bid{});
    }
  }

  // Every robot decides once, in any order, and sends a packet. True: a table has changed.
  bool round() {
    std::vector<std::size_t> order(members.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), random_);
    bool changed = false;
    for (const std::size_t robot : order) changed = turn(robot) || changed;
    ++rounds;
    return changed;
  }

  // The turn of one robot: it hears what has arrived, decides, speaks. Returns whether its bids have changed.
  bool turn(std::size_t robot) {
    auction::Participant<Rule>& self = members[robot];
    const std::vector<Bid> before(self.table().begin(), self.table().end());
    std::vector<Packet> later;
    for (const Packet& packet : on_their_way_) {
      if (packet.receiver != robot || packet.arrives > rounds) {
        later.push_back(packet);
        continue;
      }
      std::uint8_t epoch = 0;
      std::vector<auction::Told> told;
      EXPECT_TRUE(read_message(format_, packet.bytes, epoch, told));
      self.hear(static_cast<std::int32_t>(packet.sender + 1), epoch, told, static_cast<double>(rounds));
    }
    on_their_way_ = std::move(later);
    self.decide(situation(robot), {0, 1e9}, rule_);  // no claim lapses: some are never heard of but by others
    const bool changed = !std::ranges::equal(before, self.table());
    expect_rules_kept(robot);
    speak(robot);
    return changed;
  }

  bool agree() const {
    return std::ranges::all_of(
        members, [&](const auto& each) { return std::ranges::equal(each.table(), members.front().table()); });
  }

  std::vector<auction::Participant<Rule>> members;
  std::size_t rounds = 0, bids = 0;
  bool prices_fell = false;

 private:
  struct Packet {
    std::size_t arrives, sender, receiver;
    std::vector<std::uint8_t> bytes;
  };

  auction::Situation situation(std::size_t robot) const {
    auction::Situation out;
    out.now = static_cast<double>(rounds);
    out.plays = true;
    out.is_active = is_active_;
    out.robots = problem_.robots;
    out.tasks = tasks_;
    out.values = std::span(problem_.values).subspan(robot * problem_.tasks, problem_.tasks);
    out.groups = problem_.groups;
    out.is_listed = is_listed_;
    return out;
  }

  // What a robot holds after its decision, whatever the others know by then.
  void expect_rules_kept(std::size_t robot) const {
    std::vector<std::int32_t> groups;
    for (std::size_t task = 0; task < problem_.tasks; ++task) {
      if (members[robot].table()[task].bidder != static_cast<std::int32_t>(robot + 1)) continue;
      EXPECT_NE(problem_.value(robot, task), may_not);
      EXPECT_EQ(std::ranges::count(groups, problem_.groups[task]), 0) << "two tasks of a group";
      groups.push_back(problem_.groups[task]);
    }
    EXPECT_LE(groups.size(), problem_.most);
  }

  void speak(std::size_t robot) {
    auction::Participant<Rule>& self = members[robot];
    std::vector<auction::Told> told;
    for (std::size_t task = 0; task < problem_.tasks; ++task) {
      const Bid bid = self.table()[task];
      Bid& last = told_[robot][task];
      if (is_above(last, bid)) prices_fell = true;
      if (bid != last && bid.bidder == static_cast<std::int32_t>(robot + 1)) ++bids;
      last = bid;
      if (bid.price > 0) told.push_back({task, bid, false});
    }
    std::vector<std::uint8_t> bytes;
    write_message(format_, self.epoch(), told, bytes);
    self.sent();
    for (std::size_t receiver = 0; receiver < members.size(); ++receiver) {
      if (receiver == robot) continue;
      const std::size_t link = receiver * members.size() + robot;
      if (!radio_.hears.empty() && !radio_.hears[link]) continue;
      unsigned& lost = lost_[link];
      if (random_() % 100 < radio_.loss && lost + 1 < radio_.longest_gap) {
        ++lost;
        continue;
      }
      lost = 0;
      const int copies = random_() % 100 < radio_.repeats ? 2 : 1;
      for (int k = 0; k < copies; ++k) {
        on_their_way_.push_back({rounds + random_() % (radio_.delay + 1), robot, receiver, bytes});
      }
    }
  }

  const Problem& problem_;
  Rule rule_;
  Radio radio_;
  std::mt19937 random_;
  auction::Format format_;
  std::vector<std::uint32_t> tasks_;
  std::vector<char> is_active_, is_listed_;
  std::vector<unsigned> lost_;
  std::vector<std::vector<Bid>> told_;  // by robot, then task
  std::vector<Packet> on_their_way_;
};

// Plays until nothing changes any more. `spread`: rounds after which whatever was sent has been heard by all. Returns
// the round of the last change.
template <class Rule>
std::size_t play(Team<Rule>& team, std::size_t spread = 1) {
  constexpr std::size_t most_rounds = 100000;
  std::size_t last_change = 0;
  while (team.rounds < last_change + spread + 1 && team.rounds < most_rounds) {
    if (team.round()) last_change = team.rounds;
  }
  EXPECT_LT(team.rounds, most_rounds);
  return last_change;
}

struct Outcome {
  std::int64_t sum = 0;
  std::size_t filled = 0;
};

// What a table assigns; that nobody gave a task up is expected. `of_group`: only these tasks.
inline Outcome outcome(const Problem& problem, std::span<const Bid> table, std::int32_t of_group = -1) {
  Outcome out;
  for (std::size_t task = 0; task < problem.tasks; ++task) {
    if (table[task].bidder == auction::nobody) {
      EXPECT_EQ(table[task].price, 0u) << "a task was given up though nothing has changed";
      continue;
    }
    const auto robot = static_cast<std::size_t>(table[task].bidder - 1);
    if (of_group >= 0 && problem.groups[task] != of_group) continue;
    out.sum += problem.value(robot, task);
    ++out.filled;
  }
  return out;
}

}  // namespace auction_test
