// SPDX-License-Identifier: MIT
// What the program writes as a table its own reader of tables reads: every field, whatever is in it. And the ranking of
// a tournament's table is the ranking of the tournament.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "course.hpp"
#include "report/experiment_report.hpp"
#include "report/given_results.hpp"
#include "report/match_summary.hpp"
#include "report/number.hpp"
#include "report/standing.hpp"
#include "report/tournament_history.hpp"
#include "study/table.hpp"
#include "tuning_course.hpp"
#include "unit/study/experiment_fixture.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

using Rows = std::vector<std::vector<std::string>>;

class TablesOfRegista : public testing::Test {
 protected:
  TablesOfRegista() : file_(fs::temp_directory_path() / ("regista_read_back_" + std::to_string(getpid()) + ".csv")) {}
  ~TablesOfRegista() override { fs::remove(file_); }

  const fs::path& write(const std::string& csv) const {
    std::ofstream(file_, std::ios::binary) << csv;
    return file_;
  }

  // The rows without that of the names. Throws where the reader refuses the table.
  Rows rows(const std::string& csv) const {
    study::Table table(write(csv));
    Rows out;
    while (table.next()) {
      out.emplace_back();
      for (std::size_t i = 0; i < table.columns().size(); ++i) out.back().emplace_back(table.text(i));
    }
    return out;
  }

  void expect_readable(const std::vector<Figure>& figures) const {
    EXPECT_FALSE(figures.empty());
    for (const Figure& each : figures) EXPECT_FALSE(rows(each.csv).empty()) << each.name;
  }
  void expect_readable(const Outline& outline) const {
    for (const Section& section : outline.sections) {
      for (const Item& item : section.items) {
        const auto* const table = std::get_if<Table>(&item.what);
        if (table == nullptr || table->csv.empty()) continue;
        EXPECT_FALSE(rows(table->csv).empty()) << table->file;
      }
    }
  }

  fs::path file_;
};

// Fields of a few signs each, all of which mean something to a reader or a writer.
TEST_F(TablesOfRegista, FieldsComeBackAsTheyWere) {
  const std::vector<std::string> signs{"a", "\"", ",", "\n", "\r\n", "\r", " ", "\t", "'", "ü", ";", "0", "["};
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    Rows wanted;
    std::string csv = "\"x\",y,z\n";
    for (int row = 0; row < 4; ++row) {
      wanted.emplace_back();
      for (int column = 0; column < 3; ++column) {
        std::string field;
        for (auto sign = random() % 6; sign > 0; --sign) field += signs[random() % signs.size()];
        csv += (column == 0 ? "" : ",") + csv_field(field);
        const bool runs = !field.empty() && (field[0] == '\t' || field[0] == '\r');  // a spreadsheet would run it
        wanted.back().push_back(runs ? '\'' + field : field);
      }
      csv += '\n';
    }
    EXPECT_EQ(rows(csv), wanted) << testing::PrintToString(csv);
  }
}

TEST_F(TablesOfRegista, OfATournament) {
  Course course({"a, \"b\"", "c\nd"}, 10);
  match::MetricColumns columns({.of_teams = {"packets", "a,b"}, .of_match = {"ball_rests"}});
  const std::string csv = csv_head(columns.paths()) + csv_line(course.view(), 0, failed(0, "x\r\ny,\"z\""), columns) +
                          csv_line(course.view(), 1, unplayed(), columns) +
                          csv_line(course.view(), 2, match(2, 1, R"({"packets":[3,0.1]})"), columns);
  const Rows read = rows(csv);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0][4], "a, \"b\"");
  EXPECT_EQ(read[0][5], "c\nd");
  EXPECT_EQ(read[0][13], "x\r\ny,\"z\"");
  EXPECT_EQ(read[1][6], "");
  EXPECT_EQ(read[2][15], "0.1");

  TournamentHistory record(course.plan, *course.tournament, {});
  for (int i = 0; i < 8; ++i) {
    const campaign::MatchResult decided = match(i % 3, i % 2, R"({"packets":[3,4]})");
    course.take(decided);
    record.take(&decided);
  }
  expect_readable(tournament_figures(course.view(), record));
}

// Wins, draws, forfeits, a pair without a result and one that has only begun.
TEST_F(TablesOfRegista, OfATournamentAreRankedAsTheTournament) {
  Course course({"a", "b, the \"second\"", "c"}, 40);
  std::mt19937 random(2);
  match::MetricColumns columns({.of_teams = {"packets", "score"}, .of_match = {"ball_rests"}});
  std::string csv = csv_head(columns.paths());
  for (std::uint64_t i = 0; i < 40 * 6 - 3; ++i) {
    campaign::MatchResult decided = match(static_cast<int>(random() % 4), static_cast<int>(random() % 3));
    if (i % 17 == 5) decided = failed(static_cast<int>(i % 2));
    if (i == 20 || i == 51) decided = unplayed();
    course.take(decided);
    csv += csv_line(course.view(), i, decided, columns);
  }
  const RankedResults read = ranked(study::read_results_of_teams(write(csv)));
  const std::vector<Ranked> wanted = ranking(course.plan, *course.tournament);
  ASSERT_EQ(read.teams.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(read.teams[i].name, course.plan.teams[wanted[i].team].label);
    EXPECT_EQ(read.teams[i].points, wanted[i].points);
    ASSERT_TRUE(read.teams[i].elo && wanted[i].elo);
    EXPECT_EQ(read.teams[i].elo->value, wanted[i].elo->value);
    EXPECT_EQ(read.teams[i].elo->interval.low, wanted[i].elo->interval.low);
    EXPECT_EQ(read.teams[i].elo->interval.high, wanted[i].elo->interval.high);
  }
  EXPECT_THAT(read.remarks, ElementsAre("4 games are left out: without a result, or in a pair with such a game."));
}

TEST_F(TablesOfRegista, OfAnExperiment) {
  for (const std::size_t values : {1u, 3u}) {
    study::ExperimentPlan plan = study::experiment_of(2, values, 4);
    plan.asked.arms[0].name = "a, \"b\"";
    const auto report = experiment_report(plan, [](const campaign::Job&) { return std::string(); });
    std::string csv = report->begin_table({});
    std::uint64_t matches = 0;
    report->study().run([&](const study::Round& round) {
      for (std::uint64_t i = 0; i < round.matches; ++i, ++matches) {
        const study::Trial trial = study::trial(plan, i);
        const campaign::MatchResult decided =
            i == 2 ? failed(0) : study::played(trial.side, 10.0, 100 + static_cast<int>(i), 1, 0);
        round.take(i, &decided);
        csv += report->table_lines(round, i, decided);
      }
    });
    EXPECT_GE(rows(csv + report->end_table()).size(), matches);
    const Rows means = rows(report->summary_table());
    EXPECT_EQ(means.size(), plan.measures.size() * plan.conditions.size());
    EXPECT_EQ(means[0][2], "a, \"b\"");
    expect_readable(report->figures());
    expect_readable(report->outline());
  }
}

TEST_F(TablesOfRegista, OfATuning) {
  study::TuningPlan plan = tuning_plan();
  plan.search_pairs = 20;
  const TunedCourse course(plan);
  const Rows trace = rows(tuning_csv(course.view()));
  ASSERT_EQ(trace.size(), course.record.trace.size());
  for (std::size_t i = 0; i < trace.size(); ++i) {
    for (std::size_t parameter = 0; parameter < plan.parameters.size(); ++parameter)
      EXPECT_EQ(std::stod(trace[i][4 + parameter]), course.record.trace[i].values[parameter]);
  }
  expect_readable(tuning_figures(course.view()));
}

TEST_F(TablesOfRegista, OfAMatch) {
  campaign::PlayedMatch played;
  played.seed = 7;
  const std::string csv = metrics_csv(played);
  EXPECT_EQ(rows(csv).front(), (std::vector<std::string>{"", "seed", "7"}));
}

}  // namespace
}  // namespace regista::report
