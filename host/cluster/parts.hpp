// SPDX-License-Identifier: MIT
// What tasks have played, and how it comes into the study's file of results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "cluster/slice.hpp"
#include "cluster/study_folder.hpp"

namespace regista::cluster {

struct Gathered {
  std::uint64_t rows = 0;            // matches that were not there yet
  std::uint64_t refused = 0;         // matches that do not fit: their part is kept in set_aside/
  std::uint64_t in_use = 0;          // parts that a task still writes to
  std::vector<std::string> remarks;  // a line each
  std::vector<std::string> refused_nodes;
};

// Whose parts are taken: also those of tasks that were killed, once no task is left that would go on with one.
enum class Tasks { ended, killed_too };

// Takes over what has been played, and removes what was taken over whole. A part that is none, or is damaged, is set
// aside, and what it held is missing then. Throws campaign::StoreError for `results` itself and for a disk that fails,
// campaign::StoreRefusal for a part that cannot be opened now.
Gathered gather(const StudyFolder& folder, campaign::Store& results, Tasks tasks, const std::string& program_version);

// Of tasks whose matches were not gathered yet, by their names.
std::vector<Course> courses(const StudyFolder& folder);

// A node that plays nothing, because it would play other matches: what is left for gather() to find.
void write_refusal(const StudyFolder& folder, const TaskName& task, const std::string& node, const std::string& why);

// Replaces what is there; readers see one or the other.
void write_course(const StudyFolder& folder, const TaskName& task, const Course& course);

}  // namespace regista::cluster
