// SPDX-License-Identifier: MIT
// Documents of tuned teams: the text that the key of a match is made of, and the file that is written for people. Both
// must be what reading the team's file under the same values gives.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "config/documents.hpp"
#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/info.hpp"
#include "process/sanitized.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {
namespace {

namespace fs = std::filesystem;
using config::PluginDeclaration;
using config::PluginParameter;
using Declarations = std::vector<PluginDeclaration>;
using testing::HasSubstr;
using testing::Not;

const Declarations& shipped_plugins() {
  static const plugin::Catalogue catalogue({REGISTA_PLUGINS});
  static const Declarations all = plugin::declarations(catalogue.plugins());
  return all;
}

std::vector<fs::path> shipped_teams() {
  std::vector<fs::path> out;
  for (const auto& each : fs::recursive_directory_iterator(REGISTA_CONFIGS "/teams")) {
    if (each.is_regular_file()) out.push_back(each.path());
  }
  std::ranges::sort(out);
  return out;
}

// All that can be tuned, ranges on a logarithmic scale narrowed to begin above 0.
std::vector<Parameter> all_parameters(const config::Node& team, const Declarations& plugins) {
  std::vector<Parameter> out;
  const std::vector<Tunable> all = tunables(team, plugins);
  for (const Tunable& each : all) {
    if (!each.refusal.empty() || each.start < each.least || each.start > each.most) continue;
    config::TunedPath path{each.path, {}, {}, {}};
    if (each.log_scale && each.least <= 0.0) {
      if (each.start <= 0.0) continue;
      path.range = {std::min(each.start, 1e-6), each.most};
    }
    out.push_back(chosen_parameters(std::span(&path, 1), all).front());
  }
  return out;
}

// As `regista tune` makes it ready: the base team's document with all parameters in it.
TuningPlan plan_of(const fs::path& file, const std::vector<std::string>& settings, std::vector<Parameter> parameters,
                   const Declarations& plugins) {
  TuningPlan plan;
  plan.asked.team = file.string();
  plan.settings = settings;
  plan.parameters = std::move(parameters);
  config::Overrides overrides = config::typed_overrides(settings);
  for (const std::string& each : settings_of(plan, start_values(plan))) overrides.push_back(each);
  plan.document = config::show(config::load(file, overrides), plugins, config::Remarks::without);
  return plan;
}

// What a worker finds when it plays a match with these values.
std::string resolved(const TuningPlan& plan, const ParameterValues& values, const Declarations& plugins,
                     const std::vector<std::string>& more = {}) {
  config::Overrides overrides = config::typed_overrides(plan.settings);
  for (const std::string& each : settings_of(plan, values)) overrides.push_back(each);
  overrides.insert(overrides.end(), more.begin(), more.end());
  return config::show(config::load(plan.asked.team, overrides), plugins, config::Remarks::without);
}

ParameterValues random_values(const TuningPlan& plan, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-0.1, 1.1);
  ParameterValues out;
  for (const Parameter& each : plan.parameters) out.push_back(value_at_share(each, std::clamp(any(random), 0.0, 1.0)));
  return out;
}

std::vector<Parameter> some(const std::vector<Parameter>& all, std::mt19937& random) {
  std::vector<Parameter> out;
  const double share = std::uniform_real_distribution<double>(0, 1)(random);
  for (const Parameter& each : all) {
    if (std::bernoulli_distribution(share)(random)) out.push_back(each);
  }
  if (out.empty()) out.push_back(all.front());
  return out;
}

class TunedDocuments : public testing::Test {
 protected:
  TunedDocuments() { fs::create_directories(folder); }
  ~TunedDocuments() override { fs::remove_all(folder); }

  fs::path write(const std::string& name, const std::string& text) const {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  // The file of the tuned team, beside which it is written or elsewhere, means the base team with these values.
  void expect_same_team(const TuningPlan& plan, const ParameterValues& values, const Declarations& plugins,
                        const fs::path& place) const {
    const std::string base = fs::proximate(plan.asked.team, place.parent_path()).string();
    const std::string text = tuned_team(plan, values, "the_tuned_one", base);
    const fs::path file = write(place.string(), text);
    std::string found;
    try {
      const config::Node document = config::load(file);
      config::read_document<config::Team>(document);
      found = config::show(document, plugins, config::Remarks::without);
    } catch (const config::Error& error) {
      FAIL() << error.what() << '\n' << text;
    }
    EXPECT_EQ(found, resolved(plan, values, plugins, {"team=the_tuned_one"})) << text;
  }

  fs::path folder = fs::path(testing::TempDir()) / fmt::format("tuned-{}", getpid());
};

// --- Shipped teams ------------------------------------------------------------------------------------------------

TEST_F(TunedDocuments, EveryShippedTeamWithAnyValues) {
  ASSERT_FALSE(shipped_plugins().empty()) << "no plugins in " << REGISTA_PLUGINS;
  std::mt19937 random(1);
  int compared = 0;
  for (const fs::path& team : shipped_teams()) {
    const std::vector<Parameter> all = all_parameters(config::load(team), shipped_plugins());
    ASSERT_FALSE(all.empty()) << team;
    for (int round = 0; round < (sanitized ? 2 : 5); ++round) {
      const TuningPlan plan = plan_of(team, {}, round == 0 ? all : some(all, random), shipped_plugins());
      const TunedDocument document(plan);
      EXPECT_EQ(document.with(start_values(plan)), plan.document);
      for (int i = 0; i < 3; ++i) {
        const ParameterValues values = random_values(plan, random);
        ASSERT_EQ(document.with(values), resolved(plan, values, shipped_plugins())) << team << " round " << round;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, sanitized ? 100 : 300);
}

// A parameter that its team does not say changes nothing while it is at its start, but for saying it.
TEST_F(TunedDocuments, AContextsOwnValueIsOnlyTheContexts) {
  const fs::path team = fs::path(REGISTA_CONFIGS) / "teams/paper.yaml";
  const std::vector<Parameter> all = all_parameters(config::load(team), shipped_plugins());
  const auto found = std::ranges::find(all, "contexts.search.use.utility.terms.distance.weight", &Parameter::path);
  ASSERT_NE(found, all.end());
  const TuningPlan plan = plan_of(team, {}, {*found}, shipped_plugins());
  const config::Team read =
      config::read_document<config::Team>(config::parse_text(TunedDocument(plan).with({0.125}), "t"));
  for (const config::Context& context : read.contexts) {
    for (const config::UtilityTerm& term : context.terms) {
      if (term.name != "distance") continue;
      EXPECT_EQ(term.weight, context.name == "search" ? 0.125 : 0.7);
    }
  }
}

TEST_F(TunedDocuments, FilesOfShippedTeamsMeanTheSame) {
  std::mt19937 random(2);
  for (const fs::path& team : shipped_teams()) {
    const std::vector<Parameter> all = all_parameters(config::load(team), shipped_plugins());
    for (int round = 0; round < (sanitized ? 1 : 2); ++round) {
      const TuningPlan plan = plan_of(team, {}, round == 0 ? all : some(all, random), shipped_plugins());
      expect_same_team(plan, random_values(plan, random), shipped_plugins(), folder / "night one's.tuned.yaml");
    }
  }
}

// --- Made-up teams ------------------------------------------------------------------------------------------------

PluginParameter tunable(const char* name, PluginParameter::Type type, double least, double most, double initial) {
  PluginParameter out{name, type, least, most, "1", "", initial};
  out.tunable = true;
  return out;
}

Declarations made_up() {
  using enum PluginParameter::Type;
  const PluginParameter period = tunable("period", real, 0, 60, 10),
                        reserve = tunable("reserve", integer, 0, 2000000, 30);
  return {{"still", "predictor", "", {tunable("noise", real, -1e6, 1e6, 0)}},
          {"always", "context", "", {}},
          {"lost", "context", "", {tunable("after", real, 0, 60, 5)}},
          {"near", "utility", "", {tunable("reach", real, 1e-9, 4, 2)}},
          {"greedy", "assigner", "", {tunable("depth", integer, 1, 9, 3)}},
          {"timed", "sender", "", {period, reserve, {.name = "table", .type = file}}},
          {"events", "sender", "", {reserve}},
          {"grid", "positioner", "", {tunable("step", real, 0.1, 1, 0.5)}}};
}

constexpr auto awkward_team = R"(# Flow and block, dots and maps, comments and numbers in many shapes.
team: base
predictors:
  self: {plugin: still}
  ball: {plugin: still, params: {noise: -1.50e+2}}   # 1.5 = 1.5
  opponents: {plugin: still}
  teammates: {plugin: still}
contexts:
  - {name: dotted, priority: 5, plugin: lost, params: {after: 7.50}, use: {sender.params.period: 4.0, utility.terms.far.weight: 0.125, positioner: ~}}
  - name: nested
    priority: 4
    plugin: lost
    use: {sender: {plugin: events, params: {reserve: 40}}, utility: {terms: {near: ~, third: {plugin: near, weight: 2, tune: [1, 3]}}}}
  - {name: mixed, priority: 3, plugin: lost, use: {sender.params: {period: 3}, sender.params.reserve: 7, assigner: {params: {depth: 4}}}}
  - {name: empty, priority: 2, plugin: lost, use: {}}
  - {name: renamed, priority: 1, plugin: lost, use: {sender.plugin: events}}
  - {name: playing, plugin: always}
positioner: {plugin: grid}
utility:
  terms:
    near: {plugin: near, weight: 0.750, tune: [0, 1]}
    far: {plugin: near, params: {reach: 5e-1}, tune: [0, 1000000]}
    unsaid: {plugin: near, tune: [0, 2]}
assigner: {plugin: greedy, params: {depth: 5}}
sender: {plugin: timed}
roles: {r: [{name: goalkeeper, robot: 1, target: {at: own_goal}}, {name: striker, target: {at: ball}}]}
)";

TEST_F(TunedDocuments, EveryShapeOfAPageWithAnyValues) {
  const fs::path team = write("base.yaml", awkward_team);
  const std::vector<Parameter> all = all_parameters(config::load(team), made_up());
  for (const char* path :
       {"predictors.ball.params.noise", "contexts.dotted.use.sender.params.period", "contexts.dotted.params.after",
        "contexts.dotted.use.sender.params.reserve", "contexts.nested.use.sender.params.reserve",
        "contexts.nested.use.utility.terms.third.params.reach", "contexts.mixed.use.sender.params.reserve",
        "contexts.mixed.use.assigner.params.depth", "contexts.empty.use.utility.terms.near.weight",
        "contexts.renamed.use.sender.params.reserve", "contexts.playing.use.positioner.params.step",
        "utility.terms.unsaid.weight", "sender.params.reserve"}) {
    EXPECT_NE(std::ranges::find(all, path, &Parameter::path), all.end()) << path;
  }
  std::mt19937 random(3);
  for (int round = 0; round < (sanitized ? 25 : 100); ++round) {
    const TuningPlan plan = plan_of(team, {}, round == 0 ? all : some(all, random), made_up());
    const TunedDocument document(plan);
    ParameterValues values = random_values(plan, random);
    if (round % 5 == 1) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = plan.parameters[i].least;
    }
    if (round % 5 == 2) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = plan.parameters[i].most;
    }
    ASSERT_EQ(document.with(values), resolved(plan, values, made_up())) << round;
    // And what is read from it has these values.
    const auto read = tunables(config::parse_text(document.with(values), "t"), made_up());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto found = std::ranges::find(read, plan.parameters[i].path, &Tunable::path);
      ASSERT_NE(found, read.end());
      EXPECT_EQ(found->start, values[i]) << found->path;
    }
    expect_same_team(plan, values, made_up(), folder / "results of today/it's tuned.yaml");
    if (HasFatalFailure()) return;
  }
}

// --- The file of a tuned team -------------------------------------------------------------------------------------

class TunedTeamFiles : public TunedDocuments {
 protected:
  // With some parameters of the page under these settings.
  void expect_same_under(const std::vector<std::string>& settings, std::vector<std::string> paths,
                         const std::string& page = awkward_team, const std::string& name = "base.yaml") {
    const fs::path team = write(name, page);
    const std::vector<Parameter> all = all_parameters(config::load(team, config::typed_overrides(settings)), made_up());
    std::vector<Parameter> chosen;
    for (const std::string& path : paths) {
      const auto found = std::ranges::find(all, path, &Parameter::path);
      ASSERT_NE(found, all.end()) << path;
      chosen.push_back(*found);
    }
    const TuningPlan plan = plan_of(team, settings, chosen, made_up());
    std::mt19937 random(4);
    for (const char* place : {"beside.yaml", "sub folder/other.yaml"}) {
      expect_same_team(plan, random_values(plan, random), made_up(), folder / place);
    }
  }
};

TEST_F(TunedTeamFiles, SayOnlyWhatDiffers) {
  const fs::path team = write("base.yaml", awkward_team);
  const std::vector<Parameter> all = all_parameters(config::load(team), made_up());
  const auto weight = std::ranges::find(all, "utility.terms.near.weight", &Parameter::path);
  const TuningPlan plan = plan_of(team, {}, {*weight}, made_up());
  EXPECT_EQ(tuned_team(plan, {0.25}, "tuned", "../base.yaml"),
            "extends: \"../base.yaml\"\nteam: tuned\n\nutility:\n  terms:\n    near:\n      weight: 0.25\n");
}

TEST_F(TunedTeamFiles, ListsAreWrittenWhole) {
  const fs::path team = write("base.yaml", awkward_team);
  const std::vector<Parameter> all = all_parameters(config::load(team), made_up());
  const auto period = std::ranges::find(all, "contexts.dotted.use.sender.params.period", &Parameter::path);
  const TuningPlan plan = plan_of(team, {}, {*period}, made_up());
  const std::string text = tuned_team(plan, {8.5}, "tuned", "base.yaml");
  EXPECT_THAT(text, HasSubstr("sender.params.period: 8.5"));
  EXPECT_THAT(text, HasSubstr("name: playing"));
  EXPECT_THAT(text, Not(HasSubstr("utility:\n")));
}

TEST_F(TunedTeamFiles, WithSettingsOfTheBaseTeam) {
  const std::vector<std::string> weight{"utility.terms.far.weight"};
  expect_same_under({"utility.terms.unsaid=~"}, weight);
  expect_same_under({"tasks.keep=all", "tasks.hysteresis=0.30"}, weight);
  expect_same_under({"sender.params.period=4"}, {"sender.params.period", "utility.terms.far.weight"});
  expect_same_under({"contexts.dotted.priority=9"}, weight);
  expect_same_under({"contexts.empty=~"}, weight);
  expect_same_under({"contexts.0.use.sender.params.period=11"}, {"contexts.dotted.use.sender.params.period"});
  expect_same_under({"roles.r.striker.target={at: [1, 2]}"}, weight);
  expect_same_under({"utility.terms.fourth={plugin: near, weight: 0.5, params: {reach: 1}}"}, weight);
  expect_same_under({"predictors.ball={plugin: still, params: {noise: 3}}"}, {"predictors.ball.params.noise"});
}

// Settings are laid over one after the other; the file says what is left of them.
TEST_F(TunedTeamFiles, SettingsThatReplaceEachOther) {
  const std::vector<std::string> weight{"utility.terms.far.weight"};
  expect_same_under({"sender.params.period=4", "sender={params: {reserve: 3}}"}, weight);
  expect_same_under({"sender.params.period=4", "sender.plugin=events"}, {"sender.params.reserve"});
  expect_same_under({"sender.plugin=events", "sender.params.reserve=4"}, {"sender.params.reserve"});
  expect_same_under({"utility.terms.unsaid.weight=0.5", "utility.terms.unsaid=~"}, weight);
  expect_same_under({"utility.terms.far.params.reach=~"}, weight);
  expect_same_under({"utility.terms.near.weight=0.5", "utility.terms.near.weight=0.25"}, {"utility.terms.near.weight"});
}

TEST_F(TunedTeamFiles, ASettingOfTheNameGivesWay) { expect_same_under({"team=other"}, {"utility.terms.far.weight"}); }

// A file that a setting names is relative to the folder that the tuning is begun in, not to the new file.
TEST_F(TunedTeamFiles, FilesThatSettingsName) {
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  write("table.txt", "1\n");
  expect_same_under({"sender.params.table=table.txt"}, {"sender.params.period"});
  fs::current_path(before);
}

TEST_F(TunedTeamFiles, NamesOfFilesMayBeAnything) {
  for (const char* name :
       {"with space.yaml", "it's.yaml", "a: b #c.yaml", "\"quoted\".yaml", "~", "-", "é.yaml", "back\\slash.yaml"}) {
    expect_same_under({}, {"utility.terms.far.weight", "contexts.dotted.use.sender.params.period"}, awkward_team, name);
  }
}

// --- Damage -------------------------------------------------------------------------------------------------------

TEST_F(TunedDocuments, ADamagedPlanIsRefused) {
  const auto refused = [](const std::string& document, const std::vector<std::string>& paths) {
    TuningPlan plan;
    plan.asked.team = "t";
    plan.document = document;
    for (const std::string& each : paths) plan.parameters.push_back({each, 1, 0, 2, false, false, "", ""});
    EXPECT_THROW(TunedDocument{plan}, std::invalid_argument) << document;
  };
  refused("a: 1\n", {"b"});
  refused("a: {b: 1}\n", {"a"});
  refused("a: [1, 2]\n", {"a"});
  refused("a: ~\n", {"a"});
  refused("", {"a"});
  refused("a: 1\na: 2\n", {"a"});  // no document
  refused("a: [1\n", {"a"});
  refused("- 1\n", {"0"});
  refused(std::string("a: \x00", 4), {"a"});
  refused("a: '1'\n", {"a"});  // not as numbers are written
  refused("a: \"1\\x30\"\n", {"a"});
  refused("a: |\n  1\n", {"a"});
  refused("b: &x 1\na: *x\n", {"a"});  // stands elsewhere
  refused("a: 1\n", {"a", "a"});       // two at the same place
}

}  // namespace
}  // namespace regista::study
