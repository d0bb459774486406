// SPDX-License-Identifier: MIT
// The match of `regista match`, once it is set up: played, shown as it goes, recorded and reported; and compared with
// the one that a file of results holds, where it is played again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/supervised.hpp"
#include "report/what_was_played.hpp"
#include "results/stored_match.hpp"

namespace regista::results {

// What `regista match` was asked for.
struct MatchOptions : campaign::MatchRequest {
  std::vector<std::string> set, plugins;  // --set, as typed
  std::string decisions, record, metrics, from, row;
  bool force = false, json = false, quiet = false, verbose = false, in_process = false;
  std::string log = "info";  // the least level of the lines of plugins that are shown; "none": none of them
  std::string processor_seconds = "10", wall_seconds = "200";
};

// With it the report of a match begins.
report::WhatWasPlayed what_is_played(const campaign::Job& job, const campaign::MatchSetup& prepared,
                                     const plugin::Catalogue& catalogue);

// what: with it the report begins. In a process that a plugin may end; note: where it says which call it is in. words:
// as the program was called. Returns an exit code. Throws BadInput, Interrupted, output::WriteError,
// campaign::Disorder.
int play_prepared(const MatchOptions& options, std::vector<std::string> words, const std::optional<StoredMatch>& stored,
                  const report::WhatWasPlayed& what, campaign::MatchSetup prepared, campaign::WorkerNote& note);

// A match that was forfeited, or could not be played: by workers, as then, for its plugin may hang or take all memory.
// Returns an exit code: exit_done when it ends in the same way.
int play_failed(const MatchOptions& options, const StoredMatch& stored, campaign::Job job);

// "was forfeited: home, plugin greedy, assign: Segmentation fault"
std::string end_in_words(const campaign::Decided& decided);

// "03:12"; minutes may have more than two digits
std::string clock_text(double seconds);

}  // namespace regista::results
