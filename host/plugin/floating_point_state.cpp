// SPDX-License-Identifier: MIT
#include "plugin/floating_point_state.hpp"

namespace regista::plugin {
namespace {

constexpr const char* rounding = "changed the rounding mode";
constexpr const char* small_numbers = "changed how small numbers are treated (flush to zero)";
constexpr const char* exceptions = "unmasked floating-point exceptions";

}  // namespace

#if defined(__x86_64__)

// Bits of MXCSR: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 1, section 10.2.3; of the x87
// control word: section 8.1.5.
void FloatingPointState::restore() const {
  const auto x87 = static_cast<std::uint16_t>(x87_);
  // What happened so far is forgotten, else an exception that is unmasked now would be raised by the next command.
  __asm__ volatile("fnclex\n\tfldcw %0" : : "m"(x87));
  _mm_setcsr(sse_);
}

std::string FloatingPointState::changed_from(const FloatingPointState& earlier) const {
  const std::uint32_t sse = sse_ ^ earlier.sse_, x87 = x87_ ^ earlier.x87_;
  if ((sse & 0x6000) != 0 || (x87 & 0x0c00) != 0) return rounding;
  if ((sse & 0x8040) != 0) return small_numbers;
  if ((sse & 0x1f80) != 0 || (x87 & 0x003f) != 0) {
    const bool fewer = (sse & earlier.sse_ & 0x1f80) != 0 || (x87 & earlier.x87_ & 0x003f) != 0;
    return fewer ? exceptions : "masked floating-point exceptions";
  }
  if ((x87 & 0x0300) != 0) return "changed the precision of floating-point arithmetic";
  return sse != 0 || x87 != 0 ? "changed the floating-point environment" : "";
}

#else

namespace {

// Nobody but the processor says whether it flushes.
bool flushes_to_zero() {
  volatile double least = std::numeric_limits<double>::min();
  least = least / 2;
  return least == 0.0;
}

}  // namespace

std::uint32_t FloatingPointState::difference_for_numbers() {
  return std::fegetround() == FE_TONEAREST && !flushes_to_zero() ? 0 : 1;
}

FloatingPointState FloatingPointState::now() {
  FloatingPointState out;
  out.rounding_ = std::fegetround();
#if defined(__GLIBC__)
  out.unmasked_ = fegetexcept();
#endif
  out.flushes_ = flushes_to_zero();
  return out;
}

void FloatingPointState::restore() const {
  // There is no portable way to flush, so it begins with what the C library holds to be normal.
  if (flushes_to_zero() != flushes_) std::fesetenv(FE_DFL_ENV);
  std::fesetround(rounding_);
#if defined(__GLIBC__)
  fedisableexcept(FE_ALL_EXCEPT);
  feenableexcept(unmasked_);
#endif
}

std::string FloatingPointState::changed_from(const FloatingPointState& earlier) const {
  if (rounding_ != earlier.rounding_) return rounding;
  if (flushes_ != earlier.flushes_) return small_numbers;
  return unmasked_ != earlier.unmasked_ ? exceptions : "";
}

#endif

}  // namespace regista::plugin
