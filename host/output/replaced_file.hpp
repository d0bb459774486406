// SPDX-License-Identifier: MIT
// Writes files and standard output. A full disk and a closed pipe are errors, which are found before the program ends.
//
// A new file or folder is first written under another name beside its place, and then renamed. So an incomplete file
// never has the final name, and an old file is replaced only by a complete new file. A new folder replaces nothing.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "output/output_files.hpp"
#include "report/figure.hpp"

namespace regista::output {

// Thrown if writing fails. what() names the file and the error message of the system.
class WriteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns the system's message for an error number.
std::string reason_of(int error);

// Thrown if the reader of standard output has closed it, as in `regista plugin list | head -1`.
class ReaderGone : public WriteError {
  using WriteError::WriteError;
};

// Call it before opening any file, or a file could become a standard stream that was closed at the start.
void occupy_standard_streams();

// Writes all of `text` to standard output and flushes it. Throws ReaderGone, WriteError.
void print(std::string_view text);

// A file that a command writes piece by piece during its work.
class OutputFile {
 public:
  // Creates or empties the file. Throws BadInput on failure.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);  // throws WriteError
  void close();                       // throws WriteError; no write() may follow

 private:
  [[noreturn]] void fail() const;
  std::string name_;
  std::FILE* file_;
};

// --- A file may replace only a file of its own kind, so that a typing mistake cannot destroy results, teams or
// plugins. The first bytes of a file show its kind.

struct OwnKind {
  std::string_view what, begins;    // name of the kind, "recording"; first bytes of a file of this kind
  bool needs_force = false;         // true: only --force replaces a file of this kind, because its creation took time
  std::string_view cheap = {};      // first bytes of files whose creation took no time: --force is not needed
  bool replaces_others = false;     // true: with --force, a file of this kind may replace a file of another kind
  bool moved_to_its_place = false;  // true: the file is renamed to its place, so the folder must be writable
  std::string_view advice = {};     // advice for messages, in addition to "--force replaces it"
};

// Returns the kind of a written file. Precondition: the file is neither a folder nor a file of results.
OwnKind own_kind(Writes what);

// The content of an existing file, compared with a kind.
enum class Found {
  nothing,   // the file is empty
  own,       // the file begins with OwnKind::begins
  cheap,     // the file begins with OwnKind::cheap
  database,  // the file is an SQLite database, for example results
  other,
};
bool is_database(const std::filesystem::path& file);  // whether the file is an SQLite database
Found found_in(const std::filesystem::path& file, const OwnKind& kind);

enum class Existing { refused, replaced };

// Writes the whole file. Throws BadInput if the file exists and may not be replaced (the message names --force), is not
// an ordinary file, cannot be created, or if HTML or SVG would replace a file that is not markup. Throws WriteError if
// the content cannot be stored, for example on a full disk.
void write_whole(const std::filesystem::path& file, std::string_view bytes, Existing existing);

struct NewFile {
  std::string name;  // relative to the folder: "teams/a.yaml"
  std::string bytes;
};

// Throws BadInput if `folder` exists or its parent is missing or not writable. Throws WriteError if the files cannot be
// stored, for example on a full disk.
void write_new_folder(const std::filesystem::path& folder, std::span<const NewFile> files);

// --- The figures of a study as files in a folder: data (CSV) and pictures (SVG).

// Endings of figure files. Only earlier versions of Regista wrote scripts (.gnuplot) and pixel images (.png).
inline constexpr std::array<std::string_view, 4> figure_endings{".csv", ".gnuplot", ".svg", ".png"};

struct FigureOptions {
  std::optional<std::filesystem::path> folder;  // created if missing; no value: no files are written
  Existing existing = Existing::refused;
  bool only_these = false;  // true: write_figures() first removes the figures of an earlier study from the folder
};

// Throws BadInput if the folder cannot be created. Throws the exceptions of write_whole().
void write_figures(const std::vector<report::Figure>& figures, const FigureOptions& options);

}  // namespace regista::output
