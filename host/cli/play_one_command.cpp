// SPDX-License-Identifier: MIT
// `regista play-one`, hidden: a worker of a campaign. See campaign/play_one.hpp.
#include <unistd.h>

#include "campaign/play_one.hpp"
#include "campaign/worker.hpp"
#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"

namespace regista::cli {

void add_play_one(Command& parent, const Invocation& invocation) {
  Command& command = parent.add(campaign::worker_command, "one match of a campaign");
  command.hide();
  command.run = [&invocation]() -> int {
    const campaign::Surroundings surroundings{
        "regista " REGISTA_VERSION,
        [&invocation](const std::vector<std::string>& folders) { return open_plugins(folders, invocation); }};
    _exit(campaign::play_one(surroundings) ? exit_done : exit_no);
  };
}

}  // namespace regista::cli
