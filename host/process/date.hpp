// SPDX-License-Identifier: MIT
// The date that this process gets from time(), gettimeofday(), timespec_get() and clock_gettime() of the clocks that
// have a date. The program has these functions in the place of the C library's. What is measured from
// an unknown moment on (CLOCK_MONOTONIC) and processor time stay as they are.
#pragma once

#include <cstdint>

namespace regista::process {

// From now on the date is so many seconds earlier. Never later: who waits until a date then would wait as long. Does
// nothing where a sanitizer has these functions.
void set_date_back(std::int64_t seconds);

}  // namespace regista::process
