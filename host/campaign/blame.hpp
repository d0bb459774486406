// SPDX-License-Identifier: MIT
// Who is to blame when a match cannot be played to its end. Where both teams think in one process nobody can be: either
// may have damaged it. So the match is played again with each team's minds in a process of its own, and whose process
// fails is at fault. What does not come back in three isolated plays blames nobody, and nobody gains by it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "campaign/job.hpp"
#include "plugin/call_note.hpp"

namespace regista::campaign {

// How one play of a match went.
struct Attempt {
  bool isolated = false;
  bool played = false;  // to its end; else it failed:
  // By a signal that people and systems send. The machine may have been out of memory, or somebody tidied up.
  bool from_outside = false;
  std::optional<Failure> failure;  // whose process failed, in an isolated play; nothing: that of the match itself
  std::string what;                // how it failed, one line
};

enum class Judgement {
  counts,         // the last play's result
  play_isolated,  // once more
  forfeit,        // the side of the last failure loses
  set_aside,      // nobody is to blame, and there is no result
  give_up,        // something is wrong with the machine, or with this program
};

inline constexpr std::size_t isolated_plays = 3;  // that must agree before a death blames nobody
inline constexpr std::size_t most_failures = 6;   // over one match, until it is given up

// attempts: all of this match so far; at least one. A failure in an isolated play is its side's, but one by a signal
// from outside only when it comes in three isolated plays in a row; what such a signal did otherwise is forgotten.
Judgement judge(std::span<const Attempt> attempts);

// Why the match was set aside.
std::string why_set_aside(std::span<const Attempt> attempts);

// The failure of a worker that both teams share, in words: "Segmentation fault; the last call was assign of plugin
// greedy (home, robot 3, tick 41)".
std::string in_words(const std::string& what, const plugin::CallNote& note);

}  // namespace regista::campaign
