// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <gmock/gmock.h>

#include "study_of_two_rounds.hpp"

namespace regista::cluster {
namespace {

using testing::ElementsAre;

class MissingTest : public FolderTest {
 protected:
  Missing missing(std::uint64_t most = 100, std::uint64_t enough = 10, bool equal = false) {
    TwoRounds study(enough, equal);
    return missing_of(study, store, most);
  }
  // Of the first round for rows up to 6, of the second beyond.
  void play(std::int64_t row) {
    const bool second = row > 6;
    const std::int64_t fixture = store.add(std::vector<campaign::Fixture>{{second ? "two" : "one", {}}}).front();
    store.insert(row, {fixture, static_cast<std::uint64_t>(second ? 600 + row - 7 : row - 1)}, match(), 1);
  }
  campaign::Store store{folder / "results.db", campaign::Store::Mode::create, "1.0"};
};

TEST_F(MissingTest, AllOfTheFirstRoundAtFirst) {
  const Missing out = missing();
  EXPECT_THAT(out.places, ElementsAre(Slice{0, 6}));
  EXPECT_EQ(out.first_row, 0u);
  EXPECT_THAT(out.twice, ElementsAre(0));
  EXPECT_TRUE(out.is_first);
  EXPECT_EQ(out.seen, 0u);
}

TEST_F(MissingTest, WhatIsThereIsLeftOutAlsoBeyondTheFirstGap) {
  for (const std::int64_t row : {1, 2, 4}) play(row);
  const Missing out = missing();
  EXPECT_THAT(out.places, ElementsAre(Slice{2, 3}, Slice{4, 6}));
  EXPECT_THAT(out.twice, testing::IsEmpty());  // what is played twice is there
  EXPECT_EQ(out.seen, 2u);
}

TEST_F(MissingTest, NoMoreThanIsAskedFor) { EXPECT_THAT(missing(4).places, ElementsAre(Slice{0, 4})); }

TEST_F(MissingTest, TheNextRoundOnceTheFirstIsThere) {
  for (std::int64_t row = 1; row <= 7; ++row) play(row);
  const Missing out = missing();
  EXPECT_THAT(out.places, ElementsAre(Slice{1, 4}));
  EXPECT_EQ(out.first_row, 6u);
  EXPECT_EQ(out.round, 4u);
  EXPECT_FALSE(out.is_first);
}

TEST_F(MissingTest, NothingAtTheEndOrWhenNothingMoreIsNeeded) {
  for (std::int64_t row = 1; row <= 4; ++row) play(row);
  EXPECT_TRUE(missing(100, 4).complete());
  EXPECT_FALSE(missing(100, 5).complete());
  for (std::int64_t row = 5; row <= 10; ++row) play(row);
  EXPECT_TRUE(missing().complete());
}

TEST_F(MissingTest, OfEqualMatchesOne) { EXPECT_THAT(missing(100, 10, true).places, ElementsAre(Slice{0, 5})); }

}  // namespace
}  // namespace regista::cluster
