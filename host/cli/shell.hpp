// SPDX-License-Identifier: MIT
// A command as a line that a POSIX shell reads back as the same words.
#pragma once

#include <span>
#include <string>

namespace regista::cli {

std::string shell_line(std::span<const std::string> words);

}  // namespace regista::cli
