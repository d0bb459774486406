// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"
#include "cli/study_commands.hpp"

int main(int argc, char** argv) { return regista::cli::run(argc, argv, regista::cli::study_kinds()); }
