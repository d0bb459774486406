// SPDX-License-Identifier: MIT
// `regista config check FILE...`: whether documents are sound (study/document_check.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "output/output.hpp"
#include "results/study_kind.hpp"
#include "study/document_check.hpp"
#include "texts/json.hpp"

namespace regista::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto config_check_examples = R"(Examples:
  regista config check configs/teams/paper.yaml
  regista config check configs/*/*.yaml
  regista config check small_field/*.yaml --rules small_field.yaml
  regista config check configs/teams/*.yaml --json

Every mistake of a document is printed, in the order of its lines; of text that is not YAML, only the first.

Exit codes: 0 all are sound; 2 one is not, or there is nothing to check.)";

constexpr std::size_t most_printed = 100;  // mistakes of a document; --json writes all that were kept

struct ConfigCheckOptions {
  std::vector<std::string> files, plugins;
  std::string rules, robot;  // files; empty: the built-in values
  bool json = false;
};

study::Profiles profiles(const ConfigCheckOptions& options) {
  study::Profiles out;
  if (!options.rules.empty()) out.rules = config::read_document<config::Rules>(options.rules);
  if (!options.robot.empty()) out.robots.fill(config::read_document<config::Robot>(options.robot));
  return out;
}

void print(const study::DocumentCheck& checked) {
  const std::size_t all = checked.mistakes.size() + checked.more,
                    printed = std::min(checked.mistakes.size(), most_printed);
  for (std::size_t i = 0; i < printed; ++i) complain(checked.mistakes[i].line);
  if (all > printed) complain(fmt::format("{}: ... and {} more", checked.file, all - printed));
  for (const config::Warning& each : checked.warnings) complain(to_string(each));
  if (all == 0) output::print(fmt::format("{}: {}, sound\n", checked.file, checked.kind));
}

Json placed(const config::Location& where, const std::string& message) {
  return {{"file", where.file}, {"line", where.line}, {"column", where.column}, {"message", message}};
}

Json as_json(const study::DocumentCheck& checked) {
  Json mistakes = Json::array(), warnings = Json::array();
  for (const study::DocumentMistake& each : checked.mistakes) mistakes.push_back(placed(each.where, each.message));
  for (const config::Warning& each : checked.warnings) warnings.push_back(placed(each.where, each.message));
  return {{"file", checked.file},
          {"kind", checked.kind.empty() ? Json() : Json(checked.kind)},
          {"sound", checked.mistakes.empty()},
          {"mistakes", mistakes},
          {"mistakes_left_out", checked.more},
          {"warnings", warnings}};
}

int check(const ConfigCheckOptions& options, const Invocation& invocation) {
  if (options.files.empty()) throw BadInput("config check: expected at least one file");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  const study::Profiles by = profiles(options);
  std::vector<study::StudyCheck> studies;
  for (const results::StudyKind& kind : invocation.studies) {
    studies.push_back({kind.document, [&](const config::Node& document, config::Mistakes& mistakes) {
                         if (kind.check) return kind.check(document, options.plugins, catalogue, mistakes);
                         mistakes.attempt("", [&] { kind.plan(document, options.plugins, catalogue); });
                       }});
  }
  bool sound = true;
  Json documents = Json::array();
  for (const std::string& file : options.files) {
    const study::DocumentCheck checked = study::check_document(file, by, catalogue, studies);
    sound = sound && checked.mistakes.empty();
    if (options.json) {
      documents.push_back(as_json(checked));
    } else {
      print(checked);
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
  const auto options = std::make_shared<ConfigCheckOptions>();
  command.take("files", options->files, "FILE", "documents of any kind", Reads::documents);
  command.take("--rules", options->rules, "FILE",
               "rules that openings and teams must go with; default: spl2023, built in", Reads::documents);
  command.take("--robot", options->robot, "FILE", "robot that openings and teams must go with; default: nao, built in",
               Reads::documents);
  command.flag("--json", options->json, "every mistake and warning as JSON, on standard output");
  add_plugin_folders(command, options->plugins);
  command.notes(config_check_examples);
  command.run = [options, &invocation] { return check(*options, invocation); };
}

}  // namespace regista::cli
