// SPDX-License-Identifier: MIT
// A metric is one row: added to the table it stands in the JSON and the CSV of a match, among the names that studies
// may use, in the stored row, on the page of a tournament and in the documentation.
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "report/match_summary.hpp"
#include "report/metric_reference.hpp"
#include "report/tournament_report.hpp"
#include "texts/json.hpp"

namespace regista::cli {
namespace {

using testing::Contains;
using testing::HasSubstr;

class MetricRow : public testing::Test {
 protected:
  MetricRow() : table(match::metric_table()) {
    table.push_back(
        {.part = "soccer",
         .name = "headers.won",
         .unit = "times",
         .total = match::MetricRow::Total::sum,
         .title = "Headers won",
         .digits = 1,
         .meaning = "the ball met a head",
         .get = [](const match::MetricSource& from) { return from.side == match::Side::home ? 3.5 : 1.0; }});
    table.push_back({.of = match::MetricRow::Of::role,
                     .part = "soccer",
                     .name = "leaps",
                     .unit = "times",
                     .total = match::MetricRow::Total::sum,
                     .meaning = "off the ground",
                     .get = [](const match::MetricSource& from) { return static_cast<double>(from.member) + 1.0; }});
    played.role_names = {roles, roles};
    for (match::TeamMetrics& team : played.result.metrics.teams) team.coordination.roles.resize(roles.size());
  }

  std::vector<std::string> roles{"goalkeeper", "striker"};
  std::vector<match::MetricRow> table;
  campaign::PlayedMatch played;
};

TEST_F(MetricRow, StandsInTheJson) {
  const auto json = campaign::summary_json(played, table);
  EXPECT_EQ(json["headers"][0]["won"], 3.5);
  EXPECT_EQ(json["headers"][1]["won"], 1);
  EXPECT_EQ(json["roles"][1]["striker"]["leaps"], 2);
}

TEST_F(MetricRow, StandsInTheCsv) {
  const std::string csv = report::metrics_csv(played, table);
  EXPECT_THAT(csv, HasSubstr("\nhome,headers.won,3.5\n"));
  EXPECT_THAT(csv, HasSubstr("\naway,goalkeeper.leaps,1\n"));
}

TEST_F(MetricRow, MayBeNamedBeforeAMatchIsPlayed) {
  const std::vector<std::string> paths = match::metric_paths(table, {roles});
  for (const char* const path : {"headers.won", "striker.leaps", "leaps"}) EXPECT_THAT(paths, Contains(path));
}

TEST_F(MetricRow, IsStored) {
  const match::MetricNumbers numbers = campaign::numbers_of(played, table);
  const match::MetricNumbers stored(
      campaign::names_of(campaign::names_text(numbers.names())),
      campaign::numbers_of(campaign::number_bytes(numbers.values()), numbers.names().size()));
  EXPECT_EQ(stored.of_side(match::Side::home, "headers.won"), 3.5);
  EXPECT_EQ(stored.of_side(match::Side::away, "leaps"), 3.0);
  EXPECT_TRUE(stored == numbers);
}

TEST_F(MetricRow, StandsOnThePageOfATournament) {
  study::TournamentPlan plan;
  plan.asked.name = "trial";
  plan.asked.teams = {{"a.yaml", ""}, {"b.yaml", ""}};
  plan.asked.pairs = 1;
  plan.teams = {{"a", {{"team", "1"}}}, {"b", {{"team", "2"}}}};
  plan.most_goals = 10;
  study::Tournament course(plan);
  report::TournamentHistory record(plan, course, {});
  const campaign::MatchResult decided{{0, 0},       "full_time", "9f2c", campaign::numbers_of(played, table),
                                      std::nullopt, 1.0};
  for (int i = 0; i < 2; ++i) {
    course.take(&decided);
    record.take(&decided);
  }
  const report::TournamentView view{plan, course, [](std::uint64_t) { return std::string("again"); }};
  const report::TournamentPage page{record, {}, {}, {}, table};
  const std::string html = outline_page(report::tournament_outline(view, &page), "t.db", {});
  EXPECT_THAT(html, HasSubstr("<td>Headers won</td>"));
  EXPECT_THAT(html, HasSubstr("2.2")) << "the mean of 3.5 at home and 1 away";
}

TEST_F(MetricRow, StandsInTheDocumentation) {
  std::string page = "# Numbers\n";
  for (const std::string_view part : match::metric_parts) page += "<!-- metrics: " + std::string(part) + " -->\n";
  page += "\n| old | table |\n|---|---|\nlast line\n";
  const std::string written = report::with_metric_tables(page, table);
  EXPECT_THAT(written, HasSubstr("| `headers.won` | times | the ball met a head |\n"));
  EXPECT_THAT(written, HasSubstr("| `<role>.leaps` | times | off the ground |\n\n<!-- metrics: plugins -->\n"));
  EXPECT_THAT(written, HasSubstr("|\n\nlast line\n"));
  EXPECT_EQ(written.find("| old |"), std::string::npos);
  EXPECT_EQ(report::with_metric_tables(written, table), written);
  EXPECT_THAT(report::metrics_text(table), HasSubstr("headers.won"));
  EXPECT_THAT(report::metrics_json(table), HasSubstr("\"path\": \"<role>.leaps\""));
}

TEST_F(MetricRow, ThePageHasToNameEveryPartOnce) {
  EXPECT_THROW(report::with_metric_tables("# Numbers\n", table), std::invalid_argument);
  EXPECT_THROW(report::with_metric_tables("<!-- metrics: weather -->\n", table), std::invalid_argument);
}

}  // namespace
}  // namespace regista::cli
