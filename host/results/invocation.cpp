// SPDX-License-Identifier: MIT
#include "results/invocation.hpp"

#include <cstdlib>

namespace regista::results {

plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation) {
  const std::vector<std::filesystem::path> options(folders.begin(), folders.end());
  return plugin::Catalogue(plugin::Catalogue::search_path(options, std::getenv("REGISTA_PLUGIN_PATH"),
                                                          invocation.own("lib/regista/plugins")));
}

}  // namespace regista::results
