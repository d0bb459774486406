// SPDX-License-Identifier: MIT
#include "plugin/fatal_signal.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

#include "config/sanitized.hpp"

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

// The code that ran, or else the nearest that may have called it: abort() dies in the C library. What looks like a
// return address on the stack mostly is one. The kernel reads, for the stack may end anywhere.
const ObjectName* guilty_object(const Registers& at) {
  if (const ObjectName* const name = object_at(at.instruction)) return name;
  static std::uintptr_t words[words_of_stack];
  std::size_t read = sizeof words;
  for (; read >= 4096; read /= 2) {
    iovec here{words, read}, there{reinterpret_cast<void*>(at.stack), read};
    if (process_vm_readv(getpid(), &here, 1, &there, 1, 0) == static_cast<ssize_t>(read)) break;
  }
  if (read < 4096) return nullptr;
  for (std::size_t i = 0; i < read / sizeof words[0]; ++i) {
    if (const ObjectName* const name = object_at(words[i])) return name;
  }
  return nullptr;
}

void strike(int signal_number, siginfo_t*, void* context) {
  if (FatalNote* const note = target.load(); note != nullptr && !noted.test_and_set()) {
    note->other_thread = syscall(SYS_gettid) == getpid() ? 0 : 1;
    prctl(PR_GET_NAME, note->thread.data());
    note->thread.back() = '\0';
    if (const ObjectName* const name = guilty_object(registers_of(context))) note->object = *name;
    note->signal = signal_number;
  }
  std::signal(signal_number, SIG_DFL);
  raise(signal_number);  // delivered when this handler returns
}

}  // namespace

void note_fatal_signals(FatalNote& note) {
  if constexpr (sanitized) return;
  target.store(&note);
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

std::string where(const FatalNote& note) {
  if (note.signal == 0) return {};
  std::string out;
  if (note.other_thread != 0) out += fmt::format(", in thread \"{}\"", note.thread.data());
  if (note.object.front() != '\0') out += fmt::format(", in {}", note.object.data());
  return out;
}

}  // namespace regista::plugin
