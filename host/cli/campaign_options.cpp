// SPDX-License-Identifier: MIT
#include "cli/campaign_options.hpp"

#include <fmt/format.h>

#include <string>

#include "cli/plugin_folders.hpp"

namespace regista::cli {

void add_campaign_options(Command& command, campaign::Options& options, const std::string& default_results) {
  command.take("--workers", options.workers, "N", "matches at the same time; default: one for each processor core");
  add_plugin_folders(command, options.plugins);
  command.take("--results", options.results, "FILE",
               fmt::format("file the results are kept in; default: {}", default_results), Writes::results);
  command.take("--record-every", options.record_every, "N",
               "record every N-th match, beside the results in NAME.recordings/ROW.mcap; those that fail always are");
  command.flag("--resume", options.resume, "go on with what the file of results was begun with");
  command.take("--processor-seconds", options.processor_seconds, "SECONDS",
               "processor time of one call of a plugin; default 10");
  command.take("--memory", options.memory, "MIB", "address space of a match; default 2048");
  command.take("--wall-seconds", options.wall_seconds, "SECONDS",
               "wall time of one call of a plugin; default: ten times its processor time and 100 s");
  command.take("--match-seconds", options.match_seconds, "SECONDS", "wall time of a whole match; default 1800");
  command.choose("--isolation", options.isolation, {"after-death", "always"},
                 "after-death (default): a match that died is played again with each team in a process of its own; "
                 "always: all matches are played so");
  command.flag("--play-once", options.play_once,
               "do not play the first match of each pairing a second time, in which it is seen whether it is "
               "reproducible, whether robots decide alone, and whether plugins change their inputs");
  command.flag("--no-page", options.no_page, "write no page NAME.html beside the results NAME.db at the end");
  command.flag("--json", options.json, "write the report as JSON");
  command.flag("--quiet", options.quiet, "no progress on standard error");
}

}  // namespace regista::cli
