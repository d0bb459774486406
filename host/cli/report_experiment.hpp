// SPDX-License-Identifier: MIT
// `regista report` of an experiment: its text, JSON or table from stored results.
#pragma once

#include "cli/command.hpp"
#include "cli/told_study.hpp"

namespace regista::cli {

struct ExperimentWishes {
  bool json = false, csv = false;
  bool metrics = false;  // in the table: all numbers of the matches
};

// results.plan holds an experiment. Exit code; throws BadInput.
int tell_experiment(const StoredResults& results, const ExperimentWishes& wishes, const Invocation& invocation);

}  // namespace regista::cli
