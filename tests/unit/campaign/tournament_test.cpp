// SPDX-License-Identifier: MIT
#include "study/tournament.hpp"

#include <gtest/gtest.h>

namespace regista::study {
namespace {

campaign::Decided match(int home, int away) { return {{home, away}, "full_time", "h", "{}", std::nullopt, 1.0}; }

TEST(TournamentSchedule, PlaysEachSeedInBothOrders) {
  EXPECT_EQ(fixture(0, 7).seed, 7u);
  EXPECT_FALSE(fixture(0, 7).swapped);
  EXPECT_EQ(fixture(1, 7).seed, 7u);
  EXPECT_TRUE(fixture(1, 7).swapped);
  EXPECT_EQ(fixture(9, 7).seed, 11u);
  EXPECT_EQ(fixture(9, 7).pair, 4u);
}

TEST(Tally, CountsPairsAndNotOnlyGames) {
  Tally tally;
  // Each pair: A at home, then A away.
  const campaign::Decided matches[] = {match(0, 1), match(1, 0),   // LL
                                       match(0, 1), match(2, 2),   // LD
                                       match(3, 1), match(3, 1),   // WL
                                       match(0, 0), match(1, 1),   // DD
                                       match(0, 0), match(0, 4),   // WD
                                       match(2, 0), match(0, 2)};  // WW
  for (const campaign::Decided& each : matches) tally.add(each);
  const Standing& standing = tally.standing();
  EXPECT_EQ(standing.pairs, (std::array<std::uint64_t, 5>{1, 1, 2, 1, 1}));
  EXPECT_EQ(standing.wins, 4u);
  EXPECT_EQ(standing.draws, 4u);
  EXPECT_EQ(standing.losses, 4u);
  EXPECT_EQ(standing.goals, (std::array<std::uint64_t, 2>{15, 10}));
}

TEST(Tally, HalfAPairIsNoPair) {
  Tally tally;
  tally.add(match(1, 0));
  EXPECT_EQ(tally.standing().games(), 1u);
  EXPECT_EQ(tally.standing().complete_pairs(), 0u);
  EXPECT_EQ(tally.standing().pairs, (std::array<std::uint64_t, 5>{}));
}

TEST(Tally, ForfeitsFollowTheTeamAndNotTheSide) {
  Tally tally;
  campaign::Failure failure{0, "greedy", "assign", 3, 417, "Segmentation fault"};
  tally.add(campaign::forfeit(failure, 1.0));  // A at home
  failure.side = 1;
  failure.tick = 5;
  tally.add(campaign::forfeit(failure, 1.0));  // A away
  tally.add(campaign::forfeit(failure, 1.0));  // B away
  ASSERT_EQ(tally.standing().forfeits.size(), 2u);
  EXPECT_EQ(tally.standing().forfeits[0].team, 0);
  EXPECT_EQ(tally.standing().forfeits[0].count, 2u);
  EXPECT_EQ(tally.standing().forfeits[0].first_match, 0u);
  EXPECT_EQ(tally.standing().forfeits[1].team, 1);
  EXPECT_EQ(tally.standing().forfeits[1].first_match, 2u);
  EXPECT_EQ(tally.standing().goals, (std::array<std::uint64_t, 2>{10, 20}));
  EXPECT_EQ(tally.standing().pairs[0], 1u);
}

TEST(Tally, DoesNotGrowWithoutEnd) {
  Tally tally;
  for (int i = 0; i < 150; ++i) {
    tally.add(campaign::forfeit({0, "greedy", "assign", 1, 1, "reason " + std::to_string(i)}, 1.0));
  }
  EXPECT_EQ(tally.standing().forfeits.size(), most_listed);
  EXPECT_EQ(tally.standing().unlisted_forfeits, 50u);
}

}  // namespace
}  // namespace regista::study
