// SPDX-License-Identifier: MIT
// Which of the files in a folder of recordings hold the matches of a tournament. Files outlive what they were recorded
// for: the results may have been deleted and others begun under their name, a worker may have been killed while it
// wrote, and its match played later without a recording; workers run ahead of where a test stops. So a file counts only
// for what it says itself, and no word is said of the others: what there is of them depends on when somebody was
// killed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "report/course_record.hpp"
#include "report/tournament.hpp"

namespace regista::report {

struct PageRecordings {
  std::vector<RecordedRow> fitting;
  std::uint64_t not_read = 0;  // files beyond those that are looked into: CourseRecord::most_recorded
};

// Where a recorded match is found, as seen from the page.
struct RecordingLink {
  std::string path;     // relative
  std::string command;  // that shows it, given in the folder of the page
};

PageRecordings page_recordings(const TournamentView& view, const CourseRecord& record,
                               const std::filesystem::path& results);

}  // namespace regista::report
