// SPDX-License-Identifier: MIT
// What becomes of the files that an option of a command names: they are read or written, and as what. What a command
// may write over follows from that alone (output_files.hpp), and a test holds that no option with a value is left
// without a word.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace regista::output {

enum class Reads {
  documents,  // YAML, and whatever files it leads to; a folder stands for the documents in it
  results,    // a file of results, with what SQLite keeps beside it
  data,       // one file
  plugins,    // a folder of shared objects
};

enum class Writes {
  results,        // of a study, with what stands beside them
  recording,      // of a match
  decisions,      // of a match
  metrics,        // of a match, as a table
  match_table,    // of an experiment
  summary_table,  // of an experiment
  search_table,   // of a tuning
  tuned_team,
  page,     // or a picture
  drawing,  // of a team's roles
  figures,  // a folder
  sources,  // a new folder: of a plugin, in which its own is made, or of a study
};

using FileUse = std::variant<std::monostate, Reads, Writes>;  // none: the option names no file

// An option that was given.
struct GivenOption {
  std::string name;                 // "--set"; "teams"
  std::vector<std::string> values;  // in the order in which they were typed
  FileUse use;
};

}  // namespace regista::output
