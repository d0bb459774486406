// SPDX-License-Identifier: MIT
// `regista tune`: searches the numbers of a team for better ones, and says on other seeds whether they are.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/file_options.hpp"
#include "cli/output.hpp"
#include "cli/output_files.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/replaced_file.hpp"
#include "cli/results_file.hpp"
#include "cli/study_run.hpp"
#include "report/tuned_file.hpp"
#include "report/tuning_report.hpp"
#include "study/recording_place.hpp"
#include "study/tuning/search_time.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::cli {
namespace {

struct TuneOptions : study::TuningRequest {
  std::string trace, output;  // files; empty: none, beside the results
  bool force = false;         // they may replace files of another kind
};

constexpr auto examples = R"(Examples:
  regista tune configs/studies/tune_paper.yaml
  regista tune configs/studies/tune_paper.yaml --matches 400 --set search.algorithm=spsa
  regista tune configs/studies/tune_paper.yaml --results night.db --resume
  regista tune configs/studies/tune_paper.yaml --compare sbplx,spsa,sep_cma_es,random_search --repeats 9
  regista report night.db --json

The document names a team, opponents, the values that may change, what counts as better, an algorithm and how much is
played; `regista config show` explains its values, docs/tuning.md the method. What the search finds is only a guess: the
best points are played again on other seeds, and the best of these meet the base team on seeds that nobody has chosen by,
in a test that may stop at any pair. The team that comes of it is written beside the results, NAME.tuned.yaml, with
what was found about it in its head, whether or not it was found better.
--compare plays the search of several algorithms with equal numbers of matches, repeated with other seeds, and judges what
each came to on seeds that none has seen; no team is written.
Exit codes: 0 played, whatever was found; 1 interrupted, or the results could not be written; 2 bad input; 3 a defect of
Regista.)";

int tune(TuneOptions options, OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  if (options.file.empty()) throw BadInput("tune: which one? Name its file; see: regista tune --help");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::TuningPlan plan = study::planned_tuning(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) options.results = plan.name + (plan.compares() ? ".compare.db" : ".db");
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results, options.no_page ? OutputFiles::Page::none : OutputFiles::Page::with_figures);
  const std::filesystem::path tuned =
      options.output.empty() ? study::tuned_file(options.results) : std::filesystem::path(options.output);
  if (!plan.compares()) outputs.write("the tuned team", tuned, Writes::tuned_team);
  outputs.check(options.force);
  std::function<bool(std::uint64_t)> clock;  // known once there is a file of results
  report::TuningReport report(std::move(plan),
                              [&clock](std::uint64_t evaluations) { return clock && clock(evaluations); });
  campaign::Store store = open_results(options.results, options.resume, report.study(), {}, invocation.studies);
  try {
    clock = study::search_clock(store, report.plan());
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  std::optional<OutputFile> trace;
  if (!options.trace.empty()) trace.emplace(options.trace);
  std::exception_ptr not_written;
  StudyWishes wishes;
  wishes.after = [&report](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
    report.take(round, index, decided);
  };
  wishes.at_end = [&] {
    if (trace) {
      trace->write(report.table_end());
      trace->close();
    }
    if (report.plan().compares() || !report.record().tuned()) return;
    try {
      outputs.check(options.force);  // hours later, perhaps
      write_whole(tuned,
                  report::tuned_file_text(tuned, report.plan(), report.record(), REGISTA_VERSION, report.fingerprint()),
                  Existing::replaced);
      report.tuned_file(tuned.string());
    } catch (...) {
      not_written = std::current_exception();  // what was found is told all the same
    }
  };
  try {
    const int exit = play_study(report, options, invocation, store, wishes);
    if (not_written) std::rethrow_exception(not_written);
    return exit;
  } catch (const study::StudyError& error) {
    throw BadInput(std::string("tune: ") + error.what());
  }
}

}  // namespace

Command add_tune(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("tune", "search a team's numbers for better ones, and verify what was found");
  const auto options = std::make_shared<TuneOptions>();
  reads(app.add_option("file", options->file, "the tuning's document")->type_name("T.yaml"), Reads::documents);
  app.add_option("--set", options->overrides, "a value laid over that document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app.add_option("--matches", options->matches, "search with so many matches, whatever the document says")
      ->type_name("N");
  app.add_option("--compare", options->compare, "compare these algorithms instead, divided by commas")
      ->type_name("A,B,...");
  app.add_option("--repeats", options->repeats, "of each algorithm that is compared; default 5")->type_name("N");
  writes(app.add_option("--trace", options->trace, "write every point of the search as a table")->type_name("FILE"),
         Writes::search_table);
  writes(app.add_option("--output", options->output,
                        "file for the tuned team; default: NAME.tuned.yaml beside the results")
             ->type_name("FILE"),
         Writes::tuned_team);
  app.add_flag("--force", options->force, "let --trace and the tuned team replace files of another kind")
      ->disable_flag_override();
  add_campaign_options(app, *options, "the tuning's name with .db");
  app.footer(examples);
  return {&app, [options, &app, &invocation] { return tune(*options, OutputFiles(app, "tuning"), invocation); }};
}

}  // namespace regista::cli
