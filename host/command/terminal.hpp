// SPDX-License-Identifier: MIT
// The terminal: its width, a line that shows the progress of long work, and Ctrl-C during long work.
#pragma once

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "config/errors.hpp"

namespace regista::command {

// Returns the columns for text on standard output: the width of the terminal, between 40 and 120. Without a terminal:
// the value of COLUMNS, or 80.
std::size_t columns_of_output();

// Returns whether standard error is a terminal that can erase text.
bool can_rewrite();

// Writes the text to standard error immediately. Ignores write errors, because the text is not a result.
void say(const std::string& text);

// A line on standard error that is rewritten in place, at most ten times a second if due() is asked before show().
class RewrittenLine {
 public:
  explicit RewrittenLine(bool wanted) : live_(wanted && can_rewrite()) {}
  ~RewrittenLine() { clear(); }
  RewrittenLine(const RewrittenLine&) = delete;
  RewrittenLine& operator=(const RewrittenLine&) = delete;

  // Returns whether the caller should call show() now; false if rewriting is impossible or not wanted.
  bool due() const;
  void show(const std::string& text);
  void clear();

 private:
  bool live_, shown_ = false;
  std::chrono::steady_clock::time_point drawn_ = std::chrono::steady_clock::now();
};

// --- Ctrl-C (SIGINT) and SIGTERM during long work. The first signal asks the work to stop. Work that does not stop
// within a second (a plugin may hang) is ended. A second signal ends the program immediately.

// Handles SIGINT and SIGTERM while the object exists. Only one object may exist at a time.
class Interruption {
 public:
  // `last_words`: the line for standard error if the work did not stop by itself.
  explicit Interruption(std::string_view last_words);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  int signal_number() const;  // number of the received signal; 0: no signal
  bool requested() const { return signal_number() != 0; }
};

// --- The end of the program: exit codes, and the line on standard error that explains a failure.

enum ExitCode : int {
  exit_done = 0,
  exit_no = 1,         // negative answer: a check fails, or an output could not be kept
  exit_bad_input = 2,  // unusable input: command line, documents, plugins
  exit_internal = 3,   // a defect of Regista
};

// The exit code of a program that a signal ends, in the convention of shells: 130 after Ctrl-C, 141 after the reader of
// a pipe has closed it.
constexpr int exit_by_signal(int signal_number) { return 128 + signal_number; }

using config::BadInput;

// Thrown after Ctrl-C or SIGTERM. what() says how much work is done and how to continue.
struct Interrupted : std::runtime_error {
  Interrupted(const std::string& message, int signal) : std::runtime_error(message), signal_number(signal) {}
  int signal_number;
};

// Writes "regista: message" to standard error. The output is one line, even if `message` contains line breaks. On a
// terminal the first word is bold, yellow for a warning, and red in explain_current_exception().
void complain(std::string_view message);

// Must be called in a catch handler. Calls complain() for the handled exception and returns the exit code.
int explain_current_exception();

}  // namespace regista::command
