// SPDX-License-Identifier: MIT
// What a page is told of the course of a tournament, against the course itself.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <random>
#include <sstream>

#include "course.hpp"
#include "report/standing.hpp"
#include "report/tournament_history.hpp"
#include "report/tournament_report.hpp"
#include "statistics/rating.hpp"

namespace regista::report {
namespace {

struct Recorded : Course {
  explicit Recorded(std::vector<std::string> labels, std::uint64_t pairs = 1'000'000,
                    study::Objective objective = study::FixedNumber{}, std::vector<std::uint64_t> rows = {})
      : Course(std::move(labels), pairs, std::move(objective)), record(plan, *tournament, std::move(rows)) {}
  bool take(const campaign::MatchResult& decided) {
    const bool more = tournament->take(&decided);
    record.take(&decided);
    return more;
  }
  const Figure* figure(const std::string& name) {
    figures = tournament_figures(view(), record);
    const auto found = std::ranges::find(figures, name, &Figure::name);
    return found == figures.end() ? nullptr : &*found;
  }
  TournamentHistory record;
  std::vector<Figure> figures;
};

// Rows of a table without its line of names, as numbers; an empty field is NaN.
std::vector<std::vector<double>> numbers(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, field;
  std::vector<std::vector<double>> out;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line + ',');
    out.emplace_back();
    while (std::getline(fields, field, ',')) out.back().push_back(field.empty() ? NAN : std::atof(field.c_str()));
  }
  return out;
}

TEST(Thinned, KeepsEverythingUntilThereIsTooMuch) {
  Thinned<int> curve(8);
  for (int place = 1; place <= 7; ++place) curve.offer([&] { return place; });
  EXPECT_THAT(curve.with_last([] { return -1; }), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7));
}

// Evenly spaced, the last among them, never more than room for them: for any number of places.
TEST(Thinned, KeepsAnEvenSelectionAndTheLast) {
  Thinned<std::uint64_t> curve(8);
  for (std::uint64_t place = 1; place <= 5000; ++place) {
    curve.offer([&] { return place; });
    const auto kept = curve.with_last([&] { return place; });
    ASSERT_LE(kept.size(), 8u);
    ASSERT_GE(kept.size(), std::min<std::uint64_t>(place, 4));
    ASSERT_EQ(kept.back(), place);
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) ASSERT_EQ(kept[i], (i + 1) * curve.stride());
  }
}

TEST(TournamentHistory, GoalDifferencesAreAllMatches) {
  Recorded course({"a", "b"}, 500);
  std::mt19937_64 random(1);
  std::array<std::uint64_t, 21> counted{};
  for (int i = 0; i < 1000; ++i) {
    const int home = static_cast<int>(random() % 14), away = static_cast<int>(random() % 3);
    const bool forfeit = random() % 20 == 0;
    course.take(forfeit ? failed(0) : match(home, away));
    const int of_home = std::clamp(forfeit ? -10 : home - away, -10, 10);
    ++counted[static_cast<std::size_t>((i % 2 == 0 ? of_home : -of_home) + 10)];
  }
  const auto rows = numbers(course.figure("goal_differences")->csv);
  ASSERT_EQ(rows.size(), 21u);
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], static_cast<double>(i) - 10.0);
    EXPECT_EQ(rows[i][1] + rows[i][2], static_cast<double>(counted[i]));
    EXPECT_EQ(course.record.goals_of(1).played[20 - i], course.record.goals_of(0).played[i]);
    sum += rows[i][1] + rows[i][2];
  }
  EXPECT_EQ(sum, 2.0 * 500.0);
}

// Each row is what the statistics say of the pairs up to there.
TEST(TournamentHistory, EloOverPairsIsTheEloOfThePairsSoFar) {
  Recorded course({"a", "b"}, 60);
  std::mt19937_64 random(2);
  statistics::PairCounts counts;
  std::vector<statistics::Estimate> expected;
  std::vector<statistics::Count> uneven;
  for (int pair = 0; pair < 60; ++pair) {
    const int first = static_cast<int>(random() % 3) - 1, second = static_cast<int>(random() % 3) - 1;
    course.take(match(std::max(first, 0), std::max(-first, 0)));
    course.take(match(std::max(-second, 0), std::max(second, 0)));
    ++counts.seen[static_cast<std::size_t>(first + second + 2)];
    expected.push_back(statistics::elo(score_law(counts)));
    uneven.push_back(counts.seen[0] + counts.seen[1] + counts.seen[3] + counts.seen[4]);
  }
  const auto rows = numbers(course.figure("elo")->csv);
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], static_cast<double>(i + 1));
    if (std::isfinite(expected[i].value)) {
      EXPECT_EQ(rows[i][1], expected[i].value);
    }
    if (uneven[i] >= 10) {  // of fewer none is known, but for a bound where all pairs went one way
      EXPECT_EQ(rows[i][2], expected[i].interval.low);
    } else if (expected[i].interval.unbounded()) {
      EXPECT_TRUE(std::isnan(rows[i][2]));
    }
  }
}

TEST(TournamentHistory, TheRatioEndsWhereTheTestDoes) {
  Recorded course({"a", "b"}, 100000, sprt(0, 30));
  std::mt19937_64 random(3);
  bool more = true;
  while (more) {
    const bool win = random() % 10 < 6;
    course.take(match(win, !win));
    more = course.take(match(0, 0));
  }
  const auto rows = numbers(course.figure("llr")->csv);
  const auto& test = *course.tournament->meetings().front().score_test;
  EXPECT_EQ(rows.back()[0], static_cast<double>(total(test.counts())));
  EXPECT_EQ(rows.back()[1], test.ratio().value);
  EXPECT_TRUE(rows.back()[1] >= rows.back()[3] || rows.back()[1] <= rows.back()[2]);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    EXPECT_TRUE(rows[i][1] < rows[i][3] && rows[i][1] > rows[i][2]) << i;
    EXPECT_LT(rows[i][0], rows[i + 1][0]);
  }
}

TEST(TournamentHistory, CurvesOfLongTournamentsAreThinnedAndEndWithTheLastPair) {
  Recorded course({"a", "b"}, 5001);
  for (int i = 0; i < 2 * 5001; ++i) course.take(match(i % 3 == 0, i % 5 == 0));
  const auto rows = numbers(course.figure("elo")->csv);
  EXPECT_LE(rows.size(), 601u);
  EXPECT_GE(rows.size(), 300u);
  EXPECT_EQ(rows.back()[0], 5001.0);
  EXPECT_EQ(rows.back()[1], strength(*course.tournament, course.tournament->meetings().front())->elo.value);
}

std::string metrics(double overlap_home, double overlap_away, int packets_home, int packets_away) {
  return fmt::format(
      R"({{"wall_seconds":3,"roles":[{{"striker":{{"overlap_seconds":{0},"uncovered_seconds":1,"switches":2,"robot_seconds":[1,2]}},)"
      R"("wing":{{"overlap_seconds":1,"uncovered_seconds":0,"switches":0}}}},)"
      R"({{"striker":{{"overlap_seconds":{1},"uncovered_seconds":1,"switches":2}},"wing":{{"overlap_seconds":2,"uncovered_seconds":0,"switches":0}}}}],)"
      R"("packets":[{2},{3}],"packets_by_reason":[{{"goal":{2},"never":0}},{{"goal":{3},"never":0}}]}})",
      overlap_home, overlap_away, packets_home, packets_away);
}

TEST(MatchNumbers, MeansOfMatchesAndDifferencesOfPairs) {
  Recorded course({"a", "b"}, 200);
  std::mt19937_64 random(4);
  std::array<double, 2> sums{};
  double difference = 0.0;
  int matches = 0, pairs = 0;
  for (int pair = 0; pair < 200; ++pair) {
    std::array<std::array<double, 2>, 2> values{};  // by match, by team
    for (auto& each : values) each = {static_cast<double>(random() % 9), static_cast<double>(random() % 9)};
    const bool forfeit = pair % 10 == 3;
    course.take(match(0, 0, metrics(values[0][0], values[0][1], 5, 6)));
    course.take(forfeit ? failed(0) : match(0, 0, metrics(values[1][1], values[1][0], 6, 5)));
    for (std::size_t team : {0u, 1u}) sums[team] += values[0][team] + (forfeit ? 0.0 : values[1][team]);
    matches += forfeit ? 1 : 2;
    if (forfeit) continue;
    ++pairs;
    difference += (values[0][0] + values[1][0] - values[0][1] - values[1][1]) / 2.0;
  }
  const MatchNumbers& told = course.record.numbers();
  for (std::size_t team : {0u, 1u}) {
    EXPECT_EQ(told.find(team, "striker.overlap_seconds")->count(), matches);
    EXPECT_NEAR(told.find(team, "striker.overlap_seconds")->mean(), sums[team] / matches, 1e-9);
  }
  EXPECT_EQ(told.difference("striker.overlap_seconds")->difference().count(), pairs);
  EXPECT_NEAR(told.difference("striker.overlap_seconds")->difference().mean(), difference / pairs, 1e-9);
  EXPECT_EQ(told.find(0, "packets")->mean(), 5.0);  // 5 at home, and 5 away
  EXPECT_EQ(told.find(0, "wall_seconds"), nullptr);
  EXPECT_EQ(told.difference("nothing"), nullptr);
  EXPECT_THAT(role_names(told, 2), testing::ElementsAre("striker", "wing"));
  EXPECT_THAT(packet_reasons(told, 2), testing::ElementsAre("goal", "never"));
  EXPECT_TRUE(all_zero(told, 2, std::string(packets_prefix) + "never"));
  EXPECT_FALSE(all_zero(told, 2, std::string(packets_prefix) + "goal"));
}

// The same as study::metric says of a name that only roles have.
TEST(MatchNumbers, SumsOverRoles) {
  Recorded course({"a", "b"}, 1);
  course.take(match(0, 0, metrics(3, 4, 1, 2)));
  course.record.end();
  const MatchNumbers& told = course.record.numbers();
  EXPECT_EQ(told.find(0, "overlap_seconds")->mean(), 4.0);
  EXPECT_EQ(told.find(1, "overlap_seconds")->mean(), 6.0);
}

TEST(TournamentHistory, TheTablesOfRolesAndPacketsAreTheMeans) {
  Recorded course({"a", "b"}, 2);
  for (int pair = 0; pair < 2; ++pair) {
    course.take(match(0, 0, metrics(3, 5, 10, 20)));
    course.take(match(0, 0, metrics(7, 1, 40, 30)));
  }
  const std::string roles = course.figure("roles")->csv;
  EXPECT_EQ(roles,
            "role,a overlap_seconds,b overlap_seconds,a uncovered_seconds,b uncovered_seconds,a switches,b switches\n"
            "striker,2,6,1,1,2,2\nwing,1.5,1.5,0,0,0,0\n");
  EXPECT_EQ(course.figure("packets")->csv, "reason,a,b\ngoal,20,30\n");
}

TEST(TournamentHistory, NamesInTablesAreFieldsOfOneLine) {
  Recorded course({"=a,\n\"b\"", "-b"}, 1);
  course.take(match(0, 0, metrics(1, 1, 1, 1)));
  course.take(match(0, 0, metrics(1, 1, 1, 1)));
  EXPECT_THAT(course.figure("packets")->csv, testing::StartsWith("reason,\"'=a,\\n\u201db\u201d\",'-b\n"));
}

TEST(TournamentHistory, RankingOverPairs) {
  Recorded course({"a", "b", "c"}, 40);
  std::mt19937_64 random(5);
  for (int i = 0; i < 240; ++i) course.take(match(static_cast<int>(random() % 3), static_cast<int>(random() % 3)));
  const std::vector<RankingPoint> curve = course.record.ranking_curve();
  ASSERT_EQ(curve.size(), 40u);
  const auto elo = statistics::bradley_terry_elo(points_won(course.plan, *course.tournament));
  for (std::size_t team = 0; team < 3; ++team) EXPECT_EQ(curve.back().elo[team], (*elo)[team]);
  EXPECT_EQ(
      numbers(course.figure("elo")->csv).size(),
      40u - static_cast<std::size_t>(std::ranges::count_if(curve, [](const auto& each) { return each.elo.empty(); })));
  EXPECT_EQ(numbers(course.figure("ranking")->csv).size(), 3u);
}

TEST(TournamentHistory, FingerprintsAreThoseOfTheMatches) {
  const auto of = [](int goals, const std::string& hash, double seconds) {
    Recorded course({"a", "b"}, 2);
    campaign::MatchResult decided = match(goals, 0);
    decided.hash = hash;
    decided.seconds = seconds;
    course.take(decided);
    course.take(failed(1));
    return course.record.fingerprint();
  };
  EXPECT_EQ(of(1, "x", 1.0), of(1, "x", 2.0));
  EXPECT_NE(of(1, "x", 1.0), of(2, "x", 1.0));
  EXPECT_NE(of(1, "x", 1.0), of(1, "y", 1.0));
}

TEST(TournamentHistory, RecordedMatchesThatWerePlayed) {
  std::vector<std::uint64_t> rows(500);
  std::iota(rows.begin(), rows.end(), 1);
  Recorded course({"a", "b"}, 1000, study::FixedNumber{}, rows);
  course.take(match(1, 0));
  course.take(failed(1));
  course.take(match(2, 3, R"({"packets":[4,5]})"));
  EXPECT_EQ(course.record.recorded().size(), 1u);  // the last may yet turn out to be one of a pair that does not count
  course.take(match(0, 0));
  ASSERT_EQ(course.record.recorded().size(), 3u);
  EXPECT_EQ(course.record.recorded()[1].packets, 9.0);
  EXPECT_EQ(course.record.recorded()[0].index, 1u);
  EXPECT_TRUE(course.record.recorded()[0].forfeited);
  EXPECT_EQ(course.record.recorded()[1].score, (std::array<int, 2>{2, 3}));
  for (int i = 0; i < 600; ++i) course.take(match(0, 0));
  EXPECT_EQ(course.record.recorded().size(), TournamentHistory::most_recorded);
  EXPECT_EQ(course.record.recorded_matches(), 500u);
}

TEST(Figures, MarksOfAnAxisStandApart) {
  for (double end = 0.0013; end < 1e7; end *= 1.37) {
    for (const int most : {3, 5, 8}) {
      const double step = tick_step(end, most);
      EXPECT_LE(end / step, most * (1.0 + 1e-6)) << end;
      EXPECT_GT(end / step, most / 2.51) << end;
      const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      EXPECT_LT(std::min({std::abs(digit - 1.0), std::abs(digit - 2.0), std::abs(digit - 5.0)}), 1e-6) << end;
    }
  }
  EXPECT_EQ(tick_step(1000.0, 5), 200.0);
  EXPECT_EQ(tick_step(0.0, 8), 1.0);
}

TEST(Figures, NothingToShowIsNoFigure) {
  Recorded nothing({"a", "b"}, 5);
  EXPECT_TRUE(tournament_figures(nothing.view(), nothing.record).empty());
  Recorded one_sided({"a", "b"}, 5);
  for (int i = 0; i < 10; ++i) one_sided.take(match(i % 2 == 0, i % 2 == 1));
  EXPECT_NE(one_sided.figure("goal_differences"), nullptr);
  EXPECT_EQ(one_sided.figure("roles"), nullptr);
  Recorded several({"a", "b", "c"}, 5);
  EXPECT_TRUE(tournament_figures(several.view(), several.record).empty());
}

}  // namespace
}  // namespace regista::report
