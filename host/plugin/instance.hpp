// SPDX-License-Identifier: MIT
// One living instance of a plugin: created, reset, called, destroyed. What it fails at becomes a Failure that names
// plugin, robot and tick. The typed calls of each kind stand in the header of that kind; several of them may share one
// instance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include <regista/abi.h>

#include "plugin/answer_rooms.hpp"
#include "plugin/call_note.hpp"
#include "plugin/descriptor.hpp"
#include "plugin/failure.hpp"
#include "plugin/floating_point_state.hpp"
#include "plugin/found.hpp"
#include "plugin/guarded_room.hpp"
#include "plugin/inputs.hpp"
#include "plugin/parameters.hpp"

namespace regista::plugin {

class alignas(64) Instance {
 public:
  // `environment.roles`, `host` and `caller` must outlive the instance. host null: a host that refuses every offer.
  // caller null: failures name no robot. Throws Failure when the plugin refuses to be created.
  Instance(const Found& plugin, const Parameters& parameters, const regista_environment& environment,
           const regista_host* host, const Caller* caller);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  // The beginning of a match. Must come once before any call of a kind, and may come again at any time.
  void reset(std::uint64_t seed);

  bool implements(int kind) const { return plugin::implements(plugin_, kind); }
  const Found& plugin() const { return plugin_; }
  AnswerRooms& rooms() const { return *rooms_; }
  // As given at create; its spans belong to whoever gave them.
  const regista_environment& environment() const { return environment_; }

  // Calls `function` of a table of this plugin; `name` is the call's, for the note and the Failure. Fails when the
  // plugin says so, changed the floating-point state, which is restored, or wrote outside of the room for its error's
  // text.
  template <std::size_t Size, class Function, class... Arguments>
  void call(const char (&name)[Size], Function function, Arguments... arguments) {
    const bool closely = looks_closely(calls_++);
    if (closely) [[unlikely]]
      mend();
    rooms_->error.data()->text[0] = '\0';
    std::int32_t status = REGISTA_FAILED;
    begin(name);
    try {
      status = function(raw_, arguments..., rooms_->error.data());
    } catch (...) {
      threw(name);
    }
    end();
    const bool content = status == REGISTA_OK, whole = rooms_->error.edges_are_whole(),
               usual = FloatingPointState::is_usual_for_numbers();
    const bool well = content & !closely & whole & usual;
    if (!well) [[unlikely]]
      examine(name, status);
  }

  // The same, and where inputs are compared it fails when the plugin changed one: `add` tells an Inputs& what they are.
  template <class Add, std::size_t Size, class Function, class... Arguments>
  void call_with(const Add& add, const char (&name)[Size], Function function, Arguments... arguments) {
    if (!compares_inputs_) [[likely]]
      return call(name, function, arguments...);
    Inputs inputs;
    add(inputs);
    call(name, function, arguments...);
    check(name, inputs);
  }

  // A room of rooms() for the answer to the next call.
  template <class T>
  T* open(GuardedRoom<T>& room, std::size_t count) const {
    T* const out = room.open(count);
    if (looks_closely(calls_)) [[unlikely]]
      room.mend();  // else an earlier call's overflow might be taken for one of this call
    return out;
  }

  // Fails when the last call wrote outside of this room; `what` stood in it: "points". What begins at its edges is
  // always found, what jumps over them when the call is one of those that are looked at closely.
  template <class T>
  void check(const char* call, const GuardedRoom<T>& room, const char* what) const {
    if (!room.edges_are_whole() || looks_closely(calls_ - 1)) [[unlikely]] {
      if (const Overflow overflow = room.overflow(); overflow != Overflow::none) wrote_outside(call, overflow, what);
    }
  }

  // The table of this kind; throws Failure when the plugin has none.
  template <class Table>
  const Table& table(int kind) const {
    const Table* found = plugin::table<Table>(*descriptor_, kind);
    if (found == nullptr) has_no_table(kind);
    return *found;
  }

  // Ends the match: what `call` handed back breaks a promise.
  [[noreturn]] void fail(const char* call, std::string message) const;

 private:
  // Notes that a call is under way, and that it is over. A few moves of bytes where somebody listens, else a branch.
  template <std::size_t Size>
  void begin(const char (&name)[Size]) {
    static_assert(Size <= std::tuple_size_v<decltype(CallNote::call)>);
    if (note_ == nullptr) [[likely]]
      return;
    // An instance is mostly called several times in a row.
    if (note_->instance != this) {
      std::memcpy(note_->plugin.data(), noted_id_.data(), noted_id_.size());
      note_->robot = caller_->robot;
      note_->side = caller_->noting.side;
      note_->instance = this;
    }
    std::memcpy(note_->call.data(), name, Size);
    note_->tick = caller_->tick;
    note_->inside = 1;
  }
  void end() {
    if (note_ != nullptr) [[unlikely]]
      note_->inside = 0;
  }

  // One of so many calls is examined for what cannot be seen cheaply.
  static bool looks_closely(std::uint32_t call) { return call % 64 == 0; }
  // Lest this instance pays for what an earlier one did unseen.
  void mend();

  // Makes the floating-point state again what it was at first; gives what it was now.
  FloatingPointState restore_floating_point() const;
  // What the last call did beside its answer; empty when nothing. Restores the floating-point state.
  std::string damage() const;
  void check(const char* name, const Inputs& inputs) const;
  void destroy();

  [[noreturn]] void wrote_outside(const char* call, Overflow overflow, const char* what) const;
  // Fails if there is a reason.
  void examine(const char* name, std::int32_t status) const;
  [[noreturn]] void threw(const char* name) const;
  [[noreturn]] void has_no_table(int kind) const;

  // In one line of the cache: what every call needs.
  void* raw_ = nullptr;
  AnswerRooms* rooms_;
  CallNote* note_;
  const Caller* caller_;
  std::uint32_t calls_ = 0;
  bool compares_inputs_;
  FloatingPointState floating_point_ = FloatingPointState::now();

  Found plugin_;
  const regista_descriptor* descriptor_ = nullptr;  // the plugin's own
  regista_environment environment_;
  std::array<char, 64> noted_id_;
  std::unique_ptr<AnswerRooms> own_rooms_;  // where nobody gives any
};

}  // namespace regista::plugin
