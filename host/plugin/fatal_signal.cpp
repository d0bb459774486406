// SPDX-License-Identifier: MIT
#include "plugin/fatal_signal.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "process/sanitized.hpp"

namespace regista::plugin {
namespace {

// A handler has no argument for it.
std::atomic<FatalNote*> target{nullptr};
std::atomic_flag noted = ATOMIC_FLAG_INIT;

constexpr std::size_t words_of_stack = 2048;  // that are looked through for whoever called the library that ended

struct Registers {
  std::uintptr_t instruction = 0, stack = 0;
};

Registers registers_of(const void* raw) {
#if defined(__x86_64__)
  const auto& registers = static_cast<const ucontext_t*>(raw)->uc_mcontext.gregs;
  return {static_cast<std::uintptr_t>(registers[REG_RIP]), static_cast<std::uintptr_t>(registers[REG_RSP])};
#elif defined(__aarch64__)
  const auto& machine = static_cast<const ucontext_t*>(raw)->uc_mcontext;
  return {machine.pc, machine.sp};
#else
  (void)raw;
  return {};
#endif
}

// Functions of the C library that look after the heap, as far as they have names: [first, last).
struct Function {
  std::uintptr_t first = 0, last = 0;
  bool holds(std::uintptr_t address) const { return first <= address && address < last; }
};
std::array<Function, 6> heap_functions;

void find_heap_functions() {
  const std::array<void*, heap_functions.size()> known{
      reinterpret_cast<void*>(&std::malloc),   reinterpret_cast<void*>(&std::free),
      reinterpret_cast<void*>(&std::calloc),   reinterpret_cast<void*>(&std::realloc),
      reinterpret_cast<void*>(&aligned_alloc), reinterpret_cast<void*>(&posix_memalign)};
  for (std::size_t i = 0; i < known.size(); ++i) {
    Dl_info about{};
    void* raw = nullptr;
    if (dladdr1(known[i], &about, &raw, RTLD_DL_SYMENT) == 0 || raw == nullptr) continue;
    const auto first = reinterpret_cast<std::uintptr_t>(about.dli_saddr);
    heap_functions[i] = {first, first + static_cast<const ElfW(Sym)*>(raw)->st_size};
  }
}

bool of_heap(std::uintptr_t address) {
  return std::ranges::any_of(heap_functions, [address](const Function& each) { return each.holds(address); });
}

struct Walk {
  FatalNote& note;
  std::uintptr_t last = 0;  // where the caller that was found last goes on
  int left = 256;           // callers to be looked at: a damaged stack may have no end
};

// The nearest caller in a noted object, and whether the heap was at work on the way to it.
_Unwind_Reason_Code look_at_frame(_Unwind_Context* frame, void* raw) {
  Walk& walk = *static_cast<Walk*>(raw);
  walk.last = _Unwind_GetIP(frame);
  if (const ObjectName* const name = object_at(walk.last)) {
    walk.note.object = *name;
    return _URC_END_OF_STACK;
  }
  if (of_heap(walk.last)) walk.note.heap = 1;
  return --walk.left > 0 ? _URC_NO_REASON : _URC_END_OF_STACK;
}

// Where no caller is found, as after a jump to where no code is, what looks like a return address mostly is one. The
// kernel reads, for the stack may end anywhere.
void look_through_stack(std::uintptr_t stack, FatalNote& note) {
  static std::uintptr_t words[words_of_stack];
  std::size_t read = sizeof words;
  for (; read >= 4096; read /= 2) {
    iovec here{words, read}, there{reinterpret_cast<void*>(stack), read};
    if (process_vm_readv(getpid(), &here, 1, &there, 1, 0) == static_cast<ssize_t>(read)) break;
  }
  if (read < 4096) return;
  for (std::size_t i = 0; i < read / sizeof words[0]; ++i) {
    if (const ObjectName* const name = object_at(words[i])) {
      note.object = *name;
      return;
    }
  }
}

// The code that ran, or else the nearest that called it: abort() dies in the C library.
void note_place(const Registers& at, FatalNote& note) {
  note.other_thread = syscall(SYS_gettid) == getpid() ? 0 : 1;
  prctl(PR_GET_NAME, note.thread.data());
  note.thread.back() = '\0';
  if (const ObjectName* const name = object_at(at.instruction)) {
    note.object = *name;
    return;
  }
  Walk walk{note};
  _Unwind_Backtrace(look_at_frame, &walk);
  if (walk.last == at.instruction) look_through_stack(at.stack, note);
}

void strike(int signal_number, siginfo_t*, void* context) {
  if (FatalNote* const note = target.load(); note != nullptr && !noted.test_and_set()) {
    note->signal = signal_number;
    note_place(registers_of(context), *note);
  }
  std::signal(signal_number, SIG_DFL);
  raise(signal_number);  // delivered when this handler returns
}

void leave() {
  FatalNote* const note = target.load();
  if (note == nullptr || noted.test_and_set()) return;
  note_place({}, *note);
  note->exited = 1;
}

}  // namespace

void note_fatal_signals(FatalNote& note) {
  if (target.exchange(&note) == nullptr) std::atexit(leave);
  if constexpr (sanitized) return;
  find_heap_functions();
  _Unwind_Backtrace([](_Unwind_Context*, void*) { return _URC_END_OF_STACK; }, nullptr);  // what it loads at first
  // A stack of its own, for the one that has overflowed.
  static char room[64 * 1024];
  stack_t own{};
  own.ss_sp = room;
  own.ss_size = sizeof room;
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_sigaction = strike;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (const int each : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigaction(each, &action, nullptr);
}

bool ended_in(const FatalNote& note, std::string_view file) {
  if constexpr (sanitized) return note.other_thread == 0;
  const bool known = note.signal != 0 || note.exited != 0;
  const std::string_view object(note.object.data());
  return known && note.other_thread == 0 && note.heap == 0 && !object.empty() &&
         object == file.substr(0, note.object.size() - 1);
}

std::string where(const FatalNote& note) {
  if (note.signal == 0 && note.exited == 0) return {};
  std::string out;
  if (note.other_thread != 0) out += fmt::format(", in thread \"{}\"", note.thread.data());
  if (note.object.front() != '\0') out += fmt::format(", in {}", note.object.data());
  return out;
}

}  // namespace regista::plugin
