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
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <regista/abi.h>

#include "plugin/answer_rooms.hpp"
#include "plugin/call_note.hpp"
#include "plugin/call_trail.hpp"
#include "plugin/declared_reads.hpp"
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
  // The environment's spans, `host` and `caller` must outlive the instance. host null: a host that refuses every offer.
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

  // The frame as this plugin is to see it: without what it does not declare to read where inputs are compared, as it is
  // elsewhere. Null stays null. Valid until the next.
  const regista_frame* shown(const regista_frame* frame) {
    if (declared_reads_ == nullptr || !rooms_->closely || frame == nullptr) [[likely]]
      return frame;
    return declared_reads_->of(*frame);
  }

  // Calls `function` of a table of this plugin; `name` is the call's, for the note and the Failure. Fails when the
  // plugin says so, changed the floating-point state, which is restored, or wrote outside of the room for its error's
  // text; and where inputs are compared when it changed one: `add` tells an Inputs& which of the arguments they are. It
  // captures nothing, so that the usual call, which does not need it, does not pay for it.
  template <class Add, std::size_t Size, class Function, class... Arguments>
  void call_with(Add add, const char (&name)[Size], Function function, Arguments... arguments) {
    static_assert(std::is_empty_v<Add>);
    if (rooms_->closely) [[unlikely]]
      call_closely(add, name, function, arguments...);
    else
      invoke(name, function, arguments...);
  }

  // The same of a call without inputs.
  template <std::size_t Size, class Function, class... Arguments>
  void call(const char (&name)[Size], Function function, Arguments... arguments) {
    call_with([](Inputs&, const Arguments&...) {}, name, function, arguments...);
  }

  // A room for the answer to the next call.
  template <class T>
  T* open(GuardedRoom<T>& room, std::size_t count) const {
    T* const out = room.open(count);
    if (rooms_->closely) [[unlikely]]
      room.mend();  // else an earlier call's overflow might be taken for one of this call
    return out;
  }
  template <class T>
  T* open(GuardedValue<T>& room) const {
    if (rooms_->closely) [[unlikely]]
      room.mend();
    return room.data();
  }

  // A room that a call wrote to, and what stood in it: "points".
  template <class Room>
  struct Written {
    const Room& room;
    const char* what;
  };
  template <class Room>
  Written(const Room&, const char*) -> Written<Room>;

  // Fails when the last call wrote outside of one of these rooms. What begins at their edges is always found, what
  // jumps over them when they are looked at closely.
  template <class... Rooms>
  void check(const char* call, const Written<Rooms>&... written) const {
    const std::uint64_t wrong = (std::uint64_t{rooms_->closely} | ... | written.room.difference_at_edges());
    if (wrong != 0) [[unlikely]]
      (check(call, written.room.overflow(), written.what), ...);
  }

  // Whether somebody keeps what calls answer; only of decisions.
  bool is_traced() const {
    return rooms_->closely && caller_ != nullptr && caller_->noting.trail != nullptr && caller_->decides;
  }
  // What the last call answered, once it is known to keep its promises.
  template <class... Values>
  void answered(const Values&... values) const {
    if (is_traced()) [[unlikely]]
      add(*caller_->noting.trail, *note_, AnswerDigest{}(values...).value());
  }
  // And what a plugin does with the host of this instance.
  template <class... Values>
  void used(std::string_view what, const Values&... values) const {
    if (is_traced()) [[unlikely]]
      add(*caller_->noting.trail, *note_, what, AnswerDigest{}(values...).value());
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
  template <std::size_t Size, class Function, class... Arguments>
  void invoke(const char (&name)[Size], Function function, Arguments... arguments) {
    GuardedValue<regista_error>& error = rooms_->error;
    error.data()->text[0] = '\0';
    std::int32_t status = REGISTA_FAILED;
    begin(name);
    try {
      status = function(raw_, arguments..., error.data());
    } catch (...) {
      threw(name);
    }
    end();
    static_assert(REGISTA_OK == 0);
    const std::uint64_t wrong =
        error.difference_at_edges() | static_cast<std::uint32_t>(status) | FloatingPointState::difference_for_numbers();
    if (wrong != 0) [[unlikely]]
      examine(name, status);
  }

  // Apart, so that the usual call stays short.
  template <class Add, std::size_t Size, class Function, class... Arguments>
  [[gnu::noinline, gnu::cold]] void call_closely(Add add, const char (&name)[Size], Function function,
                                                 Arguments... arguments) {
    Inputs inputs;
    if (compares_inputs_) add(inputs, arguments...);
    mend();
    invoke(name, function, arguments...);
    examine(name, REGISTA_OK);
    check(name, inputs);
  }

  // Notes that a call is under way, and that it is over: a few moves of bytes.
  template <std::size_t Size>
  void begin(const char (&name)[Size]) {
    static_assert(Size <= std::tuple_size_v<decltype(CallNote::call)>);
    CallNote& note = *note_;
    // An instance is mostly called several times in a row.
    if (note.instance != this) {
      note.plugin = noted_id_;
      note.instance = this;
    }
    std::memcpy(note.call.data(), name, Size);
    note.inside = 1;
  }
  void end() { note_->inside = 0; }

  // Lest this instance pays for what an earlier one did unseen.
  void mend();

  // Makes the floating-point state again what it was at first; gives what it was now.
  FloatingPointState restore_floating_point() const;
  // What the last call did beside its answer; empty when nothing. Restores the floating-point state.
  std::string damage() const;
  void check(const char* name, const Inputs& inputs) const;
  void destroy();

  void check(const char* call, Overflow overflow, const char* what) const;
  // Fails if there is a reason.
  void examine(const char* name, std::int32_t status) const;
  [[noreturn]] void threw(const char* name) const;
  [[noreturn]] void has_no_table(int kind) const;

  // In one line of the cache: what every call needs.
  void* raw_ = nullptr;
  AnswerRooms* rooms_;
  CallNote* note_;
  const Caller* caller_;
  bool compares_inputs_;
  std::unique_ptr<DeclaredReads> declared_reads_;
  FloatingPointState floating_point_ = FloatingPointState::now();

  Found plugin_;
  const regista_descriptor* descriptor_ = nullptr;  // the plugin's own
  regista_environment environment_;
  std::array<char, 64> noted_id_;
  std::unique_ptr<AnswerRooms> own_rooms_;  // where nobody gives any
};

}  // namespace regista::plugin
