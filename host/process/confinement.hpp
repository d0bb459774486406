// SPDX-License-Identifier: MIT
// Confines this process and changes its date, so that plugins cannot exchange information or depend on the date.
#pragma once

#include <cstdint>

namespace regista::process {

// After this call, this process cannot open files for writing, change names in the file system, open sockets, or ask
// for System V objects and queues. These are the usual ways of sharing information between processes. Such a call fails
// with "Permission denied" and is reported. Uses seccomp(2) with no new privileges. The function protects against
// accidents, not against malice. Returns false if the system does not allow the confinement: then nothing is confined.
//   tried: a signal handler calls `tried` at each refused call, with a text of unlimited lifetime: "open a socket".
bool confine(void (*tried)(const char* what));

// After this call, time(), gettimeofday(), timespec_get() and clock_gettime() of clocks with a date return a date that
// is `seconds` earlier. The program replaces these functions of the C library. The date is never set forward, because a
// plugin that waits for a date would then wait `seconds` longer. CLOCK_MONOTONIC and processor time stay unchanged. The
// function has no effect if a sanitizer provides these functions.
void set_date_back(std::int64_t seconds);

}  // namespace regista::process
