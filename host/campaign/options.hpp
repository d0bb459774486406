// SPDX-License-Identifier: MIT
// How the matches of a study are played, and where they are kept: what is no part of what is asked, so that it may be
// another each time. Values as they were typed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/limits.hpp"
#include "config/match_settings.hpp"

namespace regista::campaign {

struct Options {
  std::vector<std::string> plugins;   // folders
  std::string workers, record_every;  // empty: one for each processor core; only matches that fail
  std::string results;
  bool resume = false, json = false, quiet = false, no_page = false;
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

// As a study's document has them.
Limits limits_of(const config::MatchSettings& settings);

}  // namespace regista::campaign
