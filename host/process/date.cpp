// SPDX-License-Identifier: MIT
#include "process/date.hpp"

#include <dlfcn.h>
#include <sys/time.h>

#include <atomic>
#include <ctime>

#include "process/sanitized.hpp"

namespace regista::process {
namespace {
// Functions of the C library take no arguments of ours.
std::atomic<std::int64_t> earlier{0};  // s
}  // namespace

void set_date_back(std::int64_t seconds) { earlier = seconds; }

}  // namespace regista::process

#ifndef REGISTA_SANITIZED
extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  static auto* const of_the_library = reinterpret_cast<decltype(&clock_gettime)>(::dlsym(RTLD_NEXT, "clock_gettime"));
  const int status = of_the_library(clock, now);
  if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI))
    now->tv_sec -= regista::process::earlier;
  return status;
}

int gettimeofday(timeval* now, void*) noexcept {
  timespec exact{};
  const int status = clock_gettime(CLOCK_REALTIME, &exact);
  *now = {exact.tv_sec, exact.tv_nsec / 1000};
  return status;
}

time_t time(time_t* out) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME_COARSE, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}

int timespec_get(timespec* now, int base) noexcept {
  return base == TIME_UTC && clock_gettime(CLOCK_REALTIME, now) == 0 ? base : 0;
}
}
#endif
