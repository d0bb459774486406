// SPDX-License-Identifier: MIT
// Where files stand that belong to a file of results: beside it, and called like it. NAME.db has the page NAME.html,
// the tuned team NAME.tuned.yaml, and the folders NAME.recordings and NAME.figures; any other name keeps its ending, so
// that b.sqlite (b.sqlite.html, b.sqlite.recordings) shares nothing with b.db. Recordings are called by the match's
// place in the schedule, from 1, as the row of the results is: NAME.recordings/12.mcap.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace regista::study {

// ending: with its dot.
inline std::filesystem::path beside(const std::filesystem::path& results, const std::string& ending) {
  std::filesystem::path name = results.extension() == ".db" ? results.stem() : results.filename();
  name += ending;
  return results.parent_path() / name;
}

inline std::filesystem::path page_file(const std::filesystem::path& results) { return beside(results, ".html"); }

inline std::filesystem::path tuned_file(const std::filesystem::path& results) { return beside(results, ".tuned.yaml"); }

inline std::filesystem::path figure_folder(const std::filesystem::path& results) { return beside(results, ".figures"); }

inline std::filesystem::path recording_folder(const std::filesystem::path& results) {
  return beside(results, ".recordings");
}

inline std::filesystem::path recording_file(const std::filesystem::path& results, std::int64_t row) {
  return recording_folder(results) / (std::to_string(row) + ".mcap");
}

}  // namespace regista::study
