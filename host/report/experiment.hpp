// SPDX-License-Identifier: MIT
// What is said about an experiment: a function of its plan and its results in order, equal to the byte however often it
// was stopped and by however many workers it was played. It says what was found, whatever that is: nothing here knows
// what anybody expects.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "report/outline.hpp"
#include "report/what_was_played.hpp"
#include "study/experiment.hpp"
#include "study/experiment_plan.hpp"

namespace regista::report {

struct ExperimentView {
  const study::ExperimentPlan& plan;
  const study::Experiment& course;
  // The command that plays a match of the schedule by itself.
  std::function<std::string(std::uint64_t match)> again;
};

WhatWasPlayed what_was_played(const study::ExperimentPlan& plan);

// What a live display shows: a few measures, the primary one first; of a sweep one. Lines, each ended.
std::string experiment_standing(const ExperimentView& view);

// All that is said of it, for a terminal, a page and programs.
Outline experiment_outline(const ExperimentView& view);

// What was found of the primary measure, in one line. Arms stand in an order ("a > b > c") only where every difference
// between them was found, after the correction for the number of comparisons.
std::string experiment_headline(const ExperimentView& view);

// The same in full, a sentence each: the means, then each comparison, then the test. Empty without a primary measure.
std::vector<std::string> finding_sentences(const ExperimentView& view);

// What is to be known to read the tables, a sentence each: how long was played, what a setting changes besides the
// arms, what intervals hold for.
std::vector<std::string> experiment_notes(const ExperimentView& view);

// A table with a row for each number of each match of an arm's team (RFC 4180, but lines end with \n).
enum class CsvMeasures { shown, all };
std::string experiment_csv_head(const study::ExperimentPlan& plan);
std::string experiment_csv_lines(const study::ExperimentPlan& plan, std::uint64_t index,
                                 const campaign::Decided& decided, CsvMeasures measures);

// A table with a row for each measure of each condition: the means of the outline, in full precision.
std::string experiment_summary_csv(const ExperimentView& view);

}  // namespace regista::report
