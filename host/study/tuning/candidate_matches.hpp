// SPDX-License-Identifier: MIT
// The matches of a verification: the candidates and the base team, pair by pair on held-out seeds, as
// long as its test (verification.hpp) wants more.
#pragma once

#include "study/tuning/match_tally.hpp"
#include "study/tuning/tuning_record.hpp"

namespace regista::study {

// Verifies record.candidates. deviation: what the standard deviation of a candidate's score over pairs is expected to
// be, above 0. The record's verification and what stands beside it by candidate grow with every pair. Throws what the
// source's `play` throws.
void verify_candidates(const MatchSource& source, double deviation, TuningRecord& record);

}  // namespace regista::study
