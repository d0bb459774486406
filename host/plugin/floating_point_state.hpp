// SPDX-License-Identifier: MIT
// How the processor rounds, treats small numbers and reports exceptions of floating-point arithmetic. Code of a plugin
// runs in the host's thread and may change it, while it is opened or in a call; every number that anybody computes
// afterwards would be another.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#if defined(__x86_64__)
#include <emmintrin.h>
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

  // 0 when numbers are rounded to the nearest and small ones kept, as everywhere in the host. Found out by adding, as
  // reading the state makes the processor wait until all that it has begun is done: ten times as dear. Does not see
  // which exceptions are masked, nor the state of long double: both change no number of the host.
  static std::uint32_t difference_for_numbers();

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

inline std::uint32_t FloatingPointState::difference_for_numbers() {
  using Limits = std::numeric_limits<float>;
  constexpr float ulp = Limits::epsilon(), least = Limits::min(), step = Limits::denorm_min();
  // Three quarters of a unit in the last place are lost when rounding down or to zero, a quarter becomes a whole when
  // rounding up. The last two sums take and give a number that is flushed, if any is.
  __m128 sum = _mm_setr_ps(1.0F, 1.0F, least, least);
  __asm__ volatile("" : "+x"(sum));  // now, not when it was compiled
  sum = _mm_add_ps(sum, _mm_setr_ps(0.75F * ulp, 0.25F * ulp, -step, -step));
  const __m128 expected = _mm_setr_ps(1.0F + ulp, 1.0F, least - step, least - step);
  const __m128i alike = _mm_cmpeq_epi32(_mm_castps_si128(sum), _mm_castps_si128(expected));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(alike)) ^ 0xffffu;
}
#endif

}  // namespace regista::plugin
