// SPDX-License-Identifier: MIT
#include "check/isolation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "config/errors.hpp"
#include "config/scalar.hpp"
#include "plugin/process_state.hpp"
#include "process/child.hpp"
#include "process/sanitized.hpp"
#include "texts/bytes.hpp"
#include "texts/message.hpp"

#ifndef REGISTA_SANITIZED
#include <regista/testkit/count_allocations.hpp>
#endif

namespace regista::check {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_memory = std::uint64_t{2} << 30;
constexpr std::size_t most_bytes = std::size_t{1} << 20;  // largest outcome, bytes
constexpr std::size_t most_text = std::size_t{64} << 20;  // largest text that the child may write, bytes
constexpr std::size_t much_text = std::size_t{64} << 10;  // a longer text of the child gives a warning, bytes
constexpr int out_of_memory = 91;                         // exit code of a child that ran out of memory
constexpr int own_descriptor = 700;                       // higher than numbers that a plugin might guess
constexpr std::size_t kept_text = 2000;                   // kept end of the child's text, bytes
constexpr int patience = 100;                             // ms between two checks of a silent child
constexpr std::string_view mark = "outcome:";

// --- In the child ----------------------------------------------------------------------------------------------------

// Opens all free low descriptors on a pipe, to detect writes of a plugin to a descriptor number that it guessed.
class DescriptorTrap {
 public:
  DescriptorTrap() {
    process::Pipe pipe = process::make_pipe();
    caught_ = process::moved_up(std::move(pipe.read), own_descriptor);
    pipe.write = process::moved_up(std::move(pipe.write), own_descriptor);
    ::fcntl(pipe.write.number, F_SETFL, O_NONBLOCK);
    constexpr int guessed = 32;
    for (int each = STDERR_FILENO + 1; each < guessed; ++each) {
      if (::fcntl(each, F_GETFD) == -1) ::dup3(pipe.write.number, each, O_CLOEXEC);
    }
  }
  bool has_caught() const {
    char byte;
    return ::read(caught_.number, &byte, 1) == 1;
  }

 private:
  process::FileDescriptor caught_;
};

[[noreturn]] void answer_and_end(const std::function<Outcome()>& check, int answer, Ending ending) noexcept {
  const pid_t here = ::getpid();
  const DescriptorTrap trap;
  Outcome outcome;
  try {
    outcome = without_exceptions(check);
  } catch (const std::bad_alloc&) {
    ::_exit(out_of_memory);
  }
  if (::getpid() != here) ::_exit(1);  // a plugin called fork(), and this is the new process
  if (trap.has_caught()) {
    outcome.status = Status::fail;
    outcome.lines.emplace_back("wrote into files that are not its own");
  }
  texts::BytesOut bytes;
  bytes(outcome.status, outcome.lines);
  if (!process::write_all(answer, mark) || !process::write_all(answer, bytes.bytes())) ::_exit(1);
  if (ending == Ending::as_programs_do) std::exit(0);
  ::_exit(0);
}

// --- In the parent ---------------------------------------------------------------------------------------------------

struct Text {
  process::FileDescriptor pipe;
  std::size_t kept;  // bytes at the end that are kept
  std::string end = {};
  std::size_t bytes = 0;

  void read() {
    process::read_available(pipe, [this](std::string_view piece) {
      bytes += piece.size();
      end += piece;
      if (end.size() > kept) end.erase(0, end.size() - kept);
    });
  }
};

std::string last_line(std::string_view all) {
  while (all.ends_with('\n')) all.remove_suffix(1);
  return texts::visible_at_most(all.substr(all.rfind('\n') + 1), 200);
}

std::optional<Outcome> outcome_of(std::string_view answer) {
  if (!answer.starts_with(mark)) return std::nullopt;
  answer.remove_prefix(mark.size());
  try {
    texts::BytesIn bytes({reinterpret_cast<const std::uint8_t*>(answer.data()), answer.size()});
    Outcome out;
    bytes(out.status, out.lines);
    if (!bytes.empty() || out.status > Status::skip) return std::nullopt;
    for (std::string& each : out.lines) each = texts::visible(each);
    return out;
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

std::string how_it_ended(const process::ProcessEnd& end, const Deadline& deadline) {
  if (end.exited_with(out_of_memory)) return fmt::format("took all of its {} GiB of memory", most_memory >> 30);
  return end.out_of_processor_time() ? process::used_processor_time(deadline.processor_seconds) : end.in_words();
}

// Returns why a process ended badly after its answer. Empty for a good end, or an end by the processor-time limit.
std::string ended_badly(const process::ProcessEnd& end) {
  if (end.signal_number() && !end.out_of_processor_time()) return "the process ends by " + end.in_words();
  if (end.signal_number() || end.exited_with(0)) return {};
  return fmt::format("the process ends with exit code {}", WEXITSTATUS(end.status));
}

// The work of the child. answer: descriptor to which the child writes its outcome. Returns the child's exit code.
using InTheChild = std::function<int(int answer)>;
Outcome of_a_child(const InTheChild& work, const Deadline& deadline, Underway& note, Ending ending) {
  note.write("");
  const process::Descendants descendants;
  process::Pipe answer_pipe = process::make_pipe(), text_pipe = process::make_pipe();
  answer_pipe.write = process::moved_up(std::move(answer_pipe.write), own_descriptor);
  Text answer{std::move(answer_pipe.read), most_bytes}, text{std::move(text_pipe.read), kept_text};
  const process::Setting setting{
      .files = {{text_pipe.write.number, STDOUT_FILENO}, {text_pipe.write.number, STDERR_FILENO}},
      .limits = {.processor_seconds = 1 + deadline.processor_seconds, .memory = most_memory}};
  process::Child child = process::Child::copy(setting, [&] {
    for (process::FileDescriptor* each : {&answer.pipe, &text.pipe, &text_pipe.write}) each->reset();
    return work(answer_pipe.write.number);
  });
  answer_pipe.write.reset();
  text_pipe.write.reset();

  std::string ended;  // reason why this function ended the child; empty: the child ended by itself
  process::ProcessEnd end;
  const auto began = Clock::now();
  process::IdleProcess idle(child.process());
  std::string last_place;
  for (;;) {
    std::array<pollfd, 2> watched{pollfd{answer.pipe.number, POLLIN, 0}, pollfd{text.pipe.number, POLLIN, 0}};
    ::poll(watched.data(), watched.size(), answer.pipe.is_open() || text.pipe.is_open() ? patience : 10);
    text.read();
    answer.read();
    if (const auto over = child.look()) {
      end = *over;
      if (!end.was_stopped()) break;
      if (ended.empty()) ended = end.in_words();
    }
    // A child whose note names another step of its check than before is not idle, even if it sleeps often.
    if (const std::string place = note.read(); place != last_place) {
      last_place = place;
      idle = process::IdleProcess(child.process());
    }
    const std::chrono::duration<double> waited = Clock::now() - began;
    if (ended.empty() && idle.idle_seconds() > deadline.idle_seconds) {
      ended = fmt::format("did nothing for {:.0f} s", deadline.idle_seconds);
    } else if (ended.empty() && text.bytes > most_text) {
      ended = fmt::format("wrote more than {} MiB to standard output and standard error", most_text >> 20);
    } else if (ended.empty() && waited.count() > deadline.wall_seconds()) {
      ended = fmt::format("did not end within {:.0f} s", deadline.wall_seconds());
    }
    if (!ended.empty()) child.kill();
  }
  descendants.end_all();
  answer.read();
  text.read();
  std::optional<Outcome> outcome = outcome_of(answer.end);
  if (outcome && ended.empty() && ending == Ending::as_programs_do) {
    if (const std::string wrong = ended_badly(end); !wrong.empty()) return {Status::fail, {wrong}};
  }
  if (ended.empty() && !end.signal_number()) {
    if (outcome) {
      if (outcome->status == Status::pass && text.bytes > much_text) {
        outcome->status = Status::warn;
        outcome->lines.push_back(
            fmt::format("wrote {} bytes to standard output and standard error: the log is for that", text.bytes));
      }
      return *outcome;
    }
    if (answer.bytes > 0) ended = "wrote into a file that is not its own";
  }
  Outcome out{Status::crash,
              {ended.empty() ? how_it_ended(end, deadline) : ended},
              !ended.empty() || end.out_of_processor_time()};
  if (const std::string place = note.read(); !place.empty()) out.lines.push_back("at: " + place);
  constexpr std::string_view of_memory = "memory: ";  // prefix of the testkit's message about a memory fault
  if (const std::string last = last_line(text.end); last.starts_with(of_memory)) {
    out.lines.push_back(last.substr(of_memory.size()));
  } else if (!last.empty()) {
    out.lines.push_back("it wrote: " + last);
  }
  return out;
}

}  // namespace

const char* word(Status status) {
  constexpr std::array words{"pass", "warn", "fail", "crash", "skip"};
  return words[static_cast<std::size_t>(status)];
}

bool Report::passed() const {
  return std::ranges::none_of(verdicts,
                              [](const Verdict& v) { return v.status == Status::fail || v.status == Status::crash; });
}

Underway::Underway() { text_.move_descriptor_up(own_descriptor); }
Underway::Underway(int number) : text_(process::FileDescriptor(number)) {}

void Underway::write(std::string_view text) {
  const std::size_t length = std::min(text.size(), text_->size() - 1);
  std::memcpy(text_->data(), text.data(), length);
  (*text_)[length] = '\0';
}

std::string Underway::read() const {
  // Makes the text visible, because a plugin may have overwritten it.
  return texts::visible_at_most(std::string_view(text_->data(), ::strnlen(text_->data(), text_->size())),
                                text_->size());
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

Outcome in_a_child(const std::function<Outcome()>& check, const Deadline& deadline, Underway& note, Ending ending) {
  return of_a_child([&](int answer) -> int { answer_and_end(check, answer, ending); }, deadline, note, ending);
}

Outcome in_another_program(std::vector<std::string> words, const std::vector<std::string>& environment,
                           const Deadline& deadline, Underway& note) {
  const auto become = [&](int answer) -> int {
    for (const int kept : {answer, note.number()}) ::fcntl(kept, F_SETFD, 0);
    words.insert(words.end(), {std::to_string(answer), std::to_string(note.number())});
    ::execve(process::Child::this_program, process::pointers(words).data(), process::pointers(environment).data());
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
                       const std::function<Outcome(Underway&)>& check) {
  process::default_signals();  // this program ignores some signals from its start
  constexpr std::uint64_t most = 1'000'000;
  const auto number = [](const std::string& text) {
    return static_cast<int>(config::parse_whole("number", text, own_descriptor, most));
  };
  const int to = number(answer);
  const int about = number(note);
  for (const int each : {to, about}) {
    if (::fcntl(each, F_GETFD) == -1) throw config::BadInput("this command is for the program itself");
  }
  Underway shared(about);
  for (const int each : {to, shared.number()}) ::fcntl(each, F_SETFD, FD_CLOEXEC);
  answer_and_end([&] { return check(shared); }, to, Ending::at_once);
}

Outcome leaving_the_process_alone(const std::function<Outcome()>& check) {
  const auto numbers = plugin::FloatingPointState::now();
  plugin::keep_orphans();
  const auto before = plugin::ProcessState::now();
  Outcome out = check();
  for (const std::string& changed :
       {plugin::FloatingPointState::now().changed_from(numbers), plugin::changes_since(before)}) {
    if (changed.empty()) continue;
    out.status = Status::fail;
    out.lines.push_back(changed);
  }
  return out;
}

std::size_t (*count_allocations())() {
#ifdef REGISTA_SANITIZED
  return nullptr;
#else
  testkit::counting = true;
  return [] { return testkit::allocations; };
#endif
}

}  // namespace regista::check
