// SPDX-License-Identifier: MIT
#include "cli/campaign_options.hpp"
#include "cli/file_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "cli/plugin_folders.hpp"

namespace regista::cli {

void add_campaign_options(CLI::App& app, campaign::Options& options, const std::string& default_results) {
  app.add_option("--workers", options.workers, "matches at the same time; default: one for each processor core")
      ->type_name("N");
  add_plugin_folders(app, options.plugins);
  writes(app.add_option("--results", options.results,
                        fmt::format("file the results are kept in; default: {}", default_results))
             ->type_name("FILE"),
         Writes::results);
  app.add_option("--record-every", options.record_every,
                 "record every N-th match, beside the results in NAME.recordings/ROW.mcap; those that fail always are")
      ->type_name("N");
  app.add_flag("--resume", options.resume, "go on with what the file of results was begun with")
      ->disable_flag_override();
  app.add_option("--processor-seconds", options.processor_seconds, "processor time of one call of a plugin; default 10")
      ->type_name("SECONDS");
  app.add_option("--memory", options.memory, "address space of a match; default 2048")->type_name("MIB");
  app.add_option("--wall-seconds", options.wall_seconds,
                 "wall time of one call of a plugin; default: ten times its processor time and 100 s")
      ->type_name("SECONDS");
  app.add_option("--match-seconds", options.match_seconds, "wall time of a whole match; default 1800")
      ->type_name("SECONDS");
  app.add_option("--isolation", options.isolation,
                 "after-death (default): a match that died is played again with each team in a process of its own; "
                 "always: all matches are played so")
      ->type_name("WHEN");
  app.add_flag("--play-once", options.play_once,
               "do not play the first match of each pairing a second time, in which it is seen whether it is "
               "reproducible, and whether plugins change their inputs")
      ->disable_flag_override();
  app.add_flag("--no-page", options.no_page, "write no page NAME.html beside the results NAME.db at the end")
      ->disable_flag_override();
  app.add_flag("--json", options.json, "write the report as JSON")->disable_flag_override();
  app.add_flag("--quiet", options.quiet, "no progress on standard error")->disable_flag_override();
}

}  // namespace regista::cli
