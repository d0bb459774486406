// SPDX-License-Identifier: MIT
// Plays a match whose minds are in other processes: one process for each team or for each robot. A mind is a function
// from percepts and packets to an outcome, so the processes exchange nothing else. If no process fails, the result
// equals the result of a match in one process, to the last bit. If a process dies, hangs, exits, runs out of memory or
// breaks a promise, its team is to blame, whether the cause is a call, a thread, a timer or a damaged heap. If each
// robot has a process, robots cannot share the data that a plugin keeps outside of its instance. So a team whose robots
// do not decide alone gets another result.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include "campaign/job.hpp"
#include "campaign/mind_host.hpp"
#include "campaign/worker.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_inputs.hpp"

namespace regista::campaign {

// Thrown if a process of minds failed. what() describes the failure in one line.
struct Fault : std::runtime_error {
  Fault(const Failure& of, bool outside) : std::runtime_error(of.what), failure(of), from_outside(outside) {}
  Failure failure;
  bool from_outside;  // true: the cause may be a signal from people or the system (End::How), or the machine
};

// Called with the answers of plugins in each decision, in the order of the match. May be empty.
using AfterAnswers = std::function<void(const match::Decision&, std::span<const plugin::CallAnswer>)>;

// Plays `setup` as match::play(setup, plans) does. The function copies the calling process, which must have no threads
// and must have loaded no plugin. `note` receives the process groups, and the first try of a confined mind to reach
// outside of its process. `kept` receives the names of variables of plugin files that confined minds
// (process/confinement.hpp) have changed, one line; usually empty. Throws Fault, and the exceptions of match::play.
match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans,
                            Separation separation, const Limits& limits, const Examination& examination,
                            const AfterAnswers& after, WorkerNote& note, std::string& kept);

}  // namespace regista::campaign
