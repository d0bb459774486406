// SPDX-License-Identifier: MIT
// The command line as a whole: which commands there are, which one was meant, and what is said when none was.
#pragma once

#include <functional>
#include <span>

#include "cli/commands.hpp"

namespace regista::cli {

// All commands: what there is to choose from. invocation outlives them.
void add_commands(Command& program, const Invocation& invocation);

// A command and the studies of a program that knows more than ours.
struct Addition {
  std::function<void(Command& program, const Invocation& invocation)> command;
  std::span<const results::StudyKind> studies;  // all of them
};

// Runs the command that the arguments name. Returns the exit code (end_of_program.hpp); throws nothing.
int run(int argc, char** argv, const Addition* addition = nullptr);

}  // namespace regista::cli
