// SPDX-License-Identifier: MIT
// One child process: started, limited, waited for, ended, and its end in words. It stands in a process group of its
// own, so that Ctrl-C on the terminal reaches its parent alone, and dies with its parent (PR_SET_PDEATHSIG). What it
// started in its group is ended with it.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace regista::process {

// Texts as exec() wants them, with a null at the end. The texts must live on.
std::vector<char*> pointers(const std::vector<std::string>& texts);

// What a process may use up; 0: no limit of ours.
struct Limits {
  int processor_seconds = 0;  // from its start; then SIGXCPU, and two seconds later SIGKILL
  std::uint64_t memory = 0;   // bytes of addresses; none where a sanitizer reserves more of them than there is memory
  bool core_file = false;     // of what was in memory at its death; false: none is ever made
  bool small_stack = false;   // 8 MiB: an endless recursion ends there, whatever the user's own limit is
};
// Of this process, from now on. False when that was not possible. Makes only calls that are safe in a signal handler.
bool set_limits(const Limits& limits);
// From now on; then SIGXCPU.
void limit_processor_time(int seconds);

// A file of the parent's, by its number there, and its number in the child.
struct HandedFile {
  int from = nothing;
  int to = 0;
  static constexpr int nothing = -1;  // /dev/null
};

struct Setting {
  // Beside those that are not closed at exec. Standard streams that are not among them are /dev/null.
  std::vector<HandedFile> files = {};
  Limits limits = {};
  bool keeps_streams = false;    // standard streams are those of the parent
  bool keeps_signals = false;    // handlers and mask of signals are those of the parent; else the system's
  bool outlives_parent = false;  // and what it starts outlives it
};

// Makes this new process a child in such a setting. False when something was not possible: it must end at once. Makes
// only calls that are safe in a signal handler.
bool become_child(const Setting& setting, pid_t parent);

// Handlers and mask of signals as of a program just started. Makes only calls that are safe in a signal handler.
void default_signals();

// How a process ended, or that it was stopped.
struct ProcessEnd {
  int status = 0;                  // as waitpid() gives it
  double processor_seconds = 0.0;  // that it used; 0 of one that was stopped

  bool was_stopped() const;
  bool exited_with(int code) const;
  std::optional<int> signal_number() const;  // that ended it
  // By a signal that people and systems send to processes: then its end says nothing about its code.
  bool from_outside() const;
  // By the limit of processor time.
  bool out_of_processor_time() const { return signal_number() == SIGXCPU; }
  // "Segmentation fault", "ended the process (exit code 3)", "was stopped (Stopped (signal))".
  std::string in_words() const;
};

// The same words for the same end, whoever limits it.
std::string used_processor_time(int seconds);     // "used more than 10 s of processor time"
std::string did_not_return(double wall_seconds);  // "did not return within 200 s"

class Child {
 public:
  Child() = default;
  // A process that is a child of this one, in a group of its own.
  explicit Child(pid_t process) : process_(process) {}
  // Kills and waits for it where nobody has.
  ~Child();
  Child(Child&& other) noexcept : process_(std::exchange(other.process_, -1)), ends_group_(other.ends_group_) {}
  Child& operator=(Child&& other) noexcept;

  // A copy of this process that does `work` and ends with the code that it returns, at once and without destructors.
  // This process has no threads that the copy would miss. Throws std::system_error.
  static Child copy(const Setting& setting, const std::function<int()>& work);
  // The exit code of a copy that never came to its work: a limit of the system, mostly of open files.
  static constexpr int never_began = 127;

  struct Program {
    std::string file = {};                                 // where it has no '/', it is looked for in PATH
    std::vector<std::string> words;                        // with the program's name
    std::optional<std::span<char* const>> variables = {};  // "NAME=VALUE" and a null; nothing: those of this process
  };
  static constexpr const char* this_program = "/proc/self/exe";  // also when its file has been replaced meanwhile
  // Throws std::system_error with the reason when it can't be started.
  static Child program(const Setting& setting, const Program& program);

  bool runs() const { return process_ != -1; }
  pid_t process() const { return process_; }  // -1 when it has ended

  // Without waiting: how it ended; or, every time that it was stopped, that it was. What it has started is killed when
  // it has ended. Both throw std::system_error where nobody can say how it ended.
  std::optional<ProcessEnd> look();
  ProcessEnd wait();
  // With all in its group. It is still to be waited for.
  void kill() const;

 private:
  std::optional<ProcessEnd> reaped(int options);
  pid_t process_ = -1;
  bool ends_group_ = true;
};

}  // namespace regista::process
