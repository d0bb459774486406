// SPDX-License-Identifier: MIT
// What a tuning is, and what came of it, in sentences for a terminal and for a page. They say "better" only of what was
// found better on held-out seeds, and never that there is no difference.
#pragma once

#include <string>
#include <vector>

#include "report/tuning.hpp"
#include "report/tuning_numbers.hpp"
#include "report/tuning_problem.hpp"

namespace regista::report {

// "Not at its end: ..."; empty where all is done.
std::string unfinished_sentence(const TuningView& view);

// What was asked for, by what, with which budget.
std::vector<std::string> setup_sentences(const TuningView& view);

// How the search went: its end, what it thought best, and why that is too good.
std::vector<std::string> search_sentences(const TuningView& view);

struct TuningVerdict {
  std::string headline;
  std::vector<std::string> beside;  // each candidate with its numbers, then what is to be known to read them
};
TuningVerdict tuning_verdict(const TuningView& view);

// A table's words.
const char* name(study::VerifiedAs finding);              // "undecided"
std::string end_text(RangeEnd end);                       // empty inside
std::string importance_value(const study::Slice& slice);  // "0.64", "-" where unknown
std::string importance_text(const study::Slice& slice);   // "no more than chance"
bool more_than_chance(const study::Slice& slice);
std::string seen_text(const study::TuningPlan& plan, const study::Finalist& finalist);  // "not played"
std::string slices_note(const TuningView& view);

}  // namespace regista::report
