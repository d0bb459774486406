// SPDX-License-Identifier: MIT
// What a task of the array does: plays its slices of a round into a file of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "cluster/batch.hpp"
#include "study/study.hpp"

namespace regista::cluster {

// How far a task has come.
struct Course {
  std::uint64_t done = 0, all = 0;      // matches of its slices that are decided; all
  std::uint64_t fresh = 0, failed = 0;  // of those: played since the task was started (again); forfeited or set aside
  double seconds = 0.0;                 // s of this node's steady clock, since the task was started (again)
  bool ended = false;
  std::string node;
};

std::string to_json(const Course& course);
// Throws std::invalid_argument for what to_json() did not write.
Course course_from_json(const std::string& text);

struct SliceOrder {
  std::uint64_t first_row = 0;  // of the round: see study::Round
  Slices slices;
  int workers = 1;
  // A job of the study as it is to be played here, with the file that it is recorded in, if any.
  std::function<campaign::Job(campaign::Job job, std::uint64_t row)> job;
  std::function<std::string(std::uint64_t row)> record_failure;
  std::function<void(const Course& course)> course;  // after each match
  std::function<bool()> asked_to_stop;
};

// known: what earlier rounds brought. Throws as campaign::run(), and study::StudyError when the study does not ask for
// such a round.
campaign::Finish play_slice(study::Study& study, const campaign::Store& known, campaign::Store& part,
                            const SliceOrder& order);

}  // namespace regista::cluster
