// SPDX-License-Identifier: MIT
// How a command uses a file that an option names: it reads or writes a file of some kind. output_files.hpp decides by
// these declarations alone which files may be overwritten. A test requires a declaration for every option with a value.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace regista::output {

enum class Reads {
  documents,  // a YAML document and all files that it names, or a folder of documents
  results,    // a file of results with the files that SQLite keeps beside it
  data,       // any other single file
  plugins,    // a folder of shared objects
};

enum class Writes {
  results,        // results of a study with the files beside them
  recording,      // the recording of a match
  decisions,      // the decisions of a match
  metrics,        // the metrics of a match as a table
  match_table,    // the table of the matches of an experiment
  summary_table,  // the summary of an experiment
  search_table,   // the evaluations of a tuning
  tuned_team,
  page,     // a page (HTML) or a picture (SVG)
  drawing,  // a drawing of a team's roles
  figures,  // a folder of figures
  sources,  // a new folder for a study, or the folder that will contain the folder of a new plugin
};

using FileUse = std::variant<std::monostate, Reads, Writes>;  // std::monostate: the option names no file

struct GivenOption {
  std::string name;                 // "--set"; "teams"
  std::vector<std::string> values;  // in the order of typing
  FileUse use;
};

}  // namespace regista::output
