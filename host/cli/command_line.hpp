// SPDX-License-Identifier: MIT
// The command line as a whole: which commands there are, which one was meant, and what is said when none was.
#pragma once

namespace regista::cli {

// Runs the command that the arguments name. Returns the exit code (end_of_program.hpp); throws nothing.
int run(int argc, char** argv);

}  // namespace regista::cli
