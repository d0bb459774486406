// SPDX-License-Identifier: MIT
// What a tuning is, and what came of it, in words. They say "better" only of what was found better on held-out seeds,
// and never that no difference exists.
#pragma once

#include <string>
#include <vector>

#include "report/match_remarks.hpp"
#include "report/tuning.hpp"
#include "report/tuning_numbers.hpp"

namespace regista::report {

WhatWasPlayed what_was_played(const study::TuningPlan& plan);
ForfeitWords forfeit_words(const study::TuningPlan& plan);  // the plan outlives them

// "weights: 3 parameters of paper.yaml, goal_difference as large as possible"
std::string problem_title(const study::TuningPlan& plan);

// What was asked for, by what, with which budget.
std::vector<Sentence> setup_sentences(const study::TuningPlan& plan);

// How the search went: its end, what it thought best, and why that is too good.
std::vector<Sentence> search_sentences(const TuningView& view);

struct TuningVerdict {
  std::string headline;
  std::vector<std::string> beside;  // each candidate with its numbers, then what is to be known to read them
};
TuningVerdict tuning_verdict(const TuningView& view);

// A table's words.
const char* name(study::VerifiedAs finding);                // "undecided"
bool has_unit(const study::Parameter& parameter);           // not a bare number, whose unit is "1"
std::string range_text(const study::Parameter& parameter);  // "0.1 to 10 m"
std::string importance_text(const study::Slice& slice);     // "no more than chance"
bool more_than_chance(const study::Slice& slice);
std::string slices_note(const TuningView& view);

}  // namespace regista::report
