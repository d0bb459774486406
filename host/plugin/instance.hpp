// SPDX-License-Identifier: MIT
// Creates, resets, calls and destroys an instance of a plugin. An error of the plugin becomes a Failure with plugin,
// robot and tick. kinds.hpp has the typed calls of each kind. Several kinds may share an instance.
#pragma once

#include <fmt/format.h>

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

#include "plugin/answer_buffers.hpp"
#include "plugin/call_inputs.hpp"
#include "plugin/description.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/parameters.hpp"
#include "plugin/process_state.hpp"
#include "texts/message.hpp"

namespace regista::plugin {

class alignas(64) Instance {
 public:
  // The spans in `environment`, and `host` and `caller`, must outlive the instance. If `host` is null, every offer is
  // refused. If `caller` is null, failures name no robot. Throws Failure if the plugin cannot be loaded or created.
  Instance(const Found& plugin, const Parameters& parameters, const regista_environment& environment,
           const regista_host* host, const Caller* caller);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  // Begins a match. The caller must call reset() before any call of a kind, and may call it again at any time.
  void reset(std::uint64_t seed);

  bool implements(int kind) const { return plugin_.description->implements(kind); }
  const Found& plugin() const { return plugin_; }
  AnswerBuffers& rooms() const { return *buffers_; }
  const regista_environment& environment() const { return environment_; }

  // Returns the frame that the plugin gets: `frame`, or a reduced copy (see CallTracing::hides). For null, returns
  // null. The result is valid until the next call of shown().
  const regista_frame* shown(const regista_frame* frame) {
    if (declared_reads_ == nullptr || !buffers_->strict || frame == nullptr) [[likely]]
      return frame;
    return declared_reads_->of(*frame);
  }

  // Calls `function` of one of the plugin's tables; `name` is the name of the call in notes and failures. Throws
  // Failure if the plugin reports a failure, changed the floating-point state (which is restored), wrote outside of the
  // buffer for its error text, or changed an input. `add` adds the input arguments to an Inputs&. It must capture
  // nothing, so that it costs nothing when inputs are not compared.
  template <class Add, std::size_t Size, class Function, class... Arguments>
  void call_with(Add add, const char (&name)[Size], Function function, Arguments... arguments) {
    static_assert(std::is_empty_v<Add>);
    if (buffers_->strict) [[unlikely]]
      call_closely(add, name, function, arguments...);
    else
      invoke(name, function, arguments...);
  }

  // Like call_with(), for a call without inputs.
  template <std::size_t Size, class Function, class... Arguments>
  void call(const char (&name)[Size], Function function, Arguments... arguments) {
    call_with([](Inputs&, const Arguments&...) {}, name, function, arguments...);
  }

  // Returns a buffer for the answer to the next call.
  template <class T>
  T* open(GuardedBuffer<T>& room, std::size_t count = 1) const {
    T* const out = room.open(count);
    if (buffers_->strict) [[unlikely]]
      room.mend();  // repairs damage by an earlier call, so that the host does not blame this call
    return out;
  }

  // A buffer to which a call wrote, and the name of its content, such as "points".
  template <class Room>
  struct Written {
    const Room& room;
    const char* what;
  };
  template <class Room>
  Written(const Room&, const char*) -> Written<Room>;

  // Throws Failure if the last call wrote outside of one of these buffers. Detects an overflow that changes bytes next
  // to a buffer. Detects other overflows only if the host inspects the call closely.
  template <class... Rooms>
  void check(const char* call, const Written<Rooms>&... written) const {
    const std::uint64_t wrong = (std::uint64_t{buffers_->strict} | ... | written.room.difference_at_edges());
    if (wrong != 0) [[unlikely]]
      (check(call, written.room.overflow(), written.what), ...);
  }

  // Returns whether the host records answers now. The host records only answers during decisions.
  bool is_traced() const {
    return buffers_->strict && caller_ != nullptr && caller_->tracing.trail != nullptr && caller_->decides;
  }
  // Records the answer of the last call. Precondition: the answer has been checked.
  template <class... Values>
  void answered(const Values&... values) const {
    if (is_traced()) [[unlikely]]
      add(*caller_->tracing.trail, *note_, AnswerDigest{}(values...).value());
  }
  // Records that the plugin called a function of its host, such as "offer", with these values.
  template <class... Values>
  void used(std::string_view what, const Values&... values) const {
    if (is_traced()) [[unlikely]]
      add(*caller_->tracing.trail, *note_, what, AnswerDigest{}(values...).value());
  }

  // Returns the plugin's call table of this kind. Throws Failure if the plugin has none.
  template <class Table>
  const Table& table(int kind) const {
    const Table* found = plugin::table<Table>(*descriptor_, kind);
    if (found == nullptr) fail("table", "is not {}", texts::with_article(kind_name(kind)));
    return *found;
  }

  // Throws Failure, because the result of `call` breaks a promise of abi.h. The formatted text describes the mistake.
  template <class... Values>
  [[noreturn]] void fail(const char* call, fmt::format_string<Values...> format, Values&&... values) const {
    fail_with(call, fmt::vformat(format, fmt::make_format_args(values...)));
  }

 private:
  template <std::size_t Size, class Function, class... Arguments>
  void invoke(const char (&name)[Size], Function function, Arguments... arguments) {
    GuardedBuffer<regista_error>& error = buffers_->error;
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

  // call_with() for a call that is inspected closely. A separate function, so that the usual call stays short.
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

  // begin() and end() write the beginning and the end of a call to the note. They copy only a few bytes.
  template <std::size_t Size>
  void begin(const char (&name)[Size]) {
    static_assert(Size <= std::tuple_size_v<decltype(CallNote::call)>);
    CallNote& note = *note_;
    // Usually the note is already about this instance, because most calls follow a call of the same instance.
    if (note.instance != this) {
      note.plugin = noted_id_;
      note.instance = this;
    }
    std::memcpy(note.call.data(), name, Size);
    note.inside = 1;
  }
  void end() { note_->inside = 0; }

  // Restores the floating-point state and the error buffer, because another instance may have damaged them unnoticed.
  void mend();

  // Restores the floating-point state of the time when the instance was created. Returns the state before restoring.
  FloatingPointState restore_floating_point() const;
  // Describes the damage by the last call; empty if there is no damage. Also restores the floating-point state.
  std::string damage() const;
  void check(const char* name, const Inputs& inputs) const;
  void destroy();

  [[noreturn]] void fail_with(const char* call, std::string message) const;
  void check(const char* call, Overflow overflow, const char* what) const;
  // Throws Failure if the last call reported a failure or did damage.
  void examine(const char* name, std::int32_t status) const;
  [[noreturn]] void threw(const char* name) const;

  // The data that every call needs are in one cache line.
  void* raw_ = nullptr;
  AnswerBuffers* buffers_;
  CallNote* note_;
  const Caller* caller_;
  bool compares_inputs_;
  std::unique_ptr<DeclaredReads> declared_reads_;
  FloatingPointState floating_point_ = FloatingPointState::now();

  Found plugin_;
  const regista_descriptor* descriptor_ = nullptr;  // descriptor in the plugin's file
  regista_environment environment_;
  std::array<char, 64> noted_id_;
  std::unique_ptr<AnswerBuffers> own_rooms_;  // buffers of this instance; null if the caller has buffers
};

// The base of the calls of one kind: an instance and its call table. Its constructor throws Failure for another kind.
template <class Table, int kind>
class CallsOfKind {
 protected:
  explicit CallsOfKind(std::shared_ptr<Instance> instance)
      : instance_(std::move(instance)), calls_(&instance_->table<Table>(kind)) {}

  std::shared_ptr<Instance> instance_;
  const Table* calls_;
};

}  // namespace regista::plugin
