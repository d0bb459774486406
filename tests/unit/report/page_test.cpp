// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "course.hpp"
#include "page_soundness.hpp"
#include "report/tournament_report.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const Course& course, const TournamentHistory& record, std::vector<std::string> documents = {},
                    PageRecordings recordings = {}) {
  return tournament_page(course.view(),
                         TournamentPage{record, std::move(documents), std::move(recordings),
                                        [](std::uint64_t match) {
                                          return RecordingLink{
                                              "night.recordings/" + std::to_string(match + 1) + ".mcap",
                                              "regista view " + std::to_string(match + 1)};
                                        }},
                         tournament_figures(course.view(), record));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

void expect_order(const std::string& page, const std::vector<std::string>& ids) {
  std::size_t last = 0;
  for (const std::string& id : ids) {
    const std::size_t at = page.find("id=\"" + id + "\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
  }
}

constexpr auto roles =
    R"({"roles":[{"s":{"overlap_seconds":1,"uncovered_seconds":2,"switches":3}},{"s":{"overlap_seconds":1,"uncovered_seconds":2,"switches":3}}],"packets":[1,2],"packets_by_reason":[{"goal":1},{"goal":2}]})";

// Bold is a difference whose interval does not include zero.
TEST(TournamentPage, BoldIsWhatDiffers) {
  const auto page_with = [](int first, int second) {
    Course course({"new", "old"}, 40);
    TournamentHistory record(course.plan, *course.tournament);
    for (int i = 0; i < 80; ++i) {
      const int a = first + i % 3, b = second + (i + 1) % 3;
      const campaign::MatchResult decided =
          match(0, 0,
                fmt::format(R"({{"packets":[{0},{1}],"packets_by_reason":[{{"goal":{0}}},{{"goal":{1}}}]}})",
                            i % 2 == 0 ? a : b, i % 2 == 0 ? b : a));
      course.take(decided);
      record.take(&decided);
    }
    return page_of(course, record);
  };
  constexpr auto bold = "<span class=\"differs\">";
  EXPECT_EQ(count(page_with(100, 100), bold), 0u);
  EXPECT_THAT(page_with(100, 300), HasSubstr(std::string(bold) + "-200"));
}

TEST(TournamentPage, HasItsPartsInTheirOrder) {
  Course course({"new", "old"}, 10);
  TournamentHistory record(course.plan, *course.tournament);
  const auto take = [&](const campaign::MatchResult& decided) {
    course.take(decided);
    record.take(&decided);
  };
  for (int i = 0; i < 19; ++i) take(match(i % 3, i % 2, roles));
  take(failed(1));
  const std::string page = page_of(course, record, {"team: new\nx: 1\n", "team: old\nx: 2\n"},
                                   {{{3, {0, 1}, false, {}}, {19, {0, 10}, true, {}}}, 1});
  expect_order(page, {"verdict", "standing", "curves", "roles", "packets", "variance", "failures", "recordings",
                      "configuration", "reproduction"});
  EXPECT_THAT(page, AllOf(HasSubstr("the first again: <code>again 19"), HasSubstr("href=\"./night.recordings/4.mcap\""),
                          HasSubstr("regista view 4"),
                          HasSubstr("<td><code class=\"path\">x</code></td><td><code>1</code></td>"),
                          HasSubstr("(forfeit, as far as it was played)"), HasSubstr("1 more file not read."),
                          HasSubstr("hash of new"), HasSubstr("regista run study.yaml")));
  EXPECT_EQ(count(page, "<svg "), 5u);
  // The figure that shows the verdict stands beside it, and not again below.
  const std::size_t lead = page.find("<div class=\"lead\">"),
                    figure = page.find("aria-label=\"Goal differences of matches");
  EXPECT_LT(lead, figure);
  EXPECT_LT(figure, page.find("<nav "));
  for (const char* each : {"verdict", "played", "standing", "roles", "reproduction"})
    EXPECT_EQ(count(page, fmt::format("<a href=\"#{}\">", each)), 1u) << each;
  EXPECT_EQ(count(page, "href=\"data:text/csv"), 5u);
  EXPECT_TRUE(is_our_page(page.substr(0, page_beginning)));
  EXPECT_FALSE(is_our_page("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>"));
  EXPECT_FALSE(is_our_page(""));
}

TEST(TournamentPage, NeedsNothingElse) {
  Course course({"new", "old"}, 2);
  TournamentHistory record(course.plan, *course.tournament);
  expect_sound(page_of(course, record));
}

TEST(TournamentPage, NoNameGetsOutOfItsPlace) {
  const std::string hostile =
      "</title></style></pre><script>alert(1)</script>\"'><img src=x onerror=alert(1)>\n\u202e&#60;";
  Course course({hostile, "=b", "c\"c"}, 4);
  for (study::Entrant& team : course.plan.teams) team.inputs = {{hostile, hostile}};
  course.plan.common_inputs = {{hostile, hostile}};
  course.plan.folder = course.plan.asked.settings.rules = hostile;
  course.plan.openings = {{hostile, {hostile, hostile}}};
  course.tournament.emplace(course.plan);
  TournamentHistory record(course.plan, *course.tournament);
  for (int i = 0; i < 24; ++i) {
    campaign::MatchResult decided = i % 5 == 0 ? failed(0, hostile) : match(i % 3, 1, roles);
    if (decided.failure) decided.failure->plugin = decided.failure->call = hostile;
    course.take(decided);
    record.take(&decided);
  }
  const std::string page = page_of(course, record, {hostile, "team: x\n", "a: b\n"}, {{{0, {1, 0}, false, {}}}, 0});
  EXPECT_EQ(count(page, "<script"), 1u);  // ours
  EXPECT_EQ(count(page, "<img"), 0u);
  EXPECT_EQ(count(page, "\u202e"), 0u);
  EXPECT_EQ(count(page, "</title>"), 1u);
  EXPECT_EQ(count(page, "</style>"), 1u);
  EXPECT_EQ(count(page, "<section"), count(page, "</section>"));
  EXPECT_EQ(count(page, "<details"), count(page, "</details>"));
}

// So few pairs cannot decide: the headline says so, and gives no interval.
TEST(TournamentPage, NoIntervalOfTooFewPairs) {
  const auto page = [](std::uint64_t pairs, const std::array<int, 5>& counts) {
    Course course({"new", "old"}, pairs);
    TournamentHistory record(course.plan, *course.tournament);
    course.take_pairs({counts});
    return page_of(course, record);
  };
  EXPECT_THAT(page(3, {1, 2, 0, 0, 0}),
              AllOf(HasSubstr("3 pairs cannot give a verdict: at least 6 are needed"), Not(HasSubstr("95 %")),
                    HasSubstr("Elo and nElo have no interval, and LOS is not known")));
  EXPECT_THAT(page(43, {0, 9, 28, 6, 0}), AllOf(HasSubstr("with a margin of 95 %"), HasSubstr("-0.035 ± 0.091"),
                                                HasSubstr("43 pairs find a difference of 0.5 goals a match")));
}

TEST(TournamentPage, OfNothing) {
  for (const std::size_t teams : {2u, 3u, 30u}) {
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < teams; ++i) labels.push_back("team " + std::to_string(i));
    Course course(labels, 3);
    TournamentHistory record(course.plan, *course.tournament);
    const std::string page = page_of(course, record);
    EXPECT_THAT(page, HasSubstr("nothing can be said"));
    EXPECT_THAT(page, AllOf(HasSubstr("id=\"standing\""), HasSubstr("id=\"reproduction\""), HasSubstr("</html>")));
  }
}

TEST(TournamentPage, OfOnePairAndOfManyTeams) {
  Course pair({"a", "b"}, 1);
  TournamentHistory of_pair(pair.plan, *pair.tournament);
  for (int i = 0; i < 2; ++i) {
    const campaign::MatchResult decided = match(1, 0, roles);
    pair.take(decided);
    of_pair.take(&decided);
  }
  EXPECT_THAT(page_of(pair, of_pair), HasSubstr("1 pair cannot give a verdict"));
  std::vector<std::string> labels;
  for (int i = 0; i < 20; ++i) labels.push_back("team " + std::to_string(i));
  Course many(labels, 2);
  TournamentHistory of_many(many.plan, *many.tournament);
  for (std::uint64_t i = 0; i < many.tournament->calendar().matches(); ++i) {
    const campaign::MatchResult decided = match(static_cast<int>(i * i % 4), static_cast<int>(i % 3), roles);
    many.take(decided);
    of_many.take(&decided);
  }
  const std::string page = page_of(many, of_many);
  EXPECT_THAT(page, AllOf(HasSubstr("190 pairings"), HasSubstr("All against all"),
                          HasSubstr("No difference was found between 20 teams. 2 pairs cannot give a verdict")));
}

TEST(TournamentPage, SaysWhatWasPlayed) {
  Course course({"new", "old"}, 7, sprt(-10, 5.5));
  study::TournamentPlan& plan = course.plan;
  plan.asked.seed = 3;
  plan.asked.teams[1].disturbance = "noise.yaml";
  plan.asked.settings.rules = "small.yaml";
  plan.asked.settings.limit = 30;
  plan.asked.settings.set = config::Node::map({{"a.sender.params.period", {}, config::Node::scalar("4", false, {})},
                                               {"rules.team_size", {}, config::Node::scalar("5", false, {})}},
                                              {});
  plan.common_inputs = {{"rules small", "1"},
                        {"robot nao", "2"},
                        {"home disturbance none", "3"},
                        {"away disturbance none", "4"},
                        {"program", "0123456789abcdef"}};
  plan.teams[1].disturbances = {{"home disturbance noise", "5"}, {"away disturbance noise", "6"}};
  plan.openings = {{"o/x y.yaml", {"opening x", "7"}}};
  plan.plugins = {"my plugins"};
  const std::string text = section_text(played_section(what_was_played(plan)));
  EXPECT_THAT(
      text,
      AllOf(testing::ContainsRegex("\nnew +new.yaml +[0-9a-f]+ +none \\(built in\\), set sender.params.period=4\n"),
            HasSubstr("  noise (noise.yaml)\n"), HasSubstr("rules small (small.yaml), robot nao (built in)\n"),
            HasSubstr("set rules.team_size=5\n"), HasSubstr("from 1 scene, 30 s at most; 7 pairs, seeds from 3\n"),
            HasSubstr("program 01234567; 10 s")));
  TournamentHistory record(plan, *course.tournament);
  const std::string page = page_of(course, record, {"team: x\n", "team: x\n"});
  EXPECT_THAT(page, AllOf(HasSubstr("noise.yaml"),
                          HasSubstr("disturbance</code></td><td><code>none</code></td><td><code>noise"),
                          HasSubstr("regista report night.db --study again"),
                          HasSubstr("regista run study.yaml --plugins &#39;my plugins&#39;")));
}

}  // namespace
}  // namespace regista::report
