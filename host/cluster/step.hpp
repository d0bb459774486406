// SPDX-License-Identifier: MIT
// A step of a study on a cluster gathers the results of ended tasks and submits the matches that the study still needs.
// Steps are taken by the job after a job array, by `regista gather`, and by a command that waits for the study. The
// process that takes a step locks the study's file of results, so only one process at a time takes a step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cluster/study_folder.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"

namespace regista::cluster {

struct Step {
  Gathered gathered;
  Progress progress;
  std::uint64_t submitted = 0;  // number of submitted matches
  std::uint64_t round = 0;      // number of matches in the current round of the study
  bool plays = false;           // true: a job array waits or runs
};

// Takes a step. restart: continues a study that was stopped or has failed. Throws WriteError for a disk error. Throws
// BadInput for other errors; most of these errors are stored in the folder as the failure of the study. If this machine
// would compute other results, the function throws BadInput, and the study does not fail.
Step take_step(const StudyFolder& folder, bool restart, const results::Invocation& invocation);

// A task calls this at its end, if its round may end early. Takes a step (see the top of this file), unless another
// process takes one now. If a sequential test has decided, the step ends the job array and so also this process.
void look_whether_it_is_over(const StudyFolder& folder, const results::Invocation& invocation);

// Ends the jobs of the study. Throws BadInput, WriteError.
void stop_study(const StudyFolder& folder);

// Returns the jobs of the study that wait or run, except the job of this process. Throws SlurmError.
std::vector<std::string> jobs_alive(const Progress& progress);

// Compares the program and the mathematics library of this machine with the planned study. Returns the differences,
// which would change results, in words; empty if there are none. Runs the study, so the study must not run again.
std::string what_differs_here(study::Study& study);

}  // namespace regista::cluster
