// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace regista::cluster {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Divided, GivesEachTaskAtMostSoMany) {
  EXPECT_THAT(divided({{0, 10}}, 4, 9), ElementsAre(Slice{0, 4}, Slice{4, 8}, Slice{8, 10}));
  EXPECT_THAT(divided({{3, 4}, {9, 12}}, 2, 9), ElementsAre(Slice{3, 4}, Slice{9, 11}, Slice{11, 12}));
  EXPECT_THAT(divided({}, 4, 9), IsEmpty());
}

TEST(Divided, StopsAtTheLastTask) {
  EXPECT_THAT(divided({{0, 10}, {20, 30}}, 4, 2), ElementsAre(Slice{0, 4}, Slice{4, 8}));
}

TEST(Batch, ComesBackFromItsFile) {
  const Batch batch{1200, {{0, 4}, {7, 9}}};
  EXPECT_EQ(batch.matches(), 6u);
  EXPECT_EQ(batch_from_json(to_json(batch)), batch);
  for (const char* text : {"", "{}", "[]", R"({"first_row": 0, "slices": [[2, 2]]})",
                           R"({"first_row": -1, "slices": "all"})", R"({"first_row": 0, "slices": [[1]]})"}) {
    EXPECT_THROW(batch_from_json(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace regista::cluster
