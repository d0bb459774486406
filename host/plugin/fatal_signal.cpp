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
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "process/sanitized.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

struct Range {
  std::uintptr_t first = 0, last = 0;  // [first, last)
  ObjectName name{};
};

std::array<Range, 256> ranges;
std::atomic<std::size_t> known_ranges{0};

struct Wanted {
  ElfW(Addr) base;
  const char* path;
};

int look(dl_phdr_info* object, std::size_t, void* raw) {
  const auto& wanted = *static_cast<const Wanted*>(raw);
  if (object->dlpi_addr != wanted.base || std::string_view(object->dlpi_name) != wanted.path) return 0;
  Range range{UINTPTR_MAX, 0, {}};
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD) continue;
    const std::uintptr_t first = object->dlpi_addr + segment.p_vaddr;
    range.first = std::min(range.first, first);
    range.last = std::max(range.last, first + segment.p_memsz);
  }
  std::string_view name = wanted.path;
  name.remove_prefix(name.rfind('/') + 1);
  std::copy_n(name.data(), std::min(name.size(), range.name.size() - 1), range.name.data());
  const std::size_t count = known_ranges.load();
  for (std::size_t i = 0; i < count; ++i) {
    if (ranges[i].first == range.first) return 1;
  }
  if (count == ranges.size()) return 1;
  ranges[count] = range;
  known_ranges.store(count + 1);  // the last step, so that a signal handler reads only complete entries
  return 1;
}

// Note of note_fatal_signals(). The pointer is global, because a signal handler gets no arguments from the host.
std::atomic<FatalNote*> target{nullptr};
std::atomic_flag noted = ATOMIC_FLAG_INIT;

constexpr std::size_t words_of_stack = 2048;  // number of stack words in which the handler searches for a caller

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

// The addresses [first, last) of a heap function of the C library that has a symbol.
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
  std::uintptr_t last = 0;  // return address in the last examined frame
  int left = 256;           // number of frames still to examine, because a damaged stack may have no end
};

// Looks at one frame of the stack, for _Unwind_Backtrace(). Ends the walk at the first frame whose code is in a shared
// object of the table. Notes whether a frame that was examined before belongs to a heap function.
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

// Notes the object of the first stack word that is an address in a stored object, because this word is usually a return
// address. note_place() needs this if the walk finds no caller, for example after a jump to an address without code.
// The kernel copies the stack, because a read beyond the end of the stack would crash.
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

// Notes the plugin file whose code ran; for other code, such as abort() in the C library, the plugin file that called.
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
  raise(signal_number);  // the process gets this signal when this handler returns
}

void leave() {
  FatalNote* const note = target.load();
  if (note == nullptr || noted.test_and_set()) return;
  note_place({}, *note);
  note->exited = 1;
}

}  // namespace

void note_address_range(void* handle) {
  link_map* map = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, &map) != 0 || map == nullptr) return;
  Wanted wanted{map->l_addr, map->l_name};
  dl_iterate_phdr(look, &wanted);
}

std::vector<const void*> noted_objects() {
  std::vector<const void*> out;
  for (std::size_t i = 0; i < known_ranges.load(); ++i) out.push_back(reinterpret_cast<const void*>(ranges[i].first));
  return out;
}

const ObjectName* object_at(std::uintptr_t address) {
  const std::size_t count = known_ranges.load();
  for (std::size_t i = 0; i < count; ++i) {
    if (address >= ranges[i].first && address < ranges[i].last) return &ranges[i].name;
  }
  return nullptr;
}

void note_fatal_signals(FatalNote& note) {
  if (target.exchange(&note) == nullptr) std::atexit(leave);
  if constexpr (sanitized) return;
  find_heap_functions();
  // Loads the libraries of the unwinder now, because a signal handler must not load any.
  _Unwind_Backtrace([](_Unwind_Context*, void*) { return _URC_END_OF_STACK; }, nullptr);
  // The handler uses a separate stack, because the normal stack may have overflowed.
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

static std::string line(const Found& plugin, const Caller* caller, const std::string& call,
                        const std::string& message) {
  const std::string who = fmt::format("plugin {} ({})", plugin.descriptor->id, plugin.file.string());
  if (caller == nullptr) return fmt::format("{}: {}: {}", who, call, message);
  return fmt::format("{} of team {}, robot {}, tick {}: {}: {}", who, caller->team, caller->robot, caller->tick, call,
                     message);
}

Failure::Failure(const Found& plugin, const Caller* caller, std::string call, std::string message)
    : std::runtime_error(texts::one_line(line(plugin, caller, call, message))),
      id_(plugin.descriptor->id),
      file_(plugin.file),
      caller_(caller == nullptr ? std::nullopt : std::optional<Caller>(*caller)),
      call_(std::move(call)),
      message_(std::move(message)) {}

}  // namespace regista::plugin
