// SPDX-License-Identifier: MIT
// Standard error as a screen that shows how far long work has come; how wide standard output is.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace regista::command {

// Columns for text on standard output: those of the terminal, between 40 and 120; else what COLUMNS says, or 80.
std::size_t columns_of_output();

// It is a terminal that can erase what it shows.
bool can_rewrite();

// Writes at once. What is lost of this is lost: it is no result.
void say(const std::string& text);

// A line that is rewritten in place, ten times a second at most; nothing where that cannot be, or nobody wants it.
class RewrittenLine {
 public:
  explicit RewrittenLine(bool wanted) : live_(wanted && can_rewrite()) {}
  ~RewrittenLine() { clear(); }
  RewrittenLine(const RewrittenLine&) = delete;
  RewrittenLine& operator=(const RewrittenLine&) = delete;

  // It is time for another show().
  bool due() const;
  void show(const std::string& text);
  void clear();

 private:
  bool live_, shown_ = false;
  std::chrono::steady_clock::time_point drawn_ = std::chrono::steady_clock::now();
};

}  // namespace regista::command
