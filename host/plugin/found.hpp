// SPDX-License-Identifier: MIT
// What looking at a shared object ends in: plugins that may be used, or the reason why they may not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <regista/abi.h>

#include "plugin/description.hpp"

namespace regista::plugin {

class PluginFile;

// A plugin whose descriptor was checked. What it declares is known; its code is loaded when the first instance is
// created.
struct Found {
  std::filesystem::path file;
  const regista_descriptor* descriptor = nullptr;  // what it declares; lives as long as `description`
  // Null where the descriptor is the plugin's own, whose calls may be made: in tests.
  std::shared_ptr<const Description> description = nullptr;
  std::shared_ptr<PluginFile> object = nullptr;
  std::uint32_t index = 0;  // of the descriptor in the file
};

// Whether it has a table of calls for this kind; all of them, ascending.
bool implements(const Found& plugin, int kind);
std::vector<int> kinds(const Found& plugin);
std::uint32_t subjects(const Found& plugin);            // REGISTA_SUBJECT_*, of a predictor
std::uint32_t assigner_flags(const Found& plugin);      // REGISTA_ASSIGNER_*
std::uint32_t purposes(const Found& plugin);            // REGISTA_BEHAVIOUR_*
std::vector<std::string> reasons(const Found& plugin);  // of a sender, its own
std::vector<DeclaredMetric> metrics(const Found& plugin);

// The plugin's own descriptor: loads the file if it has not been yet. Throws std::runtime_error with one line that says
// why it cannot be loaded (any more).
const regista_descriptor& loaded(const Found& plugin);

// A file that was not opened, or whose plugins may not be used.
struct Refused {
  std::filesystem::path file;
  std::string reason;  // one line
};

// "file: reason"
std::string to_string(const Refused&);

}  // namespace regista::plugin
