// SPDX-License-Identifier: MIT
// A match of a study, read from its file of results and set up as it was: from the files as they are or, where these
// have changed, as the study found them.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "campaign/document_copies.hpp"
#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/match_setup.hpp"
#include "cli/study_kinds.hpp"
#include "plugin/catalogue.hpp"

namespace regista::cli {

struct StoredMatch {
  std::string results, row;  // the file, absolute; as typed
  campaign::Job job;
  campaign::Decided decided;
  campaign::Limits limits;
};

// The files of the match are named as they were where the study was begun: goes there. Throws BadInput.
StoredMatch read_stored_match(const std::string& results, const std::string& row, std::span<const StudyKind> kinds);

class StoredSetup {
 public:
  // Goes to the folder of the copies where it takes them: the catalogue's folders must be absolute. program: how it was
  // called, for messages. Throws BadInput where the match cannot be set up as it was, output::WriteError where there is
  // no room for copies.
  StoredSetup(const StoredMatch& stored, const plugin::Catalogue& catalogue, const std::string& program);

  // What is not as it was, so that copies were taken, in words; empty when all is.
  const std::string& changed() const { return changed_; }
  // To be played while this lives, and in the folder that this went to.
  const campaign::Job& job() const { return job_; }
  campaign::MatchSetup take() { return std::move(prepared_); }

 private:
  void take_copies(const StoredMatch& stored);
  std::string set_up();

  const plugin::Catalogue& catalogue_;
  campaign::Job job_;
  campaign::MatchSetup prepared_;
  std::optional<campaign::DocumentCopies> copies_;
  std::string changed_;
};

}  // namespace regista::cli
