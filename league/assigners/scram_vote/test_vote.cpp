// SPDX-License-Identifier: MIT
// Maps keep what is written, and the election follows its rule: against counting.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "vote.hpp"

namespace {

using scram::away, scram::idle, scram::MapCode;
using Map = std::vector<std::int32_t>;
using Bytes = std::vector<std::uint8_t>;

Bytes told(const MapCode& code, const Map& map) {
  Bytes bytes;
  negotiation::BitWriter writer(bytes);
  code.write(map, writer);
  return bytes;
}

Map random_map(std::mt19937& random, std::size_t robots, std::size_t roles) {
  Map tasks(roles);
  std::iota(tasks.begin(), tasks.end(), 0);
  std::shuffle(tasks.begin(), tasks.end(), random);
  Map map(robots, idle);
  for (std::size_t robot = 0; robot < std::min(robots, roles); ++robot) {
    map[robot] = random() % 4 == 0 ? (random() % 2 == 0 ? away : idle) : tasks[robot];
  }
  return map;
}

// --- Maps as bytes ---------------------------------------------------------------------------------------------

TEST(ToldMap, IsAsShortAsIdsAllow) {
  EXPECT_EQ(MapCode(7, 19).bytes(), 5u);    // 5 bits each
  EXPECT_EQ(MapCode(7, 14).bytes(), 4u);    // 4 bits each
  EXPECT_EQ(MapCode(11, 11).bytes(), 6u);   // 4 bits each
  EXPECT_EQ(MapCode(22, 64).bytes(), 20u);  // 7 bits each
  EXPECT_EQ(MapCode(7, 19).bytes(8), 6u);
}

TEST(ToldMap, KeepsWhatIsWritten) {
  std::mt19937 random(1);
  for (int round = 0; round < 10000; ++round) {
    const std::size_t robots = 1 + random() % 22, roles = 1 + random() % 64;
    const MapCode code(robots, roles);
    const Map map = random_map(random, robots, roles);
    const Bytes bytes = told(code, map);
    ASSERT_EQ(bytes.size(), code.bytes());
    Map read(robots);
    negotiation::BitReader in(bytes);
    ASSERT_TRUE(code.read(in, read));
    ASSERT_EQ(read, map);
    // Another length is no map of this team.
    for (const int change : {-1, 1}) {
      Bytes other = bytes;
      other.resize(bytes.size() + static_cast<std::size_t>(change + 1) - 1);
      negotiation::BitReader strange(other);
      EXPECT_FALSE(code.read(strange, read));
    }
  }
}

TEST(ToldMap, ATaskTwiceOrOneThatDoesNotExistIsNoMap) {
  const MapCode wide(3, 30), code(3, 17);  // 5 bits each, both
  Map read(3);
  const auto is_map = [&](const Map& map) {
    const Bytes bytes = told(wide, map);
    negotiation::BitReader in(bytes);
    return code.read(in, read);
  };
  EXPECT_TRUE(is_map({16, 0, idle}));
  EXPECT_FALSE(is_map({17, 0, idle}));
  EXPECT_FALSE(is_map({5, 0, 5}));
  EXPECT_TRUE(is_map({away, away, away}));
}

// --- Elections -------------------------------------------------------------------------------------------------

const auto all = [](int, std::span<const std::int32_t>) { return true; };

struct Box {
  MapCode code;
  scram::BallotBox ballots;
  Box(std::size_t robots, std::size_t roles) : code(robots, roles) { ballots.reserve(code); }
  void put(int sender, const Map& map, double time) { ballots.put(sender, told(code, map), time); }
  Map elect(int own, Map map, double since, const auto& counts) {
    ballots.elect(own, map, since, counts);
    return map;
  }
};

TEST(Vote, EqualsCountingInRandomElections) {
  std::mt19937 random(2);
  int ties = 0, majorities = 0, own_lost = 0, none_heard = 0;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t robots = 1 + random() % 11, roles = 1 + random() % 20;
    Box box(robots, roles);
    // Few maps, so that many vote alike.
    std::vector<Map> maps(1 + random() % 4);
    for (Map& map : maps) map = random_map(random, robots, roles);
    const int own = 1 + static_cast<int>(random() % robots);
    const Map own_map = maps[random() % maps.size()];
    const double since = 5.0;
    struct Said {
      int sender;
      double time;
      Map map;
    };
    std::vector<Said> said;
    for (std::size_t k = random() % 25; k-- > 0;) {
      said.push_back({1 + static_cast<int>(random() % robots), static_cast<double>(random() % 200) * 0.1,
                      maps[random() % maps.size()]});
      if (random() % 8 == 0) said.push_back(said.back());  // heard twice
    }
    for (const Said& each : said) box.put(each.sender, each.map, each.time);  // in any order
    std::vector<bool> voids(robots + 1);
    for (std::size_t voter = 1; voter <= robots; ++voter) voids[voter] = random() % 5 == 0;

    // By the rule: of each teammate the newest, of equally new ones what was heard last.
    std::map<int, Said> newest;
    for (const Said& each : said) {
      const auto [place, is_new] = newest.try_emplace(each.sender, each);
      if (!is_new && each.time >= place->second.time) place->second = each;
    }
    newest.insert_or_assign(own, Said{own, 1e9, own_map});
    std::map<Map, std::vector<int>> voters;  // ascending: newest is
    for (const auto& [sender, each] : newest) {
      const bool counts = sender == own || (each.time >= since && !voids[static_cast<std::size_t>(sender)]);
      if (counts) voters[each.map].push_back(sender);
    }
    const auto best = std::max_element(voters.begin(), voters.end(), [](const auto& a, const auto& b) {
      const auto &x = a.second, &y = b.second;
      return x.size() != y.size() ? x.size() < y.size() : x.front() > y.front();
    });
    const auto with_as_many = std::count_if(
        voters.begin(), voters.end(), [&](const auto& each) { return each.second.size() == best->second.size(); });
    const Map elected = box.elect(own, own_map, since, [&](int voter, std::span<const std::int32_t> map) {
      EXPECT_TRUE(std::equal(map.begin(), map.end(), newest.at(voter).map.begin()));
      return !voids[static_cast<std::size_t>(voter)];
    });
    ASSERT_EQ(elected, best->first) << "round " << round;
    ties += with_as_many > 1;
    majorities += 2 * best->second.size() > robots;
    own_lost += elected != own_map;
    none_heard += voters.size() == 1 && best->second.size() == 1;
  }
  for (const int count : {ties, majorities, own_lost, none_heard}) EXPECT_GT(count, 500);
}

TEST(Vote, EqualVotesGoToTheMapOfTheLowestVoter) {
  Box box(5, 5);
  const Map a{0, 1, 2, 3, 4}, b{1, 0, 2, 3, 4}, c{4, 1, 2, 3, 0};
  box.put(2, b, 1.0);
  box.put(3, a, 1.0);
  box.put(4, a, 1.0);
  EXPECT_EQ(box.elect(5, b, 0.0, all), b);  // two each: robot 2 before robot 3
  EXPECT_EQ(box.elect(5, c, 0.0, all), a);
  EXPECT_EQ(box.elect(1, c, 0.0, all), a);
  box.put(4, c, 2.0);
  EXPECT_EQ(box.elect(1, b, 0.0, all), b);
  EXPECT_EQ(box.elect(5, Map{3, 1, 2, 0, 4}, 0.0, all), b);  // one each
}

TEST(Vote, TheOwnVoteCountsAlways) {
  Box box(3, 3);
  const Map own{2, 1, 0};
  for (const int sender : {1, 3}) box.put(sender, {0, 1, 2}, 1.0);
  EXPECT_EQ(box.elect(2, own, 0.0, [](int, std::span<const std::int32_t>) { return false; }), own);
  EXPECT_EQ(box.elect(2, own, 1.5, all), own);
  EXPECT_EQ(box.elect(2, own, 1.0, all), (Map{0, 1, 2}));
  box.ballots.clear();
  EXPECT_EQ(box.elect(2, own, 0.0, all), own);
}

TEST(Vote, AnyBytesAreBorne) {
  std::mt19937 random(3);
  Box box(7, 19);
  const Map own{0, 1, 2, 3, 4, 5, 6};
  for (int round = 0; round < 10000; ++round) {
    Bytes bytes(random() % 12);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    box.ballots.put(static_cast<int>(random() % 40) - 10, bytes, 0.1 * round);
    const Map elected = box.elect(4, own, 0.0, all);
    for (std::size_t robot = 0; robot < 7; ++robot) {
      ASSERT_TRUE(elected[robot] >= away && elected[robot] < 19);
      if (elected[robot] >= 0) {
        ASSERT_EQ(std::count(elected.begin(), elected.end(), elected[robot]), 1);
      }
    }
  }
}

}  // namespace
