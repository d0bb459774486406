// SPDX-License-Identifier: MIT
// `regista config show FILE`: a document with every value that is in force, its unit, its meaning and where it is from.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "config/documents.hpp"
#include "output/output.hpp"
#include "plugin/declarations.hpp"
#include "results/document_kinds.hpp"

namespace regista::cli {
namespace {

constexpr auto config_show_examples = R"(Examples:
  regista config show configs/rules/spl2023.yaml
  regista config show configs/teams/paper.yaml --set sender.params.reserve=60)";

struct ConfigShowOptions {
  std::vector<std::string> files, plugins, overrides;
};

// Plugins are opened for teams and studies only: nothing else names them.
std::vector<config::PluginDeclaration> declarations_for(const config::DocumentKind& kind,
                                                        const ConfigShowOptions& options,
                                                        const Invocation& invocation) {
  if (!(kind == config::DocumentKind::team || kind == config::DocumentKind::predictor_study)) return {};
  return plugin::declarations(open_plugins(options.plugins, invocation).plugins());
}

int show(const ConfigShowOptions& options, const Invocation& invocation) {
  if (options.files.size() != 1) {
    throw BadInput(fmt::format("config show: expected one file, {} given", options.files.size()));
  }
  const config::Node document = config::load(options.files.front(), config::typed_overrides(options.overrides));
  const config::DocumentKind kind = results::kind_of(document, invocation);
  output::print(config::show(document, kind, declarations_for(kind, options, invocation), config::Remarks::with));
  return exit_done;
}

}  // namespace

void add_config_show(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("show", "write a document with every value that is in force");
  const auto options = std::make_shared<ConfigShowOptions>();
  command.take("file", options->files, "FILE", "a document of any kind", Reads::documents);
  command.take("--set", options->overrides, "PATH=VALUE", "a value laid over the document; may be repeated");
  add_plugin_folders(command, options->plugins);
  command.notes(config_show_examples);
  command.run = [options, &invocation] { return show(*options, invocation); };
}

}  // namespace regista::cli
