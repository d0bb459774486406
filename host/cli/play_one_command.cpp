// SPDX-License-Identifier: MIT
// `regista play-one` and `regista fork-server`, hidden: how a campaign plays its matches. See campaign/play_one.hpp and
// campaign/fork_server.hpp.
#include <unistd.h>

#include "campaign/fork_server.hpp"
#include "campaign/play_one.hpp"
#include "campaign/serve_matches.hpp"
#include "campaign/worker_process.hpp"
#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"

namespace regista::cli {
namespace {

constexpr const char* this_program = "regista " REGISTA_VERSION;

}  // namespace

void add_play_one(Command& parent, const Invocation& invocation) {
  Command& command = parent.add(campaign::worker_command, "one match of a campaign");
  command.hide();
  command.run = [&invocation]() -> int {
    const campaign::Surroundings surroundings{this_program, [&invocation](const std::vector<std::string>& folders) {
                                                return open_plugins(folders, invocation);
                                              }};
    _exit(campaign::play_one(surroundings) ? exit_done : exit_no);
  };
}

void add_fork_server(Command& parent) {
  Command& command = parent.add(campaign::server_command, "many matches of a campaign");
  command.hide();
  command.run = []() -> int {
    campaign::serve_matches(this_program);
    _exit(exit_done);
  };
}

}  // namespace regista::cli
