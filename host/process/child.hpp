// SPDX-License-Identifier: MIT
// Starts a child process, limits its resources, watches it, ends it, and describes its end. A child has its own process
// group, so that Ctrl-C on the terminal reaches only its parent. A child dies with its parent (PR_SET_PDEATHSIG). Its
// group is killed with the child. Descendants kills processes that left the group.
#pragma once

#include <sys/types.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::process {

// Returns pointers to the texts and a null at the end, as exec() needs them. The texts must outlive the result.
std::vector<char*> pointers(const std::vector<std::string>& texts);

// The resource limits of a process. 0: Regista sets no limit.
struct Limits {
  int processor_seconds = 0;  // s of processor time; then the process gets SIGXCPU, and two seconds later SIGKILL
  std::uint64_t memory = 0;   // bytes of address space; ignored if a sanitizer reserves more addresses than memory
  bool core_file = false;     // false: a process that dies writes no core file
  bool small_stack = false;   // true: a stack of 8 MiB whatever the user's limit is, so an endless recursion ends
};
// Gives this process `seconds` of processor time from now on. After this time the process gets SIGXCPU.
void limit_processor_time(int seconds);

// A file descriptor of the parent, and its number in the child.
struct HandedFile {
  int from = nothing;
  int to = 0;
  static constexpr int nothing = -1;  // the child gets /dev/null
};

struct Setting {
  // Files that the child gets in addition to inherited files. A standard stream that is missing here is /dev/null.
  std::vector<HandedFile> files = {};
  Limits limits = {};
  bool keeps_streams = false;    // the child keeps the standard streams of the parent
  bool keeps_signals = false;    // the child keeps signal handlers and mask of the parent; false: system defaults
  bool outlives_parent = false;  // the child and its own children continue after the end of the parent
};

// Applies the setting to this new process. Returns false if a step failed; the process must then end immediately. Makes
// only calls that are safe in a signal handler.
bool become_child(const Setting& setting, pid_t parent);

// Sets signal handlers and mask to the state of a new program. Makes only calls that are safe in a signal handler.
void default_signals();

// The state of a process that has ended or was stopped by a signal.
struct ProcessEnd {
  int status = 0;                  // status from waitpid()
  double processor_seconds = 0.0;  // processor time that the process used; 0 for a stopped process

  bool was_stopped() const { return WIFSTOPPED(status); }
  bool exited_with(int code) const { return WIFEXITED(status) && WEXITSTATUS(status) == code; }
  // Returns the signal that ended the process.
  std::optional<int> signal_number() const {
    return WIFSIGNALED(status) ? std::optional(WTERMSIG(status)) : std::nullopt;
  }
  // Returns whether the process ended by a signal that people or systems send (SIGKILL, SIGTERM, SIGINT, SIGHUP,
  // SIGQUIT). Such an end is no evidence of a mistake in its code.
  bool from_outside() const;
  bool out_of_processor_time() const { return signal_number() == SIGXCPU; }
  // Describes the end: "Segmentation fault", "ended the process (exit code 3)", "was stopped (Stopped (signal))".
  std::string in_words() const;
};

// Texts for a process that was ended at a limit.
std::string used_processor_time(int seconds);     // "used more than 10 s of processor time"
std::string did_not_return(double wall_seconds);  // "did not return within 200 s"

class Child {
 public:
  Child() = default;
  // Takes over a child process of this process. The child must have its own process group.
  explicit Child(pid_t process) : process_(process) {}
  // Kills the process and waits for its end, unless a caller has already waited.
  ~Child();
  Child(Child&& other) noexcept : process_(std::exchange(other.process_, -1)), ends_group_(other.ends_group_) {}
  Child& operator=(Child&& other) noexcept;

  // Starts a copy of this process that runs `work`. The copy then ends immediately with the returned exit code, without
  // destructors. Precondition: `work` needs no other threads of this process. Throws std::system_error.
  static Child copy(const Setting& setting, const std::function<int()>& work);
  // The exit code of a copy that could not start its work because of a system limit, usually the limit of open files.
  static constexpr int never_began = 127;

  struct Program {
    std::string file = {};           // path of the program; a name without '/' is searched in PATH
    std::vector<std::string> words;  // arguments including the program's name
    std::optional<std::span<char* const>> variables = {};  // "NAME=VALUE" and a null; missing: as in this process
  };
  static constexpr const char* this_program = "/proc/self/exe";  // valid even if the program's file has been replaced
  // Throws std::system_error with the reason if the program cannot be started.
  static Child program(const Setting& setting, const Program& program);

  bool runs() const { return process_ != -1; }
  pid_t process() const { return process_; }  // -1 after the end of the process

  // look() does not wait. It returns the end of the process, a stop by a signal, or nothing while the process runs.
  // wait() waits for the end. After the end, both functions kill the process group of the child, unless program()
  // started it with outlives_parent. Both functions throw std::system_error if the end of the process is unknown.
  std::optional<ProcessEnd> look();
  ProcessEnd wait();
  // Kills the process and its group. The caller must still call wait().
  void kill() const;

 private:
  std::optional<ProcessEnd> reaped(int options);
  pid_t process_ = -1;
  bool ends_group_ = true;
};

// Kills processes that plugins have started, which become children of this process when their parents end. Strangers
// and their groups are not killed: children that a shell left when it became this process (`exec`).
class Descendants {
 public:
  // Must be called before this process starts children, because all present children are strangers. Each later child
  // must have its own process group.
  Descendants();

  // Kills all children of this process except `those` and strangers.
  void end_all_but(std::span<const pid_t> those) const;
  void end_all() const { end_all_but({}); }

 private:
  std::vector<pid_t> strangers_, groups_;
};

// --- Watching another process

// Returns the processor time of a running process so far, s; 0 if it is unknown.
double processor_seconds_of(pid_t process);

// Returns the mapped address space of a process, bytes; 0 if it is unknown.
std::uint64_t address_space_of(pid_t process);

// Measures how long a process has been idle. A process that waits for a processor or a disk does not count as idle.
class IdleProcess {
 public:
  explicit IdleProcess(pid_t process) : process_(process) {}

  // Returns how long, in s, all calls have found the process asleep or stopped. Must be called several times a second.
  double idle_seconds();

 private:
  using Clock = std::chrono::steady_clock;
  pid_t process_;
  unsigned long long used_ = 0;  // used processor time in clock ticks of the system
  Clock::time_point since_ = Clock::now();
};

struct CallLimits {
  int processor_seconds = 0;  // processor time of one call, s
  double wall_seconds = 0.0;  // wall time of one call, s; much longer than processor_seconds, for a plugin that sleeps
};

enum class Exceeded { nothing, processor_time, wall_time };

// Checks whether the current call in a process exceeds its limits. The owner calls look() from time to time. Call: a
// type whose values identify a call and differ from one call to the next.
template <class Call>
class CallWatch {
 public:
  using Clock = std::chrono::steady_clock;
  explicit CallWatch(const CallLimits& limits) : limits_(limits) {}

  // working: the process is in a call, and not between two calls.
  Exceeded look(const Call& call, bool working, pid_t process) {
    const double processor = processor_seconds_of(process);
    if (!(call == call_)) {
      call_ = call;
      began_ = Clock::now();
      processor_then_ = processor;
    }
    if (processor_then_ < 0.0) processor_then_ = processor;
    if (wall_seconds() > limits_.wall_seconds) return Exceeded::wall_time;
    if (working && processor - processor_then_ > limits_.processor_seconds) return Exceeded::processor_time;
    return Exceeded::nothing;
  }
  // Describes what the call has exceeded: see used_processor_time(). Precondition: not Exceeded::nothing.
  std::string in_words(Exceeded exceeded) const {
    return exceeded == Exceeded::wall_time ? did_not_return(limits_.wall_seconds)
                                           : used_processor_time(limits_.processor_seconds);
  }
  // Returns the time since the first look at the current call, s.
  double wall_seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  // Starts the measurement again. Must be called while no call with a time limit is in progress.
  void pause() {
    began_ = Clock::now();
    processor_then_ = unknown;
  }

 private:
  CallLimits limits_;
  Call call_{};
  Clock::time_point began_ = Clock::now();
  static constexpr double unknown = -1.0;
  double processor_then_ = unknown;  // processor time at the first look at the call, s
};

// Keeps the beginning and the end of the standard error text of a process.
class KeptOutput {
 public:
  void add(std::string_view text);
  // Returns the text. If a middle part is missing, a line says how many bytes were left out.
  std::string text() const;

 private:
  static constexpr std::size_t most_each = 4096;  // bytes that are kept at the beginning, and as many at the end
  std::string first_, last_;
  std::uint64_t left_out_ = 0;
};

// --- Other programs, such as the commands of Slurm, which run without a shell; and commands as lines for a shell

struct ProgramCall {
  std::vector<std::string> words;                          // program name, searched in PATH, and its arguments
  std::optional<std::chrono::milliseconds> patience = {};  // the program is killed after this time; missing: no limit
  std::size_t longest_text = std::size_t{64} << 20;        // kept bytes of output, and of errors; the rest is dropped
};

struct ProgramEnd {
  bool found = true;    // false: no such program exists
  bool in_time = true;  // false: the program was killed after ProgramCall::patience
  ProcessEnd end;
  std::string output, errors;  // text on standard output and standard error

  bool succeeded() const { return found && in_time && end.exited_with(0); }
};

// Runs a program with empty standard input to its end. The program may outlive this process. Throws std::system_error.
ProgramEnd run_program(const ProgramCall& call);

// Returns a line that a POSIX shell splits into the same words.
std::string shell_line(const std::vector<std::string>& words);

// Returns the shell line with "regista" as the name of the program, so that equal results give equal pages.
std::string command_line(const std::vector<std::string>& words);

}  // namespace regista::process
