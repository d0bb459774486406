// SPDX-License-Identifier: MIT
// Options that name files say what becomes of these: read or written, and as what. What a command may write over
// follows from that alone (output_files.hpp), and a test holds that no option with a value is left without a word.
#pragma once

#include <optional>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace regista::cli {

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
  figures,  // a folder
};

// Both give the option back.
CLI::Option* reads(CLI::Option* option, Reads what);
CLI::Option* writes(CLI::Option* option, Writes what);

// What the option was said to do; nothing when it was not.
std::optional<Reads> read_by(const CLI::Option& option);
std::optional<Writes> written_by(const CLI::Option& option);

}  // namespace regista::cli
