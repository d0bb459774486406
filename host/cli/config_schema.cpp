// SPDX-License-Identifier: MIT
// `regista config schema KIND`: the JSON Schema of a kind of document, for editors that complete and check while
// typing.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "config/documents.hpp"
#include "output/output.hpp"
#include "plugin/declarations.hpp"
#include "results/document_kinds.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto config_schema_examples = R"(Examples:
  regista config schema team > team.schema.json)";

struct ConfigSchemaOptions {
  std::vector<std::string> kinds, plugins;
};

int schema(const ConfigSchemaOptions& options, const Invocation& invocation) {
  if (options.kinds.size() != 1) {
    throw BadInput(fmt::format("config schema: expected one of {}, {} given",
                               texts::join(results::kind_names(invocation)), options.kinds.size()));
  }
  const config::DocumentKind kind = results::kind_named(options.kinds.front(), "config schema", invocation);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  output::print(config::schema(kind, plugin::declarations(catalogue.plugins())));
  return exit_done;
}

}  // namespace

void add_config_schema(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("schema", "write the JSON Schema of a kind of document");
  const auto options = std::make_shared<ConfigSchemaOptions>();
  command.choose("kind", options->kinds, results::kind_names(invocation), texts::join(results::kind_names(invocation)));
  add_plugin_folders(command, options->plugins);
  command.notes(config_schema_examples);
  command.run = [options, &invocation] { return schema(*options, invocation); };
}

}  // namespace regista::cli
