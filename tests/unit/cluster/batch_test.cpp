// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace regista::cluster {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SharedOut, GivesEachTaskAboutAsMany) {
  EXPECT_THAT(shared_out({{0, 10}}, {}, 100, 3), ElementsAre(Slices{{0, 4}}, Slices{{4, 7}}, Slices{{7, 10}}));
  EXPECT_THAT(shared_out({{5, 7}}, {}, 100, 3), ElementsAre(Slices{{5, 6}}, Slices{{6, 7}}));
  EXPECT_THAT(shared_out({}, {}, 4, 9), IsEmpty());
}

TEST(SharedOut, GivesATaskSeveralSlicesWhereTheyAreShort) {
  EXPECT_THAT(shared_out({{3, 4}, {9, 12}, {20, 21}}, {}, 3, 2),
              ElementsAre(Slices{{3, 4}, {9, 11}}, Slices{{11, 12}, {20, 21}}));
}

TEST(SharedOut, LeavesWhatIsTooMuch) {
  EXPECT_THAT(shared_out({{0, 10}, {20, 30}}, {}, 4, 2), ElementsAre(Slices{{0, 4}}, Slices{{4, 8}}));
}

TEST(SharedOut, AMatchThatIsPlayedTwiceCountsAsSeveral) {
  EXPECT_THAT(shared_out({{0, 8}}, {0}, 100, 2), ElementsAre(Slices{{0, 2}}, Slices{{2, 8}}));
  EXPECT_THAT(shared_out({{0, 4}}, {0, 2}, 100, 2), ElementsAre(Slices{{0, 2}}, Slices{{2, 4}}));
}

// Whatever there is, all tasks: in order, without a gap, none beyond its bound, and none much longer than another.
TEST(SharedOut, AnyPlaces) {
  std::mt19937_64 chance(1);
  for (int trial = 0; trial < 1000; ++trial) {
    Slices places;
    std::vector<std::uint64_t> twice, wanted;
    for (std::uint64_t place = chance() % 5; place < 60; place += 1 + chance() % 4) {
      const std::uint64_t end = place + 1 + chance() % 6;
      places.push_back({place, end});
      for (; place < end; ++place) {
        wanted.push_back(place);
        if (chance() % 7 == 0) twice.push_back(place);
      }
    }
    const std::uint64_t most = 1 + chance() % 20, tasks = 1 + chance() % 9;
    const std::vector<Slices> out = shared_out(places, twice, most, tasks);
    ASSERT_LE(out.size(), tasks);
    std::vector<std::uint64_t> given;
    std::uint64_t longest = 0, in_all = 0;
    for (const Slices& task : out) {
      ASSERT_GE(matches_of(task), 1u);
      ASSERT_LE(matches_of(task), most);
      std::uint64_t weight = 0;
      for (const Slice& each : task) {
        for (std::uint64_t place = each.begin; place < each.end; ++place) {
          given.push_back(place);
          weight += std::ranges::binary_search(twice, place) ? weight_of_twice : 1;
        }
      }
      longest = std::max(longest, weight);
      in_all += weight;
    }
    ASSERT_LE(given.size(), wanted.size());
    ASSERT_TRUE(std::equal(given.begin(), given.end(), wanted.begin()));
    if (given.size() < wanted.size()) {
      ASSERT_GE(in_all, most * tasks);  // all that they may have
    }
    ASSERT_LT(longest, in_all / tasks + 1 + weight_of_twice);
  }
}

TEST(Batch, ComesBackFromItsFile) {
  const Batch batch{1200, true, {{{0, 4}, {7, 9}}, {{12, 13}}}};
  EXPECT_EQ(batch.matches(), 7u);
  EXPECT_EQ(batch_from_json(to_json(batch)), batch);
  for (const char* text : {"", "{}", "[]", R"({"first_row": 0, "tasks": [[[1, 2]]]})"}) {
    EXPECT_THROW(batch_from_json(text), std::invalid_argument) << text;
  }
  const auto with_tasks = [](const std::string& tasks) {
    return batch_from_json(R"({"first_row": 0, "may_end_early": false, "tasks": )" + tasks + "}");
  };
  EXPECT_EQ(with_tasks("[[[1, 2]]]"), (Batch{0, false, {{{1, 2}}}}));
  for (const char* tasks : {"[[[2, 2]]]", "[[]]", "[[[2, 4], [3, 5]]]", R"("all")", "[[[1]]]", "[[[-1, 2]]]"}) {
    EXPECT_THROW(with_tasks(tasks), std::invalid_argument) << tasks;
  }
}

}  // namespace
}  // namespace regista::cluster
