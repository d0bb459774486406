// SPDX-License-Identifier: MIT
// What makes a process a worker: it dies with its coordinator (PR_SET_PDEATHSIG), stands in a process group of its own,
// so that Ctrl-C on the terminal reaches the coordinator alone, has limits, and answers at fixed file descriptors.
#pragma once

#include <sys/types.h>

#include <initializer_list>
#include <string_view>

#include "campaign/limits.hpp"

namespace regista::campaign {

// File descriptors of a worker.
inline constexpr int answer_descriptor = 3, note_descriptor = 4, trail_descriptor = 5;

// Stands before the answer: what a plugin may have written there by accident is not taken for it.
inline constexpr std::string_view answer_mark = "\nregista-answer:";

// The hidden command of the program that a worker runs: a Job on standard input, an Answer to answer_descriptor.
inline constexpr const char* worker_command = "play-one";

// What a worker is given, by its descriptors elsewhere. trail: -1 for none.
struct WorkerFiles {
  int answer = -1, note = -1, output = -1, trail = -1;
};

// Stack, address space, and no file of what was in memory at its death. False when that was not possible. Makes only
// calls that are safe in a signal handler.
bool limit_memory(const Limits& limits);

// The environment of the programs that play matches: that of this process, with these variables in addition
// ("NAME=VALUE"), and, unless told otherwise, large pages for the C library's memory where the system has them on
// demand. A match touches some megabytes for the first time, and a page fault costs as much as a thousand instructions:
// a fifth of a game's processor time that is not the game (benchmarks/campaign/fork_server.py). In static memory, valid
// until the next call. Makes only calls that are safe in a signal handler.
enum class Pages { large, usual };
char** environment_with(std::initializer_list<const char*> more, Pages pages = Pages::large);

// Makes this new process a worker whose standard input is empty. Those of the given descriptors that are none of a
// worker's stay open. False when something was not possible: it must end at once. Makes only calls that are safe in a
// signal handler.
bool become_worker(const WorkerFiles& given, const Limits& limits, pid_t coordinator);

}  // namespace regista::campaign
