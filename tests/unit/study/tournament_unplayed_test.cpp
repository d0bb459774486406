// SPDX-License-Identifier: MIT
// Pairs that could not be played: they count nowhere, and no verdict rests on what they might have brought. Compared
// with tournaments in which they were played and went all one way or all the other.
#include <gmock/gmock.h>

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "study/tournament_course.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using PairCounts = std::array<statistics::Count, 5>;

// Goals of the first team less those of the second, in the match at home and in that away; nothing: not played.
struct Played {
  std::array<int, 2> goals{};
};
using Stream = std::vector<std::optional<Played>>;

constexpr int most_goals = 10;

std::string metrics(int of_home, int of_away) {
  return R"({"packets":[)" + std::to_string(100 + of_home) + "," + std::to_string(100 + of_away) + "]}";
}

// A match in which a team has as many more packets as it has more goals.
campaign::MatchResult match_of(int difference, bool first_at_home) {
  const int home = first_at_home ? difference : -difference;
  return match(std::max(home, 0), std::max(-home, 0), metrics(home, 0));
}

// What a tournament of these pairs ends with, and after how many.
struct End {
  Verdict verdict = Verdict::none;
  bool first_has_more = false;
  std::uint64_t taken = 0;
};

End play(const TournamentPlan& plan, const Stream& stream) {
  Tournament course(plan);
  bool more = true;
  for (const std::optional<Played>& pair : stream) {
    const campaign::MatchResult first = pair ? match_of(pair->goals[0], true) : unplayed(),
                                second = pair ? match_of(pair->goals[1], false) : match_of(3, false);
    EXPECT_TRUE(course.take(&first));
    more = course.take(&second);
    if (!more) break;
  }
  EXPECT_TRUE(more || course.complete());
  return {course.verdict(), course.verdict() == Verdict::accept_h1 && course.first_has_more(), course.taken()};
}

// The same with every pair that could not be played filled in.
Stream filled(const Stream& stream, int goals) {
  Stream out = stream;
  for (std::optional<Played>& pair : out) {
    if (!pair) pair = Played{{goals, goals}};
  }
  return out;
}

Stream without(const Stream& stream) {
  Stream out = stream;
  std::erase_if(out, [](const std::optional<Played>& pair) { return !pair; });
  return out;
}

Stream drawn(std::mt19937_64& random, std::size_t pairs, int better, unsigned one_in) {
  Stream out;
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto goals = [&] { return static_cast<int>(random() % 5) - 2 + (random() % 3 == 0 ? better : 0); };
    const int first = goals(), second = goals();
    if (one_in > 0 && random() % one_in == 0)
      out.emplace_back();
    else
      out.push_back(Played{{first, second}});
  }
  return out;
}

std::vector<TournamentPlan> plans(std::uint64_t pairs) {
  ScoreTest score;
  score.design = {statistics::Model::normalized, {0, 100}, {0.05, 0.05}, true};
  return {plan_of(2, pairs, score), plan_of(2, pairs, ValueTest{goals_value, 0.05}),
          plan_of(2, pairs, ValueTest{"packets", 0.05})};
}

TEST(UnplayedPairs, CountNowhereAndLeaveTheirOtherMatchOut) {
  for (const TournamentPlan& plan : plans(100)) {
    Tournament with(plan), alone(plan);
    std::mt19937_64 random(1);
    for (int pair = 0; pair < 12; ++pair) {
      const int a = static_cast<int>(random() % 5) - 2, b = static_cast<int>(random() % 5) - 2;
      const campaign::MatchResult home = match_of(a, true), away = match_of(b, false), big = match_of(9, true),
                                  none = unplayed();
      if (pair % 4 == 1) {
        with.take(&none);
        with.take(&big);
      } else if (pair % 4 == 3) {
        with.take(&big);
        with.take(&none);
      }
      with.take(&home);
      with.take(&away);
      alone.take(&home);
      alone.take(&away);
      const Meeting &left = with.meetings().front(), &right = alone.meetings().front();
      EXPECT_EQ(left.pairs, right.pairs);
      EXPECT_EQ(left.games, right.games);
      EXPECT_EQ(left.goals, right.goals);
      EXPECT_EQ(left.goals_of_matches.mean(), right.goals_of_matches.mean());
      EXPECT_EQ(left.goals_of_pairs.variance(), right.goals_of_pairs.variance());
      EXPECT_EQ(left.goals_sequence.interval().low, right.goals_sequence.interval().low);
      EXPECT_EQ(left.goals_sequence.interval().high, right.goals_sequence.interval().high);
      if (left.metric) {
        EXPECT_EQ(left.metric->signs(), right.metric->signs());
      }
      EXPECT_EQ(with.matches(), alone.matches());
    }
    EXPECT_EQ(with.unplayed_pairs(), 6u);
    EXPECT_EQ(with.remarks().unplayed.count(), 6u);
    EXPECT_EQ(with.remarks().unplayed.listed().front(), (MatchRemark{2, unplayed().why_set_aside}));
    EXPECT_EQ(with.remarks().unplayed.listed()[1].match, 9u);
    EXPECT_EQ(alone.unplayed_pairs(), 0u);
    EXPECT_FALSE(alone.meetings().front().either_way);
  }
}

TEST(UnplayedPairs, TheirForfeitsAreNoneAndTheirMatchesSayNothingOfARow) {
  TournamentPlan plan = plan_of(2, 100);
  plan.asked.failures_in_a_row = 3;
  Tournament course(plan);
  const campaign::MatchResult by_home = failed(0), by_away = failed(1), other = failed(0, "other"), none = unplayed();
  const auto pair = [&](const campaign::MatchResult& first, const campaign::MatchResult& second) {
    EXPECT_TRUE(course.take(&first));
    return course.take(&second);
  };
  EXPECT_TRUE(pair(by_home, none));  // team 0, taken back
  EXPECT_THAT(course.forfeits().of_team(), ElementsAre(0, 0));
  EXPECT_THAT(course.forfeits().listed(), testing::IsEmpty());
  EXPECT_TRUE(pair(none, by_home));  // team 1
  EXPECT_THAT(course.forfeits().of_team(), ElementsAre(0, 0));
  EXPECT_TRUE(pair(other, by_away));  // team 0 twice
  EXPECT_TRUE(pair(other, none));     // taken back, the one before stays
  EXPECT_THAT(course.forfeits().of_team(), ElementsAre(2, 0));
  ASSERT_EQ(course.forfeits().listed().size(), 2u);
  EXPECT_EQ(course.forfeits().listed()[0].count, 1u);
  EXPECT_EQ(course.matches(), 2u);
}

// The definition itself, by brute force.
TEST(UnplayedPairs, AVerdictIsThatOfAllThreeWaysToCountThem) {
  std::array<int, 5> seen{};
  for (const TournamentPlan& plan : plans(150)) {
    for (unsigned seed = 0; seed < 120; ++seed) {
      std::mt19937_64 random(seed);
      const Stream stream =
          drawn(random, plan.pairs(), static_cast<int>(seed % 5) - 2, std::array{0u, 6u, 40u}[seed % 3]);
      const End ended = play(plan, stream);
      // As far as it came: what comes later can change nothing.
      const Stream so_far(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(ended.taken / 2));
      const std::array<End, 3> ways{play(plan, without(so_far)), play(plan, filled(so_far, -most_goals)),
                                    play(plan, filled(so_far, most_goals))};
      const auto same = [](const End& a, const End& b) {
        return a.verdict == b.verdict && a.first_has_more == b.first_has_more;
      };
      if (same(ways[0], ways[1]) && same(ways[0], ways[2])) {
        EXPECT_TRUE(same(ended, ways[0])) << seed;
      } else {
        EXPECT_EQ(ended.verdict, Verdict::prevented) << seed;
      }
      ++seen[static_cast<std::size_t>(ended.verdict)];
    }
  }
  EXPECT_GT(seen[1], 5);   // inconclusive
  EXPECT_GT(seen[2], 5);   // H0
  EXPECT_GT(seen[3], 20);  // H1
  EXPECT_GT(seen[4], 20);  // prevented
}

// Whoever can make a match that it is about to lose impossible to play gains nothing: each verdict for it also comes
// out when it loses these pairs.
TEST(UnplayedPairs, WhoLosesNoMatchThatCanBePlayedGetsNoVerdictItWouldNotGetByLosing) {
  int prevented = 0, tempting = 0;
  for (const TournamentPlan& plan : plans(200)) {
    for (unsigned seed = 0; seed < 40; ++seed) {
      std::mt19937_64 random(seed);
      Stream stream = drawn(random, plan.pairs(), -1, 0);
      for (std::optional<Played>& pair : stream) {
        if (pair->goals[0] < 0 || pair->goals[1] < 0) pair.reset();
      }
      const End ended = play(plan, stream), lost = play(plan, filled(stream, -most_goals)),
                unpunished = play(plan, without(stream));
      // Left out without a further thought they would make it the better one.
      if (unpunished.verdict == Verdict::accept_h1) ++tempting;
      if (ended.verdict == Verdict::accept_h1 && (plan.objective().index() == 1 || ended.first_has_more)) {
        EXPECT_EQ(lost.verdict, Verdict::accept_h1) << seed;
        EXPECT_EQ(lost.first_has_more, ended.first_has_more);
      }
      EXPECT_NE(ended.verdict, Verdict::accept_h1) << seed;
      if (ended.verdict == Verdict::prevented && ended.taken < plan.matches()) ++prevented;
    }
  }
  EXPECT_GT(tempting, 60);
  EXPECT_GT(prevented, 60);  // as soon as it is clear that the three will not agree
}

TEST(UnplayedPairs, OneAmongManyStopsNoVerdictForLong) {
  for (const TournamentPlan& plan : plans(2000)) {
    for (const bool at_first : {false, true}) {
      Stream stream(2000, Played{{1, 1}});
      for (std::size_t i = 0; i < stream.size(); i += 3) stream[i] = Played{{1, -1}};
      const End undisturbed = play(plan, stream);
      stream[at_first ? 0 : undisturbed.taken / 4] = std::nullopt;
      const End ended = play(plan, stream);
      EXPECT_EQ(ended.verdict, Verdict::accept_h1);
      EXPECT_GT(ended.taken, undisturbed.taken);
      EXPECT_LT(ended.taken, 3 * undisturbed.taken);
    }
  }
}

TEST(UnplayedPairs, OnlyTheirOwnPairingLacksThem) {
  const TournamentPlan plan = plan_of(3, 2);
  Tournament course(plan);
  const campaign::MatchResult won = match(1, 0), none = unplayed();
  for (std::uint64_t i = 0; i < plan.matches(); ++i) course.take(i == 3 ? &none : &won);
  EXPECT_EQ(course.meetings()[0].unplayed_pairs, 0u);
  EXPECT_EQ(course.meetings()[1].unplayed_pairs, 1u);
  EXPECT_EQ(course.meetings()[0].pairs.seen, (PairCounts{0, 0, 2, 0, 0}));
  EXPECT_EQ(course.meetings()[1].pairs.seen, (PairCounts{0, 0, 1, 0, 0}));
  EXPECT_EQ(course.verdict(), Verdict::none);
  EXPECT_TRUE(course.complete());
}

TEST(MatchRemarks, NamesTheFirstAndCountsAll) {
  const TournamentPlan plan = plan_of(2, 200);
  Tournament course(plan);
  for (std::uint64_t i = 0; i < plan.matches(); ++i) {
    campaign::MatchResult decided = match(1, 0);
    if (i % 3 == 0) decided.irreproducible = "tick " + std::to_string(i);
    if (i % 2 == 1) decided.output = "a line\n";
    course.take(&decided);
  }
  const MatchRemarks& remarks = course.remarks();
  EXPECT_EQ(remarks.irreproducible.count(), 134u);
  EXPECT_EQ(remarks.irreproducible.listed().size(), 100u);
  EXPECT_EQ(remarks.irreproducible.unlisted(), 34u);
  EXPECT_EQ(remarks.irreproducible.listed()[2], (MatchRemark{6, "tick 6"}));
  EXPECT_EQ(remarks.written_count, 200u);
  EXPECT_EQ(remarks.written.size(), 20u);
  EXPECT_EQ(remarks.written.front(), 1u);
  EXPECT_EQ(remarks.unplayed.count(), 0u);
}

TEST(UnplayedPairs, AfterThreeMatchesOfAPairingThereIsNothingLeftToCompare) {
  const TournamentPlan plan = plan_of(3, 4);
  Tournament course(plan);
  const campaign::MatchResult none = unplayed(), some = match_of(1, true);
  // A pair of each of the three pairings, and again: two deaths in each of them, then a third one.
  for (int pair = 0; pair < 2; ++pair) {
    for (int pairing = 0; pairing < 3; ++pairing) {
      course.take(&none);
      course.take(&some);
    }
  }
  EXPECT_EQ(course.unplayable(), "");
  course.take(&none);
  EXPECT_EQ(course.unplayable(),
            "team 0 against team 1: 3 matches could not be played, and no team can be blamed: " + none.why_set_aside);
}

}  // namespace
}  // namespace regista::study
