// SPDX-License-Identifier: MIT
// Which map is the newest, when it is void, and when it is kept: by definition.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "keep_map.hpp"
#include "last_map.hpp"

namespace {

using nao_devils::is_newer, nao_devils::LastMap, nao_devils::Stamp;
using scram::away, scram::idle;
using Map = std::vector<std::int32_t>;

// --- The newest ------------------------------------------------------------------------------------------------

TEST(LastMap, AHigherSerialNumberIsNewerThenALowerRobot) {
  EXPECT_TRUE(is_newer({4, 7}, {3, 1}));
  EXPECT_FALSE(is_newer({3, 1}, {4, 7}));
  EXPECT_TRUE(is_newer({4, 2}, {4, 3}));
  EXPECT_FALSE(is_newer({4, 3}, {4, 3}));
  EXPECT_TRUE(is_newer({2, 5}, {250, 5}));  // it counts on from 255 to 0
}

// Each map has its own content. In whichever order they are heard, and however often, the newest is what stays.
TEST(LastMap, TheNewestStaysWhateverTheOrder) {
  std::mt19937 random(1);
  for (int round = 0; round < 10000; ++round) {
    struct Sent {
      int serial;  // without counting on from 255 to 0
      int author;
      Map map;
    };
    const int first = static_cast<int>(random() % 256);
    std::vector<Sent> sent;
    for (int k = 0; k < 12; ++k) {
      const int serial = first + static_cast<int>(random() % 100), author = 1 + static_cast<int>(random() % 7);
      sent.push_back({serial, author, {serial, author}});
    }
    const Sent newest = *std::max_element(sent.begin(), sent.end(), [](const Sent& a, const Sent& b) {
      return a.serial != b.serial ? a.serial < b.serial : a.author > b.author;
    });
    const std::vector<Sent> twice = sent;
    sent.insert(sent.end(), twice.begin(), twice.end());
    std::shuffle(sent.begin(), sent.end(), random);
    LastMap last;
    for (const Sent& each : sent) {
      const Stamp stamp{static_cast<std::uint8_t>(each.serial), each.author};
      const Stamp before = last.stamp();
      const bool expected = !last.exists() || is_newer(stamp, before);
      ASSERT_EQ(last.adopt(stamp, each.map), expected);
    }
    ASSERT_EQ(Map(last.tasks().begin(), last.tasks().end()), newest.map);
    const Stamp next = last.next_of(3);
    EXPECT_TRUE(is_newer(next, last.stamp()));
    EXPECT_EQ(next.author, 3);
  }
}

TEST(LastMap, IsVoidWhenItFittedAndNoLongerDoes) {
  LastMap last;
  EXPECT_TRUE(last.is_wanting());
  last.look(Map{1, 2}, false);
  EXPECT_TRUE(last.is_wanting());
  last.adopt({1, 2}, Map{0, 1, away});
  EXPECT_FALSE(last.is_wanting());
  last.look(Map{1, 2}, true);
  EXPECT_FALSE(last.is_wanting());
  last.look(Map{1, 2}, false);  // other tasks
  EXPECT_TRUE(last.is_wanting());
  last.look(Map{1, 2}, true);  // and the old ones again
  EXPECT_FALSE(last.is_wanting());
  last.look(Map{1, 2, 3}, false);
  EXPECT_TRUE(last.is_wanting());
  EXPECT_FALSE(last.adopt({1, 3}, Map{1, 0, away}));
  EXPECT_TRUE(last.is_wanting());
  EXPECT_TRUE(last.adopt({2, 3}, Map{1, 0, away}));
  EXPECT_FALSE(last.is_wanting());
  last.forget();
  EXPECT_TRUE(last.is_wanting());
}

// Or two robots that see other teammates would outbid each other for ever.
TEST(LastMap, OneThatNeverFittedIsVoidOnlyWhenRobotsLeaveOrReturn) {
  LastMap last;
  last.look(Map{1, 2, 3}, false);
  last.adopt({1, 2}, Map{0, 1, away});
  for (int k = 0; k < 5; ++k) {
    last.look(Map{1, 2, 3}, false);
    EXPECT_FALSE(last.is_wanting());
  }
  last.look(Map{1, 3}, false);
  EXPECT_TRUE(last.is_wanting());
}

// --- Keeping ---------------------------------------------------------------------------------------------------

TEST(KeepMap, EqualsTryingAllPermutations) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(0.0, 5.0);
  int kept = 0, given_up = 0;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t n = 1 + random() % 6;
    std::vector<double> lengths(n * n);
    for (double& each : lengths) each = real(random);
    const auto length = [&](int robot, std::int32_t task) {
      return lengths[static_cast<std::size_t>(robot - 1) * n + static_cast<std::size_t>(task)];
    };
    const auto longest = [&](const Map& map) {
      double walk = 0.0;
      for (std::size_t robot = 0; robot < n; ++robot) {
        walk = std::max(walk, length(static_cast<int>(robot + 1), map[robot]));
      }
      return walk;
    };
    Map last(n), map(n);
    std::iota(map.begin(), map.end(), 0);
    last = map;
    std::shuffle(last.begin(), last.end(), random);
    Map best = map;
    do {
      if (longest(map) < longest(best)) best = map;
    } while (std::next_permutation(map.begin(), map.end()));
    const double margin = real(random) * 0.5;
    const bool truth = longest(last) <= longest(best) + margin;
    ASSERT_EQ(nao_devils::is_worth_keeping(last, best, margin, length), truth);
    (truth ? kept : given_up) += 1;
  }
  EXPECT_GT(kept, 2000);
  EXPECT_GT(given_up, 2000);
}

TEST(KeepMap, RobotsTasksAndTheirNumbersMustBeTheSame) {
  const auto length = [](int, std::int32_t task) {
    EXPECT_LE(task, 3);  // what is not known has no length
    return 1.0;
  };
  const auto keeps = [&](const Map& last, const Map& best) {
    return nao_devils::is_worth_keeping(last, best, 1.0, length);
  };
  EXPECT_TRUE(keeps({0, 1, idle}, {idle, 0, 1}));
  EXPECT_FALSE(keeps({0, 1, idle}, {0, 1, away}));
  EXPECT_FALSE(keeps({0, 1, away}, {0, 1, idle}));
  EXPECT_FALSE(keeps({0, 1, idle}, {0, 1, 2}));
  EXPECT_FALSE(keeps({0, 1, 2}, {0, 1, idle}));
  EXPECT_FALSE(keeps({0, 1, 9}, {0, 1, 2}));
  EXPECT_FALSE(keeps({0, 1, 9}, {0, 1, idle}));
}

// --- Memory ----------------------------------------------------------------------------------------------------

std::vector<double> kept_outside;  // so that no compiler leaves an allocation out

TEST(LastMap, NothingIsAllocatedWithinWhatWasReserved) {
  LastMap last;
  last.reserve(22);
  Map map(22), numbers(22);
  std::iota(map.begin(), map.end(), 0);
  std::iota(numbers.begin(), numbers.end(), 1);
  const auto count = regista::testkit::allocations_during([&] {
    for (int round = 0; round < 500; ++round) {
      last.adopt({static_cast<std::uint8_t>(round), 3}, map);
      last.look(std::span(numbers).first(static_cast<std::size_t>(round % 23)), round % 3 == 0);
    }
  });
  EXPECT_EQ(count, 0u);
  EXPECT_GT(regista::testkit::allocations_during([] { kept_outside = std::vector<double>(1000); }), 0u);
}

}  // namespace
