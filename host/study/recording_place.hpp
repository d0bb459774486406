// SPDX-License-Identifier: MIT
// Where the recordings of a tournament's matches stand: in the folder NAME.recordings beside the file of results
// NAME.db, each in a file of its own that is called by the match's place in the schedule, from 1, as the row of the
// results is: NAME.recordings/12.mcap.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace regista::study {

inline std::filesystem::path recording_folder(const std::filesystem::path& results) {
  std::filesystem::path name = results.stem();
  name += ".recordings";
  return results.parent_path() / name;
}

inline std::filesystem::path recording_file(const std::filesystem::path& results, std::int64_t row) {
  return recording_folder(results) / (std::to_string(row) + ".mcap");
}

}  // namespace regista::study
