// SPDX-License-Identifier: MIT
// `regista plugin list`: which plugins there are, which files were refused, and where was looked.
#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "output/output.hpp"
#include "plugin/info.hpp"
#include "report/plugin_json.hpp"

namespace regista::cli {
namespace {

constexpr auto plugin_list_examples = R"(Examples:
  regista plugin list
  regista plugin list --plugins ~/my_plugins --json)";

struct PluginListOptions {
  std::vector<std::string> plugins;
  bool json = false;
};

std::string list_json(const plugin::Catalogue& catalogue) {
  using Json = nlohmann::ordered_json;
  Json plugins = Json::array(), refused = Json::array(), searched = Json::array();
  for (const plugin::Found& found : catalogue.plugins()) plugins.push_back(report::plugin_json(found));
  for (const plugin::Refused& each : catalogue.refused()) {
    refused.push_back({{"file", each.file.string()}, {"reason", each.reason}});
  }
  for (const std::filesystem::path& folder : catalogue.folders()) searched.push_back(folder.string());
  return report::text_of({{"plugins", plugins}, {"refused", refused}, {"searched", searched}});
}

}  // namespace

void add_plugin_list(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("list", "list the plugins that a team can name");
  const auto options = std::make_shared<PluginListOptions>();
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write JSON");
  command.notes(plugin_list_examples);
  command.run = [options, &invocation] {
    const plugin::Catalogue catalogue = open_plugins(options->plugins, invocation);
    output::print(options->json ? list_json(catalogue) : plugin::list_text(catalogue));
    return exit_done;
  };
}

}  // namespace regista::cli
