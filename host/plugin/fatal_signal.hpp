// SPDX-License-Identifier: MIT
// Records where a process died: the thread, and the shared object whose code ran. The dying process writes this record
// into memory that another process reads. A global table has the addresses of shared objects, because a signal handler
// gets no arguments from the host. note_address_range() fills the table when the host loads a file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors.hpp"
#include "plugin/answer_buffers.hpp"
#include "plugin/call_inputs.hpp"
#include "plugin/description.hpp"

namespace regista::plugin {

// The name of a file, such as "voronoi.so", cut if it is too long. The name ends with a zero.
using ObjectName = std::array<char, 64>;

// Stores the address range of the shared object that `handle` (from dlopen) refers to. Ignores objects after the 256th.
void note_address_range(void* handle);

// Returns one address in each stored object, in the order of note_address_range(). Not safe in a signal handler.
std::vector<const void*> noted_objects();

// Returns the name of the stored object that contains this address, or null. Safe in a signal handler.
const ObjectName* object_at(std::uintptr_t address);

// What is known about the death of a process, as plain bytes. If all bytes are zero, nothing is known.
struct FatalNote {
  std::int32_t signal = 0;        // 0: no signal
  std::int32_t exited = 0;        // 1: some code called exit()
  std::int32_t other_thread = 0;  // 1: the process died in a thread that does not call plugins
  std::int32_t heap = 0;          // 1: the C library crashed in a heap function, or aborted because of a damaged heap
  std::array<char, 16> thread{};  // name of the thread; ends with a zero
  ObjectName object{};            // stored object whose code ran or called the code that ran; empty: unknown
  friend bool operator==(const FatalNote&, const FatalNote&) = default;
};

// Makes the process write a fatal signal or a call of exit() to `note` before the process ends. `note` must live as
// long as the process. Under a sanitizer, which has its own handlers, no signal is written.
void note_fatal_signals(FatalNote& note);

// Returns whether the process died in the code of `file` (a name without folders), or in code that `file` called. False
// for a death in another thread, in another file's signal handler, or by a damaged heap (any plugin may be the cause).
bool ended_in(const FatalNote& note, std::string_view file);

// Returns a text such as ", in thread \"worker\", in crashes_later.so"; empty if the note is empty.
std::string where(const FatalNote& note);

// --- The failure of a plugin in a match: the plugin reported a failure, or its answer broke a promise of
// <regista/abi.h>. A failure ends the match. Its message is one line with plugin, robot, tick and mistake.

// The robot for which a plugin works at the moment. The robot's mind owns this object.
struct Caller {
  std::string team;
  int robot = 0;
  std::uint64_t tick = 0;
  CallTracing tracing{};           // what the host records and inspects of the robot's calls
  AnswerBuffers* rooms = nullptr;  // buffers that the robot's plugins share; null: each instance has its own
  bool decides = false;            // true once the first decision has begun

  // The robot's mind must call this function at the beginning of each decision.
  void begin_decision() {
    if (rooms != nullptr) rooms->strict = looks_closely();
    decides = true;
    note();
  }
  // Returns whether the host inspects the calls of this decision closely. The intervals are primes, so a plugin that
  // misbehaves at a regular interval misbehaves in an inspected call sooner or later.
  bool looks_closely() const {
    constexpr std::uint64_t seldom = 127, often = 13;
    if (tracing.look == Inspection::seldom) return tick % seldom == 0;
    return tracing.look != Inspection::often || (tick + static_cast<std::uint64_t>(robot)) % often == 0;
  }

  void note() const {
    if (tracing.note == nullptr) return;
    tracing.note->robot = robot;
    tracing.note->side = tracing.side;
    tracing.note->tick = tick;
    tracing.note->instance = nullptr;
  }
};

// The failure of a plugin. what() is one line:
//   plugin greedy (lib/greedy.so) of team paper, robot 3, tick 417: assign: column 2 given to rows 0 and 4
class Failure : public std::runtime_error {
 public:
  // If `caller` is null, the failure names no robot.
  Failure(const Found& plugin, const Caller* caller, std::string call, std::string message);

  const std::string& id() const { return id_; }
  const std::filesystem::path& file() const { return file_; }
  const std::optional<Caller>& caller() const { return caller_; }
  const std::string& call() const { return call_; }        // name of the call, such as "assign"
  const std::string& message() const { return message_; }  // what went wrong, without plugin, robot and tick
  // The plugin's use in a document; without a file if the plugin was created or the use is not known.
  const config::Location& where() const { return where_; }
  void used_at(config::Location where) { where_ = std::move(where); }

 private:
  std::string id_;
  std::filesystem::path file_;
  std::optional<Caller> caller_;
  std::string call_, message_;
  config::Location where_;
};

}  // namespace regista::plugin
