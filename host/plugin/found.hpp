// SPDX-License-Identifier: MIT
// What opening a shared object ends in: plugins that may be used, or the reason why they may not.
#pragma once

#include <filesystem>
#include <string>

#include <regista/abi.h>

namespace regista::plugin {

// A plugin that was opened and whose descriptor was checked.
struct Found {
  std::filesystem::path file;
  const regista_descriptor* descriptor;  // lives for ever: a shared object is never unloaded
};

// A file that was not opened, or whose plugins may not be used.
struct Refused {
  std::filesystem::path file;
  std::string reason;  // one line
};

// "file: reason"
std::string to_string(const Refused&);

}  // namespace regista::plugin
