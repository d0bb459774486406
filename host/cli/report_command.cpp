// SPDX-License-Identifier: MIT
// `regista report`: what the stored results of a study say, without playing any match; while it is still played, too.
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"
#include "report/study_report.hpp"
#include "results/results_file.hpp"
#include "results/results_page.hpp"
#include "results/study_run.hpp"
#include "results/written_study.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::cli {
namespace {

constexpr auto report_examples = R"(Examples:
  regista report tournament.db
  regista report tournament.db --json
  regista report tournament.db --csv > matches.csv
  regista report tournament.db --csv --metrics > everything.csv
  regista report tournament.db -o tournament.html
  regista report tournament.db --figures figures
  regista report tournament.db --standard-error 17
  regista report tournament.db --study again
  regista report here.db there.db

-o writes one page that needs nothing else, --figures each of its figures as NAME.svg and its data as NAME.csv. A study
that has ended is reported as it was at its end; another one as far as its matches have been played without a gap. The
table of an experiment has a row for each number of each match, that of a tuning one for each point of its search.
Several files are reported as one where they are of one study, begun alike, whose matches were played in several places.
--study writes the study itself, as it was asked for, with its teams, profiles and scenes: `regista run study.yaml` in that
folder plays it again.
--standard-error writes what plugins wrote to standard error in a match, as far as it was kept.

Exit codes: 0 done; 1 the report could not be written; 2 bad input; 3 a defect of Regista.)";

struct ReportOptions {
  std::vector<std::string> files;                    // of one study
  std::string file;                                  // the first of them, by which what is made is called
  std::string page, figures, study, standard_error;  // the last: of this match, from 1
  bool json = false, csv = false, metrics = false, force = false;
};

// In pieces, so that a million rows need no memory.
constexpr std::size_t piece = std::size_t{1} << 20;

void refuse_what_does_not_go_together(const ReportOptions& options) {
  if (options.file.empty())
    throw BadInput("report: which results? Name a file that `regista tournament`, `experiment` or `tune` wrote");
  if (options.csv && options.json) throw BadInput("report: --csv and --json: one of them");
  if (options.metrics && !options.csv) throw BadInput("report: --metrics adds columns to --csv, which is not given");
  const bool files = !options.page.empty() || !options.figures.empty();
  if (files && (options.csv || options.json)) {
    throw BadInput(fmt::format("report: {} and {}: one of them", options.page.empty() ? "--figures" : "-o",
                               options.csv ? "--csv" : "--json"));
  }
  if (!options.standard_error.empty() && (files || options.csv || options.json)) {
    throw BadInput("report: --standard-error writes the text of a match, and nothing else");
  }
  if (!options.study.empty() && (files || options.csv || options.json || !options.standard_error.empty())) {
    throw BadInput("report: --study writes the study, and nothing else");
  }
  if (options.force && !files) throw BadInput("report: --force belongs to -o or --figures, which are not given");
}

// Names of the metrics that the matches have which the study takes: what was played ahead does not count.
match::MetricPaths metric_columns(const ReportOptions& options, const campaign::Store& store,
                                  const Invocation& invocation) {
  std::uint64_t rows = 0;
  const auto report = results::stored_study(options.file, store, {}, invocation.studies);
  study::read_back(report->study(), store, report->study().metrics(),
                   [&rows](const study::Round& round, std::uint64_t index, const campaign::Decided* /*decided*/) {
                     rows = round.first_row + index + 1;
                   });
  return store.metric_paths(static_cast<std::int64_t>(rows));
}

int print_report(const ReportOptions& options, const campaign::Store& store, const Invocation& invocation) {
  const auto report = results::stored_study(options.file, store, results::play_again(invocation), invocation.studies);
  if (options.metrics && !report->is_table_of_matches()) {
    throw BadInput(
        fmt::format("report: --metrics: the table of a {} has no row for each match", report->study().what()));
  }
  try {
    report::TableWish wish{.all_metrics = options.metrics};
    if (options.metrics && report->has_a_column_for_each_metric())
      wish.metrics = metric_columns(options, store, invocation);
    std::string csv = options.csv ? report->begin_table(wish) : std::string();
    study::read_back(report->study(), store, options.metrics ? campaign::Metrics::wanted : report->study().metrics(),
                     [&](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
                       if (!options.csv || decided == nullptr) return;
                       csv += report->table_lines(round, index, *decided);
                       if (csv.size() <= piece) return;
                       output::print(csv);
                       csv.clear();
                     });
    if (const std::string incomplete = report->incomplete(); !incomplete.empty()) {
      complain(fmt::format("{} holds {}", options.file, incomplete));
    }
    output::print(options.csv    ? csv + report->end_table()
                  : options.json ? outline_json(report->outline())
                                 : outline_text(report->outline()));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  return exit_done;
}

// What was written is no text of ours: only ends of lines may move the cursor.
int tell_standard_error(const std::string& file, const campaign::Store& store, std::int64_t match) {
  try {
    const auto row = store.row(match);
    if (!row) throw BadInput(fmt::format("{} holds no match {}", file, match));
    if (row->decided.output.empty()) {
      throw BadInput(fmt::format("{}: in match {} no plugin wrote to standard error", file, match));
    }
    const std::string text = texts::visible_lines(row->decided.output);
    output::print(text.ends_with('\n') ? text : text + '\n');
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  return exit_done;
}

int run(ReportOptions options, const output::OutputFiles& outputs, const Invocation& invocation) {
  if (!options.files.empty()) options.file = options.files.front();
  refuse_what_does_not_go_together(options);
  outputs.check(options.force);
  std::int64_t match = 0;  // none
  if (!options.standard_error.empty()) {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    match = static_cast<std::int64_t>(config::parse_whole("--standard-error", options.standard_error, 1, most));
  }
  const results::ResultsTogether results(options.files, invocation.studies);
  const campaign::Store& store = results.store();
  if (match != 0) return tell_standard_error(options.file, store, match);
  if (!options.study.empty()) {
    const auto report = results::stored_study(options.file, store, {}, invocation.studies);
    for (const std::string& each :
         results::write_study(report->played(), store.documents(), invocation.studies, options.study))
      complain(each);
    return exit_done;
  }
  if (options.page.empty() && options.figures.empty()) {
    return print_report(options, store, invocation);
  }
  results::PageWishes wishes;
  if (!options.page.empty()) wishes.page = options.page;
  if (!options.figures.empty()) wishes.figures.folder = options.figures;
  wishes.figures.existing = options.force ? output::Existing::replaced : output::Existing::refused;
  results::write_page({options.file, store, invocation.studies}, wishes);
  return exit_done;
}

}  // namespace

void add_report(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("report", "what stored results say");
  const auto options = std::make_shared<ReportOptions>();
  command.take("results", options->files, "RESULTS.db", "files that a tournament, an experiment or a tuning wrote",
               Reads::results);
  command.flag("--json", options->json, "write the report as JSON");
  command.flag("--csv", options->csv,
               "write a table with a row for each match, of an experiment for each number, of a tuning for each point");
  command.flag("--metrics", options->metrics, "with --csv: all numbers of the matches, too");
  command.take("-o,--output", options->page, "PAGE.html", "write the report as a page that needs nothing else",
               Writes::page);
  command.take("--figures", options->figures, "FOLDER", "write the figures of the page as files of this folder",
               Writes::figures);
  command.take("--study", options->study, "FOLDER", "write the study with all its files, to be played again",
               Writes::sources);
  command.take("--standard-error", options->standard_error, "MATCH",
               "write what plugins wrote to standard error in this match");
  command.flag("--force", options->force, "replace files that exist already");
  command.notes(report_examples);
  command.run = [options, &command, &invocation] {
    return run(*options, output::OutputFiles(command.given(), "report"), invocation);
  };
}

}  // namespace regista::cli
