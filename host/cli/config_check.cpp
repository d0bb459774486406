// SPDX-License-Identifier: MIT
// `regista config check FILE...`: whether documents are sound. For teams and studies that means their plugins too: that
// they exist, can be opened, are of the right kind, and take the parameters they are given. For openings it means that
// they can be played by rules and a robot.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/experiment_setup.hpp"
#include "cli/file_options.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/tune_setup.hpp"
#include "config/documents.hpp"
#include "config/read.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "plugin/failure.hpp"
#include "study/forecast.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista config check configs/teams/paper.yaml
  regista config check configs/*/*.yaml
  regista config check small_field/*.yaml --rules small_field.yaml

Exit codes: 0 all are sound; 2 one is not, or there is nothing to check.)";

struct Options {
  std::vector<std::string> files, plugins;
  std::string rules, robot;  // files; empty: the built-in values
};

// What openings are to be played by.
struct Profiles {
  config::Rules rules;
  std::array<config::Robot, 2> robots;  // by side
};

Profiles profiles(const Options& options) {
  Profiles out;
  if (!options.rules.empty()) out.rules = config::read_rules(options.rules);
  if (!options.robot.empty()) out.robots.fill(config::read_robot(options.robot));
  return out;
}

// Its kind. Throws config::Error for what is not sound.
std::string_view check(const std::string& file, const Profiles& by, const plugin::Catalogue& catalogue,
                       const std::vector<std::string>& plugins) {
  const config::DocumentKind kind = config::check(file);
  if (kind == config::DocumentKind::team) {
    const mind::TeamPlan plan(config::read_team(file), {}, {}, catalogue);  // finds what is wrong with plugins
    const mind::Mind first(plan, 1, 0);                                     // and what they refuse, files too
  }
  if (kind == config::DocumentKind::predictor_study) {
    const config::PredictorStudy study = config::read_predictor_study(file);
    const study::Forecaster forecaster(study, catalogue);  // the same for its predictor
  }
  if (kind == config::DocumentKind::experiment) {
    ExperimentOptions experiment;
    experiment.file = file;
    experiment.plugins = plugins;
    planned_experiment(experiment, catalogue);  // every arm at every value
  }
  if (kind == config::DocumentKind::tuning) {
    TuneOptions tuning;
    tuning.file = file;
    tuning.plugins = plugins;
    planned_tuning(tuning, catalogue);  // team, opponents, parameters
  }
  if (kind == config::DocumentKind::opening) {
    const config::Node document = config::load(file);
    if (const auto misfit = config::misfit(config::read_opening(document), by.rules, by.robots)) {
      config::refuse(document, {misfit->path}, misfit->reason);
    }
  }
  return config::name_of(kind);
}

int check(const Options& options, const Invocation& invocation) {
  if (options.files.empty()) throw BadInput("config check: at least one file is wanted");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  const Profiles by = profiles(options);
  bool sound = true;
  for (const std::string& file : options.files) {
    try {
      print(fmt::format("{}: {}, sound\n", file, check(file, by, catalogue, options.plugins)));
    } catch (const config::Error& error) {
      complain(error.what());
      sound = false;
    } catch (const BadInput& error) {
      complain(error.what());
      sound = false;
    } catch (const plugin::Failure& failure) {
      complain(fmt::format("{}: {}", file, failure.what()));
      sound = false;
    }
  }
  return sound ? exit_done : exit_bad_input;
}

}  // namespace

Command add_config_check(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand(
      "check", "say what is wrong with rules, robots, disturbances, openings, teams and studies");
  const auto options = std::make_shared<Options>();
  reads(app.add_option("files", options->files, "documents of any kind")->type_name("FILE..."), Reads::documents);
  reads(app.add_option("--rules", options->rules, "rules that openings must go with; default: spl2023, built in")
            ->type_name("FILE"),
        Reads::documents);
  reads(app.add_option("--robot", options->robot, "robot that openings must go with; default: nao, built in")
            ->type_name("FILE"),
        Reads::documents);
  add_plugin_folders(app, options->plugins);
  app.footer(examples);
  return {&app, [options, &invocation] { return check(*options, invocation); }};
}

}  // namespace regista::cli
