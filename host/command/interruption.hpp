// SPDX-License-Identifier: MIT
// Ctrl-C (SIGINT) and SIGTERM while long work is under way: the first one asks the work to stop, which it does within a
// second or is stopped (a plugin may hang); a second one ends the program as if nobody had asked.
#pragma once

#include <string_view>

namespace regista::command {

// Listens from its construction to its end. One at a time.
class Interruption {
 public:
  // `last_words`: the line for standard error when the work did not stop by itself.
  explicit Interruption(std::string_view last_words);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  int signal_number() const;  // the one that has asked; 0: none
  bool requested() const { return signal_number() != 0; }
};

}  // namespace regista::command
