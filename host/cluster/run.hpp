// SPDX-License-Identifier: MIT
// A study whose matches an array of Slurm plays: how it is begun, awaited, looked at and reported.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "cluster/step.hpp"
#include "cluster/study_folder.hpp"
#include "command/end_of_program.hpp"
#include "results/invocation.hpp"

namespace regista::cluster {

// As typed.
struct Options {
  std::string on, folder, array, per_task, partition, time;
  std::vector<std::string> sbatch;  // more options
  bool detach = false;
};

// From nothing to the first batch, and to the end of the study unless it is detached: the exit code. begin: plans the
// study and makes its file of results, which plays nothing. file: the study's document.
int run_on_cluster(const Options& options, const campaign::Options& campaign, const std::string& file,
                   const std::function<void(const campaign::Options& options)>& begin,
                   const results::Invocation& invocation);

// Says what the step found, and reports a study that is complete: the exit code.
int tell_step(const StudyFolder& folder, const Step& step, const campaign::Options& options,
              const results::Invocation& invocation);

// How things stand, by the files alone.
struct Status {
  Progress progress;
  std::uint64_t in_parts = 0, failed_in_parts = 0;  // matches that were not gathered yet
  std::uint64_t running = 0, ended = 0;             // tasks that have played these
  double rate = 0.0;                                // matches per second, of the tasks that run
};
Status status_of(const StudyFolder& folder);
// "1200 of 4000 matches, 12 tasks play, 3.4 matches a second, some 14 min left"
std::string in_words(const Status& status);

}  // namespace regista::cluster
