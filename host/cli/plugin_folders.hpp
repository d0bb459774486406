// SPDX-License-Identifier: MIT
// Where the commands look for plugins: the folders of `--plugins`, then those of the environment variable
// REGISTA_PLUGIN_PATH, then the one that belongs to the program: ../lib/regista/plugins, seen from its own folder.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "plugin/catalogue.hpp"

namespace regista::cli {

// Adds the option `--plugins DIR`, which may come several times.
void add_plugin_folders(Command& command, std::vector<std::string>& folders);

// Throws config::Error for a folder of an option that is none.
plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation);

// Where a catalogue was searched for, to be kept from being written over (output_files.hpp).
std::vector<std::string> folders_of(const plugin::Catalogue& catalogue);

// A line on standard error for each file of these folders that cannot be used: who names a folder wants what is in it.
void tell_what_is_not_used(const plugin::Catalogue& catalogue, const std::vector<std::string>& folders);

}  // namespace regista::cli
