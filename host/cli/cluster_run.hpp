// SPDX-License-Identifier: MIT
// A study whose matches an array of Slurm plays: how it is begun, and what is done between two batches. The same step
// is taken by the job that comes after an array, by `regista gather`, and by whoever waits for the study.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "cli/common_names.hpp"
#include "cli/invocation.hpp"
#include "cluster/parts.hpp"
#include "cluster/study_folder.hpp"

namespace regista::cli {

// As typed.
struct ClusterOptions {
  std::string on, folder, array, per_task, partition, time;
  std::vector<std::string> sbatch;  // more options
  bool detach = false;
};

void add_cluster_options(Command& command, ClusterOptions& options);

// From nothing to the first batch, and to the end of the study unless it is detached: the exit code. begin: plans the
// study and makes its file of results, which plays nothing. file: the study's document.
int run_on_cluster(const ClusterOptions& options, const campaign::Options& campaign, const std::string& file,
                   const std::function<void(const campaign::Options& options)>& begin, const Invocation& invocation);

// What a step found.
struct ClusterStep {
  cluster::Gathered gathered;
  cluster::Progress progress;
  std::uint64_t submitted = 0;  // matches
  std::uint64_t round = 0;      // matches that the study asks for at a time
  bool plays = false;           // an array waits or runs
};

// Gathers, and submits the next batch where the study needs one, nothing plays now, and it has not been stopped.
// restart: also where it has been stopped or has failed. Throws BadInput, WriteError.
ClusterStep take_step(const cluster::StudyFolder& folder, bool restart, const Invocation& invocation);

// Says what the step found, and reports a study that is complete: the exit code.
int tell_step(const cluster::StudyFolder& folder, const ClusterStep& step, const campaign::Options& options,
              const Invocation& invocation);

// All jobs that the study has submitted.
std::vector<std::string> all_jobs(const cluster::Progress& progress);

// Waits until the study has ended, takes steps where no job of it is left, and prints the report: the exit code.
int follow(const cluster::StudyFolder& folder, const campaign::Options& options, const Invocation& invocation);

// The report and what stands beside the results of a study that is complete.
int finish_on_cluster(const cluster::StudyFolder& folder, const campaign::Options& options,
                      const Invocation& invocation);

// How things stand, by the files alone. With findings: what was found, too, for which all matches are read.
struct ClusterStatus {
  cluster::Progress progress;
  std::string title, headline;  // what was found in the matches that were gathered, as far as they go without a gap
  std::uint64_t most = 0;       // matches of the study
  std::uint64_t gathered = 0, in_parts = 0, failed = 0;
  std::uint64_t running = 0, ended = 0;  // tasks of which nothing was gathered yet
  double rate = 0.0;                     // matches per second, of the tasks that run
};
enum class Findings { left_out, wanted };
ClusterStatus status_of(const cluster::StudyFolder& folder, const Invocation& invocation,
                        Findings findings = Findings::wanted);
// "1200 of 4000 matches, 12 tasks play, 3.4 matches a second, some 14 min left"
std::string in_words(const ClusterStatus& status);

}  // namespace regista::cli
