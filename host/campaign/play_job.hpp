// SPDX-License-Identifier: MIT
// A match of a campaign in the process that was started for it: whatever plugins do to that, no other match suffers.
#pragma once

#include <functional>
#include <string>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/worker_note.hpp"

namespace regista::campaign {

// program: "regista 0.1.0", for recordings. Throws what plugins throw, config::BadInput, Fault and std::runtime_error.
Answer play_job(const Job& job, MatchSetup prepared, const std::string& program, WorkerNote& note);

// What `play` gives, or how it failed.
Answer answer_of(const std::function<Answer()>& play);

// To the coordinator. False when nobody reads it.
bool hand_over(const Answer& answer);

}  // namespace regista::campaign
