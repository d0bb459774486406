// SPDX-License-Identifier: MIT
// The option `--plugins`, and what is said of the files in its folders.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "plugin/catalogue.hpp"

namespace regista::cli {

// Adds the option `--plugins DIR`, which may come several times.
void add_plugin_folders(Command& command, std::vector<std::string>& folders);

using results::open_plugins;

// Where a catalogue was searched for, to be kept from being written over (output_files.hpp).
std::vector<std::string> folders_of(const plugin::Catalogue& catalogue);

// A line on standard error for each file of these folders that cannot be used: who names a folder wants what is in it.
void tell_what_is_not_used(const plugin::Catalogue& catalogue, const std::vector<std::string>& folders);

}  // namespace regista::cli
