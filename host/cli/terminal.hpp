// SPDX-License-Identifier: MIT
// Standard error as a screen that shows how far long work has come.
#pragma once

#include <string>

namespace regista::cli {

// It is a terminal that can erase what it shows.
bool can_rewrite();

// Writes at once. What is lost of this is lost: it is no result.
void say(const std::string& text);

}  // namespace regista::cli
