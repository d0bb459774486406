// SPDX-License-Identifier: MIT
// Plays a match whose minds are in other processes: one process for each team or for each robot. A mind is a function
// from percepts and packets to an outcome, so the processes exchange nothing else. If no process fails, the result
// equals the result of a match in one process, to the last bit. If a process dies, hangs, exits, runs out of memory or
// breaks a promise, its team is to blame, whether the cause is a call, a thread, a timer or a damaged heap. If each
// robot has a process, robots cannot share the data that a plugin keeps outside of its instance. So a team whose robots
// do not decide alone gets another result.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "campaign/decision_trail.hpp"
#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"

namespace regista::campaign {

// Thrown if a process of minds failed. what() describes the failure in one line.
struct Fault : std::runtime_error {
  Fault(const Failure& of, bool outside) : std::runtime_error(of.what), failure(of), from_outside(outside) {}
  Failure failure;
  bool from_outside;  // true: the cause may be a signal from people or the system, or the machine
};

// Plays `setup` as match::play(setup, plans) does, with separation, limits and inspection of `job`, in copies of this
// process, which must have no threads and no loaded plugin. `trail` receives the answers of plugins if the job has a
// trail; `note` the process groups, and the first try of a confined mind to reach outside; `kept` the variables of
// plugin files that confined minds have changed, one line. Throws Fault, and what match::play throws.
match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Job& job,
                            std::optional<TrailWriter>& trail, WorkerNote& note, std::string& kept);

}  // namespace regista::campaign
