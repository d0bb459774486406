// SPDX-License-Identifier: MIT
// The functions with which commands play studies. `regista tournament`, `experiment` and `tune` each play one kind of
// study. `regista run` plays the study of any document; `resume` continues the study of a results file.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "cli/common_options.hpp"
#include "output/output_files.hpp"
#include "results/study_kind.hpp"
#include "results/study_run.hpp"

namespace regista::cli {

struct TuneOptions : StudyOptions {
  std::string trace, output;  // paths of files; empty trace: no file; empty output: a file beside the results
  bool force = false;         // --force: outputs may replace files of another kind
};

// Returns all kinds of studies. A new kind needs a declared struct for its document (config::DocumentKind), a
// study::Study, a report::StudyReport whose outline describes the findings, and a row in the list of this function.
// `regista run` then plays documents of the new kind. tests/integration/sixth_study is a minimal example.
std::span<const results::StudyKind> study_kinds();

// Returns the kind of study whose documents are of the kind `document`.
const results::StudyKind& study_kind(const config::DocumentKind& document);

// Plans the study of the options. Without --results, the results file gets the name of the document. The function adds
// all inputs and outputs to `outputs` without a check. Throws the exceptions that terminal.hpp explains.
results::PlannedStudy planned(const results::StudyKind& kind, StudyOptions& options, output::OutputFiles& outputs,
                              const Invocation& invocation);

// Plays the study and prints the report. Returns the exit code. hooks: returns further actions of the command; empty:
// no further actions. force: outputs may replace files of other kinds.
using HooksOf = std::function<results::StudyHooks(report::StudyReport& report, output::OutputFiles& outputs)>;
int play(const results::StudyKind& kind, StudyOptions options, output::OutputFiles outputs,
         const Invocation& invocation, const HooksOf& hooks = {}, bool force = false);

// Plays a tuning, then writes the tuned team. Returns the exit code.
int play_tuning(const std::string& plan, const TuneOptions& options, output::OutputFiles outputs,
                const Invocation& invocation);

}  // namespace regista::cli
