// SPDX-License-Identifier: MIT
// What a worker does (worker.hpp): reads a job from standard input, plays its match, and says how it ended. The process
// belongs to that one match: whatever plugins do to it, no other match suffers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/catalogue.hpp"

namespace regista::campaign {

// What the program knows about itself.
struct Surroundings {
  std::string program;  // "regista 0.1.0", for recordings
  // The plugins of these folders and of the program's own; for a job that names no files.
  std::function<plugin::Catalogue(const std::vector<std::string>& folders)> open_plugins;
};

// False when nobody reads the answer. Throws BadInput where no coordinator has started this process. Plugins have left
// things to be done at the end of the program: the caller ends it at once.
bool play_one(const Surroundings& surroundings);

}  // namespace regista::campaign
