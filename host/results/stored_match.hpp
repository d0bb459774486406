// SPDX-License-Identifier: MIT
// A match of a study that is to be played again, from its file of results.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/stored_setup.hpp"
#include "plugin/catalogue.hpp"
#include "results/study_kind.hpp"

namespace regista::results {

struct StoredMatch {
  std::string results, row;  // the file, absolute; as typed
  campaign::Job job;
  campaign::Decided decided;
  campaign::Limits limits;
};

// The files of the match are named as they were where the study was begun: goes there. Throws BadInput.
StoredMatch read_stored_match(const std::string& results, const std::string& row, std::span<const StudyKind> kinds);

// Throws BadInput where it cannot be set up as it was, output::WriteError where there is no room for copies of its
// files. program: how it was called, for messages.
std::unique_ptr<campaign::StoredSetup> set_up(const StoredMatch& stored, const plugin::Catalogue& catalogue,
                                              const std::string& program);

}  // namespace regista::results
