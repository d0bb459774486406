// SPDX-License-Identifier: MIT
// Studies as their commands play them: `regista tournament`, `experiment` and `tune`, and `regista run` and `resume`,
// which play any study that a document asks for or a file of results holds.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "cli/study_options.hpp"
#include "output/output_files.hpp"
#include "results/study_kind.hpp"
#include "results/study_run.hpp"

namespace regista::cli {

struct TuneOptions : StudyOptions {
  std::string trace, output;  // files; empty: none, beside the results
  bool force = false;         // they may replace files of another kind
};

// Which studies there are. A study needs the declared struct of its document
// (config::DocumentKind), a study::Study, a report::StudyReport whose outline says what was found, and a row here; then
// `regista run` plays its documents. tests/integration/sixth_study has these and nothing else.
std::span<const results::StudyKind> study_kinds();

// The one that such documents ask for.
const results::StudyKind& study_kind(const config::DocumentKind& document);

// Plans what the options ask for. Results get the document's name where they have none, and what is read and written is
// added to the outputs, which are not checked yet. Throws what end_of_program.hpp explains.
results::PlannedStudy planned(const results::StudyKind& kind, StudyOptions& options, output::OutputFiles& outputs,
                              const Invocation& invocation);

// Plays it to the report: the exit code. wishes: what the command does besides, with all that is written; empty:
// nothing. force: outputs may replace files of another kind.
using WishesOf = std::function<results::StudyWishes(report::StudyReport& report, output::OutputFiles& outputs)>;
int play(const results::StudyKind& kind, StudyOptions options, output::OutputFiles outputs,
         const Invocation& invocation, const WishesOf& wishes = {}, bool force = false);

// A tuning, whose team is written at its end.
int play_tuning(const std::string& plan, const TuneOptions& options, output::OutputFiles outputs,
                const Invocation& invocation);

}  // namespace regista::cli
