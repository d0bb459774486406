// SPDX-License-Identifier: MIT
#include "report/tournament_report.hpp"

#include <gmock/gmock.h>

#include "course.hpp"
#include "report/standing.hpp"
#include "statistics/paired_tests.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string sentence(const Course& course) { return plain(tournament_verdict(course.view()).sentence); }
std::string beside(const Course& course) {
  std::string out;
  for (const Sentence& each : tournament_verdict(course.view()).beside) out += plain(each) + '\n';
  return out;
}

// One goal decides each match, so the mean of a pair is half of what its points are above one half, in matches.
TEST(TournamentVerdict, OfAFixedNumberOfPairs) {
  Course clear({"new", "old"}, 290);
  clear.take_pairs({{34, 54, 63, 64, 75}});
  // 92 goals in 580 matches; the deviation of a pair is 0.674, and t of 289 degrees 1.968.
  EXPECT_EQ(sentence(clear), "new beats old by 0.159 goals a match (95 % interval 0.081 to 0.236).");
  EXPECT_THAT(beside(clear), AllOf(HasSubstr("new has 336.0 of 580 points (58 %), goals 277:185"),
                                   HasSubstr("exact sign flips of the pairs' goal differences")));
  clear.plan.pairs_before = "100";
  EXPECT_EQ(
      sentence(clear),
      "new is ahead of old by 0.159 goals a match (95 % interval 0.081 to 0.236). Pairs were added after a look.");
  Course other({"new", "old"}, 290);
  other.take_pairs({{75, 64, 63, 54, 34}});
  EXPECT_EQ(sentence(other), "old beats new by 0.159 goals a match (95 % interval 0.081 to 0.236).");
  Course open({"new", "old"}, 25);
  open.take_pairs({{5, 5, 5, 5, 5}});
  // By tables of the power of t: a difference of 0.69 deviations needs 19 pairs. Five even pairs make it a few more.
  EXPECT_EQ(sentence(open),
            "Not decided between new and old. 25 pairs find a difference of 0.5 goals a match in four of "
            "five cases.");
  EXPECT_THAT(beside(open), HasSubstr("new scores between -0.30 and 0.30 goals a match more than old."));
}

// A difference of half a goal needs 3 of 4 pairs to be uneven here, all for one side; nine pairs have six of them with
// a probability of 0.834, eight with 0.678 (binomial).
TEST(TournamentVerdict, SaysWhatTheSizeOfANewTournamentRestsOn) {
  Course open({"new", "old"}, 7);
  open.take_pairs({{0, 1, 5, 1, 0}});
  EXPECT_EQ(sentence(open),
            "Not decided between new and old. A new tournament of about 9 pairs would find a difference of 0.5 goals a "
            "match in four of five cases.");
  const study::Meeting& meeting = open.tournament->meetings().front();
  const auto [low, high] = statistics::spread_interval(statistics::Spread(meeting.goals_of_pairs), 7);
  const statistics::PowerDesign design;
  EXPECT_THAT(beside(open),
              HasSubstr("That number rests on these 7 pairs (2 uneven); with 95 % confidence it is about " +
                        std::to_string(*statistics::pairs_needed(0.5, low, design)) + " to " +
                        std::to_string(*statistics::pairs_needed(0.5, high, design)) + ".\n"));
}

TEST(TournamentVerdict, SaysThatMatchesAreTooShortForGoals) {
  Course course({"new", "old"}, 6);
  course.plan.asked.settings.limit = 60.0;
  course.tournament.emplace(course.plan);
  for (int match_ = 0; match_ < 12; ++match_) course.take(match(0, 0));
  EXPECT_EQ(sentence(course), "Not decided between new and old. All pairs ended with the same goal difference.");
  EXPECT_THAT(beside(course), HasSubstr("No match had a goal. Play longer ones, or whole matches.\n"));
  Course whole({"new", "old"}, 6);
  for (int match_ = 0; match_ < 12; ++match_) whole.take(match(0, 0));
  EXPECT_THAT(beside(whole), Not(HasSubstr("too short")));
}

// The headline agrees with the one test that decides, and an interval beside it is never of fewer than six pairs.
TEST(TournamentVerdict, FollowsTheTestThatDecides) {
  std::mt19937_64 random(7);
  int decided = 0, open = 0;
  for (int i = 0; i < 300; ++i) {
    std::array<int, 5> counts{};
    int pairs = 0;
    for (int& count : counts) pairs += count = static_cast<int>(random() % (i % 3 == 0 ? 4 : 12));
    if (pairs == 0) continue;
    Course course({"new", "old"}, static_cast<std::uint64_t>(pairs));
    course.take_pairs({counts});
    const double p = p_values(*course.tournament).adjusted.front();
    EXPECT_EQ(sentence(course).find(" beats ") != std::string::npos, p < 0.05);
    EXPECT_EQ(sentence(course).find("Not decided") != std::string::npos, p >= 0.05);
    if (pairs < 6) {
      EXPECT_THAT(sentence(course) + beside(course), Not(HasSubstr("95 %")));
    }
    (p < 0.05 ? decided : open) += 1;
  }
  EXPECT_GT(decided, 30);
  EXPECT_GT(open, 50);
}

// Nine points of ten, and still no five pairs can decide: that is said, not "no difference".
TEST(TournamentVerdict, OfFewerPairsThanCanDecide) {
  Course few({"new", "old"}, 5);
  few.take_pairs({{0, 0, 1, 0, 4}});
  EXPECT_EQ(sentence(few), "Not decided between new and old. 5 pairs cannot give a verdict: at least 6 are needed.");
  Course six({"new", "old"}, 6);
  six.take_pairs({{0, 0, 0, 0, 6}});
  EXPECT_EQ(sentence(six), "new beats old by 1.00 goals a match.");
  Course several({"a", "b", "c"}, 6);
  several.take_pairs({{0, 0, 0, 0, 6}, {0, 0, 0, 0, 6}, {0, 0, 0, 0, 6}});
  EXPECT_EQ(
      sentence(several),
      "No difference was found between 3 teams. 6 pairs cannot give a verdict: at least 7 are needed with 3 pairings.");
}

// Who stops where it looks good must not be told that it is a finding.
TEST(TournamentVerdict, NothingIsFoundBeforeTheEnd) {
  Course course({"new", "old"}, 291);
  EXPECT_THAT(sentence(course), HasSubstr("nothing can be said"));
  course.take_pairs({{34, 54, 63, 64, 75}});
  EXPECT_THAT(sentence(course), AllOf(HasSubstr("Not at its end"), Not(HasSubstr("beats"))));
  EXPECT_THAT(beside(course), Not(HasSubstr("confidence")));
}

TEST(TournamentVerdict, OfEqualTeams) {
  Course course({"a", "b"}, 2);
  course.plan.teams[1].inputs = course.plan.teams[0].inputs;
  course.take_pairs({{0, 0, 2, 0, 0}});
  EXPECT_THAT(sentence(course), HasSubstr("are the same team"));
}

TEST(TournamentVerdict, OfATestOfScores) {
  const auto after = [](double elo0, double elo1, const std::array<int, 5>& pairs, std::uint64_t most = 100000) {
    Course course({"new", "old"}, most, sprt(elo0, elo1));
    course.take_pairs({pairs});
    return sentence(course) + '|' + beside(course);
  };
  const std::array<int, 5> good{5, 5, 20, 300, 300}, bad{300, 300, 20, 5, 5};
  EXPECT_THAT(after(0, 20, good),
              AllOf(HasSubstr("new is stronger than old.|"), HasSubstr("accepted H1"), HasSubstr("biased")));
  EXPECT_THAT(after(0, 20, bad), HasSubstr("new is not 20 nElo stronger than old.|"));
  EXPECT_THAT(after(-20, 0, good), HasSubstr("new is not 20 nElo weaker than old.|"));
  EXPECT_THAT(after(-20, 0, bad), HasSubstr("old is stronger than new.|"));
  EXPECT_THAT(after(-5, 5, good), HasSubstr("new is stronger than old.|"));
  EXPECT_THAT(after(-5, 5, bad), HasSubstr("old is stronger than new.|"));
  EXPECT_THAT(after(-40, -20, good), HasSubstr("new is not 40 nElo weaker than old.|"));
  EXPECT_THAT(after(20, 40, bad), HasSubstr("new is not 40 nElo stronger than old.|"));
  EXPECT_THAT(after(0, 20, {1, 0, 0, 0, 1}), HasSubstr("No verdict yet on new and old."));
  EXPECT_THAT(after(0, 20, {1, 0, 0, 0, 1}, 2), HasSubstr("ended without a verdict on new and old."));
}

TEST(TournamentVerdict, SaysWhatATestOfFewUnevenPairsRestsOn) {
  const auto after = [](const std::array<int, 5>& pairs, std::uint64_t most) {
    Course course({"new", "old"}, most, sprt(0, 50));
    course.take_pairs({pairs});
    return sentence(course);
  };
  // By hand: each even pair takes 0.0406 off, and the test stops half of that above -2.9444.
  EXPECT_EQ(after({0, 0, 100, 0, 0}, 100),
            "new is not 50 nElo stronger than old. All 73 pairs were even: the test takes this for equal strength.");
  EXPECT_EQ(after({0, 1, 28, 1, 0}, 30),
            "The test ended without a verdict on new and old. The test rests on 2 of 30 pairs that were uneven.");
  EXPECT_EQ(after({0, 1, 28, 0, 0}, 30),
            "No verdict yet on new and old. The test rests on 1 of 29 pairs that was uneven.");
  EXPECT_EQ(after({0, 5, 20, 5, 0}, 30), "The test ended without a verdict on new and old.");
}

TEST(TournamentVerdict, OfATestOfGoals) {
  Course course({"new", "old"}, 100000, study::ValueTest{study::goals_value, 0.05});
  course.take_pairs({{0, 0, 0, 0, 1000}});
  EXPECT_EQ(sentence(course), "new scores more goals than old.");
  Course other({"new", "old"}, 100000, study::ValueTest{study::goals_value, 0.05});
  other.take_pairs({{1000, 0, 0, 0, 0}});
  EXPECT_EQ(sentence(other), "old scores more goals than new.");
}

TEST(TournamentVerdict, OfATestOfAMetric) {
  Course course({"new", "old"}, 100000, study::ValueTest{"packets", 0.05});
  for (int pair = 0; pair < 200; ++pair) {
    course.take(match(0, 0, R"({"packets":[3,5]})"));
    if (!course.take(match(0, 0, R"({"packets":[5,3]})"))) break;
  }
  EXPECT_EQ(sentence(course), "new mostly has less packets than old.");
}

TEST(TournamentVerdict, OfARoundRobin) {
  Course clear({"a", "b", "c"}, 40);
  clear.take_pairs({{30, 5, 5, 0, 0}, {0, 5, 5, 5, 25}, {0, 0, 0, 5, 35}});
  EXPECT_EQ(sentence(clear), "b leads 3 teams. b beats a by 0.81 goals a match (95 % interval 0.70 to 0.93).");
  Course open({"a", "b", "c"}, 5);
  open.take_pairs({{3, 0, 1, 0, 1}, {3, 0, 0, 0, 2}, {1, 0, 1, 0, 3}});
  EXPECT_THAT(sentence(open), HasSubstr("No difference was found between 3 teams. 5 pairs cannot give a verdict"));
  Course even({"a", "b", "c"}, 2);
  even.take_pairs({{0, 0, 2, 0, 0}, {0, 0, 2, 0, 0}, {0, 0, 2, 0, 0}});
  EXPECT_EQ(sentence(even), "All 3 teams have the same points.");
  Course together({"a", "b", "c"}, 8);
  together.take_pairs({{0, 0, 8, 0, 0}, {0, 0, 0, 1, 7}, {0, 0, 0, 1, 7}});
  EXPECT_THAT(sentence(together), HasSubstr(" and 1 more lead 3 teams together."));
  Course unplayed({"a", "b", "c"}, 5);
  EXPECT_THAT(sentence(unplayed), HasSubstr("nothing can be said"));
}

TEST(TournamentVerdict, OfAGauntlet) {
  Course course({"a", "b", "c", "d"}, 40);
  course.plan.asked.format = config::Tournament::Format::gauntlet;
  course.tournament.emplace(course.plan);
  course.take_pairs({{30, 5, 5, 0, 0}, {0, 5, 5, 5, 25}, {10, 0, 20, 0, 10}});
  EXPECT_EQ(sentence(course), "a against 3 others: beats 1, loses to 1, not decided against 1.");
}

TEST(TournamentVerdict, OfAGauntletCountsEachWay) {
  Course course({"new", "weak", "feeble", "faint", "strong"}, 40);
  course.plan.asked.format = config::Tournament::Format::gauntlet;
  course.tournament.emplace(course.plan);
  course.take_pairs({{0, 0, 5, 0, 35}, {0, 0, 5, 0, 35}, {0, 0, 5, 0, 35}, {35, 0, 5, 0, 0}});
  EXPECT_EQ(sentence(course), "new against 4 others: beats 3, loses to 1, not decided against 0.");
}

TEST(TournamentVerdict, ForfeitsAreTold) {
  Course course({"good", "bad"}, 20);
  course.plan.asked.failures_in_a_row = 2;
  course.tournament.emplace(course.plan);
  course.take(failed(1));
  course.take(failed(0));
  EXPECT_THAT(beside(course),
              AllOf(HasSubstr("bad was set aside after pair 1: its plugin greedy failed 2 times in a row."),
                    HasSubstr("2 matches of 2 were forfeited")));
}

TEST(TournamentVerdict, NamesAreEscaped) {
  Course course({"<script>alert(1)</script>", "b"}, 2);
  course.take_pairs({{0, 0, 2, 0, 0}});
  const TournamentVerdict verdict = tournament_verdict(course.view());
  EXPECT_THAT(html(verdict.sentence).str(), AllOf(HasSubstr("<bdi>&lt;script&gt;"), Not(HasSubstr("<script"))));
}

}  // namespace
}  // namespace regista::report
