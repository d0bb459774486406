// SPDX-License-Identifier: MIT
// A match of a study set up as it was: from the files as they are or, where these have changed, from the documents that
// the study was begun with.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/document_copies.hpp"
#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "plugin/catalogue.hpp"

namespace regista::campaign {

class StoredSetup {
 public:
  // The files are named as they are seen from the current folder; goes to that of the copies where it takes these, so
  // that the catalogue's folders must be absolute. documents: asked for only then. Throws what it throws, and as
  // DocumentCopies does.
  StoredSetup(const Job& stored, const plugin::Catalogue& catalogue,
              const std::function<std::vector<Document>()>& documents);

  // Why copies were wanted, in words; empty when the files are what they were.
  const std::string& changed() const { return changed_; }
  // What is not as it was all the same: it cannot be played; else empty.
  const std::string& missing() const { return missing_; }
  // To be played while this lives, and in the folder that this went to.
  const Job& job() const { return job_; }
  MatchSetup take() { return std::move(prepared_); }

 private:
  std::string set_up();

  const plugin::Catalogue& catalogue_;
  Job job_;
  MatchSetup prepared_;
  std::optional<DocumentCopies> copies_;
  std::string changed_, missing_;
};

}  // namespace regista::campaign
