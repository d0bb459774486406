// SPDX-License-Identifier: MIT
// What is searched for, as every study reports it that searches the values of a team: which numbers of which team,
// against whom, by which objective; in sentences, and in words for tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/what_was_played.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "texts/message.hpp"

namespace regista::report {

using texts::counted;                         // "1 run", "2 runs"
std::string pairs_text(std::uint64_t count);  // "1 pair"

WhatWasPlayed what_was_played(const study::TuningPlan& plan);

// "weights: 3 parameters of paper.yaml, goal_difference as large as possible"
std::string problem_title(const study::TuningPlan& plan);

// "goal_difference (per match)"
std::string objective_text(const study::TuningObjective& objective);

// Base team and opponents, objective, what a pair is.
std::vector<std::string> problem_sentences(const study::TuningPlan& plan);

// What is unusual but allowed, lines without their ends.
std::vector<std::string> problem_notes(const study::TuningPlan& plan);

// A table's words.
std::string scale_text(const study::Parameter& parameter);  // "linear", "log", "whole numbers"
bool has_unit(const study::Parameter& parameter);           // not a bare number, whose unit is "1"
std::string range_text(const study::Parameter& parameter);  // "0.1 to 10 m"
std::string values_text(const study::TuningPlan& plan, const study::ParameterValues& values);  // "a=1, b=0.5"
std::string forfeiter(const study::TuningPlan& plan, std::size_t team);  // of a tally's forfeits; not yet visible

// "search, seed 12: small 1:0 other": a match that was taken, in a line without its end.
std::string match_text(const std::string& stage, const campaign::Job& job, const campaign::Decided& decided);

}  // namespace regista::report
