// SPDX-License-Identifier: MIT
// A document as its readers want it: the file, over the files it extends, under the values of the command line.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

// A value that is laid over a document.
struct Override {
  std::string path;
  Node value;
  Location where;  // of the path

  Override(std::string path_, Node value_, Location where_)
      : path(std::move(path_)), value(std::move(value_)), where(std::move(where_)) {}
  // As it is typed, "path=value", the value in YAML: stands at "--set path=value". Throws Error for what is none.
  Override(const std::string& typed);
  Override(const char* typed) : Override(std::string(typed)) {}
};

// In the order in which they are laid over it.
using Overrides = std::vector<Override>;

Overrides typed_overrides(const std::vector<std::string>& texts);
std::string to_string(const Override& override);  // "path=value"

// Reads a file. Its key `extends: FILE` (relative to it) names a file that it is laid over, which may extend another.
// Every value keeps the Location of the file it came from, or of the override.
Node load(const std::filesystem::path& file, const Overrides& overrides = {});

// Overrides alone, over a document in memory.
Node override_with(Node document, const Overrides& overrides);

}  // namespace regista::config
