// SPDX-License-Identifier: MIT
// Runs a check of a plugin in its own process, so that a crash harms no other check and its cause is known. Measures
// what the check does to its process: allocated memory, and state that it does not restore.
#pragma once

#include <regista/abi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "process/file_descriptor.hpp"

namespace regista::check {

// --- The verdicts of `regista plugin check` on a file. Each check gives one verdict.

enum class Status : std::uint8_t {
  pass,
  warn,   // the finding may be intended, or may be a failure on other machines
  fail,   // the plugin breaks a promise of <regista/abi.h>
  crash,  // the process of the check died, or the host ended it
  skip    // there is nothing to check, or the result of an earlier check prevents the check
};

const char* word(Status status);

struct Verdict {
  std::string plugin;   // id of the plugin; empty: the verdict is about the whole file
  std::string check;    // name of the check, such as "imports" or "assigner.promises"; a name never changes
  std::string promise;  // one sentence about what is checked
  Status status = Status::pass;
  std::vector<std::string> lines;  // findings, one line each, also of a check that passed
  double seconds = 0.0;            // wall time of the check, s
};

struct Report {
  std::string file;
  std::vector<Verdict> verdicts;

  // Returns whether no check failed or crashed.
  bool passed() const;
};

// The kinds of plugins with a contract of their own, in the order of their checks.
inline constexpr std::array<std::int32_t, 7> kinds_checked{
    REGISTA_KIND_PREDICTOR, REGISTA_KIND_CONTEXT, REGISTA_KIND_POSITIONER, REGISTA_KIND_UTILITY,
    REGISTA_KIND_ASSIGNER,  REGISTA_KIND_SENDER,  REGISTA_KIND_BEHAVIOUR};

struct Outcome {
  Status status = Status::pass;
  std::vector<std::string> lines;
  bool hung = false;  // true: the host had to end the check
};

struct Deadline {
  int processor_seconds = 10;  // s of processor time for one check
  double idle_seconds = 5.0;   // the check is ended after it has slept for this time without a break, s

  // Returns the limit of wall time for one check, s. It is large, because the machine may be busy.
  double wall_seconds() const { return std::max(300.0, 30.0 * processor_seconds); }
};

// A text in shared memory that says what a child process is about to do. If the child dies, the parent reads the text.
class Underway {
 public:
  Underway();
  // Opens the text of the process that started this program. number: result of number() in that process.
  explicit Underway(int number);
  // Replaces the text. Cuts a text that is too long.
  void write(std::string_view text);
  std::string read() const;
  // Returns the descriptor of the shared file, which disappears when its creator ends.
  int number() const { return text_.descriptor(); }

 private:
  process::SharedMemory<std::array<char, 512>> text_;
};

// Calls `check`. An exception gives a failure with its message as the line. Only std::bad_alloc is passed on.
Outcome without_exceptions(const std::function<Outcome()>& check);

// How a child process ends after it has sent its outcome.
enum class Ending : std::uint8_t {
  at_once,        // by _exit, without handlers
  as_programs_do  // by std::exit, with all handlers; if this end goes wrong, the check has failed
};

// Calls `check` in a child process. If the child dies, hangs or ends early, the outcome is a crash with the reason, the
// child's last line on standard error, and the text of `note`. Throws std::system_error if no process can be started.
Outcome in_a_child(const std::function<Outcome()>& check, const Deadline& deadline, Underway& note,
                   Ending ending = Ending::at_once);

// Like in_a_child(), but the child starts this program again, so that memory has other addresses. The program gets
// `words`, the two numbers for answer_as_a_child(), and `environment` (each "NAME=VALUE").
Outcome in_another_program(std::vector<std::string> words, const std::vector<std::string>& environment,
                           const Deadline& deadline, Underway& note);

// The main function of a program that in_another_program() has started: calls `check`, sends the outcome, and ends.
[[noreturn]] void answer_as_a_child(const std::string& answer, const std::string& note,
                                    const std::function<Outcome(Underway&)>& check);

// Runs `check`. The outcome is a failure if it changes signals, locale, rounding, files or processes of this process.
Outcome leaving_the_process_alone(const std::function<Outcome()>& check);

// Starts to count allocations by operator new in this process, including those in C++ plugins. Returns a function that
// returns the count, or null if this program has a sanitizer, which allocates memory itself.
std::size_t (*count_allocations())();

}  // namespace regista::check
