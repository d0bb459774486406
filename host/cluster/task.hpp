// SPDX-License-Identifier: MIT
// A task of a Slurm job array plays its slices of the study on this node, and stores the matches in its own part.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "cluster/batch.hpp"
#include "cluster/study_folder.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"

namespace regista::cluster {

struct SliceOrder {
  std::uint64_t first_row = 0;  // first row of the round: see study::Round
  Slices slices;
  int workers = 1;
  // Returns the job with the paths of the copied files, and with a file for the recording if this row is recorded.
  std::function<campaign::Job(campaign::Job job, std::uint64_t row)> job;
  std::function<std::string(std::uint64_t row)> record_failure;
  std::function<void(const TaskProgress& progress)> progressed;  // called after each match
  std::function<bool()> asked_to_stop;
};

// Plays the slices of `order` and stores the matches in `part`. known: results of earlier rounds. Throws the exceptions
// of campaign::run(). Throws study::StudyError if the study does not ask for this round.
campaign::Finish play_slice(study::Study& study, const campaign::Store& known, campaign::Store& part,
                            const SliceOrder& order);

// Plays the matches that the task's part lacks, and stores them. Throws BadInput, Interrupted, output::WriteError.
void play_task(const std::string& folder, const TaskName& name, const results::Invocation& invocation);

}  // namespace regista::cluster
