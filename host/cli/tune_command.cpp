// SPDX-License-Identifier: MIT
// `regista tune`: searches the numbers of a team for better ones, and says on other seeds whether they are.
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands.hpp"
#include "cli/study_commands.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "report/tuned_file.hpp"
#include "report/tuning_report.hpp"
#include "results/results_file.hpp"
#include "results/study_run.hpp"
#include "study/recording_place.hpp"
#include "study/tuning/search_time.hpp"

namespace regista::cli {
namespace {

constexpr auto tune_examples = R"(Examples:
  regista tune configs/studies/tune_paper.yaml
  regista tune configs/studies/tune_paper.yaml --matches 400 --set search.algorithm=spsa
  regista tune configs/studies/tune_paper.yaml --results night.db --resume
  regista report night.db --json

The document names a team, opponents, the values that may change, what counts as better, an algorithm and how much is
played; `regista config show` explains its values, docs/tuning.md the method. What the search finds is only a guess: the
best points are played again on other seeds, and the best of these meet the base team on held-out seeds,
in a test that may stop at any pair. The team that comes of it is written beside the results, NAME.tuned.yaml, with
what was found about it in its head, whether or not it was found better.

Exit codes: 0 played, whatever was found; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

// To its end, with the table that was asked for. at_end: before the report is printed; may be empty.
int play(report::StudyReport& report, const TuneOptions& options, const Invocation& invocation, campaign::Store& store,
         const std::function<void()>& at_end) {
  std::optional<output::OutputFile> trace;
  if (!options.trace.empty()) trace.emplace(options.trace);
  results::StudyWishes wishes;
  wishes.after = [&report](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
    report.take(round, index, decided);
  };
  wishes.at_end = [&] {
    if (trace) {
      trace->write(report.end_table());
      trace->close();
    }
    if (at_end) at_end();
  };
  return results::play_study(report, options, invocation, store, wishes);
}

}  // namespace

int play_tuning(const std::string& plan, const TuneOptions& options, output::OutputFiles outputs,
                const Invocation& invocation) {
  const std::filesystem::path tuned =
      options.output.empty() ? study::tuned_file(options.results) : std::filesystem::path(options.output);
  outputs.write("the tuned team", tuned, Writes::tuned_team);
  outputs.check(options.force);
  study::OutOfTime clock;  // known once there is a file of results
  const auto out_of_time = [&clock](std::uint64_t evaluations) { return clock && clock(evaluations); };
  auto report = std::make_unique<report::TuningReport>(study::tuning_plan_from_json(plan), out_of_time);
  campaign::Store store = results::open_results(options.results, options.resume, report->study(),
                                                {outputs.documents(), {}}, invocation.studies);
  if (options.resume) {
    report =
        std::make_unique<report::TuningReport>(study::tuning_plan_from_json(results::stored_plan(store)), out_of_time);
  }
  try {
    // What was played elsewhere was not played by the clock.
    const bool plays = options.plays != campaign::Options::Plays::nothing_more;
    clock = plays ? study::search_clock(store, report->plan()) : study::stored_end_of_search(store);
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  std::exception_ptr not_written;
  const int exit = play(*report, options, invocation, store, [&] {
    if (!report->record().tuned()) return;
    try {
      outputs.check(options.force);  // hours later, perhaps
      output::write_whole(
          tuned,
          report::tuned_file_text(tuned, report->plan(), report->record(), REGISTA_VERSION, report->fingerprint()),
          output::Existing::replaced);
      report->tuned_file(tuned.string());
    } catch (...) {
      not_written = std::current_exception();  // what was found is printed all the same
    }
  });
  if (not_written) std::rethrow_exception(not_written);
  return exit;
}

static int tune(TuneOptions options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.file.empty()) throw BadInput("tune: which one? Name its file; see: regista tune --help");
  const results::PlannedStudy study = planned(study_kind(config::DocumentKind::tuning), options, outputs, invocation);
  return play_tuning(study.plan, options, std::move(outputs), invocation);
}

void add_tune(Command& parent, const Invocation& invocation) {
  static constexpr std::array own{
      DocumentOption{"--matches", "search.matches"},
      DocumentOption{"--opponent-disturbance", "opponent_disturbance"},
  };
  Command& command = parent.add("tune", "search a team's numbers for better ones, and verify what was found");
  const auto options = std::make_shared<TuneOptions>();
  command.take("file", options->file, "T.yaml", "the tuning's document", Reads::documents);
  options->values.declare(command, config::DocumentKind::tuning, own);
  options->values.declare_common(command, config::DocumentKind::tuning);
  command.take("--set", options->set, "PATH=VALUE",
               "a value laid over that document, or over those of its matches; may be repeated");
  command.take("--trace", options->trace, "FILE", "write every point of the search as a table", Writes::search_table);
  command.take("--output", options->output, "FILE",
               "file for the tuned team; default: NAME.tuned.yaml beside the results", Writes::tuned_team);
  command.flag("--force", options->force, "let --trace and the tuned team replace files of another kind");
  add_campaign_options(command, *options, "the tuning's name with .db");
  command.notes(tune_examples);
  command.run = [options, &command, &invocation] {
    return tune(*options, output::OutputFiles(command.given(), "tuning"), invocation);
  };
}

}  // namespace regista::cli
