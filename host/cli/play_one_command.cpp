// SPDX-License-Identifier: MIT
// `regista play-one`, hidden: a worker of a campaign. See campaign/play_one.hpp.
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "campaign/play_one.hpp"
#include "campaign/worker.hpp"
#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/plugin_folders.hpp"

namespace regista::cli {

Command add_play_one(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand(campaign::worker_command, "one match of a campaign");
  app.group("");
  return {&app, [&invocation]() -> int {
            const campaign::Surroundings surroundings{
                "regista " REGISTA_VERSION,
                [&invocation](const std::vector<std::string>& folders) { return open_plugins(folders, invocation); }};
            _exit(campaign::play_one(surroundings) ? exit_done : exit_no);
          }};
}

}  // namespace regista::cli
