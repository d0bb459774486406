// SPDX-License-Identifier: MIT
// Runs one check in a process of its own: whatever a plugin does to the process, nobody else is hurt, and how it ended
// is known.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "check/verdict.hpp"
#include "process/shared_memory.hpp"

namespace regista::check {

// What a check came to.
struct Outcome {
  Status status = Status::pass;
  std::vector<std::string> lines;
  bool hung = false;  // it had to be ended
};

struct Deadline {
  int processor_seconds = 10;  // of one check
  double idle_seconds = 5.0;   // that it may sleep at a stretch

  // On a machine that has much else to do.
  double wall_seconds() const { return std::max(300.0, 30.0 * processor_seconds); }
};

// What a child is about to do, for its parent to read when it died of that.
class Underway {
 public:
  Underway();
  // That of the process which has started this program: its number() there, for a program that was let have it.
  explicit Underway(int number);
  // What is too long is cut.
  void write(std::string_view text);
  std::string read() const;
  int number() const { return text_.descriptor(); }  // of the file, which ends with the process that has made it

 private:
  process::SharedMemory<std::array<char, 512>> text_;
};

// Calls `check`. An exception that it throws is a failure, and its text the line; only std::bad_alloc goes on.
Outcome without_exceptions(const std::function<Outcome()>& check);

// How a child ends that has answered.
enum class Ending : std::uint8_t {
  at_once,
  as_programs_do  // with all that is to be run at the end of a process; that it does so well is part of the outcome
};

// Calls `check` in a child of this process. A child that dies, hangs or ends early is a crash, with the reason and the
// last line that it wrote to standard error, and with the note. Throws std::system_error when no process can be
// started.
Outcome in_a_child(const std::function<Outcome()>& check, const Deadline& deadline, Underway& note,
                   Ending ending = Ending::at_once);

// The same, but the child becomes this program once more, so that nothing in it is where it is here. It is given these
// words, the two numbers of answer_as_a_child() behind them, and this environment ("NAME=VALUE" each).
Outcome in_another_program(std::vector<std::string> words, const std::vector<std::string>& environment,
                           const Deadline& deadline, Underway& note);

// What a program does that was started so: calls `check`, answers, and ends.
[[noreturn]] void answer_as_a_child(const std::string& answer, const std::string& note,
                                    const std::function<Outcome(Underway&)>& check);

}  // namespace regista::check
