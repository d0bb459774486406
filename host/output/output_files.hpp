// SPDX-License-Identifier: MIT
// Checks the files that a command writes. No output may replace a file that the command reads, the command's results, a
// file that SQLite keeps beside a database, or another output, even if another path or a link names that file. Some
// outputs may replace a file of another kind only with --force, others never. OutputFiles resolves relative paths when
// it gets them, so a command must pass all paths before it changes its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace regista::output {

// --- How a command uses a file that an option names. These declarations alone decide which files may be overwritten. A
// test requires a declaration for every option with a value.

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

class OutputFiles {
 public:
  // Takes the files that the given options of a command name, and files in values of --set. work: noun for messages.
  OutputFiles(const std::vector<GivenOption>& given, std::string work);

  // Adds files that the command reads although no option names them.
  void read(const std::vector<std::string>& files, Reads what, const std::vector<std::string>& overrides = {});
  // Adds a file that the command writes. who: the beginning of messages: an option such as "--csv", or a description.
  // Does nothing if the same file was already added with the same use.
  void write(const std::string& who, const std::filesystem::path& file, Writes what);
  // Adds the results of a study and the files beside them: the files of SQLite, the recordings, and if wanted the page
  // and its figures. Figures exist only together with the page.
  void write_beside(const std::filesystem::path& results, bool page, bool figures);

  // Returns all documents that the command reads: the named documents and, recursively, the documents that they name.
  std::vector<std::filesystem::path> documents() const;

  // Throws BadInput at the first output that is not allowed or that cannot be written to its place.
  void check(bool force) const;

 private:
  // A file: its given name and its resolved path. Two places are the same file if their paths or identities are equal.
  struct Place {
    explicit Place(const std::filesystem::path& file);
    bool same(const Place& other) const;
    bool is_among(const std::vector<Place>& others) const;
    std::filesystem::path named, path;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> identity;  // device and inode number; missing: no such file
  };
  // Files that the command reads, with unresolved links. Only check() and documents() resolve the links, because most
  // commands write nothing and need no check.
  struct Named {
    std::vector<std::filesystem::path> files;  // absolute paths
    Reads what;
    std::vector<std::string> overrides;
  };
  struct Output {
    std::string who;
    Place place;
    Writes what;
  };
  // A folder in which the command will write files with these endings. The names of these files are not known yet.
  struct Folder {
    std::string who;
    Place place;
    std::span<const std::string_view> endings;
  };

  std::vector<Place> all_reads() const;
  void check_folder(const Folder& folder, const std::vector<Place>& reads) const;
  static void check_existing(const Output& output, bool force);

  std::string work_;
  std::vector<Named> reads_;
  std::vector<Output> outputs_;
  std::vector<Folder> folders_;
};

}  // namespace regista::output
