// SPDX-License-Identifier: MIT
// `regista config check FILE...`: whether documents are sound. For teams and studies that means their plugins too: that
// they exist, can be opened, are of the right kind, and take the parameters they are given. For openings it means that
// they can be played by rules and a robot.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>

#include "cli/commands.hpp"
#include "cli/end_of_program.hpp"
#include "cli/plugin_folders.hpp"
#include "config/documents.hpp"
#include "config/json.hpp"
#include "config/team_size.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "output/output.hpp"
#include "plugin/failure.hpp"
#include "study/experiment_setup.hpp"
#include "study/prediction/forecast.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto examples = R"(Examples:
  regista config check configs/teams/paper.yaml
  regista config check configs/*/*.yaml
  regista config check small_field/*.yaml --rules small_field.yaml
  regista config check configs/teams/*.yaml --json

Every mistake of a document is told, in the order of its lines; of text that is not YAML, only the first.

Exit codes: 0 all are sound; 2 one is not, or there is nothing to check.)";

constexpr std::size_t most_told = 100;  // mistakes of a document; --json tells all that were kept

struct Options {
  std::vector<std::string> files, plugins;
  std::string rules, robot;  // files; empty: the built-in values
  bool json = false;
};

// What openings and teams are to be played by.
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

// A mistake, as it is told.
struct Told {
  config::Location where;
  std::string message, line;
};

Told of_file(const std::string& file, const std::string& message, const std::string& line) {
  Told out;
  out.where.file = file;
  out.message = message;
  out.line = line;
  return out;
}

struct Verdict {
  std::string file, kind;      // kind: empty where it is not known
  std::vector<Told> mistakes;  // in the order of the lines
  std::size_t more = 0;        // mistakes that were found, but not kept
  std::vector<config::Warning> warnings;
};

class Checker {
 public:
  Checker(const Profiles& by, const plugin::Catalogue& catalogue, const std::vector<std::string>& plugins)
      : by_(by), catalogue_(catalogue), plugins_(plugins) {}

  Verdict check(const std::string& file) const {
    Verdict out;
    out.file = file;
    config::Mistakes mistakes(config::Mistakes::After::go_on);
    std::vector<Told> others;
    try {
      mistakes.attempt("", [&] { look_at(config::load(file), out, mistakes); });
    } catch (const BadInput& error) {
      others.push_back(of_file(file, error.what(), error.what()));
    } catch (const plugin::Failure& failure) {
      others.push_back(of_file(file, failure.what(), fmt::format("{}: {}", file, failure.what())));
    }
    for (const config::Error& each : mistakes.in_order(file)) {
      out.mistakes.push_back({each.where(), each.message(), each.what()});
    }
    out.more = mistakes.total() - out.mistakes.size();
    std::ranges::move(others, std::back_inserter(out.mistakes));
    return out;
  }

 private:
  void look_at(const config::Node& document, Verdict& out, config::Mistakes& mistakes) const {
    using config::DocumentKind;
    const DocumentKind kind = config::kind_of(document);
    out.kind = config::name_of(kind);
    switch (kind) {
      case DocumentKind::rules:
        config::read_rules(document, mistakes);
        break;
      case DocumentKind::robot:
        config::read_robot(document, mistakes);
        break;
      case DocumentKind::disturbance:
        config::read_disturbance(document, mistakes);
        break;
      case DocumentKind::opening:
        config::check(config::read_opening(document, mistakes), by_.rules, by_.robots, document, mistakes);
        break;
      case DocumentKind::team:
        look_at_team(document, out, mistakes);
        break;
      case DocumentKind::predictor_study: {
        const config::PredictorStudy study = config::read_predictor_study(document, mistakes);
        if (mistakes.none()) const study::Forecaster forecaster(study, catalogue_);  // what its plugin refuses
        break;
      }
      case DocumentKind::experiment: {
        config::read_experiment(document, mistakes);
        if (!mistakes.none()) break;
        study::ExperimentRequest experiment;
        experiment.file = out.file;
        experiment.plugins = plugins_;
        study::check_experiment(experiment, catalogue_, mistakes);  // every arm at every value
        break;
      }
      case DocumentKind::tuning: {
        config::read_tuning(document, mistakes);
        if (!mistakes.none()) break;
        study::TuningRequest tuning;
        tuning.file = out.file;
        tuning.plugins = plugins_;
        study::check_tuning(tuning, catalogue_, mistakes);  // team, opponents, parameters
        break;
      }
    }
  }

  void look_at_team(const config::Node& document, Verdict& out, config::Mistakes& mistakes) const {
    const config::Team team = config::read_team(document, mistakes);
    config::check(team, by_.rules, document, mistakes);
    const mind::TeamPlan plan(team, by_.rules, by_.robots[0], catalogue_, mistakes);  // what is wrong with plugins
    if (!mistakes.none()) return;
    const mind::Mind first(plan, 1, 0);  // and what they refuse, files too
    out.warnings = config::warnings(team, by_.rules, document);
  }

  const Profiles& by_;
  const plugin::Catalogue& catalogue_;
  const std::vector<std::string>& plugins_;
};

void tell(const Verdict& verdict) {
  const std::size_t all = verdict.mistakes.size() + verdict.more, told = std::min(verdict.mistakes.size(), most_told);
  for (std::size_t i = 0; i < told; ++i) complain(verdict.mistakes[i].line);
  if (all > told) complain(fmt::format("{}: ... and {} more", verdict.file, all - told));
  for (const config::Warning& each : verdict.warnings) complain(to_string(each));
  if (all == 0) output::print(fmt::format("{}: {}, sound\n", verdict.file, verdict.kind));
}

Json placed(const config::Location& where, const std::string& message) {
  return {{"file", where.file}, {"line", where.line}, {"column", where.column}, {"message", message}};
}

Json as_json(const Verdict& verdict) {
  Json mistakes = Json::array(), warnings = Json::array();
  for (const Told& each : verdict.mistakes) mistakes.push_back(placed(each.where, each.message));
  for (const config::Warning& each : verdict.warnings) warnings.push_back(placed(each.where, each.message));
  return {{"file", verdict.file},
          {"kind", verdict.kind.empty() ? Json() : Json(verdict.kind)},
          {"sound", verdict.mistakes.empty()},
          {"mistakes", mistakes},
          {"mistakes_left_out", verdict.more},
          {"warnings", warnings}};
}

int check(const Options& options, const Invocation& invocation) {
  if (options.files.empty()) throw BadInput("config check: at least one file is wanted");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  const Profiles by = profiles(options);
  const Checker checker(by, catalogue, options.plugins);
  bool sound = true;
  Json documents = Json::array();
  for (const std::string& file : options.files) {
    const Verdict verdict = checker.check(file);
    sound = sound && verdict.mistakes.empty();
    if (options.json) {
      documents.push_back(as_json(verdict));
    } else {
      tell(verdict);
    }
  }
  if (options.json) {
    const Json out{{"documents", documents}};
    output::print(out.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  }
  return sound ? exit_done : exit_bad_input;
}

}  // namespace

void add_config_check(Command& parent, const Invocation& invocation) {
  Command& command =
      parent.add("check", "say what is wrong with rules, robots, disturbances, openings, teams and studies");
  const auto options = std::make_shared<Options>();
  command.take("files", options->files, "FILE...", "documents of any kind", Reads::documents);
  command.take("--rules", options->rules, "FILE",
               "rules that openings and teams must go with; default: spl2023, built in", Reads::documents);
  command.take("--robot", options->robot, "FILE", "robot that openings and teams must go with; default: nao, built in",
               Reads::documents);
  command.flag("--json", options->json, "every mistake and warning as JSON, on standard output");
  add_plugin_folders(command, options->plugins);
  command.notes(examples);
  command.run = [options, &invocation] { return check(*options, invocation); };
}

}  // namespace regista::cli
