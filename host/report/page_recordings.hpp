// SPDX-License-Identifier: MIT
// Which of the files in a folder of recordings hold the matches of a tournament. Files outlive what they were recorded
// for: the results may have been deleted and others begun under their name, a worker may have been killed while it
// wrote, and its match played later without a recording; workers run ahead of where a test stops. So a file counts only
// for what it says itself, and no word is said of the others: what there is of them depends on when somebody was
// killed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/course_record.hpp"
#include "report/tournament.hpp"

namespace regista::report {

// What a recording must say of itself to be taken for that of a match.
struct MatchToFind {
  std::uint64_t seed = 1;
  std::array<std::string, 2> labels;        // of the home and the away team, in the tournament
  std::string opening;                      // name; empty: from kick-off
  std::optional<std::array<int, 2>> score;  // by side; none: the match failed, and its recording may be cut off
  std::optional<double> packets;            // of both teams, of a match with a score: hardly two matches send as many
};

// Reads the beginning of the file and its last second. False for what is no recording, too.
bool holds(const std::filesystem::path& recording, const MatchToFind& match);

struct PageRecordings {
  std::vector<RecordedRow> fitting;
  std::uint64_t not_read = 0;  // files beyond those that are looked into: CourseRecord::most_recorded
};

PageRecordings page_recordings(const TournamentView& view, const CourseRecord& record,
                               const std::filesystem::path& results);

}  // namespace regista::report
