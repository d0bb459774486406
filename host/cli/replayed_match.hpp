// SPDX-License-Identifier: MIT
// A match that `regista match --from` plays again: is it the one that the file of results holds?
#pragma once

#include <string>

#include "campaign/job.hpp"
#include "cli/match_options.hpp"
#include "match/match.hpp"
#include "results/stored_match.hpp"

namespace regista::cli {

// "was forfeited: home, plugin greedy, assign: Segmentation fault"
std::string end_in_words(const campaign::Decided& decided);

// A match that was forfeited, or could not be played: by workers, as then, for its plugin may hang or take all memory.
// Returns an exit code: exit_done when it ends in the same way.
int play_failed(const MatchOptions& options, const results::StoredMatch& stored, campaign::Job job);

// Says on standard error whether the hash is that of the file. Returns an exit code.
int compare(const MatchOptions& options, const campaign::Decided& stored, const match::Result& played);

}  // namespace regista::cli
