// SPDX-License-Identifier: MIT
// Other programs, such as gnuplot or the commands of Slurm: started without a shell, waited for, and what they said.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace regista::campaign {

struct ProgramCall {
  std::vector<std::string> words;                            // the program, looked for in PATH, and its arguments
  std::filesystem::path folder = {};                         // in which it runs; empty: the current one
  std::optional<std::vector<std::string>> environment = {};  // NAME=VALUE; nothing: that of this process
  std::optional<std::chrono::milliseconds> patience = {};    // then it is killed; nothing: it may take for ever
  std::size_t longest_text = std::size_t{64} << 20;          // bytes of each of its texts; the rest is left out
};

struct ProgramEnd {
  bool found = true;           // there is such a program
  bool in_time = true;         // else it was killed
  int status = 0;              // as waitpid() gives it
  std::string output, errors;  // what it wrote

  bool succeeded() const;  // it exited with 0
};

// With nothing to read, and in a process group of its own: Ctrl-C is for this program, which then decides. Throws
// std::system_error where no process can be started.
ProgramEnd run_program(const ProgramCall& call);

}  // namespace regista::campaign
