// SPDX-License-Identifier: MIT
// Looks at files that may be anything: opens each in a process of its own and hears what it declares. A file that
// crashes, ends the process or hangs when it is opened is refused with the reason; nobody else is hurt.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plugin/description.hpp"

namespace regista::plugin {

struct Surveyed {
  std::vector<std::shared_ptr<const Description>> plugins;  // in the file's order
  std::string refusal;                                      // one line; empty when the file may be used
  std::string remark;                                       // one line for its author; mostly empty
};

// One for each file. All of them in one process while nothing goes wrong; each in a process of its own when something
// did, so that what an earlier file left running is not held against a later one. Throws std::system_error when no
// process can be started.
std::vector<Surveyed> survey(std::span<const std::filesystem::path> files);

}  // namespace regista::plugin
