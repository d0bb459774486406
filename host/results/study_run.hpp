// SPDX-License-Identifier: MIT
// Plays the matches of a study to its end: what was stored is not played again, progress is shown, Ctrl-C stops it
// cleanly, and every end but a good one says how to go on.
#pragma once

#include <functional>

#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "report/study_report.hpp"
#include "results/invocation.hpp"
#include "study/study.hpp"

namespace regista::results {

// What a command does besides. Each may be empty.
struct StudyWishes {
  study::AfterMatch after;       // each match, once the study has taken it
  std::function<void()> at_end;  // before the report is printed
  bool figures = true;           // beside the page
};

// From the first match to the report and its page: the exit code. options.results names the file that `store` holds.
// Throws what end_of_program.hpp explains; what was stored stays. With Plays::nothing_yet it
// does nothing, with Plays::nothing_more it takes all from the store.
int play_study(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
               campaign::Store& store, const StudyWishes& wishes);

// The command that plays a match by itself, by the name the program was called by. The invocation outlives it.
report::CommandOf play_again(const Invocation& invocation);

}  // namespace regista::results
