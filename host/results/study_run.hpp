// SPDX-License-Identifier: MIT
// Plays the matches of a study to its end. Stored matches are not played again. Progress is shown, Ctrl-C stops the
// study cleanly, and after an early end or an error a message says how to continue.
#pragma once

#include <functional>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "report/study_report.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"

namespace regista::results {

// What a command does while its study is played. Each function may be empty.
struct StudyHooks {
  study::AfterMatch after;       // called for each match after the study has taken its result
  std::function<void()> at_end;  // called before the report is printed
};

// Plays the study and writes the report and its page. Returns the exit code. options.results is the path of `store`. If
// the time limit options.end_of_time stops the study, the study ends with its complete pairs. Throws the exceptions
// that terminal.hpp explains; stored matches stay in the store. Plays::nothing_yet plays nothing. Plays::nothing_more
// plays nothing and takes all results from the store.
int play_study(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
               campaign::Store& store, const StudyHooks& hooks);

// Plays the study without report and page. If the time limit stopped the study before its first complete pair, the
// function prints a message and returns false.
bool play_matches(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
                  campaign::Store& store, const study::AfterMatch& after);

// Returns a function that makes the command for one match. `invocation` must outlive the returned function.
report::CommandOf play_again(const Invocation& invocation);

}  // namespace regista::results
