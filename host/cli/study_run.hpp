// SPDX-License-Identifier: MIT
// Plays the matches of a study to its end: what was stored is not played again, progress is shown, Ctrl-C stops it
// cleanly, and every end but a good one says how to go on.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "cli/campaign_options.hpp"
#include "cli/command.hpp"
#include "cli/study_progress.hpp"

namespace regista::cli {

struct StudyRun {
  std::uint64_t matches = 0;
  std::uint64_t first_row = 0;  // rows of the store that earlier runs of the study have taken
  std::vector<campaign::Store::Fixture> fixtures;
  // See campaign::Schedule; `fixture` is an index of the above.
  struct Place {
    std::size_t fixture;
    std::uint64_t seed;
  };
  std::function<std::optional<Place>(std::uint64_t index)> at;
  std::function<campaign::Job(std::uint64_t index)> job;
  std::function<bool(std::uint64_t index, const campaign::Decided* decided)> take;
  // Whether this match is the first of its pairing, which is played twice. May be empty.
  std::function<bool(std::uint64_t index)> first_of_pairing;
  campaign::Limits limits;  // of each match
  campaign::Metrics metrics = campaign::Metrics::left_out;
};

// What the study is, for messages.
struct StudyNature {
  std::string what;                        // "tournament"
  std::uint64_t matches = 0;               // of all runs, at most
  std::function<std::uint64_t()> counted;  // matches that were taken and count
};

// Plays a run, or throws: Interrupted and others that are for play_study() alone.
using PlayRun = std::function<void(const StudyRun& run)>;

// A study in one run or in several, of which each may depend on those before: `course` plays them. options.results
// names the file that `store` holds. Throws what end_of_program.hpp explains; what was stored stays.
void play_study(const StudyNature& nature, const campaign::Options& options, const Invocation& invocation,
                campaign::Store& store, StudyProgress& progress,
                const std::function<void(const PlayRun& play)>& course);

// The command that plays a match by itself, by the name the program was called by.
std::string play_again(const campaign::Job& job, const Invocation& invocation);

}  // namespace regista::cli
