// SPDX-License-Identifier: MIT
// The state that all code of a process shares: floating-point state, threads, child processes, file descriptors,
// working folder, locale, environment, signal handlers and signal mask. Plugins must leave this state unchanged. The
// host does not check functions that a plugin registers for the end of the process: destructors of static objects are
// registered in the same way, and no process of a match runs such functions.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#if defined(__x86_64__)
#include <emmintrin.h>
#else
#include <cfenv>
#endif

namespace regista::plugin {

// How the processor rounds, treats small numbers and reports floating-point exceptions. A plugin runs in the host's
// thread and could change this state; all later results of the host would then differ.
class FloatingPointState {
 public:
  static FloatingPointState now();

  void restore() const;  // sets the processor to this state

  // Describes the change from the earlier state, such as "changed the rounding mode"; empty if nothing changed.
  std::string changed_from(const FloatingPointState& earlier) const;

  // Returns 0 if the processor rounds to the nearest number and keeps denormal numbers, as the host requires. Tests
  // this by additions, because reading the state takes ten times longer. Ignores exception masks and the state of long
  // double, because they change no number of the host.
  static std::uint32_t difference_for_numbers();

  friend bool operator==(const FloatingPointState&, const FloatingPointState&) = default;

 private:
#if defined(__x86_64__)
  std::uint32_t sse_ = 0;  // control bits of MXCSR, without the bits for exceptions that happened
  std::uint32_t x87_ = 0;  // control word, for long double
#else
  int rounding_ = 0;
  int unmasked_ = 0;
  bool flushes_ = false;
#endif
};

#if defined(__x86_64__)
// These functions are in the header, because they run after every call of a plugin and should be inlined.
inline FloatingPointState FloatingPointState::now() {
  constexpr std::uint32_t happened = 0x3f;
  std::uint16_t x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  FloatingPointState out;
  out.sse_ = _mm_getcsr() & ~happened;
  out.x87_ = x87;
  return out;
}

inline std::uint32_t FloatingPointState::difference_for_numbers() {
  using Limits = std::numeric_limits<float>;
  constexpr float ulp = Limits::epsilon(), least = Limits::min(), step = Limits::denorm_min();
  // Rounding down or to zero would lose three quarters of a unit in the last place; rounding up would make a quarter of
  // a unit a whole unit. The terms or results of the last two sums are denormal; some processor modes set them to zero.
  __m128 sum = _mm_setr_ps(1.0F, 1.0F, least, least);
  __asm__ volatile("" : "+x"(sum));  // makes the compiler add at run time
  sum = _mm_add_ps(sum, _mm_setr_ps(0.75F * ulp, 0.25F * ulp, -step, -step));
  const __m128 expected = _mm_setr_ps(1.0F + ulp, 1.0F, least - step, least - step);
  const __m128i alike = _mm_cmpeq_epi32(_mm_castps_si128(sum), _mm_castps_si128(expected));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(alike)) ^ 0xffffu;
}
#endif

struct ProcessState {
  static ProcessState now();

  int threads = 1;
  int timers = 0;                // number of timers that will send a signal
  std::vector<int> descriptors;  // open file descriptors, ascending
  std::uint64_t most_descriptors = 0;
  std::string folder, locale;
  std::array<std::uintptr_t, 65> handlers{};  // addresses of signal handlers, indexed by signal number
  std::vector<int> blocked;                   // blocked signals of this thread; ascending
  std::vector<std::string> environment;       // "NAME=VALUE", in alphabetical order
  unsigned file_mode = 0;                     // umask
  bool has_children = false;
};

int running_threads();
int interval_timers();  // number of interval timers that will send a signal, without timers of timer_create()

// Makes this process the new parent of orphans: of processes that a plugin started, and whose own parents have ended.
void keep_orphans();

// Describes the changes of the state: "left 2 threads running, changed the working folder"; empty if nothing changed.
std::string changes(const ProcessState& before, const ProcessState& after);

// Describes the changes from `before` until now. If there are more threads than before, waits for a moment, because the
// kernel may still list threads that have ended.
std::string changes_since(const ProcessState& before);

}  // namespace regista::plugin
