// SPDX-License-Identifier: MIT
// The report of an experiment.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "report/outline.hpp"
#include "report/study_report.hpp"
#include "report/what_was_played.hpp"
#include "study/experiment_course.hpp"
#include "study/experiment_plan.hpp"

namespace regista::report {

struct ExperimentView {
  const study::ExperimentPlan& plan;
  const study::Experiment& course;
  // Returns the command that plays one match of the schedule.
  std::function<std::string(std::uint64_t match)> again;
};

WhatWasPlayed what_was_played(const study::ExperimentPlan& plan);

// Returns the state of a running experiment for a live display: a few measures, the primary measure first, or one
// measure for a sweep. Every line has a line end.
std::string experiment_standing(const ExperimentView& view);

Outline experiment_outline(const ExperimentView& view);

// Returns the finding of the primary measure in one line.
std::string experiment_headline(const ExperimentView& view);

// Returns sentences about the means, the comparisons and the test. Returns nothing without a primary measure.
std::vector<std::string> finding_sentences(const ExperimentView& view);

std::string in_a_row(const std::vector<std::string>& names);  // "a, b and c"

// Returns sentences that explain the tables: minutes of play, differences between the arms' settings, intervals.
std::vector<std::string> experiment_notes(const ExperimentView& view);

// Returns the figures, each as wide as the page, first the figure of the primary measure. Names without a sweep:
// "measure_N" (mean and interval of each arm; N: index of the measure in the plan), "roles" (measures of single roles),
// "measures_1", ... (several other measures in each figure). With a sweep: "sweep_N" (a curve for each arm).
std::vector<Figure> experiment_figures(const ExperimentView& view);
std::vector<std::string> names_of_experiment_figures(const study::ExperimentPlan& plan);  // all names, in order
bool is_experiment_figure(std::string_view name);  // whether a figure of some experiment may have this name

// Returns whether all numbers of this measure are 0 or missing. Figures leave out such a measure.
bool shows_nothing(const ExperimentView& view, std::size_t measure);

// Returns a table with a row for each measure of each condition, with means in full precision.
std::string experiment_summary_csv(const ExperimentView& view);

// again: makes the command with which the reader of the report plays a match again.
std::unique_ptr<StudyReport> experiment_report(study::ExperimentPlan plan, CommandOf again);

}  // namespace regista::report
