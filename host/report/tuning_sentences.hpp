// SPDX-License-Identifier: MIT
// What a tuning is, and what came of it, in sentences for a terminal and for a page. They say "better" only of what was
// found better on seeds that nobody has chosen by, and never that there is no difference.
#pragma once

#include <string>
#include <vector>

#include "report/tuning.hpp"
#include "report/tuning_numbers.hpp"

namespace regista::report {

// "weights: 3 parameters of paper.yaml, goal_difference as large as possible"
std::string tuning_title(const TuningView& view);

// "goal_difference (per match)"
std::string objective_text(const study::TuningObjective& objective);

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
const char* name(study::VerifiedAs finding);                // "undecided"
std::string scale_text(const study::Parameter& parameter);  // "linear", "log", "whole numbers"
bool has_unit(const study::Parameter& parameter);           // not a bare number, whose unit is "1"
std::string range_text(const study::Parameter& parameter);  // "0.1 to 10 m"
std::string end_text(RangeEnd end);                         // empty inside
std::string importance_value(const study::Slice& slice);    // "0.64", "-" where unknown
std::string importance_text(const study::Slice& slice);     // "no more than chance"
bool more_than_chance(const study::Slice& slice);
std::string values_text(const study::TuningPlan& plan, const study::ParameterValues& values);  // "a=1, b=0.5"
std::string forfeiter(const study::TuningPlan& plan, std::size_t team);  // of record.forfeits; not yet visible
std::string seen_text(const study::TuningPlan& plan, const study::Finalist& finalist);  // "not played"
std::string slices_note(const TuningView& view);

}  // namespace regista::report
