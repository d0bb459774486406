// SPDX-License-Identifier: MIT
// A match whose teams think in a process each. A mind is a function from percepts and packets to an outcome, so nothing
// else crosses; undisturbed, the match is the same to the last bit. Whichever process dies, hangs, exits, runs out of
// its memory or breaks a promise is its team's, whatever the cause: a call, a thread, a timer, a damaged heap.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/worker_note.hpp"
#include "match/decision_digest.hpp"
#include "match/match.hpp"
#include "match/teams.hpp"
#include "mind/team_plan.hpp"

namespace regista::campaign {

// A team's process did not do what it was there for. what() is the failure in one line.
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

// Called with the digest of each decision, in the order of the match; may be empty.
using AfterDigest = std::function<void(const match::Decision&, const match::DecisionDigest&)>;

// Plays `setup` as match::play(setup, plans) does. To be called by a process without threads that has loaded no plugin:
// it is copied. `note`: the process groups are written into it. Throws Fault, and what match::play throws.
match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Limits& limits,
                            bool closely, const AfterDigest& after, WorkerNote& note);

}  // namespace regista::campaign
