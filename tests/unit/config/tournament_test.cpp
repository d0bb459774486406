// SPDX-License-Identifier: MIT
#include "config/tournament.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

class TournamentDocument : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    for (const char* each :
         {"a.yaml", "b.yaml", "c.yaml", "rules.yaml", "robot.yaml", "wind.yaml", "scenes/one.yaml"}) {
      write(each, "x: 1\n");
    }
  }
  static std::string absolute(const char* file) { return std::filesystem::absolute(file).lexically_normal().string(); }
  Tournament read(const std::string& text) const {
    write("t.yaml", text);
    return read_document<Tournament>(std::filesystem::path("t.yaml"));
  }
  std::vector<std::string> mistakes(const std::string& text) const {
    write("t.yaml", text);
    Mistakes found(Mistakes::After::go_on);
    read_document<Tournament>(load("t.yaml"), found);
    std::vector<std::string> out;
    for (const Error& each : found.in_order("t.yaml")) out.emplace_back(each.what());
    return out;
  }
};

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(TournamentDocument, EveryKey) {
  const Tournament tournament = read(R"(tournament: every_key
question: Is anything left out?
teams: [{team: a.yaml}, {team: b.yaml}]
format: gauntlet
pairs: 40
test: {elo: [-5, 10], model: logistic, alpha: 0.01, beta: 0.1}
seed: 7
openings: scenes
limit: 120
rules: rules.yaml
robot: robot.yaml
disturbance: wind.yaml
set: {a.tasks.keep: all}
failures_in_a_row: 3
isolation: always
play_twice: false
)");
  EXPECT_EQ(tournament.name, "every_key");
  EXPECT_EQ(tournament.question, "Is anything left out?");
  ASSERT_EQ(tournament.teams.size(), 2u);
  EXPECT_EQ(tournament.teams[1].team, absolute("b.yaml"));
  EXPECT_EQ(tournament.format, Tournament::Format::gauntlet);
  EXPECT_EQ(tournament.pairs, 40);
  ASSERT_TRUE(tournament.test && tournament.test->elo);
  EXPECT_EQ(*tournament.test->elo, (std::array<double, 2>{-5, 10}));
  EXPECT_EQ(tournament.test->model, TournamentTest::Model::logistic);
  EXPECT_EQ(tournament.test->alpha, 0.01);
  EXPECT_EQ(tournament.test->beta, 0.1);
  EXPECT_EQ(tournament.seed, 7);
  ASSERT_EQ(tournament.settings.openings.size(), 1u);
  EXPECT_EQ(tournament.settings.openings[0].path, absolute("scenes"));
  EXPECT_EQ(tournament.settings.limit, 120.0);
  EXPECT_EQ(tournament.settings.rules, absolute("rules.yaml"));
  EXPECT_EQ(tournament.settings.robot, absolute("robot.yaml"));
  EXPECT_EQ(tournament.disturbance, absolute("wind.yaml"));
  EXPECT_EQ(tournament.settings.set.entries().size(), 1u);
  EXPECT_EQ(tournament.failures_in_a_row, 3);
  EXPECT_EQ(tournament.settings.isolation, Isolation::always);
  EXPECT_FALSE(tournament.settings.play_twice);
}

TEST_F(TournamentDocument, TheLeastOne) {
  const Tournament tournament = read("tournament: t\nteams: [{team: a.yaml}, {team: b.yaml}]\npairs: 1\n");
  EXPECT_EQ(tournament.format, Tournament::Format::round_robin);
  EXPECT_FALSE(tournament.test);
  EXPECT_EQ(tournament.seed, 1);
  EXPECT_EQ(tournament.failures_in_a_row, 10);
}

TEST_F(TournamentDocument, WhatDoesNotGoTogetherIsToldWithItsPlace) {
  const std::string two = "tournament: t\nteams: [{team: a.yaml}, {team: b.yaml}]\n";
  EXPECT_THAT(mistakes("tournament: t\nteams: [{team: a.yaml}]\npairs: 1\n"), ElementsAre(StartsWith("t.yaml:2:8: ")));
  EXPECT_THAT(mistakes(two), ElementsAre(StartsWith("t.yaml:1:1: pairs: how many are played?")));
  EXPECT_THAT(mistakes(two + "test: {metric: goals}\n"),
              ElementsAre(StartsWith("t.yaml:1:1: pairs: how many at most?")));
  EXPECT_THAT(mistakes(two + "test: {metric: goals, elo: [0, 20]}\n"), ElementsAre(HasSubstr("exactly one of")));
  EXPECT_THAT(mistakes(two + "test: {metric: goals, beta: 0.1}\npairs: 3\n"), ElementsAre(HasSubstr("beta")));
  EXPECT_THAT(mistakes(two + "test: {elo: [20, 0]}\n"), ElementsAre(StartsWith("t.yaml:3:13: test.elo: ")));
  EXPECT_THAT(mistakes(two + "test: {elo: [0, 20], alpha: 0.5, beta: 0.5}\n"),
              ElementsAre(HasSubstr("their sum must be below 1")));
  EXPECT_THAT(
      mistakes("tournament: t\nteams: [{team: a.yaml}, {team: b.yaml}, {team: c.yaml}]\ntest: {elo: [0, 20]}\n"),
      ElementsAre(StartsWith("t.yaml:3:7: test: a sequential test is between two teams, and there are 3")));
}

TEST_F(TournamentDocument, ATeamMayPlayItself) {
  const std::string twice = "tournament: t\nteams: [{team: a.yaml}, {team: a.yaml}]\npairs: 1\n";
  EXPECT_THAT(mistakes(twice), ElementsAre());
  EXPECT_THAT(mistakes(twice + "set: {b.tasks.keep: all}\n"), ElementsAre());
}

TEST_F(TournamentDocument, WhatIsShownReadsTheSame) {
  for (const char* test : {"{elo: [0, 20], model: logistic}", "{metric: goals, alpha: 0.1}"}) {
    write("t.yaml",
          fmt::format("tournament: t\nteams: [{{team: a.yaml}}, {{team: b.yaml}}]\ntest: {}\npairs: 3\n", test));
    const std::string shown = show(load("t.yaml"), {}, Remarks::without);
    EXPECT_EQ(show(parse_text(shown, "shown.yaml"), {}, Remarks::without), shown);
    EXPECT_THAT(shown, HasSubstr(test[1] == 'e' ? "elo: [0, 20]" : "metric: \"goals\""));
  }
}

}  // namespace
}  // namespace regista::config
