// SPDX-License-Identifier: MIT
// Reports of short games say what was spent of the share of the budget that their length has, and which team was above
// it.
#include <gmock/gmock.h>

#include "course.hpp"
#include "report/experiment_report.hpp"
#include "report/match_summary.hpp"
#include "report/tournament_history.hpp"
#include "texts/json.hpp"
#include "tuning_course.hpp"
#include "unit/study/experiment_fixture.hpp"

namespace regista::report {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

std::string metrics(int home, int away) {
  return fmt::format(R"({{"packets": [{}, {}], "packets_by_reason": [{{"goal": 1}}, {{"goal": 1}}], )"
                     R"("packets_share": [30, 30], "packets_over_share": [{}, {}]}})",
                     home, away, home - 30, away - 30);
}

// Two pairs; a spends 45 packets in each match, b 20.
struct ShortGames : Course {
  explicit ShortGames(std::vector<std::string> labels = {"a", "b"}) : Course(std::move(labels), 2) {
    plan.asked.settings.limit = 30;
    tournament.emplace(plan);
  }
  std::vector<campaign::MatchResult> matches() const {
    return {match(0, 0, metrics(45, 20)), match(0, 0, metrics(20, 45)), match(0, 0, metrics(45, 20)),
            match(0, 0, metrics(20, 45))};
  }
  void play() {
    for (const campaign::MatchResult& each : matches()) take(each);
  }
};

TEST(PacketsSpent, TextOfATournament) {
  ShortGames course;
  EXPECT_THAT(tournament_text(course.view()), Not(HasSubstr("packets")));  // nothing is known yet
  course.play();
  EXPECT_THAT(tournament_text(course.view()),
              HasSubstr("\na spent 45 packets per match, more than the share of the budget for this length: 30.\n"
                        "b spent 20 packets per match; the share of the budget for this length is 30.\n"
                        "Each of these games has the packets of a whole match. A team above its share sends more often "
                        "than it could all through a whole match. With --set rules.messages.short_games=share a short "
                        "game has its share of them.\n"));
  EXPECT_THAT(standing_text(course.view()), Not(HasSubstr("packets")));  // of the live display
}

// Of one match; 30 packets are its share of the budget, and 31 are 3 % more.
TEST(PacketsSpent, ShareAndFivePercentIsNotAboveIt) {
  campaign::PlayedMatch match;
  match.teams = match.titles = {"a", "b"};
  match.budget = 1200;
  match.packets_share = 30.0;
  match.result.packets = {30, 31};
  EXPECT_THAT(summary_text(match, {}),
              AllOf(HasSubstr("\na (home)\n"), HasSubstr("  packets 30 of 1200 (share of this length: 30)\n"),
                    HasSubstr("\nb (away)\n"), HasSubstr("  packets 31 of 1200 (share of this length: 30)\n")));
  match.result.packets = {32, 0};
  EXPECT_THAT(summary_text(match, {}), HasSubstr("  packets 32 of 1200 (more than the share of this length: 30)\n"));
}

TEST(PacketsSpent, TextOfSeveralTeamsStandsBelowTheirPairings) {
  ShortGames course({"a", "b", "c"});
  course.play();
  EXPECT_THAT(tournament_text(course.view()), HasSubstr("\n\nPackets\na spent 45 packets per match, "));
}

TEST(PacketsSpent, WholeMatchesHaveNothingToTell) {
  Course course({"a", "b"}, 2);
  for (int i = 0; i < 4; ++i) course.take(match(0, 0, metrics(45, 20)));
  EXPECT_THAT(tournament_text(course.view()), Not(HasSubstr("packets")));
  EXPECT_EQ(json::parse(tournament_json(course.view()))["teams"][0]["packets_of_short_games"], nullptr);
  EXPECT_TRUE(csv_metrics(course.plan).empty());
}

TEST(PacketsSpent, JsonOfATournament) {
  ShortGames course;
  course.play();
  const json teams = json::parse(tournament_json(course.view()))["teams"];
  EXPECT_EQ(teams[0]["packets_of_short_games"], json::parse(R"({"per_match": 45, "share": 30, "above_share": true})"));
  EXPECT_EQ(teams[1]["packets_of_short_games"], json::parse(R"({"per_match": 20, "share": 30, "above_share": false})"));
}

TEST(PacketsSpent, TableOfATournament) {
  const ShortGames course;
  match::MetricColumns columns(csv_metrics(course.plan));
  EXPECT_THAT(csv_head(columns.paths()),
              EndsWith(",why,home.packets,away.packets,home.packets_share,away.packets_share,"
                       "home.packets_over_share,away.packets_over_share\n"));
  EXPECT_THAT(csv_line(course.view(), 0, course.matches()[0], columns), EndsWith(",,,,,45,20,30,30,15,-10\n"));
  EXPECT_THAT(csv_line(course.view(), 0, failed(0), columns), EndsWith(",Segmentation fault,,,,,,\n"));
}

TEST(PacketsSpent, PageOfATournament) {
  ShortGames course;
  TournamentHistory record(course.plan, *course.tournament);
  for (const campaign::MatchResult& each : course.matches()) {
    course.take(each);
    record.take(&each);
  }
  const std::string page = tournament_page(course.view(), record);
  EXPECT_THAT(page, HasSubstr("<bdi>a</bdi> spent 45 packets per match, more than the share of the budget for this "
                              "length: 30."));
  EXPECT_THAT(page,
              HasSubstr("<bdi>b</bdi> spent 20 packets per match; the share of the budget for this length is 30."));
}

// The tuned team spends 45 packets in each match of the verification, whichever side it plays on; the opponents 20.
TEST(PacketsSpent, OfATunedTeam) {
  const study::TuningPlan plan = tuning_plan();
  const TunedCourse course(plan, [&](const campaign::Job& job) {
    campaign::MatchResult decided = decided_by(plan, job, peak);
    const bool at_home = job.overrides.front().starts_with("home.");
    decided.metrics = campaign::metrics_from_json(at_home ? metrics(45, 20) : metrics(20, 45));
    return decided;
  });
  EXPECT_THAT(text_of(course.view()),
              HasSubstr("It spent 45 packets per match, more than the share of the budget for this length: 30.\n"));
  EXPECT_EQ(json::parse(
                outline_json(tuning_outline(course.view())))["verification"]["candidates"][0]["packets_of_short_games"],
            json::parse(R"({"per_match": 45, "share": 30, "above_share": true})"));
  const TunedCourse whole(plan, [&](const campaign::Job& job) { return decided_by(plan, job, peak); });
  EXPECT_THAT(text_of(whole.view()), Not(HasSubstr("packets")));
}

// Every condition spends 10 packets more than the one before, the first 10.
struct ToldExperiment {
  std::vector<std::string> notes;
  json conditions;
};
ToldExperiment told(const study::ExperimentPlan& plan) {
  study::Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const study::Trial each = trial(plan, index);
    campaign::MatchResult decided = study::played(each.side, 1.0, 0, 0, 0);
    const int own = 10 + 10 * static_cast<int>(each.condition);
    decided.metrics = campaign::metrics_from_json(each.side == 0 ? metrics(own, 999) : metrics(999, own));
    course.take(decided);
  }
  const ExperimentView view{plan, course, [](std::uint64_t) { return std::string(); }};
  return {experiment_notes(view), json::parse(outline_json(experiment_outline(view)))["conditions"]};
}

TEST(PacketsSpent, OfTheArmsOfAnExperiment) {
  const ToldExperiment arms = told(study::experiment_of(4, 1, 2));
  EXPECT_THAT(arms.notes,
              Contains("Packets per match, and the share of the budget for games of this length: arm 0 10 of "
                       "30, arm 1 20 of 30, arm 2 30 of 30, arm 3 40 of 30 (more than its share)."));
  EXPECT_EQ(arms.conditions[1]["packets_of_short_games"],
            json::parse(R"({"per_match": 20, "share": 30, "above_share": false})"));
  EXPECT_EQ(arms.conditions[3]["packets_of_short_games"],
            json::parse(R"({"per_match": 40, "share": 30, "above_share": true})"));
}

TEST(PacketsSpent, OfASweepWhereItIsAboveTheShare) {
  EXPECT_THAT(
      told(study::experiment_of(2, 2, 2)).notes,
      Contains("Packets per match, and the share of the budget for games of this length: more than 5 % above it "
               "in 1 of 4 conditions, most of all arm 1 at 1 40 of 30 (more than its share)."));
  EXPECT_THAT(told(study::experiment_of(1, 3, 2)).notes,
              Contains("Packets per match, and the share of the budget for games of this length: within it, or at most "
                       "5 % above it, in all 3 conditions."));
}

}  // namespace
}  // namespace regista::report
