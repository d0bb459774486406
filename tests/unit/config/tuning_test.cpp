// SPDX-License-Identifier: MIT
#include "config/tuning.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

class TuningDocument : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    for (const char* each : {"base.yaml", "a.yaml", "b.yaml", "teams/c d.yaml", "rules.yaml", "robot.yaml", "own.yaml",
                             "other.yaml", "scenes/one.yaml", "two.yaml"}) {
      write(each, "x: 1\n");
    }
  }

  static std::string absolute(const char* file) { return std::filesystem::absolute(file).lexically_normal().string(); }

  Tuning read(const std::string& text) const {
    write("t.yaml", text);
    return read_document<Tuning>(std::filesystem::path("t.yaml"));
  }
};

constexpr auto whole = R"(tuning: every_key
question: Is anything left out?
team: base.yaml
opponents:
  - {team: a.yaml, weight: 2.5}
  - {team: teams/c d.yaml}
parameters:
  - utility.terms.*.weight
  - {path: sender.params.reserve, range: [10, 60]}
  - {path: contexts.search.use.assigner.params.depth}
objective: {minimise: {striker.overlap_seconds: 1, packets: -0.01}}
seed: 7
rules: rules.yaml
robot: robot.yaml
disturbance: own.yaml
opponent_disturbance: other.yaml
openings: [scenes, two.yaml]
limit: 120
set: {tasks.keep: all, rules.messages.budget: 600}
search: {algorithm: spsa, matches: 500, minutes: 2.5, pairs: 3, population: 20, start_from: [{x: 1}, {y: -2.5, z: 0}]}
selection: {finalists: 6, matches: 90}
verification: {candidates: 2, matches: 800, against: base, confidence: 0.99}
slices: {points: 9, pairs: 5}
)";

TEST_F(TuningDocument, EveryKey) {
  const Tuning tuning = read(whole);
  EXPECT_EQ(tuning.name, "every_key");
  EXPECT_EQ(tuning.question, "Is anything left out?");
  EXPECT_EQ(tuning.team, absolute("base.yaml"));
  ASSERT_EQ(tuning.opponents.size(), 2u);
  EXPECT_EQ(tuning.opponents[0].team, absolute("a.yaml"));
  EXPECT_EQ(tuning.opponents[0].weight, 2.5);
  EXPECT_EQ(tuning.opponents[1].team, absolute("teams/c d.yaml"));
  EXPECT_EQ(tuning.opponents[1].weight, 1.0);
  EXPECT_EQ(tuning.opponents[1].where.line, 6);
  ASSERT_EQ(tuning.search.start_from.size(), 2u);
  EXPECT_EQ(tuning.search.start_from[1]["y"].text(), "-2.5");
  ASSERT_EQ(tuning.parameters.size(), 3u);
  EXPECT_EQ(tuning.parameters[0].pattern, "utility.terms.*.weight");
  EXPECT_FALSE(tuning.parameters[0].range);
  EXPECT_EQ(to_string(tuning.parameters[0].where), "t.yaml:8:5");
  EXPECT_EQ(tuning.parameters[1].pattern, "sender.params.reserve");
  EXPECT_EQ(*tuning.parameters[1].range, (std::array{10.0, 60.0}));
  EXPECT_EQ(to_string(tuning.parameters[1].where), "t.yaml:9:12");
  EXPECT_EQ(to_string(tuning.parameters[1].range_where), "t.yaml:9:42");
  EXPECT_FALSE(tuning.parameters[2].range);
  EXPECT_TRUE(tuning.objective.maximise.empty());
  ASSERT_EQ(tuning.objective.minimise.size(), 2u);
  EXPECT_EQ(tuning.objective.minimise[0].measure, "striker.overlap_seconds");
  EXPECT_EQ(tuning.objective.minimise[0].weight, 1.0);
  EXPECT_EQ(tuning.objective.minimise[1].measure, "packets");
  EXPECT_EQ(tuning.objective.minimise[1].weight, -0.01);
  EXPECT_EQ(to_string(tuning.objective.minimise[1].where), "t.yaml:11:52");
  EXPECT_EQ(tuning.seed, 7);
  EXPECT_EQ(tuning.settings.rules, absolute("rules.yaml"));
  EXPECT_EQ(tuning.settings.robot, absolute("robot.yaml"));
  EXPECT_EQ(tuning.disturbance, absolute("own.yaml"));
  EXPECT_EQ(tuning.opponent_disturbance, absolute("other.yaml"));
  ASSERT_EQ(tuning.settings.openings.size(), 2u);
  EXPECT_EQ(tuning.settings.openings[0].path, absolute("scenes"));
  EXPECT_EQ(tuning.settings.openings[1].path, absolute("two.yaml"));
  EXPECT_EQ(to_string(tuning.settings.openings[1].where), "t.yaml:17:20");
  EXPECT_EQ(tuning.settings.limit, 120.0);
  EXPECT_EQ(tuning.settings.set["rules.messages.budget"].text(), "600");
  EXPECT_EQ(tuning.search.algorithm, "spsa");
  EXPECT_EQ(tuning.search.matches, 500);
  EXPECT_EQ(tuning.search.minutes, 2.5);
  EXPECT_EQ(tuning.search.pairs, 3);
  EXPECT_EQ(tuning.search.population, 20);
  EXPECT_EQ(tuning.selection.finalists, 6);
  EXPECT_EQ(tuning.selection.matches, 90);
  EXPECT_EQ(tuning.verification.candidates, 2);
  EXPECT_EQ(tuning.verification.matches, 800);
  EXPECT_EQ(tuning.verification.against, Tuning::Against::base);
  EXPECT_EQ(tuning.verification.confidence, 0.99);
  EXPECT_EQ(tuning.slices.points, 9);
  EXPECT_EQ(tuning.slices.pairs, 5);
}

constexpr auto least = "tuning: least\nteam: base.yaml\nopponents: [{team: a.yaml}]\nparameters: [a.b]\n";

TEST_F(TuningDocument, WhatIsNotSaidHasItsDefault) {
  const Tuning tuning = read(least), none;
  EXPECT_EQ(tuning.search.algorithm, none.search.algorithm);
  EXPECT_EQ(tuning.search.matches, none.search.matches);
  EXPECT_FALSE(tuning.search.minutes || tuning.search.pairs || tuning.search.population || tuning.settings.limit);
  EXPECT_TRUE(tuning.objective.maximise.empty() && tuning.objective.minimise.empty());
  // What is in force is shown.
  const Node shown = parse_text(show(load("t.yaml")), "shown.yaml");
  EXPECT_EQ(shown["objective"]["maximise"]["goal_difference"].text(), "1");
  EXPECT_EQ(tuning.verification.against, Tuning::Against::opponents);
  EXPECT_EQ(tuning.seed, 1);
  EXPECT_TRUE(tuning.settings.openings.empty());
  EXPECT_FALSE(tuning.settings.set);
}

TEST_F(TuningDocument, AMeasureByItselfCountsOnce) {
  const Tuning tuning = read(std::string(least) + "objective: {maximise: points}\n");
  ASSERT_EQ(tuning.objective.maximise.size(), 1u);
  EXPECT_EQ(tuning.objective.maximise[0].measure, "points");
  EXPECT_EQ(tuning.objective.maximise[0].weight, 1.0);
}

TEST_F(TuningDocument, OneOpeningNeedsNoList) {
  EXPECT_EQ(read(std::string(least) + "openings: two.yaml\n").settings.openings.size(), 1u);
}

TEST_F(TuningDocument, OverridesAndVariants) {
  write("t.yaml", whole);
  const Tuning set =
      read_document<Tuning>(std::filesystem::path("t.yaml"), {"search.matches=40", "parameters.1.range=[20, 30]"});
  EXPECT_EQ(set.search.matches, 40);
  EXPECT_EQ(*set.parameters[1].range, (std::array{20.0, 30.0}));
  write("v.yaml", "extends: t.yaml\ntuning: variant\nobjective: {minimise: ~, maximise: points}\n");
  const Tuning variant = read_document<Tuning>(std::filesystem::path("v.yaml"));
  EXPECT_EQ(variant.name, "variant");
  EXPECT_EQ(variant.objective.maximise.size(), 1u);
  EXPECT_EQ(variant.objective.minimise.size(), 0u);
}

// What `config show` prints is the same tuning, and shown again the same text.
TEST_F(TuningDocument, ShownReadsBackTheSame) {
  for (const std::string& text :
       {std::string(whole), std::string(least), std::string(least) + "objective: {maximise: points}\n",
        std::string(least) + "objective: {maximise: {a b: 0.1, points: 1e-3}}\nopenings: two.yaml\n"}) {
    write("t.yaml", text);
    const Node document = load("t.yaml");
    for (const Remarks remarks : {Remarks::with, Remarks::without}) {
      const std::string shown = show(document, {}, remarks);
      const Tuning a = read_document<Tuning>(document), b = read_document<Tuning>(parse_text(shown, "shown.yaml"));
      EXPECT_EQ(show(parse_text(shown, "shown.yaml"), {}, Remarks::without), show(document, {}, Remarks::without));
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.team, b.team);
      ASSERT_EQ(a.parameters.size(), b.parameters.size());
      for (std::size_t i = 0; i < a.parameters.size(); ++i) {
        EXPECT_EQ(a.parameters[i].pattern, b.parameters[i].pattern);
        EXPECT_EQ(a.parameters[i].range, b.parameters[i].range);
      }
      for (const auto which : {&TuningObjective::maximise, &TuningObjective::minimise}) {
        if (a.objective.maximise.empty() && a.objective.minimise.empty()) continue;  // the default, said
        const auto &first = a.objective.*which, &second = b.objective.*which;
        ASSERT_EQ(first.size(), second.size()) << shown;
        for (std::size_t i = 0; i < first.size(); ++i) {
          EXPECT_EQ(first[i].measure, second[i].measure);
          EXPECT_EQ(first[i].weight, second[i].weight);
        }
      }
      EXPECT_EQ(a.settings.openings.size(), b.settings.openings.size());
      EXPECT_EQ(a.settings.limit, b.settings.limit);
      EXPECT_EQ(a.search.minutes, b.search.minutes);
      EXPECT_EQ(a.search.population, b.search.population);
      EXPECT_EQ(a.verification.against, b.verification.against);
      EXPECT_EQ(a.verification.confidence, b.verification.confidence);
      EXPECT_TRUE(same(a.settings.set, b.settings.set));
    }
  }
}

// Each of these, in the place of a line of the whole document; the error's place and reason.
TEST_F(TuningDocument, WhatIsRefused) {
  struct Wrong {
    const char *line, *instead, *says;
  };
  const Wrong all[] = {
      {"tuning:", "tuning: a b", "t.yaml:1:9: tuning: "},
      {"tuning:", "tuning:", "t.yaml:1:1: tuning: "},
      {"question:", "questions: x", "t.yaml:2:1: unknown key \"questions\"; nearest: \"question\""},
      {"team:", "team: none.yaml", "t.yaml:3:7: team: "},
      {"team:", "team: ~", "t.yaml:3:7: team: "},
      {"  - {team: a.yaml", "  - {team: a.yaml, weight: 0}", "t.yaml:5:28: opponents.0.weight: "},
      {"  - {team: a.yaml", "  - {team: a.yaml, weight: -1}", "t.yaml:5:28: opponents.0.weight: "},
      {"  - {team: a.yaml", "  - {team: a.yaml, weight: .nan}", "t.yaml:5:28: opponents.0.weight: "},
      {"  - {team: a.yaml", "  - {team: none.yaml}", "t.yaml:5:12: opponents.0.team: "},
      {"  - {team: a.yaml", "  - {weight: 1}", "t.yaml:5:5: "},
      {"  - {team: a.yaml", "  - a.yaml", "t.yaml:5:5: opponents.0: "},
      {"  - {path: sender", "  - {path: a.b, range: [0.5, 0.2]}",
       "t.yaml:9:24: parameters.1.range: empty: 0.5 is more than 0.2"},
      {"  - {path: sender", "  - {path: a.b, range: [.nan, 1]}", "t.yaml:9:25: parameters.1.range.0: "},
      {"  - {path: sender", "  - {path: a.b, range: [0, nan]}", "t.yaml:9:28: parameters.1.range.1: "},
      {"  - {path: sender", "  - {path: a.b, range: [0, NaN]}", "t.yaml:9:28: parameters.1.range.1: "},
      {"  - {path: sender", "  - {path: a.b, range: [0, .inf]}", "t.yaml:9:28: parameters.1.range.1: "},
      {"  - {path: sender", "  - {path: a.b, range: [-.inf, 0]}", "t.yaml:9:25: parameters.1.range.0: "},
      {"  - {path: sender", "  - {path: a.b, range: [0, 1e999]}", "t.yaml:9:28: parameters.1.range.1: "},
      {"  - {path: sender", "  - {path: a.b, range: [0, inf]}", "t.yaml:9:28: parameters.1.range.1: "},
      {"  - {path: sender", "  - {path: a.b, range: [1]}", "t.yaml:9:24: parameters.1.range: "},
      {"  - {path: sender", "  - {path: a.b, range: [1, 2, 3]}", "t.yaml:9:24: parameters.1.range: "},
      {"  - {path: sender", "  - {path: a.b, range: 1}", "t.yaml:9:24: parameters.1.range: "},
      {"  - {path: sender", "  - {path: a.b, ranges: [1, 2]}",
       "t.yaml:9:17: unknown key \"ranges\" in parameters.1; nearest: \"range\""},
      {"  - {path: sender", "  - {range: [1, 2]}", "t.yaml:9:5: "},
      {"  - {path: sender", "  - {path: ''}", "t.yaml:9:12: parameters.1.path: expected a path"},
      {"  - {path: sender", "  - ''", "t.yaml:9:5: parameters.1: expected a path"},
      {"  - {path: sender", "  - [a, b]", "t.yaml:9:5: parameters.1: "},
      {"  - {path: sender", "  - \"a\\nb\"", "t.yaml:9:5: parameters.1: "},
      {"objective:", "objective: {}", "t.yaml:11:12: objective: "},
      {"objective:", "objective: {maximise: points, minimise: packets}", "t.yaml:11:41: objective: "},
      {"objective:", "objective: {maximise: {points: 0}}", "t.yaml:11:32: objective.maximise.points: a weight of 0"},
      {"objective:", "objective: {maximise: {points: -0.0}}", "t.yaml:11:32: objective.maximise.points: a weight of 0"},
      {"objective:", "objective: {maximise: {points: .nan}}", "t.yaml:11:32: objective.maximise.points: "},
      {"objective:", "objective: {maximise: {}}", "t.yaml:11:23: objective.maximise: expected a measure"},
      {"objective:", "objective: {maximise: []}", "t.yaml:11:23: objective.maximise: "},
      {"objective:", "objective: {maximise: {'': 1}}", "t.yaml:11:24: objective.maximise: expected a measure"},
      {"objective:", "objective: {maximise: ''}", "t.yaml:11:23: objective.maximise: "},
      {"objective:", "objective: {maximize: points}",
       "t.yaml:11:13: unknown key \"maximize\" in objective; nearest: \"maximise\""},
      {"objective:", "objective: points", "t.yaml:11:12: objective: "},
      {"seed:", "seed: -1", "t.yaml:12:7: seed: "},
      {"seed:", "seed: 1.5", "t.yaml:12:7: seed: "},
      {"openings:", "openings: []", "t.yaml:17:11: openings: "},
      {"openings:", "openings: [two.yaml, gone.yaml]", "t.yaml:17:22: openings: "},
      {"openings:", "openings: {a: b}", "t.yaml:17:11: openings: "},
      {"limit:", "limit: 0", "t.yaml:18:8: limit: "},
      {"set:", "set: [1]", "t.yaml:19:6: set: "},
      {"search:", "search: {matches: 1}", "t.yaml:20:19: search.matches: "},
      {"search:", "search: {minutes: 0}", "t.yaml:20:19: search.minutes: "},
      {"search:", "search: {pairs: 0}", "t.yaml:20:17: search.pairs: "},
      {"search:", "search: {population: 3}", "t.yaml:20:22: search.population: "},
      {"search:", "search: {algoritm: spsa}",
       "t.yaml:20:10: unknown key \"algoritm\" in search; nearest: \"algorithm\""},
      {"selection:", "selection: {finalists: 0}", "t.yaml:21:24: selection.finalists: "},
      {"selection:", "selection: {finalists: 1}", "t.yaml:22:28: verification.candidates: 2 of 1 finalists"},
      {"verification:", "verification: {candidates: 7}", "t.yaml:22:28: verification.candidates: 7 of 6 finalists"},
      {"verification:", "verification: {candidates: 0}", "t.yaml:22:28: verification.candidates: "},
      {"verification:", "verification: {against: team}", "t.yaml:22:25: verification.against: "},
      {"verification:", "verification: {confidence: 1}", "t.yaml:22:28: verification.confidence: "},
      {"slices:", "slices: {points: -1}", "t.yaml:23:18: slices.points: "},
      {"slices:", "slices: {pairs: 1}", "t.yaml:23:17: slices.pairs: "},
  };
  for (const Wrong& each : all) {
    std::string text = whole;
    const std::size_t begin = text.find(each.line), end = text.find('\n', begin);
    ASSERT_NE(begin, std::string::npos);
    text.replace(begin, end - begin, each.instead);
    const std::string found = error_of([&] { read(text); });
    EXPECT_TRUE(found.starts_with(each.says)) << each.instead << "\n  " << found << "\n  " << each.says;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
}

TEST_F(TuningDocument, EmptyAndMissingParts) {
  const auto says = [&](const std::string& text) { return error_of([&] { read(text); }); };
  EXPECT_EQ(says("tuning: a\nteam: base.yaml\nopponents: []\nparameters: [a]\n").substr(0, 22),
            "t.yaml:3:12: opponents");
  EXPECT_EQ(says("tuning: a\nteam: base.yaml\nopponents: [{team: a.yaml}]\nparameters: []\n").substr(0, 23),
            "t.yaml:4:13: parameters");
  EXPECT_EQ(says("tuning: a\nteam: base.yaml\nopponents: [{team: a.yaml}]\nparameters: a.b\n").substr(0, 23),
            "t.yaml:4:13: parameters");
  for (const char* key : {"team", "opponents", "parameters"}) {
    std::string text = least;
    const std::size_t begin = text.find(std::string("\n") + key + ":") + 1;
    text.erase(begin, text.find('\n', begin) + 1 - begin);
    EXPECT_NE(says(text).find(key), std::string::npos) << says(text);
    EXPECT_TRUE(says(text).starts_with("t.yaml:1:1: ")) << says(text);
  }
}

TEST_F(TuningDocument, TheShippedOneIsRead) {
  const Tuning tuning = read_document<Tuning>(project / "configs/studies/tune_paper.yaml");
  EXPECT_FALSE(tuning.parameters.empty());
  EXPECT_FALSE(tuning.opponents.empty());
}

}  // namespace
}  // namespace regista::config
