// SPDX-License-Identifier: MIT
#include "campaign/worker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <optional>
#include <utility>

#include "campaign/decision_trail.hpp"
#include "campaign/fork_server.hpp"

namespace regista::campaign {

process::Setting worker_setting(const WorkerFiles& files, const Limits& limits) {
  process::Setting out;
  out.files = {{files.job, STDIN_FILENO},
               {files.output, STDERR_FILENO},
               {files.answer, answer_descriptor},
               {files.note, note_descriptor},
               {files.trail, trail_descriptor}};
  out.limits = memory_limits(limits);
  out.limits.processor_seconds = limits.match_seconds();
  return out;
}

std::vector<char*> environment(bool perturbed) {
  static char large_pages[] = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";
  static std::string padding = "REGISTA_SECOND_PLAY=" + std::string(4075, 'x');
  constexpr std::size_t name = std::string_view("GLIBC_TUNABLES=").size();
  std::vector<char*> variables;
  bool tuned = false;  // true: the user has set GLIBC_TUNABLES
  for (char** each = environ; *each != nullptr; ++each) {
    variables.push_back(*each);
    tuned = tuned || std::strncmp(*each, large_pages, name) == 0;
  }
  if (!tuned && !perturbed) variables.push_back(large_pages);
  if (perturbed) variables.push_back(padding.data());
  variables.push_back(nullptr);
  return variables;
}

namespace {

// Limit in bytes. The answer for a match has some ten kilobytes; the rest of a longer answer is not read.
constexpr std::size_t longest_answer = std::size_t{16} << 20;

}  // namespace

Worker::Worker(const Job& job, SharedNote& note, int trail, ForkServer* server)
    : limits_(job.limits),
      note_(note),
      apart_(job.is_apart()),
      watch_({limits_.processor_seconds, limits_.wall_seconds}) {
  const process::FileDescriptor given = process::memory_file(to_json(job));
  process::Pipe answer = process::make_pipe(), output = process::make_pipe();
  const WorkerFiles files{answer.write.number, note.descriptor(), output.write.number, trail, given.number};
  const auto empty_files = [&] {
    note_.clear();
    if (trail != -1) empty_trail(trail);
  };
  empty_files();
  if (server != nullptr) child_ = server->start(job, files);
  if (!child_.runs()) {
    empty_files();  // a fork server that died may have begun the match
    const std::vector<char*> variables = environment(job.perturbed);
    child_ = process::Child::program(worker_setting(files, limits_),
                                     {process::Child::this_program, {"regista", worker_command}, variables});
  }
  pipe_ = std::move(answer.read);
  output_pipe_ = std::move(output.read);
}

Worker::~Worker() {
  if (child_.runs()) kill();
}

void Worker::kill() {
  // Kills the whole process groups of worker and minds, because plugins may have started processes in these groups.
  child_.kill();
  if (!apart_) return;  // otherwise plugins run in the worker and may have overwritten `groups`
  for (const pid_t each : note_->groups) {
    if (each > 1) ::kill(-each, SIGKILL);
  }
}

// Reads only what the pipes contain now, because a process that a plugin started may keep the pipes open.
void Worker::read() {
  process::read_available(pipe_, [this](std::string_view piece) {
    if (answer_.size() < longest_answer) answer_ += piece;
  });
  process::read_available(output_pipe_, [this](std::string_view piece) { output_.add(piece); });
}

bool Worker::advance() {
  if (!child_.runs()) return true;
  read();
  const std::optional<process::ProcessEnd> end = child_.look();
  if (!end) {
    if (why_killed_.empty()) watch_call();
    return false;
  }
  if (end->was_stopped()) {
    stopped_ = true;
    why_killed_ = end->in_words();
    kill();
    return false;
  }
  kill();  // ends processes that the worker has started
  read();  // reads the last bytes that the worker wrote
  ended(*end);
  return true;
}

double Worker::seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

// Returns the limit of wall time, s. It is longer for a worker with minds in other processes, because this worker
// watches the minds itself and so knows which team causes a delay.
double Worker::match_wall_seconds() const {
  return apart_ ? 2.0 * limits_.match_wall_seconds + limits_.wall_seconds : limits_.match_wall_seconds;
}

void Worker::watch_call() {
  if (!apart_) {  // a worker with minds in other processes notes no calls
    const plugin::CallNote call = note_->call;
    const process::Exceeded exceeded = watch_.look(call, call.inside == 1, child_.process());
    if (exceeded != process::Exceeded::nothing) why_killed_ = watch_.in_words(exceeded);
  }
  if (seconds() > match_wall_seconds())
    why_killed_ = fmt::format("a match did not end within {:.0f} s", limits_.match_wall_seconds);
  if (!why_killed_.empty()) kill();
}

void Worker::ended(const process::ProcessEnd& end) {
  end_.seconds = seconds();
  const WorkerNote note = note_->sound();
  end_.note = note.call;
  end_.outside = note.outside;
  end_.output = output_.text();
  const bool complete = answer_.ends_with('\n') && answer_.size() < longest_answer;
  // A plugin may have written text before the mark, because it used a wrong descriptor.
  if (const std::size_t mark = answer_.rfind(answer_mark); mark != std::string::npos) {
    answer_.erase(0, mark + answer_mark.size());
  }
  if (complete && end.exited_with(0)) {
    end_.answered = true;
    end_.text = std::move(answer_);
    return;
  }
  const bool all_used = end.signal_number() == SIGKILL && end.processor_seconds >= limits_.match_seconds();
  if (!end.signal_number()) {
    end_.text = end.in_words();
  } else if (!why_killed_.empty()) {
    end_.from_outside = stopped_;
    end_.text = why_killed_;
  } else if (end.out_of_processor_time() || all_used) {
    end_.text = fmt::format("a match used more than {} s of processor time, though no single call more than {} s",
                            limits_.match_seconds(), limits_.processor_seconds);
  } else {
    end_.from_outside = end.from_outside();
    end_.text = end.in_words() + where(note.fatal);
  }
}

}  // namespace regista::campaign
