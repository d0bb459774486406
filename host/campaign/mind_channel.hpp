// SPDX-License-Identifier: MIT
// The way between a match and the minds of one team in a process of their own: shared memory, and a wake-up each way
// for each question. No file descriptor is needed, so a plugin that closes all of them cuts nothing off.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "campaign/worker_note.hpp"

namespace regista::campaign {

enum class Question : std::uint32_t {
  decide,   // percepts and packets of a robot -> outcome
  believe,  // nothing -> belief of a robot
  finish,   // nothing -> what the minds left behind
};

enum class Reply : std::uint32_t {
  done,       // the bytes are the answer
  failed,     // the bytes are a Failure as JSON
  no_memory,  // nothing more could be said
};

// To be made before the process is copied; throws std::system_error.
class MindChannel {
 public:
  WorkerNote& note() const { return shared_->note; }
  // Takes it away from this process; a copy may still have it. Nothing may be asked of it afterwards.
  void forget() { shared_.forget(); }

  // --- The match's side

  // Hands a question over; the minds may reply from now on. `bytes` must not be longer than most_bytes.
  void ask(Question question, int robot, std::span<const std::uint8_t> bytes);
  bool replied() const { return shared_->turn.load(std::memory_order_acquire) == match_turn; }
  // Sleeps until there is a reply, a signal arrives, or so many seconds are over.
  void wait_for_reply(double seconds);
  Reply reply() const { return static_cast<Reply>(shared_->kind); }

  // --- The minds' side

  void wait_for_question();
  Question question() const { return static_cast<Question>(shared_->kind); }
  int robot() const { return shared_->robot; }
  void answer(Reply kind, std::span<const std::uint8_t> bytes);

  // What the other side handed over last; valid until the own next word.
  std::span<const std::uint8_t> bytes() const;

  static constexpr std::size_t most_bytes = std::size_t{1} << 20;

 private:
  static constexpr std::uint32_t match_turn = 0, minds_turn = 1;
  struct Shared {
    std::atomic<std::uint32_t> turn{minds_turn};  // the minds begin: they are being created
    std::uint32_t kind = 0;
    std::int32_t robot = 0;
    std::uint32_t size = 0;
    WorkerNote note;
    std::uint8_t bytes[most_bytes];
  };
  void hand_over(std::uint32_t turn, std::uint32_t kind, std::span<const std::uint8_t> bytes);
  process::SharedMemory<Shared> shared_{process::for_copies};
};

}  // namespace regista::campaign
