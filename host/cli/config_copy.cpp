// SPDX-License-Identifier: MIT
// `regista config copy FOLDER`: the shipped documents as files of one's own, to be played with and changed.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "output/output.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto config_copy_examples = R"(Examples:
  regista config copy configs

The folder must not exist yet. It gets the teams, rules, robots, disturbances, openings, formations and studies that belong to this
program; examples of other commands name them as configs/teams/paper.yaml.)";

int copy(const std::vector<std::string>& folders, const Invocation& invocation) {
  if (folders.size() != 1) throw BadInput(fmt::format("config copy: expected one folder, {} given", folders.size()));
  const fs::path from = invocation.own("share/regista/configs");
  const fs::path to = folders.front();
  std::error_code error;
  if (!fs::is_directory(from, error)) {
    throw BadInput(fmt::format("config copy: {} is missing: this program was not installed as a whole", from.string()));
  }
  if (fs::exists(fs::symlink_status(to, error))) {
    throw BadInput(fmt::format("config copy: {} exists already; name another folder", to.string()));
  }
  if (!fs::create_directory(to, error)) {
    throw BadInput(fmt::format("config copy: cannot make {}: {}", to.string(), error.message()));
  }
  fs::copy(from, to, fs::copy_options::recursive, error);
  if (error) {
    std::error_code none;
    fs::remove_all(to, none);
    throw output::WriteError(fmt::format("cannot write {}: {}", to.string(), error.message()));
  }
  output::print(fmt::format("made the folder {}\n", to.string()));
  return exit_done;
}

}  // namespace

void add_config_copy(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("copy", "copy the shipped documents into a folder of your own");
  const auto folders = std::make_shared<std::vector<std::string>>();
  command.take("folder", *folders, "NEW_FOLDER", "is made");
  command.notes(config_copy_examples);
  command.run = [folders, &invocation] { return copy(*folders, invocation); };
}

}  // namespace regista::cli
