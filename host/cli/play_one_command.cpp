// SPDX-License-Identifier: MIT
// `regista play-one` and `regista fork-server`, which no help names: how a campaign plays its matches. See
// campaign/play_one.hpp and campaign/fork_server.hpp.
#include <unistd.h>

#include <string>
#include <vector>

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

void run_for_campaign(const std::string& name, const Invocation& invocation) {
  if (name == campaign::worker_command) {
    const campaign::Surroundings surroundings{this_program, [&invocation](const std::vector<std::string>& folders) {
                                                return open_plugins(folders, invocation);
                                              }};
    _exit(campaign::play_one(surroundings) ? exit_done : exit_no);
  }
  if (name == campaign::server_command) {
    campaign::serve_matches(this_program);
    _exit(exit_done);
  }
}

}  // namespace regista::cli
