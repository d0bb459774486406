// SPDX-License-Identifier: MIT
// A document as its readers want it: the file, over the files it extends, under the values of the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

// Values of the command line, each "path=value" (`--set`), laid over the document in this order. The value is YAML.
using Overrides = std::vector<std::string>;

// Reads a file. Its key `extends: FILE` (relative to it) names a file that it is laid over, which may extend another.
// Every value keeps the Location of the file it came from; those of overrides stand at "--set path=value".
Node load(const std::filesystem::path& file, const Overrides& overrides = {});

// Overrides alone, over a document in memory.
Node override_with(Node document, const Overrides& overrides);

}  // namespace regista::config
