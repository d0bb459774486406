// SPDX-License-Identifier: MIT
#include "cli/plugin_folders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/common_names.hpp"

namespace regista::cli {

void add_plugin_folders(Command& command, std::vector<std::string>& folders) {
  command.take("--plugins", folders, "DIR", "search this folder for plugins first; may be repeated", Reads::plugins);
}

std::vector<std::string> folders_of(const plugin::Catalogue& catalogue) {
  std::vector<std::string> out;
  for (const std::filesystem::path& each : catalogue.folders()) out.push_back(each.string());
  return out;
}

void tell_what_is_not_used(const plugin::Catalogue& catalogue, const std::vector<std::string>& folders) {
  for (const plugin::Refused& refused : catalogue.refused()) {
    if (std::ranges::find(folders, refused.file.parent_path().string()) == folders.end()) continue;
    complain(fmt::format("not used: {}", plugin::to_string(refused)));
  }
  for (const plugin::Refused& remarked : catalogue.remarked()) complain(plugin::to_string(remarked));
}

}  // namespace regista::cli
