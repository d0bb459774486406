// SPDX-License-Identifier: MIT
// `regista report` of a tuning: its text, JSON or trace from stored results.
#pragma once

#include "cli/told_study.hpp"

namespace regista::cli {

struct TuningWishes {
  bool json = false, csv = false;
};

// results.plan holds a tuning. Exit code; throws BadInput.
int tell_tuning(const StoredResults& results, const TuningWishes& wishes);

}  // namespace regista::cli
