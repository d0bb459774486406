// SPDX-License-Identifier: MIT
// Ballots keep what is written, and the election follows its rule.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "vote.hpp"

namespace {

using Numbers = std::vector<std::int32_t>;
using Bytes = std::vector<std::uint8_t>;

Bytes ballot(const Numbers& numbers, unsigned team_size = 7, std::uint8_t fingerprint = 5) {
  Bytes bytes;
  scram::write_ballot(fingerprint, numbers, team_size, bytes);
  return bytes;
}

Numbers elected(const scram::BallotBox& box, Numbers own, double since, const auto& fits) {
  Numbers scratch(2 * own.size());
  box.elect(own, since, scratch, fits);
  return own;
}
const auto any = [](std::span<const std::int32_t>) { return true; };

scram::BallotBox box_for(unsigned team_size, std::size_t tasks) {
  scram::BallotBox box;
  box.reserve(team_size, tasks);
  return box;
}

TEST(Vote, SevenTasksAreThreeBytes) {
  EXPECT_EQ(scram::ballot_bytes(7, 7), 3u);
  EXPECT_EQ(scram::ballot_bytes(11, 11), 6u);
  EXPECT_EQ(scram::ballot_bytes(0, 7), 1u);
}

TEST(Vote, BallotsKeepWhatIsWritten) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    const auto team_size = static_cast<unsigned>(1 + random() % 22);
    Numbers numbers(random() % 23), read;
    for (std::int32_t& number : numbers) number = static_cast<std::int32_t>(random() % (team_size + 1));
    const auto fingerprint = static_cast<std::uint8_t>(random() % 8);
    const Bytes bytes = ballot(numbers, team_size, fingerprint);
    EXPECT_EQ(scram::fingerprint_of(bytes), fingerprint);
    read.resize(numbers.size());
    scram::read_ballot(bytes, team_size, read);
    ASSERT_EQ(read, numbers);
  }
}

TEST(Vote, PluralityWins) {
  scram::BallotBox box = box_for(7, 3);
  EXPECT_EQ(elected(box, {1, 2, 3}, 0.0, any), (Numbers{1, 2, 3}));
  box.put(2, ballot({3, 2, 1}), 1.0);
  box.put(3, ballot({3, 2, 1}), 1.0);
  box.put(4, ballot({2, 1, 3}), 1.0);
  EXPECT_EQ(elected(box, {1, 2, 3}, 0.0, any), (Numbers{3, 2, 1}));
  EXPECT_EQ(elected(box, {2, 1, 3}, 0.0, any), (Numbers{2, 1, 3}));  // two each: the lower robot for the first task
}

TEST(Vote, EqualVotesGoToTheLexicographicallyLeastWhereverTheyAreCounted) {
  scram::BallotBox box = box_for(7, 2);
  box.put(2, ballot({1, 0}), 1.0);
  EXPECT_EQ(elected(box, {1, 2}, 0.0, any), (Numbers{1, 2}));  // nobody counts as the last
  EXPECT_EQ(elected(box, {2, 1}, 0.0, any), (Numbers{1, 0}));
}

TEST(Vote, TheNewestBallotOfATeammateCounts) {
  scram::BallotBox box = box_for(7, 2);
  box.put(2, ballot({2, 1}), 5.0);
  box.put(2, ballot({3, 1}), 4.0);  // overtaken
  box.put(3, ballot({2, 1}), 1.0);
  EXPECT_EQ(elected(box, {1, 2}, 0.0, any), (Numbers{2, 1}));
  EXPECT_EQ(elected(box, {1, 2}, 2.0, any), (Numbers{1, 2}));  // one is too old: one each
}

TEST(Vote, WhatDoesNotFitIsNotCounted) {
  scram::BallotBox box = box_for(7, 2);
  for (const int sender : {2, 3, 4}) box.put(sender, ballot({2, 1}), 1.0);
  EXPECT_EQ(elected(box, {1, 2}, 0.0, [](std::span<const std::int32_t> named) { return named[0] != 2; }),
            (Numbers{1, 2}));
  EXPECT_EQ(elected(box, {1, 2, 3, 4, 5, 6}, 0.0, any), (Numbers{1, 2, 3, 4, 5, 6}));  // another length
  box.put(9, ballot({2, 1}), 1.0);
  box.put(0, ballot({2, 1}), 1.0);
  box.put(5, Bytes(100, 0xff), 1.0);
}

TEST(Vote, OtherTasksEmptyTheBox) {
  scram::BallotBox box = box_for(7, 2);
  const auto fill = [&] {
    for (const int sender : {2, 3}) box.put(sender, ballot({2, 1}, 7, 5), 1.0);
  };
  fill();
  box.tasks_changed(5, false);  // these ballots came ahead of the own change of tasks
  EXPECT_EQ(elected(box, {1, 2}, 0.0, any), (Numbers{2, 1}));
  box.tasks_changed(4, false);
  EXPECT_EQ(elected(box, {1, 2}, 0.0, any), (Numbers{1, 2}));
  fill();
  box.tasks_changed(5, true);
  EXPECT_EQ(elected(box, {1, 2}, 0.0, any), (Numbers{1, 2}));
}

TEST(Vote, FingerprintsTellMostTasksApart) {
  const auto print = [](const Numbers& ids) {
    scram::Fingerprint out;
    for (const std::int32_t id : ids) out.add(id);
    return out.value();
  };
  int alike = 0, all = 0;
  for (int left_out = 0; left_out < 12; ++left_out) {
    for (int other = 0; other < left_out; ++other) {
      Numbers a, b;
      for (int id = 0; id < 12; ++id) {
        if (id != left_out) a.push_back(id);
        if (id != other) b.push_back(id);
      }
      alike += print(a) == print(b) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_LT(alike, all / 4);
  EXPECT_NE(print({0, 1, 2}), print({2, 1, 0}));
}

}  // namespace
