// SPDX-License-Identifier: MIT
// The results of a study as a file that can be continued: the file holds what was planned, and is continued only by the
// same plan. Everything that differs is named; nothing is mixed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "process/temporary_folder.hpp"
#include "report/study_report.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"

namespace regista::results {

// What a file of results keeps of what its study was begun with.
struct BegunWith {
  std::vector<std::filesystem::path> files;  // documents that were read, so that a match can be played again
  std::vector<std::string> teams;            // documents of the teams, resolved, for readers
};

// Opens the file of results for this study. One that is resumed goes on as it was begun: stored_study() has it.
// Throws BadInput: it exists and is not to be continued, or the other way round, holds something else, or cannot be
// used.
campaign::Store open_results(const std::string& file, bool resume, const study::Study& study,
                             const BegunWith& begun_with, std::span<const StudyKind> kinds);

// The teams' documents that a file keeps, by team; none where it has none. Throws campaign::StoreError.
std::vector<std::string> stored_documents(const campaign::Store& store);

// A file of results to be read. Throws BadInput.
campaign::Store read_results(const std::string& file);

// Files of results of one study, read as one: in a temporary file where there are several. Throws BadInput for such as
// do not fit together, and output::WriteError.
class ResultsTogether {
 public:
  ResultsTogether(const std::vector<std::string>& files, std::span<const StudyKind> kinds);
  ~ResultsTogether();
  ResultsTogether(const ResultsTogether&) = delete;
  ResultsTogether& operator=(const ResultsTogether&) = delete;
  const campaign::Store& store() const { return *store_; }

 private:
  std::unique_ptr<process::TemporaryFolder> folder_;
  std::unique_ptr<campaign::Store> store_;
};

// The plan of its study.
std::string stored_plan(const campaign::Store& store);

// The kind of study that a plan is of; file: its name, for messages. Throws BadInput for one that is not known.
const StudyKind& kind_of(const std::string& file, const std::string& plan, std::span<const StudyKind> kinds);

// The study of the file gets so many pairs of matches, those it has among them. Throws BadInput where it may not.
void give_pairs(const std::string& file, std::uint64_t pairs, std::span<const StudyKind> kinds);

// What it holds, as far as its plan says; file: its name, for messages. Throws BadInput.
std::unique_ptr<report::StudyReport> stored_study(const std::string& file, const campaign::Store& store,
                                                  report::CommandOf again, std::span<const StudyKind> kinds);

// Of the matches of its first round enough that every team and every scene is among them. The study has been run then.
std::vector<campaign::Job> first_jobs(study::Study& study);

// The match in a row of the file, from 1; nothing when it has not been played. Throws campaign::StoreError.
std::optional<campaign::Store::Row> stored_match(const campaign::Store& store, study::Study& study, std::uint64_t row);

}  // namespace regista::results
