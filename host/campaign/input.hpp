// SPDX-License-Identifier: MIT
// One of the things a match is a function of: a name for people, and a hash of what it contains.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace regista::campaign {

// {"plugin greedy (lib/greedy.so)", "greedy 9f2c..."}
struct Input {
  std::string name, hash;
  friend bool operator==(const Input&, const Input&) = default;
};

// Which inputs have changed, are gone or are new, in words: "plugin greedy (lib/greedy.so) has changed". Each name
// once; what stands in brackets, where a file was found, makes no other thing of it.
std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now);

}  // namespace regista::campaign
