// SPDX-License-Identifier: MIT
// The guard of everything that is written to files. A command's outputs are never written over what it reads, over its
// results, over what SQLite keeps beside a database, or over one another, by whatever path or link they are named; over
// files of another kind not at all, or only when --force is given. Paths are taken as they are when they are named
// here: before a command goes to another folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "output/file_use.hpp"

namespace regista::output {

class OutputFiles {
 public:
  // All that the given options of a command name; those of --set lead to files, too. work: "match", for messages.
  OutputFiles(const std::vector<GivenOption>& given, std::string work);

  // More of the same, which no option names.
  void read(const std::vector<std::string>& files, Reads what, const std::vector<std::string>& overrides = {});
  // who: as messages begin, "--csv" or the same in words. A name that was written before keeps its first place.
  void write(const std::string& who, const std::filesystem::path& file, Writes what);
  // Results of a study: also what stands beside them when it ends, as far as it is wished.
  enum class Page { none, alone, with_figures };
  void write_beside(const std::filesystem::path& results, Page page);

  // All documents that are read: those that were named, and those that they lead to.
  std::vector<std::filesystem::path> documents() const;

  // Throws BadInput for the first output that cannot be allowed, or not be written where it is.
  void check(bool force) const;

 private:
  // A file as it was named, and what the name leads to: two names are the same file when one of these is.
  struct Place {
    explicit Place(const std::filesystem::path& file);
    bool same(const Place& other) const;
    std::filesystem::path named, path;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> identity;  // device and number; none: there is no such file
  };
  // As named. What it leads to is looked for when something is to be checked against it: most commands write nothing.
  struct Named {
    std::vector<std::filesystem::path> files;  // absolute
    Reads what;
    std::vector<std::string> overrides;
  };
  struct Read {
    Place place;
    std::string what;  // "a file that this match reads"
  };
  struct Output {
    std::string who;
    Place place;
    Writes what;
  };
  // A folder into which files of these endings are written, by names that follow from the work.
  struct Folder {
    std::string who;
    Place place;
    std::vector<std::string_view> endings;
  };

  std::vector<Read> all_reads() const;
  static void check_reads(const Output& output, const std::vector<Read>& reads);
  void check_others(std::size_t output) const;
  static void check_folder(const Folder& folder, const std::vector<Output>& outputs, const std::vector<Read>& reads);
  static void check_existing(const Output& output, bool force);

  std::string work_;
  std::vector<Named> reads_;
  std::vector<Output> outputs_;
  std::vector<Folder> folders_;
};

}  // namespace regista::output
