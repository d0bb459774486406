// SPDX-License-Identifier: MIT
// A command as a line that a POSIX shell reads back as the same words.
#pragma once

#include <span>
#include <string>

namespace regista::campaign {

std::string shell_line(std::span<const std::string> words);

// The same after "regista", by the program's name and not by the path that was typed this time: the same results make
// the same page.
std::string command_line(std::span<const std::string> words);

}  // namespace regista::campaign
