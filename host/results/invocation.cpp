// SPDX-License-Identifier: MIT
#include "results/invocation.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

#include "command/end_of_program.hpp"
#include "process/program.hpp"
#include "texts/message.hpp"

namespace regista::results {

plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation) {
  const std::vector<std::filesystem::path> options(folders.begin(), folders.end());
  return plugin::Catalogue(plugin::Catalogue::search_path(options, std::getenv("REGISTA_PLUGIN_PATH"),
                                                          invocation.own("lib/regista/plugins")));
}

plugin::Catalogue open_stored_plugins(const std::string& file, const std::vector<std::string>& folders,
                                      const Invocation& invocation) {
  for (const std::string& each : folders) {
    std::error_code error;
    if (std::filesystem::is_directory(each, error)) continue;
    const std::string write =
        process::shell_line(std::vector<std::string>{"regista", "report", file, "--study", "again"});
    throw command::BadInput(texts::one_line(fmt::format(
        "{}: it was played with the plugins of {}, which is no folder any more; put it back, or play its study "
        "with others: {}, then regista run again/study.yaml --plugins DIR",
        file, std::filesystem::absolute(each).lexically_normal().string(), write)));
  }
  return open_plugins(folders, invocation);
}

}  // namespace regista::results
