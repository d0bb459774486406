// SPDX-License-Identifier: MIT
// What everything that plays many matches can be asked for, whatever they are for. Values as they were typed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/limits.hpp"
#include "config/isolation.hpp"

namespace regista::campaign {

struct Options {
  std::vector<std::string> plugins;   // folders
  std::string workers, record_every;  // empty: one for each processor core; only matches that fail
  std::string results, processor_seconds = "10", memory = "2048";
  std::string isolation, wall_seconds, match_seconds = "1800";  // isolation empty: as the study's document says
  bool resume = false, json = false, quiet = false, no_page = false, play_once = false;
  // Not typed: what is not in the file of results is played; nothing is, but the file made; or nothing is, for all is
  // there.
  enum class Plays { what_is_missing, nothing_yet, nothing_more } plays = Plays::what_is_missing;
  std::vector<std::string> plugin_files;  // not typed: what the search of the folders has found
};

// Throws BadInput for what none of the functions below can read: to be called before a file is made.
void check(const Options& options);

// All throw BadInput.
int number_of_workers(const Options& options);
std::uint64_t record_every(const Options& options);  // 0: none but those that fail
// What the study's document says may be overruled by an option.
Limits limits_of(const Options& options, config::Isolation isolation = config::Isolation::after_death,
                 bool play_twice = true, bool allow_shared_memory = false);

}  // namespace regista::campaign
