// SPDX-License-Identifier: MIT
#include "cli/campaign_options.hpp"
#include "cli/file_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <thread>

#include "cli/end_of_program.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/test_options.hpp"
#include "config/text.hpp"

namespace regista::cli {

void add_campaign_options(CLI::App& app, CampaignOptions& options, const std::string& default_results) {
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
               "do not play the first match of each pairing a second time to see whether it is reproducible")
      ->disable_flag_override();
  app.add_flag("--no-page", options.no_page, "write no page NAME.html beside the results NAME.db at the end")
      ->disable_flag_override();
  app.add_flag("--json", options.json, "write the report as JSON")->disable_flag_override();
  app.add_flag("--quiet", options.quiet, "no progress on standard error")->disable_flag_override();
}

void check(const CampaignOptions& options) {
  number_of_workers(options);
  record_every(options);
  limits(options);
}

int number_of_workers(const CampaignOptions& options) {
  if (options.workers.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 1024u));
  return static_cast<int>(parse_whole("--workers", options.workers, 1, 1024));
}

std::uint64_t record_every(const CampaignOptions& options) {
  return options.record_every.empty() ? 0 : parse_whole("--record-every", options.record_every, 1, UINT64_MAX);
}

campaign::Limits limits(const CampaignOptions& options, config::Isolation isolation, bool play_twice) {
  campaign::Limits limits;
  limits.processor_seconds =
      static_cast<int>(parse_whole("--processor-seconds", options.processor_seconds, 1, 1'000'000));
  limits.memory = parse_whole("--memory", options.memory, 64, std::uint64_t{1} << 24) << 20;
  // A machine may have much else to do: only a plugin that sleeps comes here.
  limits.wall_seconds = 10.0 * limits.processor_seconds + 100.0;
  if (!options.wall_seconds.empty()) {
    limits.wall_seconds = static_cast<double>(parse_whole("--wall-seconds", options.wall_seconds, 1, 1'000'000));
  }
  limits.match_wall_seconds = static_cast<double>(parse_whole("--match-seconds", options.match_seconds, 1, 1'000'000));
  limits.play_twice = play_twice && !options.play_once;
  if (!options.isolation.empty()) {
    const std::vector<std::string>& known = config::isolation_names();
    const auto named = std::ranges::find(known, options.isolation);
    if (named == known.end()) throw BadInput(config::unknown("value", options.isolation, "--isolation", known));
    isolation = static_cast<config::Isolation>(named - known.begin());
  }
  limits.isolation =
      isolation == config::Isolation::always ? campaign::Isolation::always : campaign::Isolation::after_a_death;
  return limits;
}

}  // namespace regista::cli
