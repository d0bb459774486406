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
  const Batch batch{1200, {{{0, 4}, {7, 9}}, {{12, 13}}}};
  EXPECT_EQ(batch.matches(), 7u);
  EXPECT_EQ(batch_from_json(to_json(batch)), batch);
  for (const char* text : {"", "{}", "[]", R"({"first_row": 0, "tasks": [[[2, 2]]]})",
                           R"({"first_row": 0, "tasks": [[]]})", R"({"first_row": 0, "tasks": [[[2, 4], [3, 5]]]})",
                           R"({"first_row": -1, "tasks": "all"})", R"({"first_row": 0, "tasks": [[[1]]]})"}) {
    EXPECT_THROW(batch_from_json(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace regista::cluster
