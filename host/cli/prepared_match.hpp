// SPDX-License-Identifier: MIT
// The match of `regista match`, once it is set up: played, shown as it goes, recorded and reported.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/match_setup.hpp"
#include "campaign/supervised.hpp"
#include "cli/match_options.hpp"
#include "report/what_was_played.hpp"
#include "results/stored_match.hpp"

namespace regista::cli {

// what: with it the report begins. In a process that a plugin may end; note: where it says which call it is in. words:
// as the program was called. Returns an exit code. Throws BadInput, Interrupted, output::WriteError,
// campaign::Disorder.
int play_prepared(const MatchOptions& options, std::vector<std::string> words,
                  const std::optional<results::StoredMatch>& stored, const report::WhatWasPlayed& what,
                  campaign::MatchSetup prepared, campaign::WorkerNote& note);

}  // namespace regista::cli
