// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace regista::cluster {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SharedOut, GivesEachTaskAtMostSoMany) {
  EXPECT_THAT(shared_out({{0, 10}}, 4, 9), ElementsAre(Slices{{0, 4}}, Slices{{4, 8}}, Slices{{8, 10}}));
  EXPECT_THAT(shared_out({}, 4, 9), IsEmpty());
}

TEST(SharedOut, GivesATaskSeveralSlicesWhereTheyAreShort) {
  EXPECT_THAT(shared_out({{3, 4}, {9, 12}, {20, 21}}, 3, 9),
              ElementsAre(Slices{{3, 4}, {9, 11}}, Slices{{11, 12}, {20, 21}}));
}

TEST(SharedOut, StopsAtTheLastTask) {
  EXPECT_THAT(shared_out({{0, 10}, {20, 30}}, 4, 2), ElementsAre(Slices{{0, 4}}, Slices{{4, 8}}));
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
