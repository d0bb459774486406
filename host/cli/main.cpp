// SPDX-License-Identifier: MIT
// The program `regista`.
#include "cli/command_line.hpp"

int main(int argc, char** argv) { return regista::cli::run(argc, argv); }
