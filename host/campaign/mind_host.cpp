// SPDX-License-Identifier: MIT
#include "campaign/mind_host.hpp"

#include <linux/futex.h>
#include <regista/extensions/log.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "match/teams.hpp"
#include "mind/serialization.hpp"
#include "plugin/elf_file.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/process_state.hpp"
#include "process/confinement.hpp"

namespace regista::campaign {
namespace {

// FUTEX_PRIVATE_FLAG is not set, because two processes share the word.
void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t value, const timespec* at_most) {
  syscall(SYS_futex, &word, FUTEX_WAIT, value, at_most, nullptr, 0);
}

void wake(std::atomic<std::uint32_t>& word) { syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0); }

Failure failure_of(const plugin::Failure& failure, int side) {
  Failure out{side, failure.id(), failure.call(), 0, 0, failure.message()};
  if (failure.caller()) {
    out.robot = failure.caller()->robot;
    out.tick = failure.caller()->tick;
  }
  return out;
}

// Returns the failure for an exception that is not a plugin::Failure.
Failure failure_of(const plugin::CallNote& note, int side, const char* what) {
  return {side, note.plugin.data(), note.call.data(), note.robot, note.tick, what};
}

bool is_confined(const Job& job) { return job.separation == Separation::robots; }

class MindHost {
 public:
  MindHost(const mind::TeamPlan& plan, const MindPlace& place, const Job& job, MindChannel& channel)
      : first_(std::max(place.robot, 1)),
        answers_wanted_(job.trail),
        looks_at_memory_(is_confined(job)),
        channel_(channel) {
    const plugin::CallTracing tracing{&channel.note().call, static_cast<std::int32_t>(match::index(place.side)),
                                      job.look, answers_wanted_ ? &answers_ : nullptr, job.hides};
    const mind::MindOptions telling{.log = mind::to_standard_error(REGISTA_LOG_WARNING, mind::most_kept_of_log)};
    if (place.robot == 0)
      minds_ = match::minds(plan, place.side, job.seed, tracing, telling);
    else
      minds_.push_back(match::mind(plan, place.side, place.robot, job.seed, tracing, telling));
  }

  void answer() {
    out_.clear();
    switch (channel_.question()) {
      case Question::decide:
        decide();
        break;
      case Question::believe:
        match::belief_of(mind(), belief_);
        out_(belief_);
        break;
      case Question::finish: {
        std::string kept = kept_in_files();
        minds_.clear();
        channel_.note().call = {};
        out_(kept);
        break;
      }
    }
  }
  std::span<const std::uint8_t> bytes() const { return out_.bytes(); }

 private:
  mind::Mind& mind() { return minds_.at(static_cast<std::size_t>(channel_.robot() - first_)); }

  void decide() {
    texts::BytesIn in(channel_.bytes());
    in(percepts_);
    mind::read_heard(in, heard_);
    outcome_.clear();
    answers_.clear();
    if (looks_at_memory_ && decisions_++ == decisions_before_memory) remember_memory();
    mind().think(percepts_, heard_, outcome_);
    out_(outcome_);
    if (answers_wanted_) out_(answers_);
  }

  // Called after some decisions, because data that a plugin creates at its first use do not count as a change.
  void remember_memory() {
    for (const void* const object : plugin::noted_objects()) memory_.emplace_back(object).remember();
  }
  // Returns the files and variables that have changed: "greedy.so: taken, worst.so"; usually empty.
  std::string kept_in_files() const {
    std::string out;
    for (const plugin::OwnMemory& each : memory_) {
      const auto change = each.change();
      if (!change) continue;
      const std::string variable = plugin::variable_at(each.file(), *change);
      out += (out.empty() ? "" : ", ") + each.file().filename().string() + (variable.empty() ? "" : ": " + variable);
    }
    return out;
  }

  static constexpr int decisions_before_memory = 50;
  int first_;  // number of the first mind
  bool answers_wanted_, looks_at_memory_;
  int decisions_ = 0;
  std::vector<plugin::OwnMemory> memory_;
  MindChannel& channel_;
  plugin::CallTrail answers_;
  std::vector<mind::Mind> minds_;
  mind::Percepts percepts_;
  std::vector<mind::HeardPacket> heard_;
  mind::Outcome outcome_;
  match::Belief belief_;
  texts::BytesOut out_;
};

// This variable is global, because a signal handler can use only global variables.
std::atomic<WorkerNote*> tries{nullptr};

void note_try(const char* what) {
  WorkerNote& note = *tries;
  if (note.outside.what.front() != '\0') return;
  note.outside.call = note.call;
  std::strncpy(note.outside.what.data(), what, note.outside.what.size() - 1);
}

void confine(WorkerNote& note) {
  tries = &note;
  if (!process::confine(note_try)) note.outside.unconfined = 1;
}

void answer_failed(MindChannel& channel, const Failure& failure) {
  const std::string text = to_json(failure);
  channel.answer(Reply::failed, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// Must be called in a catch clause. Answers the question with the current exception as a failure.
void answer_what_was_thrown(MindChannel& channel, int number) {
  try {
    throw;
  } catch (const plugin::Failure& failure) {
    answer_failed(channel, failure_of(failure, number));
  } catch (const std::bad_alloc&) {
    channel.answer(Reply::no_memory, {});
  } catch (const std::exception& error) {
    answer_failed(channel, failure_of(channel.note().call, number, error.what()));
  } catch (...) {
    answer_failed(channel, failure_of(channel.note().call, number, "something that is no exception was thrown"));
  }
}

}  // namespace

void MindChannel::hand_over(std::uint32_t turn, std::uint32_t kind, std::span<const std::uint8_t> bytes) {
  assert(bytes.size() <= most_bytes);
  shared_->kind = kind;
  shared_->size = static_cast<std::uint32_t>(bytes.size());
  if (!bytes.empty()) std::memcpy(shared_->bytes, bytes.data(), bytes.size());
  shared_->turn.store(turn, std::memory_order_release);
  wake(shared_->turn);
}

void MindChannel::ask(Question question, int robot, std::span<const std::uint8_t> bytes) {
  shared_->robot = robot;
  hand_over(minds_turn, static_cast<std::uint32_t>(question), bytes);
}

void MindChannel::wait_for_reply(double seconds) {
  if (replied()) return;
  const auto whole = static_cast<std::time_t>(seconds);
  const timespec at_most{whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
  sleep_while(shared_->turn, minds_turn, &at_most);
}

void MindChannel::wait_for_question() {
  while (shared_->turn.load(std::memory_order_acquire) != minds_turn) sleep_while(shared_->turn, match_turn, nullptr);
}

void MindChannel::answer(Reply kind, std::span<const std::uint8_t> bytes) {
  hand_over(match_turn, static_cast<std::uint32_t>(kind), bytes);
}

// A plugin in the other process may have overwritten `size`, so this function limits `size`.
std::span<const std::uint8_t> MindChannel::bytes() const {
  return std::span(shared_->bytes).first(std::min<std::size_t>(shared_->size, most_bytes));
}

void serve_minds(const mind::TeamPlan& plan, const MindPlace& place, const Job& job, MindChannel& channel) noexcept {
  const int number = static_cast<int>(match::index(place.side));
  plugin::note_fatal_signals(channel.note().fatal);
  if (is_confined(job)) confine(channel.note());
  plugin::keep_orphans();
  const plugin::ProcessState before = plugin::ProcessState::now();
  const pid_t here = ::getpid();
  try {
    // The host is never destroyed; only Question::finish ends its minds. A destructor in a damaged process could end
    // the process before the process has reported the plugin.
    MindHost& host = *new MindHost(plan, place, job, channel);
    for (;;) {
      channel.answer(Reply::done, host.bytes());
      channel.wait_for_question();
      const bool last = channel.question() == Question::finish;
      host.answer();
      if (::getpid() != here) ::_exit(1);  // this is the child of a fork() by a plugin
      if (!last) continue;
      const std::string left = plugin::changes_since(before);
      if (left.empty()) {
        channel.answer(Reply::done, host.bytes());
      } else {
        answer_failed(channel, {number, "", "", 0, 0, left});
      }
      break;
    }
  } catch (...) {
    // A plugin may have taken all memory, so that even the answer fails.
    try {
      answer_what_was_thrown(channel, number);
    } catch (...) {
      channel.answer(Reply::no_memory, {});
    }
  }
  for (;;) pause();  // the match ends this process
}

}  // namespace regista::campaign
