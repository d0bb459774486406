// SPDX-License-Identifier: MIT
// How the processor rounds, treats small numbers and reports exceptions of floating-point arithmetic. Code of a plugin
// runs in the host's thread and may change it, while it is opened or in a call; every number that anybody computes
// afterwards would be another.
#pragma once

#include <cstdint>
#include <string>

#if defined(__x86_64__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace regista::plugin {

class FloatingPointState {
 public:
  static FloatingPointState now();

  // Makes the processor work in this state again.
  void restore() const;

  // What was done to the earlier state to make it this one: "changed the rounding mode". Empty when they are alike.
  std::string changed_from(const FloatingPointState& earlier) const;

  friend bool operator==(const FloatingPointState&, const FloatingPointState&) = default;

 private:
#if defined(__x86_64__)
  std::uint32_t sse_ = 0;  // control bits of MXCSR; the others say which exceptions happened, which they may
  std::uint32_t x87_ = 0;  // control word, for long double
#else
  int rounding_ = 0;
  int unmasked_ = 0;
  bool flushes_ = false;
#endif
};

#if defined(__x86_64__)
// In the header, as it is asked after every call.
inline FloatingPointState FloatingPointState::now() {
  constexpr std::uint32_t happened = 0x3f;
  std::uint16_t x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  FloatingPointState out;
  out.sse_ = _mm_getcsr() & ~happened;
  out.x87_ = x87;
  return out;
}
#endif

}  // namespace regista::plugin
