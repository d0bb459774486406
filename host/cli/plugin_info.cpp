// SPDX-License-Identifier: MIT
// `regista plugin info ID`: all that a plugin says about itself, its parameters first of all.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "output/output.hpp"
#include "plugin/info.hpp"
#include "report/plugin_json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto plugin_info_examples = R"(Examples:
  regista plugin info greedy
  regista plugin info voronoi --json)";

struct PluginInfoOptions {
  std::vector<std::string> ids, plugins;
  bool json = false;
};

// All of this id: two builds of a plugin may stand in two folders.
std::vector<const plugin::Found*> find(const plugin::Catalogue& catalogue, const std::string& id) {
  std::vector<const plugin::Found*> found;
  std::vector<std::string> known;
  for (const plugin::Found& plugin : catalogue.plugins()) {
    if (plugin.descriptor->id == id) found.push_back(&plugin);
    known.emplace_back(plugin.descriptor->id);
  }
  if (!found.empty()) return found;
  std::vector<std::string> folders;
  for (const std::filesystem::path& folder : catalogue.folders()) folders.push_back(folder.string());
  throw BadInput(
      fmt::format("plugin info: {}; searched: {}", texts::unknown("plugin", id, "", known), texts::join(folders)));
}

int show(const PluginInfoOptions& options, const Invocation& invocation) {
  if (options.ids.size() != 1) {
    throw BadInput(fmt::format("plugin info: expected one id of a plugin, {} given; see: regista plugin list",
                               options.ids.size()));
  }
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  std::string out;
  auto json = nlohmann::ordered_json::array();
  for (const plugin::Found* plugin : find(catalogue, options.ids.front())) {
    if (!out.empty()) out += '\n';
    out += plugin::info_text(*plugin);
    json.push_back(report::plugin_json(*plugin));
  }
  output::print(options.json ? report::text_of(json) : out);
  return exit_done;
}

}  // namespace

void add_plugin_info(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("info", "describe a plugin and its parameters");
  const auto options = std::make_shared<PluginInfoOptions>();
  command.take("id", options->ids, "ID", "name of the plugin, as teams use it");
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write JSON: a list, with one element for each build of the plugin");
  command.notes(plugin_info_examples);
  command.run = [options, &invocation] { return show(*options, invocation); };
}

}  // namespace regista::cli
