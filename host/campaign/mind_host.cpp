// SPDX-License-Identifier: MIT
#include "campaign/mind_host.hpp"

#include <regista/extensions/log.h>
#include <unistd.h>

#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "campaign/belief_wire.hpp"
#include "campaign/job.hpp"
#include "match/decision_digest.hpp"
#include "match/mind_belief.hpp"
#include "match/teams.hpp"
#include "mind/wire.hpp"
#include "plugin/failure.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/process_state.hpp"

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
  MindHost(const mind::TeamPlan& plan, match::Side side, std::uint64_t seed, const Examination& examination,
           MindChannel& channel)
      : side_(static_cast<int>(match::index(side))), examination_(examination), channel_(channel) {
    minds_ = match::minds(plan, side, seed, {&channel.note().call, side_, examination.closely},
                          {.whole_frame = examination.digest_decisions,
                           .log = mind::to_standard_error(REGISTA_LOG_WARNING, mind::most_kept_of_log)});
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
      case Question::finish:
        minds_.clear();
        channel_.note().call = {};
        break;
    }
  }
  std::span<const std::uint8_t> bytes() const { return out_.bytes(); }

 private:
  mind::Mind& mind() { return minds_.at(static_cast<std::size_t>(channel_.robot() - 1)); }

  void decide() {
    config::BytesIn in(channel_.bytes());
    in(percepts_);
    mind::read_heard(in, heard_);
    outcome_.clear();
    mind().think(percepts_, heard_, outcome_);
    out_(outcome_);
    if (!examination_.digest_decisions) return;
    for (const std::uint64_t each : match::digest_of(mind(), outcome_)) out_(each);
  }

  int side_;
  Examination examination_;
  MindChannel& channel_;
  std::vector<mind::Mind> minds_;
  mind::Percepts percepts_;
  std::vector<mind::HeardPacket> heard_;
  mind::Outcome outcome_;
  match::Belief belief_;
  config::BytesOut out_;
};

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

void serve_minds(const mind::TeamPlan& plan, match::Side side, std::uint64_t seed, const Examination& examination,
                 MindChannel& channel) noexcept {
  const int number = static_cast<int>(match::index(side));
  plugin::note_fatal_signals(channel.note().fatal);
  const plugin::ProcessState before = plugin::ProcessState::now();
  try {
    // Never destroyed but by the last question: what a plugin has damaged must not end this process before it has said
    // which one it was.
    MindHost& host = *new MindHost(plan, side, seed, examination, channel);
    for (;;) {
      channel.answer(Reply::done, host.bytes());
      channel.wait_for_question();
      const bool last = channel.question() == Question::finish;
      host.answer();
      if (!last) continue;
      const std::string left = plugin::changes_since(before);
      if (left.empty()) {
        channel.answer(Reply::done, {});
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
