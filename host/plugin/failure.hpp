// SPDX-License-Identifier: MIT
// A plugin that failed during a match: it said so, or what it handed back breaks a promise of <regista/abi.h>. Ends the
// match with a line that says who, when and what.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "plugin/answer_rooms.hpp"
#include "plugin/call_note.hpp"
#include "plugin/found.hpp"

namespace regista::plugin {

// For whom a plugin works at the moment. Owned by the mind.
struct Caller {
  std::string team;
  int robot = 0;
  std::uint64_t tick = 0;
  Noting noting{};               // where its calls are noted
  AnswerRooms* rooms = nullptr;  // of its plugins; null: each has its own
  bool decides = false;          // since its first decision began

  // At the beginning of each decision.
  void begin_decision() {
    if (rooms != nullptr) rooms->closely = looks_closely();
    decides = true;
    note();
  }
  // Primes, so that no plugin's period keeps it away from all of these decisions.
  bool looks_closely() const {
    constexpr std::uint64_t seldom = 127, often = 13;
    if (noting.look == Look::seldom) return tick % seldom == 0;
    return noting.look != Look::often || (tick + static_cast<std::uint64_t>(robot)) % often == 0;
  }

  // Notes for whom the next calls are, whichever plugin's.
  void note() const {
    if (noting.note == nullptr) return;
    noting.note->robot = robot;
    noting.note->side = noting.side;
    noting.note->tick = tick;
    noting.note->instance = nullptr;
  }
};

// what() is one line:
//   plugin greedy (lib/greedy.so) of team paper, robot 3, tick 417: assign: column 2 given to rows 0 and 4
class Failure : public std::runtime_error {
 public:
  // `caller` may be null: nobody in particular.
  Failure(const Found& plugin, const Caller* caller, std::string call, std::string message);

  const std::string& id() const { return id_; }
  const std::filesystem::path& file() const { return file_; }
  const std::optional<Caller>& caller() const { return caller_; }
  const std::string& call() const { return call_; }        // e.g. "assign"
  const std::string& message() const { return message_; }  // what went wrong, without who and when

 private:
  std::string id_;
  std::filesystem::path file_;
  std::optional<Caller> caller_;
  std::string call_, message_;
};

}  // namespace regista::plugin
