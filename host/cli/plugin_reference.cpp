// SPDX-License-Identifier: MIT
// `regista plugin reference`: a page of Markdown about all plugins, for a web site or a repository.
#include "plugin/reference.hpp"

#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "output/output.hpp"

namespace regista::cli {
namespace {

constexpr auto plugin_reference_examples = R"(Examples:
  regista plugin reference > docs/plugin-reference.md
  regista plugin reference --plugins ~/my_plugins)";

}  // namespace

void add_plugin_reference(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("reference", "write the reference of all plugins as Markdown");
  const auto folders = std::make_shared<std::vector<std::string>>();
  add_plugin_folders(command, *folders);
  command.notes(plugin_reference_examples);
  command.run = [folders, &invocation] {
    output::print(plugin::reference_text(open_plugins(*folders, invocation)));
    return exit_done;
  };
}

}  // namespace regista::cli
