// SPDX-License-Identifier: MIT
// `regista plugin reference`: a page of Markdown about all plugins, for a web site or a repository.
#include "plugin/reference.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista plugin reference > docs/plugin-reference.md
  regista plugin reference --plugins ~/my_plugins)";

}  // namespace

Command add_plugin_reference(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("reference", "write the reference of all plugins as Markdown");
  const auto folders = std::make_shared<std::vector<std::string>>();
  add_plugin_folders(app, *folders);
  app.footer(examples);
  return {&app, [folders, &invocation] {
            print(plugin::reference_text(open_plugins(*folders, invocation)));
            return exit_done;
          }};
}

}  // namespace regista::cli
