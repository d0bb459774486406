// SPDX-License-Identifier: MIT
// Small questions about other processes.
#pragma once

#include <sys/types.h>

#include <span>

namespace regista::campaign {

// s of processor time of a process that runs, so far; 0 where it cannot be told.
double processor_seconds_of(pid_t process);

// A signal that people and systems send to processes: that one died of it says nothing about its code.
bool comes_from_outside(int signal_number);

// Kills the process and all that it started in its group.
void end_group(pid_t process);

// From now on, processes that a plugin has started and whose parent is gone become children of this one.
void adopt_orphans();
// Kills all children of this process but those.
void end_children_but(std::span<const pid_t> those);

}  // namespace regista::campaign
