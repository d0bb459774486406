// SPDX-License-Identifier: MIT
// Whatever a study's document can say is said by its report, as JSON and as a page, and is written to the folder that
// plays it again: every key of every kind of study, each with another value than its own.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cli/study_commands.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/values.hpp"
#include "process/file_descriptor.hpp"
#include "report/evaluation_report.hpp"
#include "report/experiment_report.hpp"
#include "report/outline.hpp"
#include "report/tournament_report.hpp"
#include "report/tuning_report.hpp"
#include "results/results_file.hpp"
#include "texts/json.hpp"
#include "unit/study/experiment_fixture.hpp"
#include "unit/study/tournament_fixture.hpp"
#include "unit/study/tuning_fixture.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

// What studies share.
constexpr auto settings = R"(
rules: rules.yaml
robot: robot.yaml
openings: [scenes, other.yaml]
limit: 12.5
set: {rules.team_size: 5}
limits: {processor_seconds: 3, memory: 512, wall_seconds: 70, match_seconds: 600}
isolation: always
play_twice: false
allow_shared_memory: true
played_with: [program 01]
)";

constexpr auto tournament = R"(
tournament: night
question: Which?
teams: [{team: a.yaml, disturbance: own.yaml}, {team: b.yaml, disturbance: other.yaml}]
format: gauntlet
pairs: 7
test: {elo: [-3, 8], model: logistic, alpha: 0.04, beta: 0.2}
seed: 5
seeds: consecutive
disturbance: wind.yaml
failures_in_a_row: 4
)";

constexpr auto experiment = R"(
experiment: arms
question: Which?
arms: [{name: one, team: a.yaml, set: {sender.params.period: 4}}, {name: two, team: b.yaml, set: {tasks.keep: all}}]
team: c.yaml
opponent: d.yaml
matches: 6
seed: 5
seeds: consecutive
disturbance: wind.yaml
opponent_disturbance: fog.yaml
sweep: {path: rules.messages.budget, values: [600, 1200]}
measures: [packets]
primary: {measure: goals, compare: [[two, one]], test: sign_flip}
confidence: 0.9
)";

constexpr auto tuning = R"(
tuning: weights
question: Which?
team: a.yaml
opponents: [{team: b.yaml, weight: 3}]
parameters: [{path: p0, range: [0.25, 0.75]}]
objective: {minimise: {goals_against: 2}}
seed: 5
seeds: consecutive
disturbance: wind.yaml
opponent_disturbance: fog.yaml
search: {algorithm: spsa, matches: 400, minutes: 2.5, pairs: 3, population: 8, start_from: [{p0: 0.3}]}
selection: {finalists: 6, matches: 96}
verification: {candidates: 2, matches: 600, against: base, test: symmetric, confidence: 0.9}
slices: {points: 3, pairs: 6}
)";

constexpr auto prediction = R"(
predictor_study: ours
format: ssl_robots
subject: opponents
predictor: {plugin: imm, file: imm.so, params: {gate: 9}}
field: {length: 12, width: 9}
robot_radius: 0.08
camera: {noise: 0.004, range: 20}
observations: {every: 0.5, drop: 0.25, seed: 7}
questions: {every: 5, horizons: [0.2, 0.4, 0.6, 0.8], tolerance: 0.01, memory: 2, step: 0.05}
baselines: {window: 0.2, least: 6, time_constant: 0.5}
)";

// Keys that go with others than those above, and are asked for in documents of their own.
const std::vector<std::string> alternatives{"test.metric", "minutes", "rounds", "objective.maximise",
                                            "baselines.deceleration"};

void expect_keys(const config::Map& declared, const Json& said, const Json& usual, const std::string& path) {
  for (const config::Field& each : declared.fields) {
    const std::string name = path.empty() ? each.key : path + '.' + each.key;
    if (std::ranges::find(alternatives, name) != alternatives.end()) continue;
    ASSERT_TRUE(said.contains(each.key)) << name << ": this test has to say it, too";
    const Json& value = said.at(each.key);
    if (const auto* section = std::get_if<config::Section>(&each.kind)) {
      expect_keys(section->open(), value, usual.value(each.key, Json::object()), name);
    } else if (const auto* list = std::get_if<config::List>(&each.kind)) {
      expect_keys(list->element(0), value.at(0), Json::object(), name + ".0");
    } else {
      EXPECT_TRUE(!usual.contains(each.key) || usual.at(each.key) != value) << name << " has its usual value here";
    }
  }
}

std::string without_entities(std::string text) {
  for (const auto& [entity, character] :
       {std::pair{"&quot;", "\""}, {"&#39;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string_view(entity).size(), character);
  }
  return text;
}

// said: the document as the plan has it.
template <class Document>
void expect_said(Document document, const report::WhatWasPlayed& played) {
  const Json said = config::to_json(config::values_of(declare(document)));
  Document nothing;
  expect_keys(declare(document), said, config::to_json(config::values_of(declare(nothing))), "");

  EXPECT_EQ(report::played_json(played).at("document"), said);

  report::Outline outline;
  outline.played = played;
  const std::string page = without_entities(report::outline_page(outline, "results.db", {}));
  EXPECT_THAT(page, testing::HasSubstr(config::document_text(document)));

  const process::TemporaryFolder folder;
  results::write_study(played, {}, cli::study_kinds(), folder.path() / "again");
  std::ifstream in(folder.path() / "again" / "study.yaml");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Json again = config::to_json(config::parse_text(text, "study.yaml"));
  // Files that the results do not hold are named where they are; what was found says what it is played with.
  for (const char* const name : {"a.yaml", "b.yaml", "rules.yaml", "scenes", "wind.yaml"})
    EXPECT_EQ(text.find(name) != std::string::npos, config::document_text(document).find(name) != std::string::npos);
  again.erase("played_with");
  Json expected = said;
  expected.erase("played_with");
  const std::string here = played.folder + '/';
  std::string with_names = again.dump();
  for (std::size_t at = 0; (at = with_names.find(here, at)) != std::string::npos;) with_names.erase(at, here.size());
  EXPECT_EQ(with_names, expected.dump());
}

template <class Document>
Document read(const std::string& text) {
  config::Mistakes first(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
  return config::read_document<Document>(config::parse_text(text, "document.yaml"), first);
}

TEST(PlayedFields, OfATournament) {
  study::TournamentPlan plan = study::plan_of(2, 7);
  plan.folder = "/somewhere";
  for (const std::string& text :
       {std::string(tournament) + settings, std::string("tournament: night\nteams: [{team: a.yaml}, {team: b.yaml}]\n"
                                                        "pairs: 3\ntest: {metric: goals}\n")}) {
    plan.asked = read<config::Tournament>(text);
    if (text.find("metric") == std::string::npos) expect_said(plan.asked, report::what_was_played(plan));
    EXPECT_EQ(report::played_json(report::what_was_played(plan)).at("document"),
              config::to_json(config::values_of(declare(plan.asked))));
  }
}

TEST(PlayedFields, OfAnExperiment) {
  study::ExperimentPlan plan = study::experiment_of(2, 2, 3);
  plan.folder = "/somewhere";
  plan.asked = read<config::Experiment>(std::string(experiment) + settings);
  expect_said(plan.asked, report::what_was_played(plan));
}

TEST(PlayedFields, OfATuning) {
  study::TuningPlan plan = study::tuning_of(1, 1, study::Algorithm::spsa);
  plan.folder = "/somewhere";
  plan.asked = read<config::Tuning>(std::string(tuning) + settings);
  expect_said(plan.asked, report::what_was_played(plan));
}

// It has no page and no folder: one command plays a document and a recording.
TEST(PlayedFields, OfAnEvaluation) {
  auto study = read<config::PredictorStudy>(prediction);
  config::PredictorStudy nothing;
  const Json said = Json::parse(report::evaluation_json(study, {}, {})).at("evaluated").at("document");
  expect_keys(declare(study), said, config::to_json(config::values_of(declare(nothing))), "");
  EXPECT_EQ(said, config::to_json(config::parse_text(prediction, "document.yaml")));
}

}  // namespace
}  // namespace regista::cli
