// SPDX-License-Identifier: MIT
// `regista config show FILE`: a document with every value that is in force, its unit, its meaning and where it is from.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/file_options.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"
#include "config/documents.hpp"
#include "plugin/declarations.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista config show configs/rules/spl2023.yaml
  regista config show configs/teams/paper.yaml --set sender.params.reserve=60)";

struct Options {
  std::vector<std::string> files, plugins, overrides;
};

// Plugins are opened for teams and studies only: nothing else names them.
std::vector<config::PluginDeclaration> declarations_for(const config::Node& document, const Options& options,
                                                        const Invocation& invocation) {
  const config::DocumentKind kind = config::kind_of(document);
  if (kind != config::DocumentKind::team && kind != config::DocumentKind::predictor_study) return {};
  return plugin::declarations(open_plugins(options.plugins, invocation).plugins());
}

int show(const Options& options, const Invocation& invocation) {
  if (options.files.size() != 1) {
    throw BadInput(fmt::format("config show: one file is wanted, {} given", options.files.size()));
  }
  const config::Node document = config::load(options.files.front(), options.overrides);
  print(config::show(document, declarations_for(document, options, invocation)));
  return exit_done;
}

}  // namespace

Command add_config_show(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("show", "write a document with every value that is in force");
  const auto options = std::make_shared<Options>();
  reads(app.add_option("file", options->files, "a document of any kind")->type_name("FILE"), Reads::documents);
  app.add_option("--set", options->overrides, "a value laid over the document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  add_plugin_folders(app, options->plugins);
  app.footer(examples);
  return {&app, [options, &invocation] { return show(*options, invocation); }};
}

}  // namespace regista::cli
