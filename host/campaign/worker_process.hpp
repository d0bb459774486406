// SPDX-License-Identifier: MIT
// What coordinator and worker agree on: files under fixed numbers, limits, surroundings, and how an answer begins.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "campaign/limits.hpp"
#include "process/child.hpp"

namespace regista::campaign {

// File descriptors of a worker.
inline constexpr int answer_descriptor = 3, note_descriptor = 4, trail_descriptor = 5;

// Stands before the answer: what a plugin may have written there by accident is not taken for it.
inline constexpr std::string_view answer_mark = "\nregista-answer:";

// The hidden command of the program that a worker runs: a Job on standard input, an Answer to answer_descriptor.
inline constexpr const char* worker_command = "play-one";

// What a worker is given, by its descriptors elsewhere; -1 for none. job: what stands on standard input.
struct WorkerFiles {
  int answer = -1, note = -1, output = -1, trail = -1, job = -1;
};
process::Setting worker_setting(const WorkerFiles& files, const Limits& limits);

// Of a process that opens plugins: stack and address space.
process::Limits memory_limits(const Limits& limits);

// The environment of the programs that play matches, with a null at its end: that of this process, with these variables
// in addition ("NAME=VALUE"), and, unless told otherwise, large pages for the C library's memory where the system has
// them on demand. A match touches some megabytes for the first time, and a page fault costs as much as a thousand
// instructions: a fifth of a game's processor time that is not the game (benchmarks/campaign/fork_server.py).
enum class Pages { large, usual };
std::vector<char*> environment_with(std::initializer_list<const char*> more, Pages pages = Pages::large);

}  // namespace regista::campaign
