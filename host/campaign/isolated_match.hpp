// SPDX-License-Identifier: MIT
// A match whose minds are kept apart: those of each team, or each of them, in a process of their own. A mind is a
// function from percepts and packets to an outcome, so nothing else crosses; undisturbed, the match is the same to the
// last bit. Whichever process dies, hangs, exits, runs out of its memory or breaks a promise is its team's, whatever
// the cause: a call, a thread, a timer, a damaged heap. And where each robot has a process, what a plugin keeps outside
// of its instance is no longer shared: a team whose robots do not decide alone plays another match.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/mind_host.hpp"
#include "campaign/worker_note.hpp"
#include "match/match.hpp"
#include "match/teams.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_trail.hpp"

namespace regista::campaign {

// A process of minds did not do what it was there for. what() is the failure in one line.
class Fault : public std::runtime_error {
 public:
  Fault(Failure failure, bool from_outside)
      : std::runtime_error(failure.what), failure_(std::move(failure)), from_outside_(from_outside) {}
  const Failure& failure() const { return failure_; }
  bool from_outside() const { return from_outside_; }  // a signal that people and systems send

 private:
  Failure failure_;
  bool from_outside_;
};

// Called with what plugins answered in each decision, in the order of the match; may be empty.
using AfterAnswers = std::function<void(const match::Decision&, std::span<const plugin::CallAnswer>)>;

// Plays `setup` as match::play(setup, plans) does. To be called by a process without threads that has loaded no plugin:
// it is copied. `note`: the process groups are written into it, and the first try of a confined mind to reach outside
// of its process. `kept`: what plugins of confined minds have changed in their files' own memory, one line; mostly
// empty. Throws Fault, and what match::play throws.
match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans,
                            Separation separation, const Limits& limits, const Examination& examination,
                            const AfterAnswers& after, WorkerNote& note, std::string& kept);

}  // namespace regista::campaign
