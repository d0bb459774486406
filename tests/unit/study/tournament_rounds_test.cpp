// SPDX-License-Identifier: MIT
// Draws of Swiss rounds and brackets, against small examples drawn by hand and against what must hold of every draw.
#include "study/tournament_calendar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <set>

namespace regista::study {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SwissStanding standing_of(std::vector<double> points) {
  const std::size_t teams = points.size();
  return {std::move(points), std::vector<char>(teams, 1), std::vector<char>(teams, 0),
          std::vector(teams, std::vector<char>(teams, 0))};
}

// The team that plays, but has no opponent in this round.
std::optional<std::size_t> bye(const SwissStanding& standing, const std::vector<Pairing>& round) {
  for (std::size_t team = 0; team < standing.plays.size(); ++team) {
    const auto meets = [team](const Pairing& each) { return each.first == team || each.second == team; };
    if (standing.plays[team] != 0 && std::ranges::none_of(round, meets)) return team;
  }
  return std::nullopt;
}

void meet(SwissStanding& standing, const std::vector<Pairing>& round) {
  for (const auto& [a, b] : round) standing.met[a][b] = standing.met[b][a] = 1;
  if (const auto team = bye(standing, round)) standing.had_bye[*team] = 1;
}

TEST(Swiss, NeighboursInTheOrderOfPointsMeet) {
  EXPECT_THAT(swiss_round(standing_of({0, 0, 0, 0})), ElementsAre(Pairing{0, 1}, Pairing{2, 3}));
  SwissStanding after = standing_of({2, 0, 0, 2});
  after.met[0][1] = after.met[1][0] = after.met[2][3] = after.met[3][2] = 1;
  EXPECT_THAT(swiss_round(after), ElementsAre(Pairing{0, 3}, Pairing{1, 2}));
}

TEST(Swiss, ADrawThatLeavesTwoWhoHaveMetIsChanged) {
  // 0 has met 1, and 2 has met 3. The first choice, 0 with 2 and 1 with 3, stands; without 1 against 3 it is changed.
  SwissStanding standing = standing_of({3, 2, 2, 1});
  standing.met[0][1] = standing.met[1][0] = standing.met[1][3] = standing.met[3][1] = 1;
  EXPECT_THAT(swiss_round(standing), ElementsAre(Pairing{0, 3}, Pairing{1, 2}));
}

TEST(Swiss, TheLastWithoutAByeGetsOne) {
  SwissStanding standing = standing_of({4, 3, 2, 1, 0});
  EXPECT_EQ(bye(standing, swiss_round(standing)), 4u);
  standing.had_bye[4] = 1;
  EXPECT_EQ(bye(standing, swiss_round(standing)), 3u);
  standing.plays[4] = 0;
  EXPECT_EQ(bye(standing, swiss_round(standing)), std::nullopt);
}

TEST(Swiss, NobodyMeetsTwiceUntilAllHaveMet) {
  std::mt19937 random(1);
  for (std::size_t teams = 2; teams <= 14; ++teams) {
    SwissStanding standing = standing_of(std::vector<double>(teams, 0.0));
    const std::size_t all = teams - 1 + teams % 2;  // rounds of a round robin
    int again = 0;
    for (std::size_t round = 0; round < all; ++round) {
      const std::vector<Pairing> drawn = swiss_round(standing);
      std::set<std::size_t> seen;
      if (const auto team = bye(standing, drawn)) seen.insert(*team);
      for (const auto& [a, b] : drawn) {
        EXPECT_LT(a, b);
        seen.insert({a, b});
        again += standing.met[a][b];
        standing.points[random() % 2 == 0 ? a : b] += 1.0;
      }
      EXPECT_EQ(seen.size(), teams) << "everybody has one place";
      EXPECT_EQ(bye(standing, drawn).has_value(), teams % 2 == 1);
      if (round < teams / 2) {
        EXPECT_EQ(again, 0) << "half of the rounds of a round robin always go without";
      }
      meet(standing, drawn);
    }
    EXPECT_LE(again, static_cast<int>(teams));
  }
}

TEST(KnockOut, TheFavouritesMeetLast) {
  const auto favourite = [](const Pairing& pair) { return pair.first; };
  EXPECT_THAT(knock_out_round(8, 0, favourite),
              ElementsAre(Pairing{0, 7}, Pairing{3, 4}, Pairing{1, 6}, Pairing{2, 5}));
  EXPECT_THAT(knock_out_round(8, 1, favourite), ElementsAre(Pairing{0, 3}, Pairing{1, 2}));
  EXPECT_THAT(knock_out_round(8, 2, favourite), ElementsAre(Pairing{0, 1}));
  EXPECT_THAT(knock_out_round(8, 3, favourite), IsEmpty());
}

TEST(KnockOut, TheFirstHaveByes) {
  const auto favourite = [](const Pairing& pair) { return pair.first; };
  EXPECT_THAT(knock_out_round(5, 0, favourite), ElementsAre(Pairing{3, 4}));
  EXPECT_THAT(knock_out_round(5, 1, favourite), ElementsAre(Pairing{0, 3}, Pairing{1, 2}));
}

TEST(KnockOut, EveryTeamButOneLosesOnce) {
  std::mt19937 random(2);
  for (std::size_t teams = 2; teams <= 33; ++teams) {
    std::set<std::size_t> out;
    std::set<Pairing> lost_by_first;
    std::size_t meetings = 0;
    const auto winner = [&](const Pairing& pair) { return lost_by_first.contains(pair) ? pair.second : pair.first; };
    for (std::size_t round = 0; round < knock_out_rounds(teams); ++round) {
      for (const Pairing& pair : knock_out_round(teams, round, winner)) {
        ++meetings;
        if (random() % 2 == 0) lost_by_first.insert(pair);
        EXPECT_TRUE(out.insert(winner(pair) == pair.first ? pair.second : pair.first).second);
      }
    }
    EXPECT_EQ(meetings, teams - 1);
    EXPECT_EQ(out.size(), teams - 1);
    EXPECT_THAT(knock_out_round(teams, knock_out_rounds(teams), winner), IsEmpty());
  }
}

}  // namespace
}  // namespace regista::study
