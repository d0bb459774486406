// SPDX-License-Identifier: MIT
// How the program ends: its exit codes, and the one line on standard error that explains every end but a good one.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "config/bad_input.hpp"

namespace regista::command {

enum ExitCode : int {
  exit_done = 0,
  exit_no = 1,         // the answer is no: a check fails, what was written could not be kept
  exit_bad_input = 2,  // what the user gave cannot be used: command line, documents, plugins
  exit_internal = 3,   // a defect of Regista
};

// The exit code of a program that a signal ends, as shells count it: 130 after Ctrl-C, 141 when the reader of a pipe
// has gone away.
constexpr int exit_by_signal(int signal_number) { return 128 + signal_number; }

using config::BadInput;

// Ctrl-C. what() says how far the work came and how to do it again.
class Interrupted : public std::runtime_error {
 public:
  Interrupted(const std::string& message, int signal_number)
      : std::runtime_error(message), signal_number_(signal_number) {}
  int signal_number() const { return signal_number_; }

 private:
  int signal_number_;
};

// Writes "regista: message" as one line to standard error, whatever the message contains.
void complain(std::string_view message);

// To be called in a handler: complains about the exception that is being handled, and returns the exit code for it.
int explain_current_exception();

}  // namespace regista::command
