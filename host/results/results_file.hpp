// SPDX-License-Identifier: MIT
// The file of results of a study. The file stores the plan of the study, and only the same plan can continue the study.
// If another plan is used, the error names everything that differs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "campaign/stored_setup.hpp"
#include "process/file_descriptor.hpp"
#include "report/study_report.hpp"
#include "report/what_was_played.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"

namespace regista::results {

// The inputs of a study that its file of results keeps.
struct BegunWith {
  std::vector<std::filesystem::path> files;  // all documents of the study, for a replay of a match
  std::vector<std::string> teams;            // resolved documents of the teams, for readers
};

// Opens the file of results for this study. A resumed study continues with its stored plan: see stored_study(). Throws
// BadInput if the file exists without `resume`, is missing with it, belongs to another study, or is unusable.
campaign::Store open_results(const std::string& file, bool resume, const study::Study& study,
                             const BegunWith& begun_with, std::span<const StudyKind> kinds);

// Returns the stored documents of the teams, by team; empty if the file has none. Throws campaign::StoreError.
std::vector<std::string> stored_documents(const campaign::Store& store);

// Opens a file of results for reading. Throws BadInput.
campaign::Store read_results(const std::string& file);

// Reads several files of results of one study like a single file. Copies all files into one temporary file. Throws
// BadInput for files of different studies, and output::WriteError.
class ResultsTogether {
 public:
  ResultsTogether(const std::vector<std::string>& files, std::span<const StudyKind> kinds);
  const campaign::Store& store() const { return *store_; }

 private:
  std::unique_ptr<process::TemporaryFolder> folder_;
  std::unique_ptr<campaign::Store> store_;
};

std::string stored_plan(const campaign::Store& store);

// Returns the kind of study of a plan. file: the file's name in messages. Throws BadInput for an unknown kind.
const StudyKind& kind_of(const std::string& file, const std::string& plan, std::span<const StudyKind> kinds);

// Replaces the stored plan by another plan of the same study. Throws campaign::StoreError.
void store_plan(campaign::Store& store, const std::string& plan);

// Removes the early end from a study that its time limit (--until, --minutes) stopped, so that the study can continue.
// Other studies stay unchanged. file: the store's name in messages. Throws BadInput.
void lift_end(const std::string& file, campaign::Store& store, std::span<const StudyKind> kinds);

// Changes the current folder to the folder in which a study was begun, because the study names its files relative to
// this folder. who: the beginning of messages. Throws BadInput.
void enter_folder(const std::string& who, const std::string& folder);

// Changes the number of pairs of matches of the stored study. `pairs` includes the pairs that were played already.
// Throws BadInput if the kind of study or its plan forbids the number.
void give_pairs(const std::string& file, std::uint64_t pairs, std::span<const StudyKind> kinds);

// Returns the report of the stored study, made from its plan. file: the file's name in messages. Throws BadInput.
std::unique_ptr<report::StudyReport> stored_study(const std::string& file, const campaign::Store& store,
                                                  report::CommandOf again, std::span<const StudyKind> kinds);

// Returns matches of the first round that together include every team and every scene. The function begins to run the
// study, so the study must not run afterwards.
std::vector<campaign::Job> first_jobs(study::Study& study);

// Returns the match in a row of the file, counted from 1, or nothing if it is unplayed. Throws campaign::StoreError.
std::optional<campaign::Store::Row> stored_match(const campaign::Store& store, study::Study& study, std::uint64_t row);

// --- A stored study as a folder that `regista run` plays: study.yaml and, below it, the teams, profiles, scenes and
// data files of the study, in the same relative places. Names of files in the folder are relative.

// Writes a study to a new folder. documents: the documents of the study; kinds: all kinds of studies; folder: must not
// exist. Returns one line for each file or folder that the new folder lacks. Throws BadInput and output::WriteError.
std::vector<std::string> write_study(const report::WhatWasPlayed& played,
                                     const std::vector<campaign::Document>& documents, std::span<const StudyKind> kinds,
                                     const std::filesystem::path& folder);

}  // namespace regista::results
