// SPDX-License-Identifier: MIT
#include "study/tournament_plan.hpp"

#include <gmock/gmock.h>

#include <array>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "config/values.hpp"
#include "texts/json.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

config::Node text(const char* value) { return config::Node::scalar(value, false, {}); }

TournamentPlan full_plan() {
  TournamentPlan plan = plan_of(3, 7);
  config::Tournament& asked = plan.asked;
  asked.question = "Which?";
  asked.format = config::Tournament::Format::gauntlet;
  asked.seed = std::int64_t{1} << 53;
  asked.failures_in_a_row = 3;
  asked.disturbance = "noise.yaml";
  asked.settings.rules = "rules.yaml";
  asked.settings.robot = "robot.yaml";
  asked.settings.limit = 12.5;
  asked.settings.openings = {{"openings", {}}};
  asked.settings.set = config::Node::map({{"a.x", {}, text("1")}, {"rules.y", {}, text("2")}}, {});
  asked.settings.limits = {3, 512, 70, 600};
  asked.settings.isolation = config::Isolation::always;
  asked.settings.play_twice = false;
  asked.settings.allow_shared_memory = true;
  plan.openings = {{"openings/corner.yaml", {"opening corner", "c"}}, {"openings/free.yaml", {"opening free", "f"}}};
  plan.most_goals = 12;
  plan.folder = "/tmp";
  plan.program = "1.2";
  plan.plugins = {"old", "new"};
  return plan;
}

void expect_same(const TournamentPlan& a, const TournamentPlan& b) {
  EXPECT_EQ(config::document_text(a.asked), config::document_text(b.asked));
  ASSERT_EQ(a.teams.size(), b.teams.size());
  for (std::size_t i = 0; i < a.teams.size(); ++i) {
    EXPECT_EQ(a.teams[i].label, b.teams[i].label);
    EXPECT_EQ(a.teams[i].inputs, b.teams[i].inputs);
    EXPECT_EQ(a.teams[i].disturbances, b.teams[i].disturbances);
  }
  ASSERT_EQ(a.openings.size(), b.openings.size());
  for (std::size_t i = 0; i < a.openings.size(); ++i) {
    EXPECT_EQ(a.openings[i].file, b.openings[i].file);
    EXPECT_EQ(a.openings[i].input, b.openings[i].input);
  }
  EXPECT_EQ(a.pairs(), b.pairs());
  EXPECT_EQ(a.first_seed(), b.first_seed());
  EXPECT_EQ(a.limits(), b.limits());
  EXPECT_EQ(a.most_goals, b.most_goals);
  EXPECT_EQ(a.pairs_before, b.pairs_before);
  EXPECT_EQ(a.ended_after, b.ended_after);
  EXPECT_EQ(a.folder, b.folder);
  EXPECT_EQ(a.program, b.program);
  EXPECT_EQ(a.plugins, b.plugins);
  EXPECT_EQ(a.common_inputs, b.common_inputs);
  const Calendar calendar(a);
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(calendar.matches(), 100); ++i)
    EXPECT_EQ(job(a, calendar.at(i)), job(b, Calendar(b).at(i)));
}

TEST(TournamentPlan, SurvivesTheWayToAFile) {
  TournamentPlan plan = full_plan();
  expect_same(tournament_plan_from_json(to_json(plan)), plan);
  plan.openings.clear();
  plan.pairs_before = "3, 5";
  plan.ended_after = 1;
  plan.asked.format = config::Tournament::Format::round_robin;
  plan.asked.teams[1].disturbance = "own.yaml";
  plan.teams[1].disturbances = {{"home disturbance own", "h"}, {"away disturbance own", "a"}};
  expect_same(tournament_plan_from_json(to_json(plan)), plan);

  plan = plan_of(2, 7);
  ScoreTest score;
  score.design = {statistics::Model::logistic, {-1.75, 0.25}, {0.01, 0.2}, true};
  plan.asked.test = test_of(score);
  plan.asked.pairs.reset();
  TournamentPlan back = tournament_plan_from_json(to_json(plan));
  EXPECT_EQ(back.pairs(), most_pairs);
  const Objective scored = back.objective();
  ASSERT_TRUE(std::holds_alternative<ScoreTest>(scored));
  const auto& design = std::get<ScoreTest>(scored).design;
  EXPECT_EQ(design.model, statistics::Model::logistic);
  EXPECT_EQ(design.hypotheses.elo0, -1.75);
  EXPECT_EQ(design.hypotheses.elo1, 0.25);
  EXPECT_EQ(design.rates.alpha, 0.01);
  EXPECT_EQ(design.rates.beta, 0.2);

  plan.asked.pairs = 7;
  plan.asked.test = test_of(ValueTest{"striker.overlap_seconds", 0.1});
  back = tournament_plan_from_json(to_json(plan));
  const Objective measured = back.objective();
  ASSERT_TRUE(std::holds_alternative<ValueTest>(measured));
  EXPECT_EQ(std::get<ValueTest>(measured).value, "striker.overlap_seconds");
  EXPECT_EQ(std::get<ValueTest>(measured).alpha, 0.1);
}

// Pairs that are added after a look are reported; those of a sequential test need not be.
TEST(TournamentPlan, IsGoneOnWithAfterTheClockStoppedIt) {
  TournamentPlan plan = plan_of(2, 100);
  EXPECT_EQ(plan.pairs_to_its_end(), 100u);
  EXPECT_EQ(to_json(without_end(plan)), to_json(plan));
  plan.ended_after = 37;
  EXPECT_EQ(plan.pairs_to_its_end(), 37u);
  const TournamentPlan on = without_end(plan);
  EXPECT_EQ(on.pairs_to_its_end(), 100u);
  EXPECT_EQ(on.pairs_before, "37");
  const TournamentPlan fewer = with_pairs(plan, 60);
  EXPECT_EQ(fewer.pairs_to_its_end(), 60u);
  EXPECT_EQ(fewer.pairs_before, "37");
  EXPECT_THROW(with_pairs(plan, 37), std::invalid_argument);
  EXPECT_EQ(with_pairs(plan, 200).pairs(), 200u);
  plan.asked.test = test_of(ValueTest{"goals"});
  EXPECT_EQ(without_end(plan).pairs_before, "");
  EXPECT_FALSE(without_end(plan).ended_after);
}

TEST(TournamentPlan, EndsAfterPairsThatItHas) {
  for (const std::uint64_t after : {0u, 101u}) {
    TournamentPlan plan = plan_of(2, 100);
    plan.ended_after = after;
    EXPECT_THROW(tournament_plan_from_json(to_json(plan)), std::invalid_argument) << after;
  }
}

TEST(TournamentPlan, TextThatIsNoUtf8IsStillAPlan) {
  TournamentPlan plan = plan_of(2, 1);
  plan.asked.teams[0].team = "\xff.yaml";
  EXPECT_EQ(tournament_plan_from_json(to_json(plan)).asked.teams[0].team, "\xef\xbf\xbd.yaml");
}

TEST(TournamentPlan, RefusesWhatItDidNotWrite) {
  const Json sound = Json::parse(to_json(full_plan()));
  for (const auto& [name, value] : sound.items()) {
    Json damaged = sound;
    damaged.erase(name);
    if (name != "program") {
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
  EXPECT_THAT(complaint("version", 3), HasSubstr("its plan is of another version"));
  EXPECT_THAT(complaint("document", "tournament: x\nteams: []\n"), HasSubstr("its plan is damaged: its document:2:8"));
}

// What would be divided by, searched in or bet on later.
TEST(TournamentPlan, RefusesValuesThatNoTournamentHas) {
  const auto refused = [](const char* what, const std::function<void(TournamentPlan&)>& change) {
    TournamentPlan plan = full_plan();
    change(plan);
    EXPECT_THROW(tournament_plan_from_json(to_json(plan)), std::invalid_argument) << what;
  };
  const auto tested = [](TournamentPlan& plan, const Objective& objective) { plan = plan_of(2, 7, objective); };
  ScoreTest score;
  score.design.hypotheses = {10, 10};
  refused("equal hypotheses", [&](TournamentPlan& plan) { tested(plan, score); });
  score.design.hypotheses = {0, 10};
  score.design.rates = {0.0, 0.05};
  refused("no error at all", [&](TournamentPlan& plan) { tested(plan, score); });
  score.design.rates = {0.45, 0.5};
  EXPECT_NO_THROW(tournament_plan_from_json(to_json(plan_of(2, 7, score))));
  refused("a rate of one", [&](TournamentPlan& plan) { tested(plan, ValueTest{"goals", 1.0}); });
  refused("three teams under a test", [&](TournamentPlan& plan) { plan.asked.test = test_of(ValueTest{"goals"}); });
  refused("one team", [](TournamentPlan& plan) {
    plan.asked.teams.resize(1);
    plan.teams.resize(1);
  });
  refused("a team that nothing was found of", [](TournamentPlan& plan) { plan.teams.pop_back(); });
  refused("a disturbance that nothing was found of",
          [](TournamentPlan& plan) { plan.asked.teams[0].disturbance = "own.yaml"; });
  refused("no pairs", [](TournamentPlan& plan) { plan.asked.pairs = 0; });
  refused("a seed below zero", [](TournamentPlan& plan) { plan.asked.seed = -1; });
  refused("a seed beyond all", [](TournamentPlan& plan) { plan.asked.seed = (std::int64_t{1} << 53) + 2; });
  refused("no goals", [](TournamentPlan& plan) { plan.most_goals = 0; });
  refused("failures", [](TournamentPlan& plan) { plan.asked.failures_in_a_row = -1; });
}

TEST(TournamentPlan, Pairings) {
  using Format = config::Tournament::Format;
  const auto pairings = [](std::size_t teams, Format format) {
    TournamentPlan plan = plan_of(teams, 1);
    plan.asked.format = format;
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
  plan.asked.seed = 40;
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

// Who repeats a study with the next seed must not see its matches again.
TEST(Seeds, OfNeighbouringStudiesShareNone) {
  std::map<std::uint64_t, std::int64_t> seen;
  for (std::int64_t seed = 0; seed < 300; ++seed) {
    const std::uint64_t first = first_seed(seed, config::Seeds::hashed);
    EXPECT_LT(first, std::uint64_t{1} << 32);
    for (std::uint64_t pair = 0; pair < 1000; ++pair) {
      const auto [place, fresh] = seen.emplace(first + pair, seed);
      ASSERT_TRUE(fresh) << "seeds " << place->second << " and " << seed;
    }
  }
  EXPECT_EQ(first_seed(7, config::Seeds::consecutive), 7u);
}

TEST(Seeds, OfAllPairingsOfAPairAreTheSame) {
  TournamentPlan plan = plan_of(3, 4);
  plan.asked.settings.seeds = config::Seeds::hashed;
  const Calendar calendar(plan);
  for (std::uint64_t i = 0; i < calendar.matches(); ++i)
    EXPECT_EQ(calendar.at(i).seed, first_seed(plan.asked.seed, config::Seeds::hashed) + i / 6);
}

// Older plans do not say how their seeds follow.
TEST(Seeds, OfOlderPlansAreConsecutive) {
  auto json = nlohmann::ordered_json::parse(to_json(plan_of(2, 3)));
  std::string document = json["document"];
  const std::string line = "seeds: consecutive\n";
  ASSERT_NE(document.find(line), std::string::npos) << document;
  document.erase(document.find(line), line.size());
  json["document"] = document;
  EXPECT_EQ(tournament_plan_from_json(json.dump()).asked.settings.seeds, config::Seeds::consecutive);
  TournamentPlan hashed = plan_of(2, 3);
  hashed.asked.settings.seeds = config::Seeds::hashed;
  EXPECT_EQ(tournament_plan_from_json(to_json(hashed)).asked.settings.seeds, config::Seeds::hashed);
}

TEST(Fixtures, EveryNumberIsUniqueAndMeansItsMatch) {
  for (const std::size_t openings : {0u, 1u, 5u}) {
    using Format = config::Tournament::Format;
    for (const Format format : {Format::round_robin, Format::gauntlet}) {
      TournamentPlan plan = plan_of(4, 7);  // and fewer pairs than it takes for every opening to come up
      if (openings == 5) plan.asked.pairs = 2;
      plan.asked.format = format;
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
  plan.asked.settings.set = {};
  const Calendar calendar(plan);
  const campaign::Job swapped = job(plan, calendar.at(7));  // pair 1, gauntlet: team 2 at home against team 0
  EXPECT_EQ(swapped.teams, (std::array<std::string, 2>{"2.yaml", "0.yaml"}));
  EXPECT_EQ(swapped.seed, (std::uint64_t{1} << 53) + 1);
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
  std::vector<config::Node::Entry> settings;
  for (const auto& [path, value] :
       {std::pair{"a.x", "1.5"}, {"rules.y", "2"}, {"b.a.z", "a.b"}, {"c.x", "4"}, {"utility.near", "6"}, {"z.q", "7"}})
    settings.push_back({path, {}, text(value)});
  plan.asked.settings.set = config::Node::map(settings, {});
  const auto overrides = [&](std::uint64_t index) { return job(plan, Calendar(plan).at(index)).overrides; };
  // 0: a, b; 1: b, a; 2: a, c; 3: c, a; 4: b, c; 5: c, b. What names no team of the plan goes on as it was typed.
  EXPECT_THAT(overrides(0), ElementsAre("home.x=1.5", "rules.y=2", "away.a.z=a.b", "utility.near=6", "z.q=7"));
  EXPECT_THAT(overrides(1), ElementsAre("away.x=1.5", "rules.y=2", "home.a.z=a.b", "utility.near=6", "z.q=7"));
  EXPECT_THAT(overrides(3), ElementsAre("away.x=1.5", "rules.y=2", "home.x=4", "utility.near=6", "z.q=7"));
  EXPECT_THAT(overrides(4), ElementsAre("rules.y=2", "home.a.z=a.b", "away.x=4", "utility.near=6", "z.q=7"));
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
  moved.asked.teams[0].team = "elsewhere.yaml";
  moved.asked.settings.openings = {{"elsewhere", {}}};
  moved.asked.name = "other";
  EXPECT_THAT(differences(full_plan(), moved), IsEmpty());
}

TEST(PlanDifferences, InWords) {
  const TournamentPlan before = full_plan();
  TournamentPlan now = before;
  now.asked.pairs = 8;
  now.asked.seed = 3;
  now.asked.format = config::Tournament::Format::round_robin;
  now.asked.failures_in_a_row = 0;
  now.asked.settings.allow_shared_memory = false;
  EXPECT_THAT(
      differences(before, now),
      ElementsAre("format: was gauntlet, now round_robin", "pairs: was 7, now 8", "seed: was 9007199254740992, now 3",
                  "failures_in_a_row: was 3, now 0", "allow_shared_memory: was true, now false"));
  now = before;
  now.asked.teams.pop_back();
  now.teams.pop_back();
  EXPECT_THAT(differences(before, now), ElementsAre("the number of teams: was 3, now 2"));
  now = before;
  now.teams[1].inputs[0].hash = "other";
  now.common_inputs[1].hash = "other";
  now.openings[0].input.hash = "other";
  EXPECT_THAT(differences(before, now), ElementsAre("team team 1: team 1.yaml has changed", "rules spl2023 has changed",
                                                    "opening corner has changed"));
  now = before;
  now.asked.settings.set = config::Node::map({{"a.x", {}, text("2")}}, {});
  EXPECT_THAT(differences(before, now), ElementsAre("set.a.x: was 1, now 2", "set.rules.y: was 2, now none"));
  now = before;
  std::swap(now.openings[0], now.openings[1]);
  EXPECT_THAT(differences(before, now), ElementsAre("the openings come in another order"));
  now = before;
  now.openings.pop_back();
  EXPECT_THAT(differences(before, now), ElementsAre(HasSubstr("opening free")));
}

TEST(PlanDifferences, OfTheTest) {
  TournamentPlan before = plan_of(2, 7), now = before;
  now.asked.test = test_of(ValueTest{"goals", 0.01});
  EXPECT_THAT(differences(before, now),
              ElementsAre("test.alpha: was none, now 0.01", "test.metric: was none, now goals",
                          "test.model: was none, now normalized"));
  before = now;
  now.asked.test->metric = "packets";
  EXPECT_THAT(differences(before, now), ElementsAre("test.metric: was goals, now packets"));
}

}  // namespace
}  // namespace regista::study
