// SPDX-License-Identifier: MIT
// Small questions about other processes.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace regista::campaign {

// s of processor time of a process that runs, so far; 0 where it cannot be known.
double processor_seconds_of(pid_t process);

// Bytes of addresses that a process has mapped; 0 where it cannot be known.
std::uint64_t address_space_of(pid_t process);

// A signal that people and systems send to processes: that one died of it says nothing about its code.
bool comes_from_outside(int signal_number);

// Kills the process and all that it started in its group.
void end_group(pid_t process);

}  // namespace regista::campaign
