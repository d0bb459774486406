// SPDX-License-Identifier: MIT
// `regista config check FILE...`: whether documents are sound. For teams and studies that means their plugins too: that
// they exist, can be opened, are of the right kind, and take the parameters they are given.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"
#include "config/documents.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "plugin/failure.hpp"
#include "study/forecast.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista config check configs/teams/paper.yaml
  regista config check configs/*/*.yaml

Exit codes: 0 all are sound; 2 one is not, or there is nothing to check.)";

struct Options {
  std::vector<std::string> files, plugins;
};

// Its kind. Throws config::Error for what is not sound.
std::string_view check(const std::string& file, const plugin::Catalogue& catalogue) {
  const config::DocumentKind kind = config::check(file);
  if (kind == config::DocumentKind::team) {
    const mind::TeamPlan plan(config::read_team(file), {}, {}, catalogue);  // finds what is wrong with plugins
    const mind::Mind first(plan, 1, 0);                                     // and what they refuse, files too
  }
  if (kind == config::DocumentKind::predictor_study) {
    const config::PredictorStudy study = config::read_predictor_study(file);
    const study::Forecaster forecaster(study, catalogue);  // the same for its predictor
  }
  return config::name_of(kind);
}

int check(const Options& options, const Invocation& invocation) {
  if (options.files.empty()) throw BadInput("config check: at least one file is wanted");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  bool sound = true;
  for (const std::string& file : options.files) {
    try {
      print(fmt::format("{}: {}, sound\n", file, check(file, catalogue)));
    } catch (const config::Error& error) {
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
  CLI::App& app =
      *parent.add_subcommand("check", "say what is wrong with rules, robots, disturbances, teams and studies");
  const auto options = std::make_shared<Options>();
  app.add_option("files", options->files, "documents of any kind")->type_name("FILE...");
  add_plugin_folders(app, options->plugins);
  app.footer(examples);
  return {&app, [options, &invocation] { return check(*options, invocation); }};
}

}  // namespace regista::cli
