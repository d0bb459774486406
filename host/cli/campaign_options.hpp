// SPDX-License-Identifier: MIT
// What every command that plays many matches can be asked for, whatever they are for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/worker.hpp"
#include "config/isolation.hpp"

namespace CLI {
class App;
}

namespace regista::cli {

struct CampaignOptions {
  std::vector<std::string> plugins;   // folders
  std::string workers, record_every;  // empty: one for each processor core; only matches that fail
  std::string results, processor_seconds = "10", memory = "2048";
  std::string isolation, wall_seconds, match_seconds = "1800";  // isolation empty: as the study's document says
  bool resume = false, json = false, quiet = false, no_page = false, play_once = false;
  std::vector<std::string> plugin_files;  // not typed: what the search of the folders has found
};

// default_results: what the help says.
void add_campaign_options(CLI::App& app, CampaignOptions& options, const std::string& default_results);

// Throws BadInput for what none of the functions below can read: to be called before a file is made.
void check(const CampaignOptions& options);

// All throw BadInput.
int number_of_workers(const CampaignOptions& options);
std::uint64_t record_every(const CampaignOptions& options);  // 0: none but those that fail
// What the study's document says may be overruled by an option.
campaign::Limits limits(const CampaignOptions& options, config::Isolation isolation = config::Isolation::after_death,
                        bool play_twice = true);

}  // namespace regista::cli
