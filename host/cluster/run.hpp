// SPDX-License-Identifier: MIT
// Begins a study whose matches a Slurm job array plays, waits for its end, and shows its state and its results.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "campaign/engine.hpp"
#include "cluster/step.hpp"
#include "cluster/study_folder.hpp"
#include "results/study_kind.hpp"

namespace regista::cluster {

// Options as typed.
struct Options {
  std::string on, folder, array, per_task, partition, time;
  std::vector<std::string> sbatch;  // more options for sbatch
  bool detach = false;
};

// Plans a study on the cluster and submits its first batch. Then waits for the end of the study, except with `detach`.
// Returns the exit code. begin: plans the study and creates its file of results without matches. file: the document.
int run_on_cluster(const Options& options, const campaign::Options& campaign, const std::string& file,
                   const std::function<void(const campaign::Options& options)>& begin,
                   const results::Invocation& invocation);

// Prints what the step has done, and the report of the study if the study is complete. Returns the exit code.
int tell_step(const StudyFolder& folder, const Step& step, const campaign::Options& options,
              const results::Invocation& invocation);

// The state of a study, computed from its files alone.
struct Status {
  Progress progress;
  std::uint64_t in_parts = 0, failed_in_parts = 0;  // decided and failed matches that have not been gathered yet
  std::uint64_t running = 0, ended = 0;             // running tasks; ended tasks with matches not yet gathered
  double rate = 0.0;                                // matches per second of all running tasks together
};
Status status_of(const StudyFolder& folder);
// Describes the state: "1200 of 4000 matches, 12 tasks play, 3.4 matches a second, some 14 min left"
std::string in_words(const Status& status);

}  // namespace regista::cluster
