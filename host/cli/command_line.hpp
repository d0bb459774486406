// SPDX-License-Identifier: MIT
// The command line as a whole: which commands there are, which one was meant, and what is said when none was.
#pragma once

#include <span>

#include "cli/commands.hpp"

namespace regista::cli {

// All commands: what there is to choose from. invocation outlives them.
void add_commands(Command& program, const Invocation& invocation);

// Runs the command that the arguments name. studies: those that the program knows. Returns the exit code
// (end_of_program.hpp); throws nothing.
int run(int argc, char** argv, std::span<const results::StudyKind> studies);

}  // namespace regista::cli
