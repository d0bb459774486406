// SPDX-License-Identifier: MIT
#include "campaign/mind_host.hpp"

#include <regista/extensions/log.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "campaign/belief_wire.hpp"
#include "campaign/job.hpp"
#include "match/mind_belief.hpp"
#include "match/teams.hpp"
#include "mind/wire.hpp"
#include "plugin/address_ranges.hpp"
#include "plugin/failure.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/own_memory.hpp"
#include "plugin/process_state.hpp"
#include "process/confinement.hpp"

namespace regista::campaign {
namespace {

Failure failure_of(const plugin::Failure& failure, int side) {
  Failure out{side, failure.id(), failure.call(), 0, 0, failure.message()};
  if (failure.caller()) {
    out.robot = failure.caller()->robot;
    out.tick = failure.caller()->tick;
  }
  return out;
}

// Whatever came out of a call that is not a plugin's own word.
Failure failure_of(const plugin::CallNote& note, int side, const char* what) {
  return {side, note.plugin.data(), note.call.data(), note.robot, note.tick, what};
}

class MindHost {
 public:
  MindHost(const mind::TeamPlan& plan, const MindPlace& place, std::uint64_t seed, const Examination& examination,
           MindChannel& channel)
      : first_(std::max(place.robot, 1)),
        answers_wanted_(examination.answers),
        looks_at_memory_(examination.confined),
        channel_(channel) {
    const plugin::Noting noting{&channel.note().call, static_cast<std::int32_t>(match::index(place.side)),
                                examination.look, answers_wanted_ ? &answers_ : nullptr, examination.hides};
    const mind::Telling telling{.log = mind::to_standard_error(REGISTA_LOG_WARNING, mind::most_kept_of_log)};
    if (place.robot == 0)
      minds_ = match::minds(plan, place.side, seed, noting, telling);
    else
      minds_.push_back(match::mind(plan, place.side, place.robot, seed, noting, telling));
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

  // What is made once, at its first use, is no news.
  void remember_memory() {
    for (const void* const object : plugin::noted_objects()) memory_.emplace_back(object).remember();
  }
  // "greedy.so: taken, worst.so"; mostly empty.
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

// Handlers of signals take no arguments of ours.
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

// In a handler: what went wrong, as a failure.
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

void serve_minds(const mind::TeamPlan& plan, const MindPlace& place, std::uint64_t seed, const Examination& examination,
                 MindChannel& channel) noexcept {
  const int number = static_cast<int>(match::index(place.side));
  plugin::note_fatal_signals(channel.note().fatal);
  if (examination.confined) confine(channel.note());
  plugin::keep_orphans();
  const plugin::ProcessState before = plugin::ProcessState::now();
  const pid_t here = ::getpid();
  try {
    // Never destroyed but by the last question: what a plugin has damaged must not end this process before it has said
    // which one it was.
    MindHost& host = *new MindHost(plan, place, seed, examination, channel);
    for (;;) {
      channel.answer(Reply::done, host.bytes());
      channel.wait_for_question();
      const bool last = channel.question() == Question::finish;
      host.answer();
      if (::getpid() != here) ::_exit(1);  // a plugin has doubled the process: one of the two is enough
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
    // A plugin may have taken all memory, so that not even this can be said.
    try {
      answer_what_was_thrown(channel, number);
    } catch (...) {
      channel.answer(Reply::no_memory, {});
    }
  }
  for (;;) pause();  // whoever asked ends this process
}

}  // namespace regista::campaign
