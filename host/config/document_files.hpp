// SPDX-License-Identifier: MIT
// Finds and reads the files that documents are and name. A file of the user comes before a shipped document of the same
// name. The Error for a missing file says where the file's name is written and which similar file exists. named_files()
// finds all files that a document needs.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.hpp"
#include "config/overlay.hpp"

namespace regista::config {

inline constexpr std::string_view yaml_file = "a YAML file";  // what read_file() expects of a document

// Returns the path of the shipped document that is called `written`: a document that comes with the program, in its
// folder share/regista/configs. Returns `path` if the file `path` exists, if `written` contains a dot or a slash, or if
// no shipped document has this name. `path` is `written` with its folder.
std::filesystem::path own_or_shipped(const std::filesystem::path& path, const std::filesystem::path& written);
inline std::filesystem::path own_or_shipped(const std::filesystem::path& path) { return own_or_shipped(path, path); }

// Returns the whole content of a regular file of at most `largest_file` bytes. Throws Error at `asked_by` (default: at
// the file) if the file does not exist, is too large, is unreadable, or is not a regular file. `expected` describes the
// wanted kind of file in the message about a folder.
std::string read_file(const std::filesystem::path& file, const Location& asked_by = {},
                      std::string_view expected = "a file");

// Returns the whole content of a file of any size, or nothing if the file is unreadable.
std::optional<std::string> file_content(const std::filesystem::path& file);

// Returns the path of the file that a value names. A relative path begins at the folder of the value's file, or at the
// current folder for a value of the command line; the name of a shipped document gives its path. Throws Error at the
// value if it is empty or no text. `what` is the path of the value, such as "sender.file".
std::filesystem::path named_file(const Node& value, std::string_view what);

// Returns the absolute path of named_file(). Throws Error at the value if no regular file has this path.
std::filesystem::path existing_file(const Node& value, std::string_view what);

// Returns the documents and all files that they name directly or indirectly: extended documents, teams and openings of
// a study, files of parameters, pinned plugins. The search tests every value as a file name and repeats this in each
// document that it finds. Each file name is returned once, in the order of the search. For a file with several names
// (links), at most eight names are returned. If a value names a folder, the search takes the .yaml files of this
// folder. The search also tests the values of overrides. An unreadable file causes no exception.
std::vector<std::filesystem::path> named_files(std::span<const std::filesystem::path> documents,
                                               const Overrides& overrides = {});

}  // namespace regista::config
