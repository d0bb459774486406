// SPDX-License-Identifier: MIT
#include "check/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>

#include "config/bad_input.hpp"
#include "config/bytes.hpp"
#include "config/sanitized.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"
#include "config/visible_text.hpp"
#include "plugin/descendants.hpp"
#include "plugin/idle_process.hpp"

namespace regista::check {
namespace {

using Clock = std::chrono::steady_clock;

constexpr rlim_t most_memory = rlim_t{2} << 30;
constexpr std::size_t most_bytes = std::size_t{1} << 20;  // of an outcome
constexpr std::size_t most_text = std::size_t{64} << 20;  // bytes that it may write
constexpr std::size_t much_text = std::size_t{64} << 10;  // of which a warning tells
constexpr int out_of_memory = 91;                         // exit code of a child
constexpr int own_descriptor = 700;                       // above what a plugin would close or write to by guessing
constexpr std::size_t kept_text = 2000;                   // bytes of the end of what it wrote
constexpr std::size_t note_bytes = 512;
constexpr int patience = 100;  // ms between two looks at a child that says nothing
constexpr std::array<std::uint8_t, 8> mark{'o', 'u', 't', 'c', 'o', 'm', 'e', ':'};

// --- In the child ----------------------------------------------------------------------------------------------------

void limit(__rlimit_resource what, rlim_t most) {
  rlimit now{};
  ::getrlimit(what, &now);
  now.rlim_cur = std::min(most, now.rlim_max);
  ::setrlimit(what, &now);
}

void write_all(int pipe, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(pipe, bytes.data(), bytes.size());
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) ::_exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

// Files that a plugin may write into by guessing their numbers: they are caught here.
class DescriptorTrap {
 public:
  DescriptorTrap() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == -1) return;
    reading_ = ::fcntl(ends[0], F_DUPFD_CLOEXEC, own_descriptor);
    const int writing = ::fcntl(ends[1], F_DUPFD_CLOEXEC, own_descriptor);
    ::close(ends[0]);
    ::close(ends[1]);
    constexpr int guessed = 32;
    for (int each = STDERR_FILENO + 1; each < guessed; ++each) {
      if (::fcntl(each, F_GETFD) == -1) ::dup3(writing, each, O_CLOEXEC);
    }
    ::close(writing);
  }
  bool has_caught() const {
    char byte;
    return reading_ != -1 && ::read(reading_, &byte, 1) == 1;
  }

 private:
  int reading_ = -1;  // ends with the process
};

// Of the child's own, with limits. Returns the number of the file for its answer, out of the way.
int become_a_child(const Deadline& deadline, int answer, int text, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(text, STDOUT_FILENO);
  ::dup2(text, STDERR_FILENO);
  ::close(nothing);
  ::close(text);
  if (const int higher = ::fcntl(answer, F_DUPFD_CLOEXEC, own_descriptor); higher != -1) {
    ::close(answer);
    answer = higher;
  }
  limit(RLIMIT_CORE, 0);
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  limit(RLIMIT_CPU, static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + deadline.processor_seconds));
  if (!addresses_are_reserved()) limit(RLIMIT_AS, most_memory);  // more than there is memory
  return answer;
}

[[noreturn]] void answer_and_end(const std::function<Outcome()>& check, int answer, Ending ending) noexcept {
  for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGPIPE, SIGXCPU}) std::signal(each, SIG_DFL);
  const pid_t here = ::getpid();
  const DescriptorTrap trap;
  Outcome outcome;
  try {
    outcome = without_exceptions(check);
  } catch (const std::bad_alloc&) {
    ::_exit(out_of_memory);
  }
  if (::getpid() != here) ::_exit(1);  // a plugin has doubled the process: one of the two is enough
  if (trap.has_caught()) {
    outcome.status = Status::fail;
    outcome.lines.emplace_back("wrote into files that are not its own");
  }
  config::BytesOut bytes;
  bytes(outcome.status, outcome.lines);
  write_all(answer, mark);
  write_all(answer, bytes.bytes());
  if (ending == Ending::as_programs_do) std::exit(0);
  ::_exit(0);
}

// Their strings must live until then.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (std::string& each : texts) out.push_back(each.data());
  out.push_back(nullptr);
  return out;
}

// --- In the parent ---------------------------------------------------------------------------------------------------

// Reads what is there, without waiting, and counts it. False at the end of the pipe. keep: bytes of the end that are
// kept.
bool take(int pipe, std::vector<std::uint8_t>& into, std::size_t keep, std::size_t& taken) {
  std::array<std::uint8_t, 4096> buffer;
  for (int i = 0; i < 64; ++i) {  // a plugin may write without end
    const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
    if (count == -1 && errno == EINTR) continue;
    if (count == -1) return errno == EAGAIN;
    if (count == 0) return false;
    taken += static_cast<std::size_t>(count);
    into.insert(into.end(), buffer.begin(), buffer.begin() + count);
    if (into.size() > keep) into.erase(into.begin(), into.end() - static_cast<std::ptrdiff_t>(keep));
  }
  return true;
}

std::string last_line(const std::vector<std::uint8_t>& text) {
  std::string_view all(reinterpret_cast<const char*>(text.data()), text.size());
  while (all.ends_with('\n')) all.remove_suffix(1);
  return config::visible_at_most(all.substr(all.rfind('\n') + 1), 200);
}

std::optional<Outcome> outcome_of(const std::vector<std::uint8_t>& answer) {
  if (answer.size() < mark.size() || !std::equal(mark.begin(), mark.end(), answer.begin())) return std::nullopt;
  try {
    const std::span<const std::uint8_t> all(answer);
    config::BytesIn bytes(all.subspan(mark.size()));
    Outcome out;
    bytes(out.status, out.lines);
    if (!bytes.empty() || out.status > Status::skip) return std::nullopt;
    for (std::string& each : out.lines) each = config::visible(each);
    return out;
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) == -1) throw std::system_error(errno, std::generic_category(), "pipe");
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    ::close(ends[0]);
    if (ends[1] != -1) ::close(ends[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_writing_end() {
    ::close(ends[1]);
    ends[1] = -1;
  }
  std::array<int, 2> ends{};
};

std::string how_it_ended(int status, const Deadline& deadline) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory) {
    return fmt::format("took all of its {} GiB of memory", most_memory >> 30);
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    return fmt::format("took more than {} s of processor time", deadline.processor_seconds);
  }
  if (WIFSIGNALED(status)) return ::strsignal(WTERMSIG(status));
  return fmt::format("ended the process (exit code {})", WEXITSTATUS(status));
}

// Of one that had nothing to do but to end; empty when all is well, and when its time was up.
std::string ended_badly(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) != SIGXCPU) {
    return fmt::format("the process ends by {}", ::strsignal(WTERMSIG(status)));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) == 0) return {};
  return fmt::format("the process ends with exit code {}", WEXITSTATUS(status));
}

int new_file_for_a_note() {
  const int low = ::memfd_create("regista", MFD_CLOEXEC);
  const int out = low == -1 ? -1 : ::fcntl(low, F_DUPFD_CLOEXEC, own_descriptor);
  if (out == -1 || ::ftruncate(out, note_bytes) == -1) throw std::system_error(errno, std::generic_category(), "memfd");
  ::close(low);
  return out;
}

char* page_of(int number) {
  void* const page = ::mmap(nullptr, note_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, number, 0);
  if (page == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  return static_cast<char*>(page);
}

using InTheChild = std::function<void(int answer, int text, pid_t parent)>;  // does not return
Outcome of_a_child(const InTheChild& become, const Deadline& deadline, SharedNote& note, Ending ending);

}  // namespace

SharedNote::SharedNote() : number_(new_file_for_a_note()), page_(page_of(number_)) {}
SharedNote::SharedNote(int number) : number_(number), page_(page_of(number)) {}
SharedNote::~SharedNote() {
  ::munmap(page_, note_bytes);
  ::close(number_);
}

void SharedNote::write(std::string_view text) {
  const std::size_t length = std::min(text.size(), note_bytes - 1);
  std::memcpy(page_, text.data(), length);
  page_[length] = '\0';
}

std::string SharedNote::read() const {
  // A plugin may have written here, too.
  return config::visible_at_most(std::string_view(page_, ::strnlen(page_, note_bytes)), note_bytes);
}

Outcome without_exceptions(const std::function<Outcome()>& check) {
  try {
    return check();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {Status::fail, {error.what()}};
  } catch (...) {
    return {Status::fail, {"threw something that is no exception"}};
  }
}

Outcome in_a_child(const std::function<Outcome()>& check, const Deadline& deadline, SharedNote& note, Ending ending) {
  const auto become = [&](int answer, int text, pid_t parent) {
    answer_and_end(check, become_a_child(deadline, answer, text, parent), ending);
  };
  return of_a_child(become, deadline, note, ending);
}

Outcome in_another_program(std::vector<std::string> words, const std::vector<std::string>& environment,
                           const Deadline& deadline, SharedNote& note) {
  const auto become = [&](int answer, int text, pid_t parent) {
    answer = become_a_child(deadline, answer, text, parent);
    for (const int kept : {answer, note.number()}) ::fcntl(kept, F_SETFD, 0);
    words.insert(words.end(), {std::to_string(answer), std::to_string(note.number())});
    std::vector<std::string> own = environment;
    ::execve("/proc/self/exe", pointers_to(words).data(), pointers_to(own).data());
    const std::string reason = std::generic_category().message(errno);
    answer_and_end(
        [&] {
          return Outcome{Status::skip, {fmt::format("the program cannot be started once more: {}", reason)}};
        },
        answer, Ending::at_once);
  };
  return of_a_child(become, deadline, note, Ending::at_once);
}

void answer_as_a_child(const std::string& answer, const std::string& note,
                       const std::function<Outcome(SharedNote&)>& check) {
  constexpr std::uint64_t most = 1'000'000;
  const auto number = [](const std::string& text) {
    return static_cast<int>(config::parse_whole("number", text, own_descriptor, most));
  };
  const int to = number(answer);
  const int about = number(note);
  for (const int each : {to, about}) {
    if (::fcntl(each, F_GETFD) == -1) throw config::BadInput("this command is for the program itself");
  }
  SharedNote shared(about);
  for (const int each : {to, shared.number()}) ::fcntl(each, F_SETFD, FD_CLOEXEC);
  answer_and_end([&] { return check(shared); }, to, Ending::at_once);
}

namespace {

Outcome of_a_child(const InTheChild& become, const Deadline& deadline, SharedNote& note, Ending ending) {
  note.write("");
  const plugin::Descendants descendants;
  Pipe answer, text;
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == -1) throw std::system_error(errno, std::generic_category(), "cannot start a process for a check");
  if (child == 0) {
    for (const int parents : {answer.ends[0], text.ends[0]}) ::close(parents);
    become(answer.ends[1], text.ends[1], parent);
    ::_exit(1);
  }
  ::setpgid(child, child);  // whoever of the two comes first
  answer.close_writing_end();
  text.close_writing_end();

  std::vector<std::uint8_t> answered, written;
  std::size_t answered_bytes = 0, written_bytes = 0;
  std::string ended;  // by this function, and why
  int status = 0;
  const auto began = Clock::now();
  plugin::IdleProcess idle(child);
  bool answers = true, writes = true;
  std::string last_place;
  for (;;) {
    std::array<pollfd, 2> watched{pollfd{answers ? answer.ends[0] : -1, POLLIN, 0},
                                  pollfd{writes ? text.ends[0] : -1, POLLIN, 0}};
    ::poll(watched.data(), watched.size(), answers || writes ? patience : 10);
    if (writes) writes = take(text.ends[0], written, kept_text, written_bytes);
    if (answers) answers = take(answer.ends[0], answered, most_bytes, answered_bytes);
    const pid_t over = ::waitpid(child, &status, WNOHANG | WUNTRACED);
    if (over == child && !WIFSTOPPED(status)) break;
    if (over == child && ended.empty()) ended = fmt::format("was stopped ({})", ::strsignal(WSTOPSIG(status)));
    // Who goes from scene to scene is not idle, however often it sleeps.
    if (const std::string place = note.read(); place != last_place) {
      last_place = place;
      idle = plugin::IdleProcess(child);
    }
    const std::chrono::duration<double> waited = Clock::now() - began;
    if (ended.empty() && idle.idle_seconds() > deadline.idle_seconds) {
      ended = fmt::format("did nothing for {:.0f} s", deadline.idle_seconds);
    } else if (ended.empty() && written_bytes > most_text) {
      ended = fmt::format("wrote more than {} MiB to standard output and standard error", most_text >> 20);
    } else if (ended.empty() && waited.count() > deadline.wall_seconds()) {
      ended = fmt::format("did not end within {:.0f} s", deadline.wall_seconds());
    }
    if (!ended.empty()) ::kill(-child, SIGKILL);
  }
  ::kill(-child, SIGKILL);  // what a plugin may have started
  descendants.end_all();
  take(answer.ends[0], answered, most_bytes, answered_bytes);
  take(text.ends[0], written, kept_text, written_bytes);
  if (auto outcome = outcome_of(answered); outcome && ended.empty() && ending == Ending::as_programs_do) {
    if (const std::string wrong = ended_badly(status); !wrong.empty()) return {Status::fail, {wrong}};
  }
  if (ended.empty() && WIFEXITED(status)) {
    if (auto outcome = outcome_of(answered)) {
      if (outcome->status == Status::pass && written_bytes > much_text) {
        outcome->status = Status::warn;
        outcome->lines.push_back(
            fmt::format("wrote {} bytes to standard output and standard error: the log is for that", written_bytes));
      }
      return *outcome;
    }
    if (!answered.empty()) ended = "wrote into a file that is not its own";
  }
  const bool out_of_time = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  Outcome out{Status::crash, {ended.empty() ? how_it_ended(status, deadline) : ended}, !ended.empty() || out_of_time};
  if (const std::string place = note.read(); !place.empty()) out.lines.push_back("at: " + place);
  constexpr std::string_view of_memory = "memory: ";  // what the testkit says of a fault
  if (const std::string last = last_line(written); last.starts_with(of_memory)) {
    out.lines.push_back(last.substr(of_memory.size()));
  } else if (!last.empty()) {
    out.lines.push_back("it wrote: " + last);
  }
  return out;
}

}  // namespace
}  // namespace regista::check
