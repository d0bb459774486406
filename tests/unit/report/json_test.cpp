// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>

#include "course.hpp"
#include "report/standing.hpp"
#include "report/tournament_report.hpp"
#include "statistics/rating.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::json;

Json read(const Course& course) {
  const std::string text = tournament_json(course.view());
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  return Json::parse(text);
}

TEST(TournamentJson, SaysWhatTheNumbersAre) {
  Course course({"new", "old"}, 290);
  course.take_pairs({{34, 54, 63, 64, 75}});
  const Json json = read(course);
  const Strength known = *strength(*course.tournament, course.tournament->meetings().front());
  EXPECT_EQ(json["pairs"], 290);
  EXPECT_EQ(json["matches"], 580);
  EXPECT_EQ(json["first_seed"], 1);
  EXPECT_EQ(json["format"], "round_robin");
  EXPECT_TRUE(json["verdict"].is_null());
  EXPECT_FALSE(json.contains("ranking"));
  ASSERT_EQ(json["pairings"].size(), 1u);
  const Json& pairing = json["pairings"][0];
  EXPECT_EQ(pairing["teams"], (Json{"new", "old"}));
  EXPECT_EQ(pairing["equal_teams"], false);
  EXPECT_EQ(pairing["games"], 580);
  EXPECT_EQ(pairing["wins"], 277);
  EXPECT_EQ(pairing["losses"], 185);
  EXPECT_EQ(pairing["draws"], 118);
  EXPECT_EQ(pairing["points"], 336.0);
  EXPECT_EQ(pairing["pentanomial"], (Json{34, 54, 63, 64, 75}));
  EXPECT_EQ(pairing["goals"], (Json{277, 185}));
  EXPECT_NEAR(pairing["elo"].get<double>(), 55.58, 0.005);
  EXPECT_NEAR(pairing["nelo"].get<double>(), 57.94, 0.005);
  EXPECT_EQ(pairing["elo_interval"][0], known.elo.interval.low);
  EXPECT_EQ(pairing["elo_interval"][1], known.elo.interval.high);
  EXPECT_EQ(pairing["los"], *known.superiority);
  EXPECT_EQ(pairing["pair_ratio"], *known.pair_ratio);
  EXPECT_EQ(pairing["variance_ratio"]["scores"], *known.score_ratio);
  EXPECT_EQ(pairing["variance_ratio"]["goals"], *known.goals_ratio);
  EXPECT_EQ(pairing["goals_per_match"]["t_interval"][0], known.goals_t->interval.low);
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(pairing["p"], p_values(*course.tournament).single[0]);
  EXPECT_EQ(pairing["p_holm"], pairing["p"]);
  EXPECT_FALSE(pairing.contains("sprt") || pairing.contains("metric"));
}

TEST(TournamentJson, OfASequentialTest) {
  Course course({"a", "b"}, 1000, sprt(0, 100));
  course.take_pairs({{0, 0, 1, 2, 97}});
  const Json json = read(course), &test = json["pairings"][0]["sprt"];
  EXPECT_EQ(json["verdict"], "H1");
  EXPECT_EQ(test["model"], "normalized");
  EXPECT_EQ(test["elo1"], 100.0);
  EXPECT_NEAR(test["llr_bounds"][1].get<double>(), 2.944439, 1e-6);
  EXPECT_GE(test["llr"].get<double>(), test["llr_stopping"][1].get<double>());
  EXPECT_LE(test["llr_stopping"][1].get<double>(), test["llr_bounds"][1].get<double>());
  // A t test of a number of pairs that the test has chosen would be wrong.
  EXPECT_TRUE(json["pairings"][0]["goals_per_match"]["t_interval"].is_null());
  EXPECT_LT(json["matches"], 200);
}

TEST(TournamentJson, OfAMetric) {
  Course course({"a", "b"}, 1000, study::ValueTest{"packets", 0.01});
  course.take(match(0, 0, R"({"packets":[3,5]})"));
  course.take(match(0, 0, R"({"packets":[5,5]})"));
  course.take(match(0, 0, R"({"packets":[9,5]})"));
  course.take(failed(0));
  const Json json = read(course), &metric = json["pairings"][0]["metric"];
  EXPECT_EQ(json["verdict"], "INCONCLUSIVE");
  EXPECT_EQ(metric["name"], "packets");
  EXPECT_EQ(metric["alpha"], 0.01);
  EXPECT_EQ(metric["means"], (Json{4.0, 5.0}));
  EXPECT_EQ(metric["difference"], -1.0);
  EXPECT_EQ(metric["interval"], (Json{nullptr, nullptr}));
  EXPECT_EQ(metric["pairs_less_equal_more"], (Json{1, 0, 0}));
  EXPECT_EQ(metric["pairs_without"], 1);
}

TEST(TournamentJson, WhatIsInfiniteOrUnknownIsNull) {
  Course course({"a", "b"}, 3);
  EXPECT_FALSE(read(course)["pairings"][0].contains("elo"));
  course.take_pairs({{0, 0, 0, 0, 2}});
  const Json pairing = read(course)["pairings"][0];
  EXPECT_TRUE(pairing["elo"].is_null());
  EXPECT_TRUE(pairing["elo_interval"][1].is_null());
  EXPECT_NEAR(pairing["elo_interval"][0].get<double>(), statistics::elo_of_score(std::sqrt(0.025)), 1e-9);
  EXPECT_TRUE(pairing["los"].is_null());
  EXPECT_TRUE(pairing["pair_ratio"].is_null());
  EXPECT_TRUE(pairing["variance_ratio"]["scores"].is_null());
}

TEST(TournamentJson, ARanking) {
  Course course({"c", "b", "a"}, 5);
  course.take_pairs({{3, 0, 1, 0, 1}, {3, 0, 0, 0, 2}, {1, 0, 1, 0, 3}});
  const Json json = read(course);
  const auto ranks = ranking(course.plan, *course.tournament);
  ASSERT_EQ(json["ranking"].size(), 3u);
  EXPECT_EQ(json["pairings"].size(), 3u);
  EXPECT_EQ(json["ranking"][0]["team"], "b");
  EXPECT_EQ(json["ranking"][2]["team"], "c");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(json["ranking"][i]["elo"], ranks[i].elo->value);
    EXPECT_EQ(json["ranking"][i]["points"], ranks[i].points);
    EXPECT_EQ(json["ranking"][i]["games"], 20);
    EXPECT_EQ(json["ranking"][i]["goals"], (Json{ranks[i].scored, ranks[i].conceded}));
  }
}

TEST(TournamentJson, Failures) {
  Course course({"good", "bad"}, 20);
  course.plan.asked.failures_in_a_row = 2;
  course.take(failed(1, "\xff"));
  course.take(failed(0, "\xff"));
  const Json json = read(course);
  EXPECT_EQ(json["teams"][0]["failures"], 0);
  EXPECT_EQ(json["teams"][1]["failures"], 2);
  EXPECT_EQ(json["teams"][1]["file"], "bad.yaml");
  EXPECT_EQ(json["forfeits"], Json::parse(R"([{"team": "bad", "plugin": "greedy", "call": "assign", "what": "\ufffd",
                                               "matches": 2, "first_match": 1, "again": "again 0"}])"));
  EXPECT_EQ(json["set_aside"], Json::parse(R"([{"team": "bad", "plugin": "greedy", "failures": 2, "after_pair": 1}])"));
}

}  // namespace
}  // namespace regista::report
