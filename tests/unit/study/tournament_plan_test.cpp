// SPDX-License-Identifier: MIT
#include "study/tournament_plan.hpp"

#include <gmock/gmock.h>

#include <array>
#include <set>
#include <stdexcept>

#include "config/json.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TournamentPlan full_plan() {
  TournamentPlan plan = plan_of(3, 7);
  plan.format = Format::gauntlet;
  plan.openings = {{"openings/corner.yaml", {"opening corner", "c"}}, {"openings/free.yaml", {"opening free", "f"}}};
  plan.first_seed = UINT64_MAX - 6;
  plan.most_goals = 12;
  plan.failures_in_a_row = 3;
  plan.common.rules = "rules.yaml";
  plan.common.robot = "robot.yaml";
  plan.common.disturbance = "noise.yaml";
  plan.common.limit = "12.5";
  plan.common.overrides = {"a.x=\"1\"", "rules.y=2"};
  plan.common.plugins = {"old", "new"};
  return plan;
}

void expect_same(const TournamentPlan& a, const TournamentPlan& b) {
  ASSERT_EQ(a.teams.size(), b.teams.size());
  for (std::size_t i = 0; i < a.teams.size(); ++i) {
    EXPECT_EQ(a.teams[i].label, b.teams[i].label);
    EXPECT_EQ(a.teams[i].file, b.teams[i].file);
    EXPECT_EQ(a.teams[i].inputs, b.teams[i].inputs);
  }
  ASSERT_EQ(a.openings.size(), b.openings.size());
  for (std::size_t i = 0; i < a.openings.size(); ++i) {
    EXPECT_EQ(a.openings[i].file, b.openings[i].file);
    EXPECT_EQ(a.openings[i].input, b.openings[i].input);
  }
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.first_seed, b.first_seed);
  EXPECT_EQ(a.objective.index(), b.objective.index());
  EXPECT_EQ(a.most_goals, b.most_goals);
  EXPECT_EQ(a.failures_in_a_row, b.failures_in_a_row);
  EXPECT_EQ(a.common, b.common);
  EXPECT_EQ(a.common_inputs, b.common_inputs);
}

TEST(TournamentPlan, SurvivesTheWayToAFile) {
  TournamentPlan plan = full_plan();
  expect_same(tournament_plan_from_json(to_json(plan)), plan);
  plan.openings.clear();
  plan.format = Format::round_robin;
  expect_same(tournament_plan_from_json(to_json(plan)), plan);

  ScoreTest score;
  score.design = {statistics::Model::logistic, {-1.75, 0.25}, {0.01, 0.2}, true};
  plan.objective = score;
  TournamentPlan back = tournament_plan_from_json(to_json(plan));
  ASSERT_TRUE(std::holds_alternative<ScoreTest>(back.objective));
  const auto& design = std::get<ScoreTest>(back.objective).design;
  EXPECT_EQ(design.model, statistics::Model::logistic);
  EXPECT_EQ(design.hypotheses.elo0, -1.75);
  EXPECT_EQ(design.hypotheses.elo1, 0.25);
  EXPECT_EQ(design.rates.alpha, 0.01);
  EXPECT_EQ(design.rates.beta, 0.2);

  plan.objective = ValueTest{"striker.overlap_seconds", 0.1};
  back = tournament_plan_from_json(to_json(plan));
  ASSERT_TRUE(std::holds_alternative<ValueTest>(back.objective));
  EXPECT_EQ(std::get<ValueTest>(back.objective).value, "striker.overlap_seconds");
  EXPECT_EQ(std::get<ValueTest>(back.objective).alpha, 0.1);
}

TEST(TournamentPlan, TextThatIsNoUtf8IsStillAPlan) {
  TournamentPlan plan = plan_of(2, 1);
  plan.teams[0].file = "\xff.yaml";
  EXPECT_EQ(tournament_plan_from_json(to_json(plan)).teams[0].file, "\xef\xbf\xbd.yaml");
}

TEST(TournamentPlan, RefusesWhatItDidNotWrite) {
  const Json sound = Json::parse(to_json(full_plan()));
  for (const auto& [name, value] : sound.items()) {
    Json damaged = sound;
    damaged.erase(name);
    // Results of before know none.
    if (name != "match_wall_seconds") {
      EXPECT_THROW(tournament_plan_from_json(damaged.dump()), std::invalid_argument) << name << " is missing";
    }
    damaged = sound;
    damaged[name] = value.is_string() ? Json(1) : Json("text");
    EXPECT_THROW(tournament_plan_from_json(damaged.dump()), std::invalid_argument) << name << " is of another type";
  }
  for (const char* text : {"", "[]", "{}", "null", "{\"study\":\"tournament\"}"}) {
    EXPECT_THROW(tournament_plan_from_json(text), std::invalid_argument) << text;
  }
  const std::string whole = sound.dump();
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    EXPECT_THROW(tournament_plan_from_json(whole.substr(0, length)), std::invalid_argument) << length;
  }
}

TEST(TournamentPlan, SaysWhoseResultsTheseAre) {
  const auto complaint = [](const char* name, const Json& value) -> std::string {
    Json other = Json::parse(to_json(full_plan()));
    other[name] = value;
    try {
      tournament_plan_from_json(other.dump());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint("study", "tuning"), HasSubstr("results of another study"));
  EXPECT_THAT(complaint("version", 2), HasSubstr("its plan is of another version"));
  EXPECT_THAT(complaint("teams", Json::array()), HasSubstr("fewer than two teams"));
}

// What would be divided by, searched in or bet on later.
TEST(TournamentPlan, RefusesValuesThatNoTournamentHas) {
  const Json score{{"test", "score"}, {"model", "normalized"}, {"elo0", 0},
                   {"elo1", 10},      {"alpha", .05},          {"beta", .05}};
  const Json value{{"test", "value"}, {"value", "goals"}, {"alpha", 0.05}};
  const auto accepted = [](const std::string& name, const Json& changed) {
    Json json = Json::parse(to_json(plan_of(2, 7)));
    json[name] = changed;
    try {
      tournament_plan_from_json(json.dump());
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  };
  const auto with = [](Json json, const char* name, const Json& changed) {
    json[name] = changed;
    return json;
  };
  EXPECT_TRUE(accepted("objective", score));
  EXPECT_TRUE(accepted("objective", value));
  EXPECT_FALSE(accepted("objective", with(score, "test", "dreams")));
  EXPECT_FALSE(accepted("objective", with(score, "model", "dreams")));
  EXPECT_FALSE(accepted("objective", with(score, "elo1", 0)));
  EXPECT_FALSE(accepted("objective", with(score, "alpha", 0)));
  EXPECT_FALSE(accepted("objective", with(score, "beta", 0.95)));
  EXPECT_FALSE(accepted("objective", with(value, "alpha", 1)));
  EXPECT_FALSE(accepted("format", "dreams"));
  EXPECT_FALSE(accepted("pairs", 0));
  EXPECT_FALSE(accepted("pairs", -1));
  EXPECT_FALSE(accepted("pairs", UINT64_MAX));
  EXPECT_FALSE(accepted("first_seed", UINT64_MAX - 5));
  EXPECT_TRUE(accepted("first_seed", UINT64_MAX - 6));
  EXPECT_FALSE(accepted("most_goals", 0));
  EXPECT_FALSE(accepted("failures_in_a_row", -1));
  EXPECT_TRUE(accepted("failures_in_a_row", 0));
}

TEST(TournamentPlan, Pairings) {
  const auto pairings = [](std::size_t teams, Format format) {
    TournamentPlan plan = plan_of(teams, 1);
    plan.format = format;
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (const Pairing& each : plan.pairings()) out.push_back({each.first, each.second});
    return out;
  };
  using Pair = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(pairings(2, Format::round_robin), ElementsAre(Pair(0, 1)));
  EXPECT_THAT(pairings(2, Format::gauntlet), ElementsAre(Pair(0, 1)));
  EXPECT_THAT(pairings(4, Format::round_robin),
              ElementsAre(Pair(0, 1), Pair(0, 2), Pair(0, 3), Pair(1, 2), Pair(1, 3), Pair(2, 3)));
  EXPECT_THAT(pairings(4, Format::gauntlet), ElementsAre(Pair(0, 1), Pair(0, 2), Pair(0, 3)));
}

TEST(Calendar, ThreeTeamsAndTwoOpeningsByHand) {
  TournamentPlan plan = plan_of(3, 3);
  plan.openings = {{"o0.yaml", {"opening o0", "0"}}, {"o1.yaml", {"opening o1", "1"}}};
  plan.first_seed = 40;
  const Calendar calendar(plan);
  struct Line {
    std::uint64_t pair, seed;
    std::size_t opening, home, away;
  };
  const std::vector<Line> expected{
      {0, 40, 0, 0, 1}, {0, 40, 0, 1, 0}, {0, 40, 0, 0, 2}, {0, 40, 0, 2, 0}, {0, 40, 0, 1, 2}, {0, 40, 0, 2, 1},  //
      {1, 41, 1, 0, 1}, {1, 41, 1, 1, 0}, {1, 41, 1, 0, 2}, {1, 41, 1, 2, 0}, {1, 41, 1, 1, 2}, {1, 41, 1, 2, 1},  //
      {2, 42, 0, 0, 1}, {2, 42, 0, 1, 0}, {2, 42, 0, 0, 2}, {2, 42, 0, 2, 0}, {2, 42, 0, 1, 2}, {2, 42, 0, 2, 1}};
  ASSERT_EQ(calendar.matches(), expected.size());
  EXPECT_EQ(plan.matches(), expected.size());
  for (std::uint64_t i = 0; i < expected.size(); ++i) {
    const Fixture fixture = calendar.at(i);
    const Line& line = expected[i];
    EXPECT_EQ(fixture.pair, line.pair) << i;
    EXPECT_EQ(fixture.seed, line.seed) << i;
    EXPECT_EQ(fixture.opening, line.opening) << i;
    EXPECT_EQ(fixture.home, line.home) << i;
    EXPECT_EQ(fixture.away, line.away) << i;
    EXPECT_EQ(fixture.swapped, i % 2 == 1) << i;
    EXPECT_EQ(fixture.pairing, i / 2 % 3) << i;
  }
}

TEST(Calendar, TheLastSeedOfAll) {
  TournamentPlan plan = plan_of(2, 1'000'000);
  plan.first_seed = UINT64_MAX - 999'999;
  const Calendar calendar(plan);
  EXPECT_EQ(calendar.at(calendar.matches() - 1).seed, UINT64_MAX);
  EXPECT_EQ(calendar.at(calendar.matches() - 1).pair, 999'999u);
}

TEST(Fixtures, EveryNumberIsUniqueAndMeansItsMatch) {
  for (const std::size_t openings : {0u, 1u, 5u}) {
    for (const Format format : {Format::round_robin, Format::gauntlet}) {
      TournamentPlan plan = plan_of(4, 7);  // and fewer pairs than it takes for every opening to come up
      if (openings == 5) plan.pairs = 2;
      plan.format = format;
      for (std::size_t i = 0; i < openings; ++i) {
        const std::string number = std::to_string(i);
        plan.openings.push_back({number + ".yaml", {"opening " + number, number}});
      }
      const std::vector<campaign::Store::Fixture> all = fixtures(plan);
      ASSERT_EQ(all.size(), 2 * plan.pairings().size() * std::max<std::size_t>(openings, 1));
      std::set<std::string> keys;
      for (const campaign::Store::Fixture& each : all) keys.insert(each.key);
      EXPECT_EQ(keys.size(), all.size());
      const Calendar calendar(plan);
      for (std::uint64_t i = 0; i < calendar.matches(); ++i) {
        const Fixture fixture = calendar.at(i);
        ASSERT_LT(fixture.number, all.size());
        campaign::Job expected = job(plan, fixture);
        expected.seed = all[fixture.number].job.seed;
        EXPECT_EQ(all[fixture.number].job, expected) << i;
      }
    }
  }
}

TEST(Job, OfAFixture) {
  TournamentPlan plan = full_plan();
  plan.common.overrides.clear();
  const Calendar calendar(plan);
  const campaign::Job swapped = job(plan, calendar.at(7));  // pair 1, gauntlet: team 2 at home against team 0
  EXPECT_EQ(swapped.teams, (std::array<std::string, 2>{"2.yaml", "0.yaml"}));
  EXPECT_EQ(swapped.seed, UINT64_MAX - 5);
  EXPECT_EQ(swapped.opening, "openings/free.yaml");
  EXPECT_EQ(swapped.rules + swapped.robot + swapped.disturbance + swapped.limit, "rules.yamlrobot.yamlnoise.yaml12.5");
  EXPECT_THAT(swapped.plugins, ElementsAre("old", "new"));
  EXPECT_EQ(swapped.home_inputs, plan.teams[2].inputs);
  EXPECT_EQ(swapped.away_inputs, plan.teams[0].inputs);
  std::vector<campaign::Input> common = plan.common_inputs;
  common.push_back({"opening free", "f"});
  EXPECT_EQ(swapped.common_inputs, common);
  plan.openings.clear();
  EXPECT_EQ(job(plan, Calendar(plan).at(0)).opening, "");
  EXPECT_EQ(job(plan, Calendar(plan).at(0)).common_inputs, plan.common_inputs);
}

TEST(Job, OverridesGoToTheTeamOfTheirLetter) {
  TournamentPlan plan = plan_of(3, 1);
  plan.common.overrides = {"a.x=1.5", "rules.y=2", "b.a.z=a.b", "c.x=4", "away=5", "utility.near=6", "z.q=7", "a=8"};
  const auto overrides = [&](std::uint64_t index) { return job(plan, Calendar(plan).at(index)).overrides; };
  // 0: a, b; 1: b, a; 2: a, c; 3: c, a; 4: b, c; 5: c, b. What names no team of the plan goes on as it was typed.
  EXPECT_THAT(overrides(0),
              ElementsAre("home.x=1.5", "rules.y=2", "away.a.z=a.b", "away=5", "utility.near=6", "z.q=7", "a=8"));
  EXPECT_THAT(overrides(1),
              ElementsAre("away.x=1.5", "rules.y=2", "home.a.z=a.b", "away=5", "utility.near=6", "z.q=7", "a=8"));
  EXPECT_THAT(overrides(3),
              ElementsAre("away.x=1.5", "rules.y=2", "home.x=4", "away=5", "utility.near=6", "z.q=7", "a=8"));
  EXPECT_THAT(overrides(4),
              ElementsAre("rules.y=2", "home.a.z=a.b", "away.x=4", "away=5", "utility.near=6", "z.q=7", "a=8"));
}

TEST(Letter, Names) {
  EXPECT_EQ(letter(0), "a");
  EXPECT_EQ(letter(25), "z");
  EXPECT_EQ(letter(26), "");
}

TEST(EqualTeams, AreThoseWithTheSameContent) {
  TournamentPlan plan = plan_of(3, 1);
  plan.teams[1].inputs = {{"team of another name", "hash 0"}};
  EXPECT_TRUE(equal_teams(plan, {0, 1}));
  EXPECT_FALSE(equal_teams(plan, {0, 2}));
  EXPECT_FALSE(equal_teams(plan, {1, 2}));
}

TEST(PlanDifferences, NothingWhereNothingDiffers) {
  EXPECT_THAT(differences(full_plan(), full_plan()), IsEmpty());
  EXPECT_THAT(differences(full_plan(), tournament_plan_from_json(to_json(full_plan()))), IsEmpty());
  // Names of files are for people; what is in them counts.
  TournamentPlan moved = full_plan();
  moved.teams[0].file = "elsewhere.yaml";
  EXPECT_THAT(differences(full_plan(), moved), IsEmpty());
}

TEST(PlanDifferences, InWords) {
  const TournamentPlan before = full_plan();
  TournamentPlan now = before;
  now.pairs = 8;
  now.first_seed = 3;
  now.format = Format::round_robin;
  now.failures_in_a_row = 0;
  EXPECT_THAT(differences(before, now),
              ElementsAre("--format: was gauntlet, now round_robin", "--pairs: was 7, now 8",
                          "--seed: was 18446744073709551609, now 3", "--failures-in-a-row: was 3, now 0"));
  now = before;
  now.teams.pop_back();
  EXPECT_THAT(differences(before, now), ElementsAre("the number of teams: was 3, now 2"));
  now = before;
  now.teams[1].inputs[0].hash = "other";
  now.common_inputs[1].hash = "other";
  now.openings[0].input.hash = "other";
  EXPECT_THAT(differences(before, now), ElementsAre("team team 1: team 1.yaml has changed", "rules spl2023 has changed",
                                                    "opening corner has changed"));
  now = before;
  std::swap(now.openings[0], now.openings[1]);
  EXPECT_THAT(differences(before, now), ElementsAre("the openings come in another order"));
  now = before;
  now.openings.pop_back();
  EXPECT_THAT(differences(before, now), ElementsAre(HasSubstr("opening free")));
}

TEST(PlanDifferences, OfTheTest) {
  TournamentPlan before = plan_of(2, 7), now = before;
  ScoreTest score;
  score.design = {statistics::Model::normalized, {0, 12.5}, {0.05, 0.1}, true};
  now.objective = score;
  EXPECT_THAT(differences(before, now),
              ElementsAre("the test: was no test, now --sprt 0,12.5 --model normalized --alpha 0.05 --beta 0.1"));
  before.objective = ValueTest{"goals", 0.01};
  score.design.model = statistics::Model::logistic;
  now.objective = score;
  EXPECT_THAT(differences(before, now),
              ElementsAre("the test: was --metric goals --alpha 0.01, now --sprt 0,12.5 --model logistic --alpha 0.05 "
                          "--beta 0.1"));
  now.objective = ValueTest{"packets", 0.01};
  EXPECT_THAT(differences(before, now),
              ElementsAre("the test: was --metric goals --alpha 0.01, now --metric packets --alpha 0.01"));
}

}  // namespace
}  // namespace regista::study
