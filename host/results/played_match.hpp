// SPDX-License-Identifier: MIT
// Plays a match of `regista match` after its setup: shows its progress, records the match and reports the result. If
// the match comes from a file of results, the functions compare the replay with the stored match.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/forked_match.hpp"
#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/stored_setup.hpp"
#include "plugin/catalogue.hpp"
#include "report/what_was_played.hpp"
#include "results/study_kind.hpp"

namespace regista::results {

// --- Replay of a match of a study from its file of results.

struct StoredMatch {
  std::string results, row;  // absolute path of the file; the row as the user typed it
  campaign::Job job;
  campaign::MatchResult decided;
  campaign::Limits limits;
};

// Reads a match and changes the current folder to the folder in which the study was begun, because the match names its
// files relative to this folder. Throws BadInput.
StoredMatch read_stored_match(const std::string& results, const std::string& row, std::span<const StudyKind> kinds);

// Use of a match whose program or plugins have changed: refuse it, or play it to see whether the result is the same.
enum class Changed { refused, played };

// Sets up a stored match. Throws BadInput if this cannot be done in its stored form; with Changed::played, only if it
// cannot be done at all. Throws output::WriteError without room for copies of its files. program: the name in messages.
std::unique_ptr<campaign::StoredSetup> set_up(const StoredMatch& stored, const plugin::Catalogue& catalogue,
                                              const std::string& program, Changed changed = Changed::refused);

// Plays the match in workers under the limits of its study, as the job says. Throws BadInput and output::WriteError.
campaign::MatchResult play_by_workers(const StoredMatch& stored, campaign::Job job);

// Returns whether both matches have the same hash, were forfeited by the same side, or could not be played.
bool came_out_alike(const campaign::MatchResult& stored, const campaign::MatchResult& now);

struct MatchOptions : campaign::MatchConditions {
  std::vector<std::string> teams, set, plugins;  // as typed; teams: files: home, away
  std::string seed = "1";
  std::string decisions, record, metrics, from, row;
  bool force = false, json = false, quiet = false, verbose = false, in_process = false;
  std::string log = "info";  // lowest level of the plugin log lines that are shown; "none": no lines
  std::string processor_seconds = "10", wall_seconds = "200";
};

// Returns the job of these options, without inputs and plugin files. Throws BadInput, config::Error.
campaign::Job job_of(const MatchOptions& options);

// Returns the inputs of a match, which its report shows first.
report::WhatWasPlayed what_is_played(const campaign::Job& job, const campaign::MatchSetup& prepared,
                                     const plugin::Catalogue& catalogue);

// Plays a match in this process, which a plugin may crash or end. words: the command line. what: the inputs that the
// report shows first. note: receives the plugin call in progress. Returns an exit code. Throws BadInput, Interrupted,
// output::WriteError and campaign::LeftoverState.
int play_prepared(const MatchOptions& options, std::vector<std::string> words, const std::optional<StoredMatch>& stored,
                  const report::WhatWasPlayed& what, campaign::MatchSetup prepared, campaign::WorkerNote& note);

// Replays a match that was forfeited or not played. Workers play it, because its plugin may hang or take all memory.
// Returns an exit code: exit_done if the replay ends like the stored match.
int play_failed(const MatchOptions& options, const StoredMatch& stored, campaign::Job job);

// Describes the end of a match: "was forfeited: home, plugin greedy, assign: Segmentation fault"
std::string end_in_words(const campaign::MatchResult& decided);

// Returns a clock time: "03:12". The minutes may have more than two digits.
std::string clock_text(double seconds);

}  // namespace regista::results
