// SPDX-License-Identifier: MIT
// Checks a shared object against <regista/abi.h> as `regista plugin check` does: first without running it, then opened,
// then the contract of each kind that its plugins implement. The contracts are those of the testkit; each check runs in
// a process of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "check/child.hpp"
#include "check/verdict.hpp"

namespace regista::check {

struct Options {
  std::vector<std::string> only;     // checks or groups of them; empty: all
  std::vector<std::string> plugins;  // ids of those of the file that are checked; empty: all
  // Values of the plugin's parameters, as text; of a file its path.
  std::vector<std::pair<std::string, std::string>> parameters;
  bool may_idle = false;    // an assigner may leave robots without a task
  std::uint64_t seed = 0;   // of what the checks draw by chance
  bool in_process = false;  // in this process, for a debugger
  // This program, and which of its commands calls play_elsewhere(); empty: nobody plays elsewhere.
  std::vector<std::string> elsewhere;
  std::filesystem::path visitors;  // a folder with plugins of which one plays there first
  Deadline deadline;
};

// What can be checked of the plugins of a file: names for `only`.
std::vector<std::string> known_checks();

// Hears of what is found as soon as it is; each may be empty.
struct Listener {
  std::function<void(const std::string& file, const Verdict&)> verdict;
  std::function<void(const Report&)> report;  // at the end of a file
};

// One report for each file. All are looked at before the first check: throws config::BadInput for an unknown name in
// `only`, for a file that does not exist, for a value that a parameter cannot have, and for a plugin, parameter or
// check that none of the files has.
std::vector<Report> check_files(const std::vector<std::filesystem::path>& files, const Options& options,
                                const Listener& listener);

}  // namespace regista::check
