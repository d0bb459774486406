// SPDX-License-Identifier: MIT
#include "campaign/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "campaign/file_descriptor.hpp"
#include "campaign/process.hpp"
#include "campaign/whole_text.hpp"
#include "campaign/worker_process.hpp"

namespace regista::campaign {
namespace {

// A match is answered in some ten kilobytes; who writes without end is stopped.
constexpr std::size_t longest_answer = std::size_t{16} << 20;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

// The job as a file without a name, from its beginning: unlike a pipe it never fills.
int file_of(const std::string& text) {
  FileDescriptor file(memfd_create("regista-job", MFD_CLOEXEC));
  if (file.number == -1) fail("cannot hand over a match");
  if (!write_all(file.number, text)) fail("cannot hand over a match");
  lseek(file.number, 0, SEEK_SET);
  return file.release();
}

struct Start {
  WorkerFiles files;
  int job;
  pid_t coordinator;
  bool elsewhere;
};

// Between fork and exec: only calls that are safe in a signal handler.
[[noreturn]] void execute_worker(const Start& start, const Limits& limits) {
  constexpr int cannot = 127;
  const int job = fcntl(start.job, F_DUPFD, 10);
  if (job == -1 || !become_worker(start.files, limits, start.coordinator)) _exit(cannot);
  if (dup2(job, STDIN_FILENO) == -1) _exit(cannot);
  close(job);
  // The program that runs now, even when its file has been replaced meanwhile.
  std::array<char, 8> name{"regista"};
  std::array<char, 16> command{};
  std::strncpy(command.data(), worker_command, command.size() - 1);
  char* const arguments[] = {name.data(), command.data(), nullptr};
  // What a match must not depend on is another than in the first play: where its memory is, too.
  static char padding[4096] = "REGISTA_SECOND_PLAY=";
  memset(padding + 20, 'x', sizeof padding - 21);
  execve("/proc/self/exe", arguments,
         start.elsewhere ? environment_with({padding}, Pages::usual) : environment_with({}));
  _exit(cannot);
}

pid_t start_program(const Start& start, const Limits& limits) {
  const pid_t process = fork();
  if (process == -1) fail("cannot start a worker");
  if (process == 0) execute_worker(start, limits);
  return process;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Worker::Worker(const Job& job, const Limits& limits, SharedNote& note, int trail, ForkServer* server)
    : limits_(limits), note_(note), isolated_(job.isolated) {
  note_.clear();
  const FileDescriptor given(file_of(to_json(job)));
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) == -1) fail("cannot make a pipe");
  FileDescriptor reading(ends[0]);
  const FileDescriptor writing(ends[1]);
  std::array<int, 2> output_ends{};
  if (pipe2(output_ends.data(), O_CLOEXEC) == -1) fail("cannot make a pipe");
  FileDescriptor reading_output(output_ends[0]);
  const FileDescriptor writing_output(output_ends[1]);
  // The reading ends alone: what the worker inherits must block.
  fcntl(reading.number, F_SETFL, O_NONBLOCK);
  fcntl(reading_output.number, F_SETFL, O_NONBLOCK);
  const WorkerFiles files{writing.number, note.descriptor(), writing_output.number, trail};
  if (server != nullptr) process_ = server->start(job, given.number, files);
  if (process_ == -1) {
    // A server that has died may have begun it.
    note_.clear();
    if (trail != -1 && (ftruncate(trail, 0) == -1 || lseek(trail, 0, SEEK_SET) == -1))
      fail("cannot begin a match anew");
    process_ = start_program({files, given.number, getpid(), job.elsewhere}, limits);
  }
  setpgid(process_, process_);  // whoever of the two comes first
  pipe_ = reading.release();
  output_pipe_ = reading_output.release();
}

Worker::~Worker() {
  if (process_ != -1) {
    kill();
    while (waitpid(process_, nullptr, 0) == -1 && errno == EINTR) {
    }
  }
  if (pipe_ != -1) close(pipe_);
  if (output_pipe_ != -1) close(output_pipe_);
}

void Worker::kill() {
  // The whole group: a plugin may have started processes of its own. So may the minds of an isolated match.
  end_group(process_);
  if (!isolated_) return;  // plugins can write that note; where minds are apart, they have lost sight of it
  for (const pid_t each : note_.note().groups) {
    if (each > 1) ::kill(-each, SIGKILL);
  }
}

// Bounded, as a plugin may write without end.
void Worker::read() {
  std::array<char, 65536> buffer;
  for (int i = 0; i < 16 && pipe_ != -1; ++i) {
    const ssize_t count = ::read(pipe_, buffer.data(), buffer.size());
    if (count > 0) {
      if (answer_.size() < longest_answer) answer_.append(buffer.data(), static_cast<std::size_t>(count));
      continue;
    }
    if (count == -1 && errno == EINTR) continue;
    if (count == -1 && errno == EAGAIN) return;
    close(pipe_);
    pipe_ = -1;
  }
}

// Bounded, and never waited for: a process that a plugin started may hold the pipe open.
void Worker::read_output() {
  std::array<char, 65536> buffer;
  for (int i = 0; i < 16 && output_pipe_ != -1; ++i) {
    const ssize_t count = ::read(output_pipe_, buffer.data(), buffer.size());
    if (count > 0) {
      output_.add({buffer.data(), static_cast<std::size_t>(count)});
      continue;
    }
    if (count == -1 && errno == EINTR) continue;
    if (count == -1 && errno == EAGAIN) return;
    close(output_pipe_);
    output_pipe_ = -1;
  }
}

bool Worker::advance() {
  if (process_ == -1) return true;
  read();
  read_output();
  int status = 0;
  rusage usage{};
  const pid_t waited = wait4(process_, &status, WNOHANG | WUNTRACED, &usage);
  if (waited == process_ && WIFSTOPPED(status)) {
    killed_for_ = End::How::stopped;
    kill();
    return false;
  }
  if (waited == process_) {
    kill();  // what it has started
    read();  // what it wrote last
    read_output();
    process_ = -1;
    ended(status, seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime));
    return true;
  }
  if (!killed_for_) watch_call();
  return false;
}

// Who plays an isolated match watches its minds, and knows whose fault it is.
double Worker::match_wall_seconds() const {
  return isolated_ ? 2.0 * limits_.match_wall_seconds + limits_.wall_seconds : limits_.match_wall_seconds;
}

void Worker::watch_call() {
  if (isolated_) {
    call_began_ = Clock::now();  // it notes no calls of its own
    if (std::chrono::duration<double>(Clock::now() - began_).count() <= match_wall_seconds()) return;
    killed_for_ = End::How::match_wall_time;
    kill();
    return;
  }
  const plugin::CallNote now = note_.note().call;
  const double processor = processor_seconds_of(process_);
  if (now != call_) {
    call_ = now;
    call_began_ = Clock::now();
    processor_at_call_ = processor;
  }
  const bool working = processor - processor_at_call_ > static_cast<double>(limits_.processor_seconds);
  if (now.inside == 1 && working) killed_for_ = End::How::processor_time;
  if (std::chrono::duration<double>(Clock::now() - call_began_).count() > limits_.wall_seconds) {
    killed_for_ = End::How::wall_time;
  }
  if (std::chrono::duration<double>(Clock::now() - began_).count() > match_wall_seconds()) {
    killed_for_ = End::How::match_wall_time;
  }
  if (killed_for_) kill();
}

void Worker::ended(int status, double processor_seconds) {
  end_.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  end_.note = note_.note().call;
  end_.note.plugin.back() = end_.note.call.back() = '\0';
  plugin::FatalNote fatal = note_.note().fatal;
  fatal.thread.back() = fatal.object.back() = '\0';
  end_.output = output_.text();
  const bool complete = answer_.ends_with('\n') && answer_.size() < longest_answer;
  // What stands before the mark is not the worker's: a plugin wrote to a descriptor that it took for its own.
  if (const std::size_t mark = answer_.rfind(answer_mark); mark != std::string::npos) {
    answer_.erase(0, mark + answer_mark.size());
  }
  if (WIFEXITED(status)) {
    if (complete && WEXITSTATUS(status) == 0) {
      end_.how = End::How::answered;
      end_.text = std::move(answer_);
      return;
    }
    end_.how = End::How::died;
    end_.text = fmt::format("ended the process (exit code {})", WEXITSTATUS(status));
    return;
  }
  const int signal_number = WTERMSIG(status);
  if (killed_for_ == End::How::wall_time) {
    end_.how = End::How::wall_time;
    end_.text = fmt::format("did not return within {:.0f} s", limits_.wall_seconds);
  } else if (killed_for_ == End::How::match_wall_time) {
    end_.how = End::How::match_wall_time;
    end_.text = fmt::format("a match did not end within {:.0f} s", limits_.match_wall_seconds);
  } else if (killed_for_ == End::How::stopped) {
    end_.how = End::How::stopped;
    end_.text = "was stopped";
  } else if (killed_for_) {
    end_.how = End::How::processor_time;
    end_.text = fmt::format("used more than {} s of processor time", limits_.processor_seconds);
  } else if (signal_number == SIGXCPU ||
             (signal_number == SIGKILL && processor_seconds >= static_cast<double>(limits_.match_seconds()))) {
    end_.how = End::How::match_time;
    end_.text = fmt::format("a match used more than {} s of processor time, though no single call more than {} s",
                            limits_.match_seconds(), limits_.processor_seconds);
  } else {
    end_.how = comes_from_outside(signal_number) ? End::How::killed_from_outside : End::How::died;
    end_.text = strsignal(signal_number) + where(fatal);
  }
}

}  // namespace regista::campaign
