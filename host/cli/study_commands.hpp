// SPDX-License-Identifier: MIT
// Studies as their commands play them: `regista tournament`, `experiment` and `tune`, and `regista run` and `resume`,
// which play whatever a document or a file of results is of.
#pragma once

#include <span>
#include <string>

#include "cli/study_options.hpp"
#include "output/output_files.hpp"
#include "results/study_kind.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::cli {

struct ExperimentOptions : StudyOptions {
  std::string csv, summary;  // files; empty: none
  bool force = false;        // they may replace files of another kind
};

struct TuneOptions : StudyOptions {
  std::string trace, output;  // files; empty: none, beside the results
  bool force = false;         // they may replace files of another kind
};

// From what is asked to the report: the exit code. Each throws what end_of_program.hpp explains.
int tournament(StudyOptions options, output::OutputFiles outputs, const Invocation& invocation);
int experiment(ExperimentOptions options, output::OutputFiles outputs, const Invocation& invocation);
int tune(TuneOptions options, output::OutputFiles outputs, const Invocation& invocation);

// Goes on with a tuning whose plan is known.
int tune_by_plan(study::TuningPlan plan, const TuneOptions& options, output::OutputFiles outputs,
                 const Invocation& invocation);

// Which studies there are: the one place that knows them all. A new study needs a study::Study in host/study, a
// report::StudyReport in host/report, a command in host/cli that command_line.cpp adds, and a row in study_kinds.cpp.
// tests/integration/fifth_study has these and nothing else; what a study with a document of its own needs besides
// stands in docs/architecture.md.
std::span<const results::StudyKind> study_kinds();

}  // namespace regista::cli
