// SPDX-License-Identifier: MIT
// Decides who is to blame if a match cannot be played to its end. If both teams share a process, either team may have
// caused a crash. So the match is replayed "isolated": each team has its own process for its minds. The team whose
// process fails is to blame. If three isolated plays succeed, the match is set aside, and no team is to blame.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "campaign/job.hpp"
#include "plugin/call_inputs.hpp"

namespace regista::campaign {

// Thrown if the campaign cannot continue. what() is one line that says why.
struct CampaignError : std::runtime_error {
  enum class Kind {
    input,    // a file changed while the campaign ran, or cannot be used any more
    machine,  // too many workers died, or workers died that run no code of plugins
  };
  CampaignError(Kind of, const std::string& message) : std::runtime_error(message), kind(of) {}
  Kind kind;
};

// The outcome of one play of a match.
struct Attempt {
  bool isolated = false;  // true: each team had its own process
  bool played = false;    // true: the play came to its end; false: the following members describe the failure
  // true: the process was killed by a signal that people or systems send, for example because the memory was full.
  bool from_outside = false;
  std::optional<Failure> failure;  // blames the team whose process failed in an isolated play; empty: no team failed
  std::string what;                // reason of the failure, one line
};

enum class Judgement {
  counts,         // the result of the last play is the result of the match
  play_isolated,  // the match must be played once more, with one process for each team
  forfeit,        // the side whose process failed in the last play loses
  set_aside,      // no team is to blame, and the match has no result
  give_up,        // the campaign must end, because the machine or this program has a fault
};

inline constexpr std::size_t isolated_plays = 3;  // judge() decides after this number of equal isolated plays
inline constexpr std::size_t most_failures = 6;   // failed plays of one match after which the campaign ends

// Returns what must happen to a match next. attempts: all plays of the match so far, at least one. If a signal from
// outside killed a process, its team forfeits only if it failed in each of the last three plays, all isolated.
Judgement judge(std::span<const Attempt> attempts);

std::string why_set_aside(std::span<const Attempt> attempts);

// Describes the failure of a worker that both teams share: "Segmentation fault; the last call was assign of plugin
// greedy (home, robot 3, tick 41)".
std::string in_words(const std::string& what, const plugin::CallNote& note);

}  // namespace regista::campaign
