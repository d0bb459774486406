// SPDX-License-Identifier: MIT
// Checks shared objects against <regista/abi.h>, as `regista plugin check` does. Inspects a file, opens it, and checks
// the contract (of the testkit) of each kind that its plugins implement. Each check runs in its own process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "check/given_values.hpp"
#include "check/isolation.hpp"

namespace regista::check {

struct Options {
  std::vector<std::string> only;     // names of checks or groups of checks; empty: all
  std::vector<std::string> plugins;  // ids of the plugins to check; empty: all plugins of the file
  // Names and values of the plugin's parameters, as text. The value of a parameter for a file is the path of the file.
  GivenTexts parameters;
  bool may_idle = false;    // true: an assigner may leave robots without a task
  std::uint64_t seed = 0;   // seed of the random numbers in the checks
  bool in_process = false;  // true: checks run in this process, for a debugger
  // Words of the command of this program that calls play_perturbed(). Empty: the check `elsewhere` is skipped.
  std::vector<std::string> perturbed;
  std::filesystem::path visitors;  // a folder with plugins; one of them plays first in the check `elsewhere`
  Deadline deadline;
};

// Functions that receive each result as soon as the result is known. Each function may be empty.
struct Listener {
  std::function<void(const std::string& file, const Verdict&)> verdict;
  std::function<void(const Report&)> report;  // called after all checks of a file
};

// Returns one report for each file. Looks at all files before the first check. Throws config::BadInput for an unknown
// name in `only`, a missing file, a wrong value, and a plugin, parameter or check that no file has.
std::vector<Report> check_files(const std::vector<std::filesystem::path>& files, const Options& options,
                                const Listener& listener);

}  // namespace regista::check
