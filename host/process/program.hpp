// SPDX-License-Identifier: MIT
// Other programs, such as the commands of Slurm: started without a shell, waited for, and what they said; and how a
// command is written down for a shell.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/child.hpp"

namespace regista::process {

struct ProgramCall {
  std::vector<std::string> words;                          // the program, looked for in PATH, and its arguments
  std::optional<std::chrono::milliseconds> patience = {};  // then it is killed; nothing: it may take for ever
  std::size_t longest_text = std::size_t{64} << 20;        // bytes of each of its texts; the rest is left out
};

struct ProgramEnd {
  bool found = true;    // there is such a program
  bool in_time = true;  // else it was killed
  ProcessEnd end;
  std::string output, errors;  // what it wrote

  bool succeeded() const { return found && in_time && end.exited_with(0); }
};

// With nothing to read. It goes on where this process is killed. Throws std::system_error where no process can be
// started.
ProgramEnd run_program(const ProgramCall& call);

// A command as a line that a POSIX shell reads back as the same words.
std::string shell_line(std::span<const std::string> words);

// The same after "regista", by the program's name and not by the path that was typed this time: the same results make
// the same page.
std::string command_line(std::span<const std::string> words);

}  // namespace regista::process
