// SPDX-License-Identifier: MIT
// A process for minds of one team, which answers the questions of a match until the match ends the process. The channel
// between match and minds is shared memory; each question wakes the minds, and each reply wakes the match. The channel
// has no file descriptor, so a plugin that closes all descriptors does not close the channel.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "match/metrics_world.hpp"
#include "match/side.hpp"
#include "mind/team_plan.hpp"
#include "texts/bytes.hpp"

// Converts the beliefs of a mind to bytes and back: see texts/bytes.hpp.
namespace regista::match {

template <class Archive>
void visit(Archive& archive, Vector& vector) {
  archive(vector.x, vector.y);
}

template <class Archive>
void visit(Archive& archive, Estimate& estimate) {
  archive(estimate.known, estimate.at, estimate.xx, estimate.xy, estimate.yy);
}

template <class Archive>
void visit(Archive& archive, Belief& belief) {
  archive(belief.self, belief.ball, belief.teammates, belief.opponents);
}

}  // namespace regista::match

namespace regista::campaign {

// A question of the match, and what the bytes of the question and of the answer contain.
enum class Question : std::uint32_t {
  decide,   // question: percepts and packets of a robot; answer: the outcome
  believe,  // question: nothing; answer: the belief of a robot
  finish,   // question: nothing; answer: the variables of plugin files that have changed. Ends the minds.
};

enum class Reply : std::uint32_t {
  done,       // the bytes of the reply are the answer
  failed,     // the bytes of the reply are a Failure as JSON
  no_memory,  // there are no bytes, because the process has no memory left
};

// The channel between a match and its minds, created before the process is copied. Throws std::system_error.
class MindChannel {
 public:
  WorkerNote& note() const { return shared_->note; }
  // Removes the channel from this process, but not from its copies. No other member may be used afterwards.
  void forget() { shared_.forget(); }

  // --- The match's side

  // Sends a question for one robot to the minds and wakes them. `bytes` must not be longer than most_bytes.
  void ask(Question question, int robot, std::span<const std::uint8_t> bytes);
  bool replied() const { return shared_->turn.load(std::memory_order_acquire) == match_turn; }
  // Sleeps until the minds reply, a signal arrives, or `seconds` are over.
  void wait_for_reply(double seconds);
  Reply reply() const { return static_cast<Reply>(shared_->kind); }

  // --- The minds' side

  void wait_for_question();
  Question question() const { return static_cast<Question>(shared_->kind); }
  int robot() const { return shared_->robot; }
  void answer(Reply kind, std::span<const std::uint8_t> bytes);

  // Returns the bytes that this side received last. They are valid until this side asks or answers.
  std::span<const std::uint8_t> bytes() const;

  static constexpr std::size_t most_bytes = std::size_t{1} << 20;

 private:
  static constexpr std::uint32_t match_turn = 0, minds_turn = 1;
  struct Shared {
    std::atomic<std::uint32_t> turn{minds_turn};  // the minds send the first reply when they have been created
    std::uint32_t kind = 0;
    std::int32_t robot = 0;
    std::uint32_t size = 0;
    WorkerNote note;
    std::uint8_t bytes[most_bytes];
  };
  void hand_over(std::uint32_t turn, std::uint32_t kind, std::span<const std::uint8_t> bytes);
  process::SharedMemory<Shared> shared_{process::for_copies};
};

// The minds of one process: all minds of one side, or one mind.
struct MindPlace {
  match::Side side = match::Side::home;
  int robot = 0;  // number, from 1; 0: all robots of the side
};

// Serves minds in a fresh copy of the match's process. The first answer tells the match that the minds have been
// created. If the job has a trail, each outcome comes with the answers of plugins. Minds that are alone in a process
// are confined (process/confinement.hpp): the note gets their first try to reach outside, and at the end they report
// changed variables of plugin files. Throws nothing and never returns, because its callers belong to the match.
[[noreturn]] void serve_minds(const mind::TeamPlan& plan, const MindPlace& place, const Job& job,
                              MindChannel& channel) noexcept;

}  // namespace regista::campaign
