// SPDX-License-Identifier: MIT
// Teams whose plugins fail again and again: when they are set aside, and what becomes of the others.
#include <gmock/gmock.h>

#include "study/tournament_course.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;

constexpr std::size_t nobody = 99;

class SetAsideTest : public testing::Test {
 protected:
  void begin(std::size_t teams, int in_a_row, std::uint64_t pairs = 1000) {
    plan = plan_of(teams, pairs);
    plan.asked.failures_in_a_row = in_a_row;
    course.emplace(plan);
  }

  // The next match, forfeited by this team.
  bool forfeited_by(std::size_t team, const std::string& plugin = "greedy") {
    const Fixture fixture = course->calendar().at(course->taken());
    EXPECT_TRUE(team == nobody || team == fixture.home || team == fixture.away);
    const campaign::MatchResult decided = team == nobody ? match(1, 0) : failed(team == fixture.home ? 0 : 1, plugin);
    return course->take(&decided);
  }

  TournamentPlan plan;
  std::optional<Tournament> course;
};

TEST_F(SetAsideTest, AfterSoManyInARowAtTheEndOfAPair) {
  begin(2, 3);
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));  // enough, but in the middle of a pair
  EXPECT_THAT(course->set_aside(), testing::IsEmpty());
  EXPECT_FALSE(forfeited_by(0));
  ASSERT_EQ(course->set_aside().size(), 1u);
  const SetAside& team = course->set_aside().front();
  EXPECT_EQ(team.team, 0u);
  EXPECT_EQ(team.plugin, "greedy");
  EXPECT_EQ(team.failures, 4u);
  EXPECT_EQ(team.pair, 1u);
  EXPECT_FALSE(course->wanted(course->taken()));
  EXPECT_EQ(total(course->meetings().front().pairs), 2);
}

TEST_F(SetAsideTest, ExactlyAsManyAsWereAsked) {
  begin(2, 4);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(forfeited_by(1)) << i;
  EXPECT_FALSE(forfeited_by(1));
  EXPECT_EQ(course->set_aside().front().team, 1u);
}

TEST_F(SetAsideTest, AMatchPlayedToItsEndBreaksTheRow) {
  begin(2, 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(forfeited_by(0));
    EXPECT_TRUE(forfeited_by(0));
    EXPECT_TRUE(forfeited_by(0));
    EXPECT_TRUE(forfeited_by(nobody));
  }
  EXPECT_THAT(course->set_aside(), testing::IsEmpty());
  EXPECT_THAT(course->forfeits().of_team(), ElementsAre(300, 0));
}

TEST_F(SetAsideTest, AnotherPluginBeginsAnotherRow) {
  begin(2, 3);
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(forfeited_by(0, "one"));
    EXPECT_TRUE(forfeited_by(0, "one"));
    EXPECT_TRUE(forfeited_by(0, "two"));
    EXPECT_TRUE(forfeited_by(0, "two"));
  }
  EXPECT_THAT(course->set_aside(), testing::IsEmpty());
  EXPECT_TRUE(forfeited_by(0, "two"));  // the third
  EXPECT_FALSE(forfeited_by(0, "two"));
  EXPECT_EQ(course->set_aside().front().plugin, "two");
  EXPECT_EQ(course->set_aside().front().failures, 4u);
}

TEST_F(SetAsideTest, NeverWhereNobodyAskedForIt) {
  begin(2, 0);
  for (int i = 0; i < 2000; ++i) EXPECT_TRUE(forfeited_by(0));
  EXPECT_THAT(course->set_aside(), testing::IsEmpty());
}

TEST_F(SetAsideTest, ForfeitsOfOthersNeitherBreakNorLengthenARow) {
  begin(2, 3);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(forfeited_by(0));
    EXPECT_TRUE(forfeited_by(1, "other"));
  }
  EXPECT_THAT(course->set_aside(), testing::IsEmpty());
  EXPECT_TRUE(forfeited_by(1, "other"));  // three of team 1, two of team 0
  EXPECT_FALSE(forfeited_by(0));
  ASSERT_EQ(course->set_aside().size(), 2u);
  EXPECT_EQ(course->set_aside()[0].failures, 3u);
  EXPECT_EQ(course->set_aside()[1].failures, 3u);
  EXPECT_EQ(course->set_aside()[0].pair, 2u);
}

TEST_F(SetAsideTest, ARowGoesOnFromOnePairingToTheNext) {
  begin(3, 4);
  // 0-1, 1-0, 0-2, 2-0, 1-2, 2-1
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));
  ASSERT_EQ(course->set_aside().size(), 1u);
  EXPECT_EQ(course->set_aside().front().team, 0u);
  EXPECT_EQ(course->set_aside().front().pair, 0u);
}

TEST_F(SetAsideTest, TheRestPlaysOnAndWhatIsIgnoredMayHoldAnything) {
  // Played twice: with whatever matches of the team there are, and with none.
  std::array<std::vector<std::array<statistics::Count, 5>>, 2> pairs;
  std::array<std::uint64_t, 2> matches{};
  for (const bool held : {false, true}) {
    begin(3, 2, 4);
    bool more = true;
    while (course->taken() < plan.matches()) {
      ASSERT_TRUE(more);
      const std::uint64_t index = course->taken();
      const Fixture fixture = course->calendar().at(index);
      if (course->wanted(index)) {
        const bool plays = fixture.home == 1 || fixture.away == 1;
        const campaign::MatchResult decided = plays ? failed(fixture.home == 1 ? 0 : 1) : match(2, 1);
        more = course->take(&decided);
      } else {
        EXPECT_TRUE(fixture.home == 1 || fixture.away == 1);
        const campaign::MatchResult ignored = index % 2 == 0 ? match(9, 0) : failed(fixture.home == 1 ? 1 : 0);
        more = course->take(held ? &ignored : nullptr);
      }
    }
    EXPECT_TRUE(more);
    ASSERT_EQ(course->set_aside().size(), 1u);
    EXPECT_EQ(course->set_aside().front().team, 1u);
    EXPECT_EQ(course->set_aside().front().pair, 0u);
    EXPECT_THAT(course->forfeits().of_team(), ElementsAre(0, 2, 0));
    ASSERT_EQ(course->forfeits().listed().size(), 1u);
    for (const Meeting& meeting : course->meetings()) {
      pairs[held ? 1 : 0].push_back(meeting.pairs.seen);
      EXPECT_EQ(2 * total(meeting.pairs), static_cast<statistics::Count>(meeting.matches()));
    }
    matches[held ? 1 : 0] = course->matches();
  }
  EXPECT_EQ(pairs[0], pairs[1]);
  using Counts = std::array<statistics::Count, 5>;
  // 0-1 once, forfeited twice by team 1; 0-2 in all four pairs; 1-2 never, for it comes after.
  EXPECT_THAT(pairs[0], ElementsAre(Counts{0, 0, 0, 0, 1}, Counts{0, 0, 4, 0, 0}, Counts{}));
  EXPECT_EQ(matches[0], 10u);
  EXPECT_EQ(matches[1], 10u);
}

TEST_F(SetAsideTest, ItIsOverWhenNobodyIsLeftToPlayAgainst) {
  begin(3, 2);
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_TRUE(forfeited_by(0));  // aside: 1 and 2 are left
  EXPECT_TRUE(course->take(nullptr));
  EXPECT_TRUE(course->take(nullptr));
  EXPECT_TRUE(forfeited_by(2));
  EXPECT_FALSE(forfeited_by(2));
  ASSERT_EQ(course->set_aside().size(), 2u);
  EXPECT_EQ(course->set_aside()[1].team, 2u);
}

TEST_F(SetAsideTest, AGauntletIsOverWithoutItsFirstTeam) {
  plan = plan_of(3, 1000);
  plan.asked.format = config::Tournament::Format::gauntlet;
  plan.asked.failures_in_a_row = 2;
  course.emplace(plan);
  EXPECT_TRUE(forfeited_by(0));
  EXPECT_FALSE(forfeited_by(0));
}

}  // namespace
}  // namespace regista::study
