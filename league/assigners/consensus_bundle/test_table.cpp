// SPDX-License-Identifier: MIT
// The table against its own text, as it is printed, read by a small interpreter; and a robot that hears packets against
// one that is written down here anew, with that text for its table.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "test_problems.hpp"

namespace {

using namespace consensus_bundle;
using namespace consensus_bundle::test;

// Columns: I say me, I say k, I say a third, I say nobody. U: update, R: reset, L: leave. >m: the sender's stamp of m
// is newer than mine, <m: mine is; y: the sender's bid is higher, or equal with the lower winner.
constexpr std::array<std::array<std::string_view, 4>, 4> printed{{
    // the sender k says k
    {"U if y", "U", "U if >m or y", "U"},
    // the sender says me
    {"L", "R", "R if >m", "L"},
    // the sender says m
    {"U if >m and y", "U if >m, else R", "same: U if >m; other: U if >m and (>n or y); R if >n and <m", "U if >m"},
    // the sender says nobody
    {"L", "U", "U if >m", "L"},
}};

struct Facts {
  bool newer_m, older_m, newer_n, y, same;
};

bool holds(std::string_view condition, const Facts& f) {
  const std::map<std::string_view, bool> all{{"y", f.y},
                                             {">m", f.newer_m},
                                             {">m or y", f.newer_m || f.y},
                                             {">m and y", f.newer_m && f.y},
                                             {">m and (>n or y)", f.newer_m && (f.newer_n || f.y)},
                                             {">n and <m", f.newer_n && f.older_m}};
  return all.at(condition);
}

Action action_of(char letter) {
  switch (letter) {
    case 'U':
      return Action::update;
    case 'R':
      return Action::reset;
    case 'L':
      return Action::leave;
    default:
      throw std::logic_error("no action");
  }
}

// "A", "A if condition", "A if condition, else B", "A if condition; B if condition".
Action act(std::string_view cell, const Facts& f) {
  if (cell.starts_with("same: ")) {
    const auto cut = cell.find("; other: ");
    return f.same ? act(cell.substr(6, cut - 6), f) : act(cell.substr(cut + 9), f);
  }
  if (cell.size() == 1) return action_of(cell[0]);
  const std::string_view rest = cell.substr(5);  // behind "A if "
  if (const auto cut = rest.find(", else "); cut != rest.npos) {
    return holds(rest.substr(0, cut), f) ? action_of(cell[0]) : action_of(rest[cut + 7]);
  }
  if (const auto cut = rest.find("; "); cut != rest.npos) {
    return holds(rest.substr(0, cut), f) ? action_of(cell[0]) : act(rest.substr(cut + 2), f);
  }
  return holds(rest, f) ? action_of(cell[0]) : Action::leave;
}

constexpr std::array columns{Says::me, Says::sender, Says::third, Says::nobody};
constexpr std::array rows{Says::sender, Says::me, Says::third, Says::nobody};

TEST(Table, IsThePrintedOneInEveryCase) {
  int cases = 0;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (unsigned bits = 0; bits < 32; ++bits) {
        const Facts f{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
        if (f.newer_m && f.older_m) continue;
        const Case c{rows[row], columns[column], f.same, f.newer_m, f.older_m, f.newer_n, f.y};
        EXPECT_EQ(believe(c), act(printed[row][column], f)) << row << ' ' << column << ' ' << bits;
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 16 * 24);
}

// What the paper calls z, y, s and b of robot `me`.
struct Plain {
  int me = 0;
  std::vector<int> z;
  std::vector<std::uint32_t> y;
  std::vector<std::int64_t> s;
  std::vector<std::uint32_t> bundle;

  void hear(const Told& packet) {
    const int k = packet.sender;
    if (packet.sent < s[static_cast<std::size_t>(k) - 1]) return;
    const auto column_of = [&](int who) { return who == me ? 0u : who == k ? 1u : who != 0 ? 2u : 3u; };
    const auto row_of = [&](int who) { return who == k ? 0u : who == me ? 1u : who != 0 ? 2u : 3u; };
    for (std::size_t j = 0; j < z.size(); ++j) {
      const int theirs = packet.claims[j].winner, mine = z[j];
      const std::uint32_t bid = packet.claims[j].bid;
      const std::size_t row = row_of(theirs), column = column_of(mine);
      const auto newer = [&](int who) {
        const auto at = static_cast<std::size_t>(who) - 1;
        return packet.stamps[at] > s[at] ? 1 : packet.stamps[at] < s[at] ? -1 : 0;
      };
      Facts f{false, false, false, false, false};
      if (row == 2) f.newer_m = newer(theirs) > 0, f.older_m = newer(theirs) < 0;
      if (row != 2 && column == 2) f.newer_m = newer(mine) > 0, f.older_m = newer(mine) < 0;
      if (row == 2 && column == 2) f.newer_n = newer(mine) > 0, f.same = theirs == mine;
      f.y = bid > y[j] || (bid == y[j] && theirs < mine);
      const Action action = act(printed[row][column], f);
      if (action == Action::update) z[j] = theirs, y[j] = bid;
      if (action == Action::reset) z[j] = 0, y[j] = 0;
    }
    for (std::size_t m = 0; m < s.size(); ++m) s[m] = std::max(s[m], packet.stamps[m]);
    s[static_cast<std::size_t>(k) - 1] = packet.sent;
    std::size_t lost = 0;
    while (lost < bundle.size() && z[bundle[lost]] == me) ++lost;
    for (std::size_t later = lost; later < bundle.size(); ++later) {
      if (z[bundle[later]] == me) z[bundle[later]] = 0, y[bundle[later]] = 0;
    }
    bundle.resize(lost);
  }
};

// Packets that no sound team would send are among them: small numbers, so that all rows and ties occur.
TEST(Consensus, HearsAsThePaperSays) {
  Random random(9);
  std::array<int, 16> seen{};
  for (int round = 0; round < 1000; ++round) {
    const Problem problem = random_problem(random, Gains::covering, 1 + below(random, 3), 5, 6);
    Consensus consensus;
    Plain plain{1 + static_cast<int>(below(random, problem.robots)),
                std::vector<int>(problem.tasks, 0),
                std::vector<std::uint32_t>(problem.tasks, 0),
                std::vector<std::int64_t>(problem.robots, never),
                {}};
    consensus.setup(plain.me, problem.robots, problem.tasks);
    for (int step = 0; step < 30; ++step) {
      if (below(random, 3) == 0) {
        consensus.extend(problem.limit, [&](auto path, std::uint32_t task) {
          return problem.gain(static_cast<std::size_t>(plain.me) - 1, path, task);
        });
        plain.bundle.assign(consensus.bundle().begin(), consensus.bundle().end());
        for (const std::uint32_t task : plain.bundle) {
          plain.z[task] = plain.me;
          plain.y[task] = consensus.claims()[task].bid;
        }
      }
      Told packet;
      do packet.sender = 1 + static_cast<int>(below(random, problem.robots));
      while (packet.sender == plain.me);
      packet.sent = step / 3;
      for (std::size_t k = 0; k < problem.robots; ++k) {
        packet.stamps.push_back(below(random, 4) == 0 ? never : static_cast<std::int64_t>(below(random, 10)));
      }
      packet.stamps[static_cast<std::size_t>(packet.sender) - 1] = packet.sent;
      for (std::size_t task = 0; task < problem.tasks; ++task) {
        const int winner = static_cast<int>(below(random, problem.robots + 1));
        const std::uint32_t bid = winner == 0 ? 0 : static_cast<std::uint32_t>(500 + 10 * below(random, 40));
        packet.claims.push_back({winner, bid});
        const auto says = [&](int who) {
          return who == plain.me        ? Says::me
                 : who == packet.sender ? Says::sender
                 : who != 0             ? Says::third
                                        : Says::nobody;
        };
        ++seen[4 * static_cast<std::size_t>(says(winner)) + static_cast<std::size_t>(says(plain.z[task]))];
      }
      consensus.hear(packet);
      plain.hear(packet);
      for (std::size_t task = 0; task < problem.tasks; ++task) {
        ASSERT_EQ(consensus.claims()[task].winner, plain.z[task]) << round << ' ' << step;
        ASSERT_EQ(consensus.claims()[task].bid, plain.y[task]);
      }
      for (std::size_t k = 0; k < problem.robots; ++k) ASSERT_EQ(consensus.stamps()[k], plain.s[k]);
      ASSERT_TRUE(std::ranges::equal(consensus.bundle(), plain.bundle));
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(Consensus, WhatFollowsALostTaskIsReleasedAndTheOthersKeepTheirOrder) {
  Consensus consensus;
  consensus.setup(2, 3, 5);
  const std::vector<std::uint32_t> gains{50, 40, 30, 20, 10};
  // Each new task is put first into the path.
  consensus.extend(4, [&](auto, std::uint32_t task) { return Gain{gains[task], 0}; });
  ASSERT_TRUE(std::ranges::equal(consensus.bundle(), std::vector<std::uint32_t>{0, 1, 2, 3}));
  ASSERT_TRUE(std::ranges::equal(consensus.path(), std::vector<std::uint32_t>{3, 2, 1, 0}));
  Told packet{1, 5, std::vector<Claim>(5), {5, never, never}};
  packet.claims[2] = {1, 31};
  consensus.hear(packet);
  EXPECT_TRUE(std::ranges::equal(consensus.bundle(), std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(std::ranges::equal(consensus.path(), std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(consensus.claims()[2], (Claim{1, 31}));
  EXPECT_EQ(consensus.claims()[3], Claim{});
  EXPECT_EQ(consensus.claims()[1], (Claim{2, 40}));
  EXPECT_EQ(consensus.first_task_of(2), 0u);
  EXPECT_EQ(consensus.first_task_of(1), 2u);
  EXPECT_EQ(consensus.first_task_of(3), 5u);
}

}  // namespace
