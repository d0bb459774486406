// SPDX-License-Identifier: MIT
#include "campaign/shell.hpp"

#include <vector>

#include <algorithm>
#include <string_view>

namespace regista::campaign {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-./=:,+@%").find(c) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string out = "'";
  for (const char c : word) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + '\'';
}

}  // namespace

std::string shell_line(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    line += quoted(word);
  }
  return line;
}

std::string command_line(std::span<const std::string> words) {
  std::vector<std::string> line{"regista"};
  line.insert(line.end(), words.begin(), words.end());
  return shell_line(line);
}

}  // namespace regista::campaign
