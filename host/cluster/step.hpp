// SPDX-License-Identifier: MIT
// What is done between two batches of a study on a cluster: what tasks have played is gathered, and what the study
// still needs is submitted. The job after an array takes such a step, and `regista gather`, and whoever waits for the
// study. One at a time: who holds the study's file of results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cluster/parts.hpp"
#include "cluster/study_folder.hpp"
#include "results/invocation.hpp"

namespace regista::cluster {

struct Step {
  Gathered gathered;
  Progress progress;
  std::uint64_t submitted = 0;  // matches
  std::uint64_t round = 0;      // matches that the study asks for at a time
  bool plays = false;           // an array waits or runs
};

// restart: also where the study has been stopped or has failed. Throws BadInput, WriteError; then the study has failed,
// and its folder says why, unless this machine is none that may take a step.
Step take_step(const StudyFolder& folder, bool restart, const results::Invocation& invocation);

// By a task that has ended: a test may have decided, and then nobody need wait for the rest of the array, which is
// ended, this process too. Does nothing where somebody else takes a step.
void look_whether_it_is_over(const StudyFolder& folder, const results::Invocation& invocation);

// Ends the jobs of the study. Throws BadInput, WriteError.
void stop_study(const StudyFolder& folder);

// Those of the study's jobs that wait or run, but for the one that this process is part of. Throws SlurmError.
std::vector<std::string> jobs_alive(const Progress& progress);

// Why this machine would play other matches than those that were planned, and would want others next; empty: it would
// not.
std::string what_differs_here(const campaign::Job& planned);

// The line of the shell that goes on with the study.
std::string command_to_go_on(const StudyFolder& folder);

}  // namespace regista::cluster
